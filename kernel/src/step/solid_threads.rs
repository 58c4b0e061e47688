//! Forces, monitor and limit of a solid on several cores (feature `threads`). No number depends on how many there are.

use alloc::vec::Vec;

use rayon::prelude::*;

use crate::element::ElementEnergy;
use crate::mesh::Grid;
use crate::step::solid_cells::Cells;
use crate::step::solid_rows::CellRow;

/// The fewest blocks for which waking other cores pays.
const MIN_BLOCKS: usize = 64;

/// Whether the mesh is that of a solid and large enough, and there is another core.
pub(super) fn pays(grid: &Grid) -> bool {
    grid.is_solid() && grid.n_block() >= MIN_BLOCKS && rayon::current_num_threads() > 1
}

/// Does `work`, in which steps are made, on one of the cores that share in them: from outside, each part of each step would have to
/// be handed over to them and waited for.
pub(crate) fn among_threads<R: Send>(grid: &Grid, work: impl FnOnce() -> R + Send) -> R {
    if pays(grid) { rayon::scope(|_| work()) } else { work() }
}

/// Takes the forces of `rows` of cells that have no node in common, and adds up their energies in the order of the rows.
pub(super) fn take_forces<'s>(cells: &Cells, rows: impl Iterator<Item = CellRow<'s>>, energy: &mut ElementEnergy) {
    let rows: Vec<CellRow> = rows.collect();
    let of_rows: Vec<ElementEnergy> = rows.into_par_iter().map(|row| cells.take_forces(row)).collect();
    of_rows.iter().for_each(|of_row| energy.add(of_row));
}

/// Whether `found(part, size)` is true of a part of a work of so many pieces; there is a part for each core, of this size.
pub(super) fn any(pieces: usize, found: impl Fn(usize, usize) -> bool + Send + Sync) -> bool {
    let size = pieces.div_ceil(rayon::current_num_threads()).max(1);
    (0..pieces.div_ceil(size)).into_par_iter().any(|part| found(part, size))
}

/// What each of the first `count` numbers gives, in their order.
pub(super) fn each<R: Send>(count: usize, of: impl Fn(usize) -> R + Send + Sync) -> Vec<R> {
    (0..count).into_par_iter().map(of).collect()
}
