//! Internal forces of a solid.
//!
//! The cells of a block give forces on their corners first; then each row of nodes takes those of the blocks about it, in index
//! order. So the bits are the same whichever rows are computed at the same time (feature `threads`).

use core::hint::black_box;

use crate::element::{ElementEnergy, SolidBlock, SolidConstants, SolidCorners, solid_force, tetrahedron_gradient};
use crate::error::StepError;
use crate::mesh::TETRAHEDRA;
use crate::model::{Constants, Model};
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Work};
use crate::state::{SolidState, SolidView, State, solid_corners, subtract_solid_force};

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

/// The cells of a solid with the displacements of its nodes.
pub(super) struct Cells<'m> {
    pub set: InstructionSet,
    pub constants: &'m Constants,
    pub blocks: &'m [SolidConstants],
    /// Along x, y and z, m.
    pub displacement: [&'m [Real]; 3],
}

impl Cells<'_> {
    /// Packs of the history of a row of cells.
    pub fn history_of_row(&self) -> usize {
        (self.constants.grid.blocks_per_row() * TETRAHEDRA * self.constants.solid_history_packs).max(1)
    }

    /// Row from the core and slice of the `number`-th row of cells.
    pub fn place(&self, number: usize) -> [usize; 2] {
        let slices = self.constants.grid.n_w.max(1);
        [number / slices, number % slices]
    }

    /// Hands the forces on the corners of the `number`-th row of cells to `take`, block by block, N; advances their `history`.
    pub fn row(
        &self,
        number: usize,
        history: &mut [Pack],
        energy: &mut ElementEnergy,
        mut take: impl FnMut(usize, &SolidCorners<Pack>),
    ) {
        let (constants, place) = (self.constants, self.place(number));
        let (grid, laws) = (&constants.grid, constants.laws_of_row(place[0]));
        let per_row = grid.blocks_per_row();
        let share = (TETRAHEDRA * constants.solid_history_packs).max(1);
        let blocks = self.blocks.get(number * per_row..(number + 1) * per_row).unwrap_or_default();
        for (at, (block, history)) in blocks.iter().zip(history.chunks_exact_mut(share)).enumerate() {
            let mut force = [[ZERO; 3]; 8];
            let mirrored = grid.mirrored(at);
            self.set.run(BlockForces {
                block: SolidBlock { laws, constants: block },
                rows: grid.solid_rows(place, at),
                displacement: self.displacement,
                mirrored: mirrored.as_ref(),
                history,
                energy,
                force: &mut force,
            });
            take(at, &force);
        }
    }
}

/// Forces on the corners of the cells of a block, N, as work for an instruction set: the one copy of the element loop.
struct BlockForces<'b> {
    block: SolidBlock<'b>,
    rows: [usize; 4],
    displacement: [&'b [Real]; 3],
    mirrored: Option<&'b Pack>,
    history: &'b mut [Pack],
    energy: &'b mut ElementEnergy,
    force: &'b mut SolidCorners<Pack>,
}

impl Work for BlockForces<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Self { block, rows, displacement, mirrored, history, energy, force } = self;
        for chunk in 0..LANES / S::WIDTH {
            let block = SolidBlock { constants: black_box(block.constants), ..block };
            let mut corners = solid_corners(simd, chunk, &rows, displacement, mirrored);
            solid_force(simd, chunk, &block, &mut corners, black_box(&mut *history), energy);
            for corner in 0..8 {
                for i in 0..3 {
                    simd.store(corners[corner][i], &mut force[corner][i], chunk);
                }
            }
        }
    }
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
