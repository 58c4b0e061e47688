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
    let rows = (first_row..grid.n_v).step_by(2);
    let nodes = planes_about(grid, rows.clone(), force);
    rows.zip(nodes).zip(cells).flat_map(move |((row, planes), history)| {
        let [[x_low, x_up], [y_low, y_up], [z_low, z_up]] =
            planes.map(|planes| planes.split_at_mut_checked(plane).unwrap_or_default().into());
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

/// The two planes of nodes about each of these `rows` of cells, every second one, of each of three numbers of the nodes.
fn planes_about<'s>(
    grid: &Grid,
    rows: impl Iterator<Item = usize>,
    mut numbers: [&'s mut [Real]; 3],
) -> impl Iterator<Item = [&'s mut [Real]; 3]> {
    let plane = grid.plane().max(1);
    let mut passed = 0;
    rows.map(move |row| {
        // Layers that are not bonded have a row of nodes more between the cells.
        let first = grid.node_row(row) * plane;
        let planes = numbers.each_mut().map(|rest| {
            let (_, from) = core::mem::take(rest).split_at_mut_checked(first - passed).unwrap_or_default();
            let (planes, next) = from.split_at_mut_checked(2 * plane).unwrap_or_default();
            *rest = next;
            planes
        });
        passed = first + 2 * plane;
        planes
    })
}

/// Two of these, and never nothing, which would be no size of a chunk.
fn pair_of(numbers: usize) -> usize {
    (2 * numbers).max(1)
}

/// The first of every two parts of `share` packs each, beginning with the `first`-th part.
fn every_second(history: &mut [Pack], share: usize, first: usize) -> impl Iterator<Item = &mut [Pack]> {
    let share = share.max(1);
    let rest = history.get_mut(first * share..).unwrap_or_default();
    rest.chunks_mut(pair_of(share)).filter_map(move |pair| pair.get_mut(..share))
}

/// The rows of nodes on both sides of every second slice of cells, from the `first`-th on, of a plane of nodes.
fn slices<'s>(
    grid: &Grid,
    first: usize,
    plane: [&'s mut [Real]; 3],
) -> impl Iterator<Item = [[&'s mut [Real]; 3]; 2]> + use<'s> {
    let stride = grid.stride().max(1);
    let [x, y, z] =
        plane.map(|row| row.get_mut(first * stride..).unwrap_or_default().chunks_exact_mut(pair_of(stride)));
    x.zip(y).zip(z).map(move |((x, y), z)| {
        let [(x, next_x), (y, next_y), (z, next_z)] =
            [x, y, z].map(|pair| pair.split_at_mut_checked(stride).unwrap_or_default());
        [[x, y, z], [next_x, next_y, next_z]]
    })
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::vec::Vec;

    use super::*;
    use crate::scenario::preset::{self, study};
    use crate::scenario::{Body, Formulation, Layer, LayerInterface, Symmetry};

    #[test]
    fn every_row_of_cells_comes_once_with_its_nodes_and_its_history() {
        for symmetry in [Symmetry::Quarter, Symmetry::Half, Symmetry::Full] {
            for size in [3e-3, 4e-3, 5e-3, 8e-3, 15e-3, 50e-3] {
                let mut scenario = study();
                scenario.geometry.formulation = Formulation::Solid;
                scenario.geometry.symmetry = symmetry;
                scenario.mesh.element_size = size;
                assert_rows(&Grid::new(&scenario).unwrap());
                // Of layers of odd and even rows of cells.
                for thickness in [3e-3, 8e-3] {
                    let (interface, width) = (LayerInterface::Separating, 20.0 * thickness);
                    let layer = Layer { interface, thickness, width, ..preset::spare_layer() };
                    scenario.layers.insert(1, layer).unwrap();
                }
                for body in [Body::Prism, Body::Revolved] {
                    scenario.geometry.body = body;
                    assert_rows(&Grid::new(&scenario).unwrap());
                }
            }
        }
    }

    /// Numbers that tell where they stand are handed out as they lie in memory.
    fn assert_rows(grid: &Grid) {
        const SHARE: usize = 3;
        let mut force: [Vec<Real>; 3] =
            core::array::from_fn(|i| (0..grid.n_node()).map(|node| (3 * node + i) as Real).collect());
        let mut history: Vec<Pack> = (0..SHARE * grid.n_v * grid.n_w).map(|pack| [pack as Real; 8]).collect();
        let mut seen = Vec::new();
        for kind in KINDS {
            let [x, y, z] = &mut force;
            for row in rows_of_kind(grid, kind, [x, y, z], &mut history, SHARE) {
                let [v, w] = row.place;
                for (nodes, first) in row.force.iter().zip(grid.solid_rows([v, w], 0)) {
                    for (i, along) in nodes.iter().enumerate() {
                        assert_eq!((along.len(), along[0]), (grid.stride(), (3 * first + i) as Real), "{v} {w}");
                    }
                }
                assert_eq!((row.history.len(), row.history[0][0]), (SHARE, (SHARE * (v * grid.n_w + w)) as Real));
                seen.push([v, w]);
            }
        }
        seen.sort_unstable();
        let all: Vec<[usize; 2]> = (0..grid.n_v).flat_map(|v| (0..grid.n_w).map(move |w| [v, w])).collect();
        assert_eq!(seen, all);
    }
}
