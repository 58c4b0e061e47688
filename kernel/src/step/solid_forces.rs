//! Internal forces of a solid.
//!
//! The cells of a block give forces on their corners first; then each row of nodes takes those of the blocks about it, in index
//! order. So the bits are the same whichever rows are computed at the same time (feature `threads`).

use crate::element::{ElementEnergy, SolidBlock, tetrahedron_gradient};
use crate::error::StepError;
use crate::mesh::TETRAHEDRA;
use crate::model::Model;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, sum};
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::state::{SolidState, SolidView, State, solid_corners, subtract_solid_force};
use crate::step::solid_cells::Cells;

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
    #[cfg(feature = "threads")]
    if super::solid_threads::pays(constants) {
        super::solid_threads::forces(&cells, [fx, fy, fz], history, energy);
        return ended(model, state, energy);
    }
    for (number, history) in history.chunks_exact_mut(cells.history_of_row()).enumerate() {
        let place = cells.place(number);
        let mut of_row = ElementEnergy::ZERO;
        cells.row(number, history, &mut of_row, |block, force| {
            let rows = constants.grid.solid_rows(place, block);
            subtract_solid_force(&rows, [&mut *fx, &mut *fy, &mut *fz], force, constants.grid.mirrored(block).as_ref());
        });
        energy.add(&of_row);
    }
    ended(model, state, energy)
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
