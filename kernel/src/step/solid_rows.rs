//! The rows of cells of a solid by four kinds, of which those of one kind have no node in common.

use crate::mesh::Grid;
use crate::number::pack::Pack;
use crate::number::real::Real;

/// Every second row from the core and every second slice, beginning with the first or the second of either.
pub(super) const KINDS: [[usize; 2]; 4] = [[0, 0], [0, 1], [1, 0], [1, 1]];

/// A row of cells: what its forces change.
pub(super) struct CellRow<'s> {
    /// Row from the core and slice.
    pub place: [usize; 2],
    /// The four rows of nodes about it in the order of [`crate::mesh::Grid::solid_rows`], of each the forces along x, y and z, N.
    pub force: [[&'s mut [Real]; 3]; 4],
    /// Histories of its tetrahedra.
    pub history: &'s mut [Pack],
}

/// The rows of cells of one kind, with their part of the nodal `force` along x, y and z and of the `history`, of which a row has
/// `share` packs.
pub(super) fn rows_of_kind<'s>(
    grid: &'s Grid,
    [first_row, first_slice]: [usize; 2],
    force: [&'s mut [Real]; 3],
    history: &'s mut [Pack],
    share: usize,
) -> impl Iterator<Item = CellRow<'s>> {
    let plane = grid.plane().max(1);
    let cells = every_second(history, share * grid.n_w, first_row);
    let [x, y, z] = force.map(|force| force.get_mut(first_row * plane..).unwrap_or_default());
    let nodes = x.chunks_exact_mut(2 * plane).zip(y.chunks_exact_mut(2 * plane)).zip(z.chunks_exact_mut(2 * plane));
    nodes.zip(cells).enumerate().flat_map(move |(number, (((x, y), z), history))| {
        let row = first_row + 2 * number;
        let [[x_low, x_up], [y_low, y_up], [z_low, z_up]] =
            [x, y, z].map(|planes| planes.split_at_mut_checked(plane).unwrap_or_default().into());
        let lower = slices(grid, first_slice, [x_low, y_low, z_low]);
        let upper = slices(grid, first_slice, [x_up, y_up, z_up]);
        let cells = every_second(history, share, first_slice);
        lower.zip(upper).zip(cells).enumerate().map(move |(number, ((lower, upper), history))| {
            let slice = first_slice + 2 * number;
            let ([low_here, low_next], [up_here, up_next]) = (lower, upper);
            // The slices before the middle one are mirrored.
            let force = if slice < grid.centre_w {
                [up_next, low_next, up_here, low_here]
            } else {
                [up_here, low_here, up_next, low_next]
            };
            CellRow { place: [row, slice], force, history }
        })
    })
}

/// The first of every two parts of `share` packs each, beginning with the `first`-th part.
fn every_second(history: &mut [Pack], share: usize, first: usize) -> impl Iterator<Item = &mut [Pack]> {
    let share = share.max(1);
    let rest = history.get_mut(first * share..).unwrap_or_default();
    rest.chunks_mut(2 * share).filter_map(move |pair| pair.get_mut(..share))
}

/// The rows of nodes on both sides of every second slice of cells, from the `first`-th on, of a plane of nodes.
fn slices<'s>(
    grid: &Grid,
    first: usize,
    plane: [&'s mut [Real]; 3],
) -> impl Iterator<Item = [[&'s mut [Real]; 3]; 2]> + use<'s> {
    let stride = grid.stride().max(1);
    let [x, y, z] = plane.map(|row| row.get_mut(first * stride..).unwrap_or_default().chunks_exact_mut(2 * stride));
    x.zip(y).zip(z).map(move |((x, y), z)| {
        let [(x, next_x), (y, next_y), (z, next_z)] =
            [x, y, z].map(|pair| pair.split_at_mut_checked(stride).unwrap_or_default());
        [[x, y, z], [next_x, next_y, next_z]]
    })
}
