//! The forces of the cells of a solid, row by row and block by block.

use core::hint::black_box;

use crate::element::{ElementEnergy, SolidBlock, SolidConstants, SolidCorners, solid_force};
use crate::mesh::TETRAHEDRA;
use crate::model::Constants;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Work};
use crate::state::solid_corners;

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
