//! Internal forces of a solid.
//!
//! The rows of cells come by four kinds, one after another; those of a kind have no node in common ([`crate::step::solid_rows`]).
//! So each node takes the forces of its cells in one order, and the bits are the same whichever rows of a kind are computed at the
//! same time (feature `threads`).

use crate::element::{ElementEnergy, SolidBlock, tetrahedron_gradient};
use crate::error::StepError;
use crate::mesh::TETRAHEDRA;
use crate::model::Model;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, sum};
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::state::{SolidState, SolidView, State, solid_corners};
use crate::step::solid_cells::Cells;
use crate::step::solid_rows::{CellRow, KINDS, rows_of_kind};

/// Fills the nodal forces with minus the internal forces and adds up the energies.
pub(super) fn internal_forces(
    set: InstructionSet,
    model: &Model,
    state: &mut State,
    energy: &mut ElementEnergy,
) -> Result<(), StepError> {
    let constants = model.constants;
    let SolidState { displacement: uz, force: fz, history, .. } =
        SolidState::of(&constants.grid, constants.solid_history_packs, state.nodes.solid);
    let ([ux, uy], [fx, fy]) = (&state.nodes.displacement, &mut state.nodes.force);
    for force in [&mut *fx, &mut *fy, &mut *fz] {
        force.fill(0.0);
    }
    let cells = Cells { set, constants, blocks: model.solid().blocks, displacement: [ux, uy, uz] };
    for kind in KINDS {
        let force = [&mut **fx, &mut **fy, &mut *fz];
        let rows = rows_of_kind(&constants.grid, kind, force, history, cells.history_of_row());
        take_forces(&cells, rows, energy);
    }
    ended(model, state, energy)
}

/// Takes the forces of `rows` of cells that have no node in common, and adds up their energies.
fn take_forces<'s>(cells: &Cells, rows: impl Iterator<Item = CellRow<'s>>, energy: &mut ElementEnergy) {
    #[cfg(feature = "threads")]
    if super::solid_threads::pays(&cells.constants.grid) {
        let of_rows = super::solid_threads::each(rows, |row| cells.take_forces(row));
        return of_rows.iter().for_each(|of_row| energy.add(of_row));
    }
    rows.for_each(|row| energy.add(&cells.take_forces(row)));
}

/// The error of an inverted tetrahedron, if there is one.
fn ended(model: &Model, state: &State, energy: &ElementEnergy) -> Result<(), StepError> {
    if sum(&energy.inverted) > 0.0 { Err(first_inverted(model, state)) } else { Ok(()) }
}

/// The first inverted tetrahedron, as the error that it is.
#[cold]
#[inline(never)]
fn first_inverted(model: &Model, state: &State) -> StepError {
    let constants = model.constants;
    let grid = &constants.grid;
    let solid = SolidView::of(grid, constants.solid_history_packs, state.nodes.solid);
    let [ux, uy] = &state.nodes.displacement;
    let displacement = [&**ux, &**uy, solid.displacement];
    let found = model.solid().blocks.iter().enumerate().find_map(|(index, block)| {
        let (row, place) = grid.solid_place(index);
        let (rows, mirrored) = (grid.solid_rows(row, place), grid.mirrored(place));
        let block = SolidBlock { laws: constants.laws_of_row(row[0]), constants: block };
        (0..LANES * TETRAHEDRA).find_map(|i| {
            let (t, l) = (i / LANES, i % LANES);
            let corners = solid_corners(Scalar, l, &rows, displacement, mirrored.as_ref());
            let (_, jacobian) = tetrahedron_gradient(&block, l, t, &corners);
            if jacobian > Real::MIN_POSITIVE { None } else { Some(grid.element_index(index, l, t)) }
        })
    });
    StepError::Inverted { element: found.unwrap_or_default(), time: constants.time(state.scalars.step_index) }
}
