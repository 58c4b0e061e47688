//! Fields

use core::ffi::c_char;
use core::mem::MaybeUninit;

use softanvil_kernel::result::RETIRED_FIELDS;
use softanvil_kernel::{FIELDS, Field};

use crate::c_api::error::{SoftanvilError, report, status};
use crate::c_api::failure::Failure;
use crate::c_api::header::SoftanvilSimulation;
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::tables::{SOFTANVIL_DESCRIPTION_SIZE, SOFTANVIL_UNIT_SIZE, field_row, find_field, largest, texts};
use crate::c_api::text::SOFTANVIL_NAME_SIZE;
use crate::c_api::{block, ptr};

/// One row of the table of fields.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct SoftanvilFieldInfo {
    /// Its number, a `SoftanvilField`.
    pub id: u32,
    /// Numbers per value: 1, 2 (x and y) or 3.
    pub components: u32,
    /// Always 0.
    pub reserved: [f64; 4],
    /// Name, such as "node.displacement".
    pub name: [c_char; SOFTANVIL_NAME_SIZE],
    /// SI unit.
    pub unit: [c_char; SOFTANVIL_UNIT_SIZE],
    /// Meaning, one line.
    pub description: [c_char; SOFTANVIL_DESCRIPTION_SIZE],
}

/// One component of a field: the number at (row, column) is `data[row * row_stride + column * column_stride]`.
///
/// Nodes lie in rows from the core to the surface and in columns from one edge of the section to the other; the surface
/// is one row; triangles lie in the rows of their cells, two columns per cell, so that triangle `element` of a
/// `SoftanvilError` is in row `element / columns`, column `element % columns`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SoftanvilView {
    /// First number, inside the memory of the simulation; NULL if the field is computed when it is read.
    pub data: *const f64,
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Numbers from one row to the next; 0 if the field is computed.
    pub row_stride: usize,
    /// Numbers from one column to the next; 0 if the field is computed.
    pub column_stride: usize,
    /// Always 0.
    pub reserved: [usize; 3],
}

/// Fields are numbered from 0 to this less one in the library that is running; a retired number is refused.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_field_count() -> u32 {
    largest(FIELDS.iter().map(|row| row.id), RETIRED_FIELDS) + 1
}

/// Finds a field by its name.
///
/// @param name Name, such as "node.displacement".
/// @param field Its number.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_NAME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_field_find(name: *const c_char, field: *mut u32) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (name, field) = unsafe { (ptr::name(name, "name"), ptr::out(field, "field")) };
    status(|| {
        let (name, field) = (name?, field?);
        field.write(find_field(&name)?.id);
        Ok(())
    })
}

/// Describes a field.
///
/// @param field A `SoftanvilField`.
/// @param info Its row.
/// @return NULL_POINTER, MISALIGNED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_field_info(field: u32, info: *mut SoftanvilFieldInfo) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let info = unsafe { ptr::out(info, "info") };
    status(|| {
        let (info, row) = (info?, field_row(field)?);
        let (name, unit, description) = texts(&row.name, row.unit, row.description)?;
        let components = row.components as u32;
        info.write(SoftanvilFieldInfo { id: field, components, reserved: [0.0; 4], name, unit, description });
        Ok(())
    })
}

/// Shows one component of a field: its shape and, unless the field is computed, its numbers where they lie. The view
/// shows the present of the simulation for as long as its memory is neither moved nor used otherwise.
///
/// @param simulation The simulation.
/// @param field A `SoftanvilField`.
/// @param component Component, from 0.
/// @param view The view.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_field_view(
    simulation: *const SoftanvilSimulation,
    field: u32,
    component: u32,
    view: *mut SoftanvilView,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (block, view) = unsafe { (ptr::shared_block(simulation), ptr::out(view, "view")) };
    status(|| {
        let (block, view, row) = (block?, view?, field_row(field)?);
        check_component(row, component)?;
        view.write(block::look(block, |model, state| {
            let [rows, columns] = row.shape(model);
            let stored = row.strided(model, state, component as usize);
            Ok(SoftanvilView {
                data: stored.map_or(core::ptr::null(), |stored| stored.data.as_ptr()),
                rows,
                columns,
                row_stride: stored.map_or(0, |stored| stored.row_stride),
                column_stride: usize::from(stored.is_some()),
                reserved: [0; 3],
            })
        })?);
        Ok(())
    })
}

/// Copies one component of a field, stored or computed, to where the caller wants it: the number at (row, column) goes
/// to `values[(row * columns + column) * stride]`, and nothing in between is touched.
///
/// @param simulation The simulation.
/// @param field A `SoftanvilField`.
/// @param component Component, from 0.
/// @param values Room for the numbers.
/// @param count Numbers of room there, at least `(rows * columns - 1) * stride + 1`.
/// @param stride Numbers from one value to the next; the number of components interleaves them, 0 counts as 1.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID, SHORT_BUFFER.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_field_read(
    simulation: *const SoftanvilSimulation,
    field: u32,
    component: u32,
    values: *mut f64,
    count: usize,
    stride: usize,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (block, error) = unsafe { (ptr::shared_block(simulation), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let values = unsafe { ptr::room(values, count, "values") };
    report(error, || {
        let (block, values, row) = (block?, values?, field_row(field)?);
        check_component(row, component)?;
        block::look(block, |model, state| {
            let [rows, columns] = row.shape(model);
            let mut room = strided(values, rows * columns, stride)?;
            for (r, c) in (0..rows).flat_map(|r| (0..columns).map(move |c| (r, c))) {
                if let (Some(place), Some(value)) = (room.next(), row.value(model, state, r, c, component as usize)) {
                    place.write(value);
                }
            }
            Ok(())
        })
    })
}

fn check_component(row: &Field, component: u32) -> Result<(), Failure> {
    if (component as usize) < row.components {
        return Ok(());
    }
    Err(Failure::UnknownId { argument: "component", id: component, largest: row.components as u32 - 1 })
}

/// Every `stride`-th place, `needed` of them.
fn strided(
    values: &mut [MaybeUninit<f64>],
    needed: usize,
    stride: usize,
) -> Result<impl Iterator<Item = &mut MaybeUninit<f64>>, Failure> {
    let stride = stride.max(1);
    let room = needed.saturating_sub(1).saturating_mul(stride).saturating_add(1);
    if values.len() < room {
        let [given, needed] = [values.len(), room].map(|count| count.saturating_mul(size_of::<f64>()));
        return Err(Failure::Short { argument: "values", given, needed });
    }
    Ok(values.iter_mut().step_by(stride))
}
