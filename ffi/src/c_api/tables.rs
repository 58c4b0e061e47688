//! Tables of parameters and outputs

use core::ffi::c_char;
use core::fmt::Display;

use softanvil_kernel::parameter::{Kind, NUMBERS};
use softanvil_kernel::preset::{self, PRESETS, Preset};
use softanvil_kernel::result::{RETIRED_FIELDS, RETIRED_OUTPUTS};
use softanvil_kernel::{FIELDS, Field, OUTPUTS, Output, Parameter};

use crate::c_api::error::status;
use crate::c_api::failure::{Failure, NONE};
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
    /// Its number: a `SoftanvilParameter`, or SOFTANVIL_PARAMETER_OF_LAYER of a layer and a `SoftanvilLayer`.
    pub id: u32,
    /// Number of choices, numbered from 0; 0 for a number.
    pub choices: u32,
    /// 1 if the value is a whole number, 0 if not.
    pub is_whole: u32,
    /// The layer that it belongs to, 0 next to the core; SOFTANVIL_NONE if it belongs to none.
    pub layer: u32,
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

/// Number of parameters of the library that is running, those of all layers that there can be included. Their numbers have
/// gaps: `softanvil_parameter_at` tells them.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_parameter_count() -> u32 {
    Parameter::COUNT as u32
}

/// Tells the number of a parameter by its place in the table: what belongs to the test, then what belongs to each layer from
/// the core to the surface, then the rest.
///
/// @param place Place, 0 to `softanvil_parameter_count()` less one.
/// @param parameter Its number.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_parameter_at(place: u32, parameter: *mut u32) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let parameter = unsafe { ptr::out(parameter, "parameter") };
    status(|| {
        let unknown = Failure::UnknownId { argument: "place", id: place, largest: Parameter::COUNT as u32 - 1 };
        let (parameter, found) = (parameter?, Parameter::all().nth(place as usize).ok_or(unknown)?);
        parameter.write(found.number());
        Ok(())
    })
}

/// Outputs are numbered from 0 to this less one in the library that is running; a retired number is refused.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_output_count() -> u32 {
    largest(OUTPUTS.iter().map(|row| row.id), RETIRED_OUTPUTS) + 1
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
        parameter.write(find_parameter(&name)?.number());
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
        output.write(find_output(&name)?.id);
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
        let (info, row) = (info?, parameter_of(parameter)?);
        let (min, max) = row.range();
        let (name, unit, description) = texts(&row.name(), row.unit(), row.description())?;
        info.write(SoftanvilParameterInfo {
            id: parameter,
            choices: row.labels().len() as u32,
            is_whole: u32::from(row.kind() != Kind::Quantity),
            layer: row.layer().map_or(NONE, |layer| layer as u32),
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
        let (room, labels) = (room?, parameter_of(parameter)?.labels());
        let largest = labels.len().saturating_sub(1) as u32;
        let unknown = Failure::UnknownId { argument: "choice", id: choice, largest };
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
        let (name, unit, description) = texts(&row.name, row.unit, row.description)?;
        info.write(SoftanvilOutputInfo { id: output, reserved_word: 0, reserved: [0.0; 4], name, unit, description });
        Ok(())
    })
}

/// The parameter with this number.
pub(crate) fn parameter_of(number: u32) -> Result<Parameter, Failure> {
    let largest = NUMBERS as u32 - 1;
    Parameter::by_number(number).ok_or(missing("parameter", number, largest, Parameter::is_retired(number)))
}

/// Row of an output.
pub(crate) fn output_row(id: u32) -> Result<&'static Output, Failure> {
    let largest = largest(OUTPUTS.iter().map(|row| row.id), RETIRED_OUTPUTS);
    OUTPUTS.iter().find(|row| row.id == id).ok_or(missing("output", id, largest, RETIRED_OUTPUTS.contains(&id)))
}

/// Row of a field.
pub(crate) fn field_row(id: u32) -> Result<&'static Field, Failure> {
    let largest = largest(FIELDS.iter().map(|row| row.id), RETIRED_FIELDS);
    FIELDS.iter().find(|row| row.id == id).ok_or(missing("field", id, largest, RETIRED_FIELDS.contains(&id)))
}

/// Row of a preset.
pub(crate) fn preset_row(id: u32) -> Result<&'static Preset, Failure> {
    let largest = largest(PRESETS.iter().map(|row| row.id), preset::RETIRED);
    PRESETS.iter().find(|row| row.id == id).ok_or(missing("preset", id, largest, preset::RETIRED.contains(&id)))
}

/// The largest number that a table has, or had.
pub(crate) fn largest(present: impl Iterator<Item = u32>, retired: &[u32]) -> u32 {
    present.chain(retired.iter().copied()).fold(0, u32::max)
}

/// Why a table has no row with the number `id`.
fn missing(argument: &'static str, id: u32, largest: u32, is_retired: bool) -> Failure {
    if is_retired { Failure::RetiredId { argument, id } } else { Failure::UnknownId { argument, id, largest } }
}

/// The parameter of a name.
pub(crate) fn find_parameter(name: &Name) -> Result<Parameter, Failure> {
    Parameter::find(name.text()).ok_or(Failure::UnknownName { argument: "name" })
}

/// Row of an output.
pub(crate) fn find_output(name: &Name) -> Result<&'static Output, Failure> {
    Output::find(name.text()).ok_or(Failure::UnknownName { argument: "name" })
}

/// Row of a field.
pub(crate) fn find_field(name: &Name) -> Result<&'static Field, Failure> {
    Field::find(name.text()).ok_or(Failure::UnknownName { argument: "name" })
}

pub(crate) type Texts =
    ([c_char; SOFTANVIL_NAME_SIZE], [c_char; SOFTANVIL_UNIT_SIZE], [c_char; SOFTANVIL_DESCRIPTION_SIZE]);

/// The texts of a row; that all of them fit is tested.
pub(crate) fn texts(name: &dyn Display, unit: &str, description: &str) -> Result<Texts, Failure> {
    characters(name)
        .zip(characters(&unit))
        .zip(characters(&description))
        .map(|((name, unit), description)| (name, unit, description))
        .ok_or(Failure::UnknownName { argument: "info" })
}
