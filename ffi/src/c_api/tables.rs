//! Tables of parameters and outputs

use core::ffi::c_char;

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Field, Output, Parameter};

use crate::c_api::error::status;
use crate::c_api::failure::Failure;
use crate::c_api::ids::{FIELD_BY_ID, OUTPUT_BY_ID, PARAMETER_BY_ID};
use crate::c_api::ptr::{self, Name};
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::text::{SOFTANVIL_NAME_SIZE, characters};

/// Bytes of a unit, its NUL included.
pub const SOFTANVIL_UNIT_SIZE: usize = 16;
/// Bytes of a description, its NUL included.
pub const SOFTANVIL_DESCRIPTION_SIZE: usize = 256;

/// One row of the table of parameters.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SoftanvilParameterInfo {
    /// Its number, a `SoftanvilParameter`.
    pub id: u32,
    /// Number of choices, numbered from 0; 0 for a physical quantity.
    pub choices: u32,
    /// Smallest legal value.
    pub min: f64,
    /// Largest legal value.
    pub max: f64,
    /// Always 0.
    pub reserved: [f64; 4],
    /// Name, such as "impactor.mass".
    pub name: [c_char; SOFTANVIL_NAME_SIZE],
    /// SI unit; "1" for ratios and choices.
    pub unit: [c_char; SOFTANVIL_UNIT_SIZE],
    /// Meaning, one line.
    pub description: [c_char; SOFTANVIL_DESCRIPTION_SIZE],
}

/// One row of the table of outputs.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SoftanvilOutputInfo {
    /// Its number, a `SoftanvilOutput`.
    pub id: u32,
    /// Always 0.
    pub reserved_word: u32,
    /// Always 0.
    pub reserved: [f64; 4],
    /// Name, such as "contact.force".
    pub name: [c_char; SOFTANVIL_NAME_SIZE],
    /// SI unit; "1" for ratios.
    pub unit: [c_char; SOFTANVIL_UNIT_SIZE],
    /// Meaning, one line.
    pub description: [c_char; SOFTANVIL_DESCRIPTION_SIZE],
}

/// Number of parameters of the library that is running; their numbers are 0 to this less one.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_parameter_count() -> u32 {
    PARAMETER_BY_ID.len() as u32
}

/// Outputs are numbered from 0 to this less one in the library that is running; a retired number is refused.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_output_count() -> u32 {
    OUTPUT_BY_ID.len() as u32
}

/// Finds a parameter by its name.
///
/// @param name Name, such as "impactor.mass".
/// @param parameter Its number.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_parameter_find(name: *const c_char, parameter: *mut u32) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (name, parameter) = unsafe { (ptr::name(name, "name"), ptr::out(parameter, "parameter")) };
    status(|| {
        let (name, parameter) = (name?, parameter?);
        parameter.write(find_parameter(&name)?.0);
        Ok(())
    })
}

/// Finds an output by its name.
///
/// @param name Name, such as "contact.force".
/// @param output Its number.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_output_find(name: *const c_char, output: *mut u32) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (name, output) = unsafe { (ptr::name(name, "name"), ptr::out(output, "output")) };
    status(|| {
        let (name, output) = (name?, output?);
        output.write(find_output(&name)?.0);
        Ok(())
    })
}

/// Describes a parameter.
///
/// @param parameter A `SoftanvilParameter`.
/// @param info Its row.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_parameter_info(
    parameter: u32,
    info: *mut SoftanvilParameterInfo,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let info = unsafe { ptr::out(info, "info") };
    status(|| {
        let (info, row) = (info?, parameter_row(parameter)?);
        let (min, max) = row.range();
        let choices = labels(row).len() as u32;
        let (name, unit, description) = texts(row.name, row.unit(), row.description)?;
        info.write(SoftanvilParameterInfo {
            id: parameter,
            choices,
            min,
            max,
            reserved: [0.0; 4],
            name,
            unit,
            description,
        });
        Ok(())
    })
}

/// Names a choice of a parameter.
///
/// @param parameter A `SoftanvilParameter`.
/// @param choice Number of the choice.
/// @param name Room for the name.
/// @param size Bytes of room; `SOFTANVIL_NAME_SIZE` is always enough.
/// @return NULL_POINTER, UNKNOWN_ID, SHORT_BUFFER.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_parameter_choice(
    parameter: u32,
    choice: u32,
    name: *mut c_char,
    size: usize,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let room = unsafe { ptr::room(name.cast::<u8>(), size, "name") };
    status(|| {
        let (room, labels) = (room?, labels(parameter_row(parameter)?));
        let unknown = Failure::UnknownId { argument: "choice", id: choice, count: labels.len() };
        let label = labels.get(choice as usize).ok_or(unknown)?;
        let short = Failure::Short { argument: "name", given: room.len(), needed: label.len() + 1 };
        let (text, rest) = room.split_at_mut_checked(label.len()).ok_or(short)?;
        let end = rest.first_mut().ok_or(short)?;
        for (place, byte) in text.iter_mut().zip(label.bytes()) {
            place.write(byte);
        }
        end.write(0);
        Ok(())
    })
}

/// Describes an output.
///
/// @param output A `SoftanvilOutput`.
/// @param info Its row.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_output_info(output: u32, info: *mut SoftanvilOutputInfo) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let info = unsafe { ptr::out(info, "info") };
    status(|| {
        let (info, row) = (info?, output_row(output)?);
        let (name, unit, description) = texts(row.name, row.unit, row.description)?;
        info.write(SoftanvilOutputInfo { id: output, reserved_word: 0, reserved: [0.0; 4], name, unit, description });
        Ok(())
    })
}

/// Row of a parameter.
pub(crate) fn parameter_row(id: u32) -> Result<&'static Parameter, Failure> {
    let count = PARAMETER_BY_ID.len();
    PARAMETER_BY_ID.get(id as usize).copied().ok_or(Failure::UnknownId { argument: "parameter", id, count })
}

/// Row of an output.
pub(crate) fn output_row(id: u32) -> Result<&'static Output, Failure> {
    let count = OUTPUT_BY_ID.len();
    let row = OUTPUT_BY_ID.get(id as usize).ok_or(Failure::UnknownId { argument: "output", id, count })?;
    row.ok_or(Failure::RetiredId { argument: "output", id })
}

/// Row of a field.
pub(crate) fn field_row(id: u32) -> Result<&'static Field, Failure> {
    let count = FIELD_BY_ID.len();
    FIELD_BY_ID.get(id as usize).copied().ok_or(Failure::UnknownId { argument: "field", id, count })
}

/// Number and row of a parameter.
pub(crate) fn find_parameter(name: &Name) -> Result<(u32, &'static Parameter), Failure> {
    let found = (0..).zip(PARAMETER_BY_ID).find(|(_, row)| name.is(row.name));
    found.ok_or(Failure::UnknownName { argument: "name" })
}

/// Number and row of an output.
pub(crate) fn find_output(name: &Name) -> Result<(u32, &'static Output), Failure> {
    let found = (0..).zip(OUTPUT_BY_ID).find_map(|(id, row)| Some((id, row.filter(|row| name.is(row.name))?)));
    found.ok_or(Failure::UnknownName { argument: "name" })
}

/// Number and row of a field.
pub(crate) fn find_field(name: &Name) -> Result<(u32, &'static Field), Failure> {
    let found = (0..).zip(FIELD_BY_ID).find(|(_, row)| name.is(row.name));
    found.ok_or(Failure::UnknownName { argument: "name" })
}

fn labels(row: &Parameter) -> &'static [&'static str] {
    match row.kind {
        Kind::Choice { labels, .. } => labels,
        Kind::Real { .. } => &[],
    }
}

pub(crate) type Texts =
    ([c_char; SOFTANVIL_NAME_SIZE], [c_char; SOFTANVIL_UNIT_SIZE], [c_char; SOFTANVIL_DESCRIPTION_SIZE]);

/// The texts of a row; that all of them fit is tested.
pub(crate) fn texts(name: &str, unit: &str, description: &str) -> Result<Texts, Failure> {
    characters(name)
        .zip(characters(unit))
        .zip(characters(description))
        .map(|((name, unit), description)| (name, unit, description))
        .ok_or(Failure::UnknownName { argument: "info" })
}
