//! The forces of the cells of a solid, of a row of cells block by block.

use core::hint::black_box;

use crate::element::{ElementEnergy, SolidBlock, SolidConstants, SolidCorners, solid_force};
use crate::mesh::TETRAHEDRA;
use crate::model::Constants;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Work};
use crate::state::{solid_corners, subtract_from_row};
use crate::step::solid_rows::CellRow;

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

    /// Takes the forces of a row of cells from those of the nodes about it, block by block; advances its history. The energies of
    /// the row.
    pub fn take_forces(&self, row: CellRow) -> ElementEnergy {
        let CellRow { place, force: mut nodes, history } = row;
        let constants = self.constants;
        let (grid, laws) = (&constants.grid, constants.laws_of_row(place[0]));
        let (per_row, first) = (grid.blocks_per_row(), place[0] * grid.n_w + place[1]);
        let share = (TETRAHEDRA * constants.solid_history_packs).max(1);
        let blocks = self.blocks.get(first * per_row..(first + 1) * per_row).unwrap_or_default();
        let mut energy = ElementEnergy::ZERO;
        // Written over by every block, so that none has to fill it first.
        let mut force = [[ZERO; 3]; 8];
        for (at, (block, history)) in blocks.iter().zip(history.chunks_exact_mut(share)).enumerate() {
            let mirrored = grid.mirrored(at);
            self.set.run(BlockForces {
                block: SolidBlock { laws, constants: block },
                rows: grid.solid_rows(place, at),
                displacement: self.displacement,
                mirrored: mirrored.as_ref(),
                history,
                energy: &mut energy,
                force: &mut force,
                nodes: &mut nodes,
                first: at * LANES,
            });
        }
        energy
    }
}

/// Takes the forces of the cells of a block from those of its nodes, as work for an instruction set: the one copy of the element loop.
struct BlockForces<'b, 'n> {
    block: SolidBlock<'b>,
    rows: [usize; 4],
    displacement: [&'b [Real]; 3],
    mirrored: Option<&'b Pack>,
    history: &'b mut [Pack],
    energy: &'b mut ElementEnergy,
    /// On the corners of the cells, N.
    force: &'b mut SolidCorners<Pack>,
    /// Forces of the four rows of nodes along x, y and z, N, and the first node of the block in them.
    nodes: &'b mut [[&'n mut [Real]; 3]; 4],
    first: usize,
}

impl Work for BlockForces<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Self { block, rows, displacement, mirrored, history, energy, force, nodes, first } = self;
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
        for (place, nodes) in nodes.iter_mut().enumerate() {
            for (i, row) in nodes.iter_mut().enumerate() {
                subtract_from_row(
                    simd,
                    row,
                    first,
                    [&force[(2 * place) % 8][i], &force[(2 * place + 1) % 8][i]],
                    mirrored,
                );
            }
        }
    }
}
