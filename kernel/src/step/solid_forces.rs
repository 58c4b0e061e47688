//! Internal forces of a solid: row by row of cells, in index order.

use crate::element::{ElementEnergy, SolidBlock, SolidConstants, SolidCorners, solid_force, solid_gradients};
use crate::error::StepError;
use crate::mesh::TETRAHEDRA;
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Pack, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd};
use crate::state::{SolidState, SolidView, State, solid_corners, subtract_solid_force};

/// Fills the nodal forces with minus the internal forces and adds up the energies.
#[inline(always)]
pub(super) fn internal_forces<S: Simd>(
    simd: S,
    model: &Model,
    state: &mut State,
    energy: &mut ElementEnergy,
) -> Result<(), StepError> {
    let constants = model.constants;
    let grid = &constants.grid;
    let SolidState { displacement: uz, force: fz, history, .. } =
        SolidState::of(grid, constants.solid_history_packs, state.nodes.solid);
    let ([ux, uy], [fx, fy]) = (&state.nodes.displacement, &mut state.nodes.force);
    for force in [&mut *fx, &mut *fy, &mut *fz] {
        force.fill(0.0);
    }
    let per_row = grid.blocks_per_row().max(1);
    let share = (per_row * TETRAHEDRA * constants.solid_history_packs).max(1);
    let rows = model.solid().blocks.chunks_exact(per_row).zip(history.chunks_exact_mut(share));
    for (number, (blocks, history)) in rows.enumerate() {
        let row = CellRow { constants, place: [number / grid.n_w.max(1), number % grid.n_w.max(1)], blocks };
        let of_row = row_forces(simd, &row, [ux, uy, uz], [fx, fy, fz], history);
        energy.add(&of_row);
    }
    if sum(&energy.inverted) > 0.0 { Err(first_inverted(model, state)) } else { Ok(()) }
}

/// A row of cells.
struct CellRow<'m> {
    constants: &'m Constants,
    /// Row from the core, then slice.
    place: [usize; 2],
    blocks: &'m [SolidConstants],
}

/// Takes the internal forces of a row of cells from those of the nodes; gives its energies.
#[inline(always)]
fn row_forces<S: Simd>(
    simd: S,
    row: &CellRow,
    displacement: [&[Real]; 3],
    [fx, fy, fz]: [&mut [Real]; 3],
    history: &mut [Pack],
) -> ElementEnergy {
    let (grid, laws) = (&row.constants.grid, row.constants.laws_of_row(row.place[0]));
    let mut energy = ElementEnergy::ZERO;
    let share = (TETRAHEDRA * row.constants.solid_history_packs).max(1);
    for (place, (constants, history)) in row.blocks.iter().zip(history.chunks_exact_mut(share)).enumerate() {
        let (rows, mirrored) = (grid.solid_rows(row.place, place), grid.mirrored(place));
        let block = SolidBlock { laws, constants };
        let mut force: SolidCorners<Pack> = [[ZERO; 3]; 8];
        for chunk in 0..LANES / S::WIDTH {
            let corners = solid_corners(simd, chunk, &rows, displacement, mirrored.as_ref());
            let of_chunk = solid_force(simd, chunk, &block, &corners, history, &mut energy);
            for corner in 0..8 {
                for i in 0..3 {
                    simd.store(of_chunk[corner][i], &mut force[corner][i], chunk);
                }
            }
        }
        subtract_solid_force(simd, &rows, [fx, fy, fz], &force, mirrored.as_ref());
    }
    energy
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
            let jacobian = solid_gradients(Scalar, l, &block, &corners).jacobian[t % TETRAHEDRA];
            if jacobian > Real::MIN_POSITIVE { None } else { Some(grid.element_index(index, l, t)) }
        })
    });
    StepError::Inverted { element: found.unwrap_or_default(), time: constants.time(state.scalars.step_index) }
}
