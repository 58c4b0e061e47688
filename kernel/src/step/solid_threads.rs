//! Internal forces of a solid on several cores (feature `threads`): first all rows of cells, then all rows of nodes. No number
//! depends on how many there are.

use alloc::vec;
use alloc::vec::Vec;

use rayon::prelude::*;

use crate::element::{ElementEnergy, SolidCorners};
use crate::model::Constants;
use crate::number::pack::{Pack, ZERO};
use crate::number::real::Real;
use crate::state::subtract_from_row;
use crate::step::solid_cells::Cells;

/// The fewest blocks for which waking other cores pays.
const MIN_BLOCKS: usize = 64;

/// Whether the mesh is large enough, and there is another core.
pub(super) fn pays(constants: &Constants) -> bool {
    constants.grid.n_block() >= MIN_BLOCKS && rayon::current_num_threads() > 1
}

/// Takes the internal forces from the nodal `force` along x, y and z, and adds up the energies.
pub(super) fn forces(cells: &Cells, force: [&mut [Real]; 3], history: &mut [Pack], energy: &mut ElementEnergy) {
    let grid = &cells.constants.grid;
    let per_row = grid.blocks_per_row().max(1);
    let mut corners: Vec<SolidCorners<Pack>> = vec![[[ZERO; 3]; 8]; grid.n_block()];
    let rows = history.par_chunks_exact_mut(cells.history_of_row()).zip(corners.par_chunks_exact_mut(per_row));
    let of_rows = rows.enumerate().map(|(number, (history, corners))| {
        let mut of_row = ElementEnergy::ZERO;
        cells.row(number, history, &mut of_row, |block, force| {
            if let Some(place) = corners.get_mut(block) {
                *place = *force;
            }
        });
        of_row
    });
    let of_rows: Vec<ElementEnergy> = of_rows.collect();
    of_rows.iter().for_each(|of_row| energy.add(of_row));
    let [x, y, z] = force;
    let stride = grid.stride();
    let rows = x.par_chunks_exact_mut(stride).zip(y.par_chunks_exact_mut(stride)).zip(z.par_chunks_exact_mut(stride));
    rows.enumerate().for_each(|(number, ((x, y), z))| gather(cells, &corners, number, [x, y, z]));
}

/// Takes the forces of the cells about the `number`-th row of nodes, in index order.
fn gather(cells: &Cells, corners: &[SolidCorners<Pack>], number: usize, force: [&mut [Real]; 3]) {
    let grid = &cells.constants.grid;
    let per_row = grid.blocks_per_row();
    let [v, w] = [number / grid.node_slices(), number % grid.node_slices()];
    let [x, y, z] = force;
    for (down, back) in [(1, 1), (1, 0), (0, 1), (0, 0)] {
        let (Some(row), Some(slice)) = (v.checked_sub(down), w.checked_sub(back)) else { continue };
        if row >= grid.n_v || slice >= grid.n_w {
            continue;
        }
        // The row of nodes is above the cells or below them, and nearer to z = 0 or farther.
        let across = usize::from(down == 0);
        let along = if slice < grid.centre_w { usize::from(back == 0) } else { usize::from(back == 1) };
        for block in 0..per_row {
            let Some(of_block) = corners.get((row * grid.n_w + slice) * per_row + block) else { continue };
            let mirrored = grid.mirrored(block);
            subtract_from_row(block, [&mut *x, &mut *y, &mut *z], of_block, across + 2 * along, mirrored.as_ref());
        }
    }
}
