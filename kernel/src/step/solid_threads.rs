//! Forces, motion, monitor and limit of a solid on several cores (feature `threads`). No number depends on how many there are.

use alloc::vec::Vec;

use rayon::prelude::*;

use crate::mesh::Grid;

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

/// Does both of these at once, if that pays.
pub(super) fn both<A: Send, B: Send>(
    grid: &Grid,
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    if pays(grid) { rayon::join(one, other) } else { (one(), other()) }
}

/// What each of `parts` gives, in their order.
pub(super) fn each<T: Send, R: Send>(parts: impl Iterator<Item = T>, of: impl Fn(T) -> R + Send + Sync) -> Vec<R> {
    let parts: Vec<T> = parts.collect();
    parts.into_par_iter().map(of).collect()
}

/// Whether `found(part, size)` is true of a part of a work of so many pieces; there is a part for each core, of this size.
pub(super) fn any(pieces: usize, found: impl Fn(usize, usize) -> bool + Send + Sync) -> bool {
    let size = pieces.div_ceil(rayon::current_num_threads()).max(1);
    (0..pieces.div_ceil(size)).into_par_iter().any(|part| found(part, size))
}
