//! Where the nodes of a solid rest.

use crate::mesh::Grid;
use crate::mesh::columns::half_angle;
use crate::mesh::paths::{PATHS, TETRAHEDRA};
use crate::mesh::section::{height_over_core, reference_position};
use crate::mesh::slices::on_disc;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{Body, Scenario, Shape};

/// Position of the node in column `u`, row `v` and slice `w` at rest, m: x outwards, y upwards, z along the axis of a prism.
pub fn solid_position(scenario: &Scenario, grid: &Grid, [u, v, w]: [usize; 3]) -> [Real; 3] {
    match scenario.geometry.body {
        Body::Prism => {
            let [x, y] = reference_position(scenario, grid, u, v);
            let z = grid.slices.z(w.abs_diff(grid.centre_w));
            [x, y, if w < grid.centre_w { -z } else { z }]
        }
        Body::Revolved => {
            let [cos, sin, part] = on_disc(grid.across(u), grid.along(w));
            let depth = height_over_core(scenario, grid, v);
            let [radius, y] = match scenario.geometry.shape {
                Shape::Round => {
                    let (radius, angle) = (scenario.geometry.core_radius + depth, half_angle(scenario) * part);
                    [radius * math::sin(angle), radius * math::cos(angle)]
                }
                Shape::Block => [scenario.half_block_width() * part, depth],
            };
            [radius * cos, y, radius * sin]
        }
    }
}

/// Column, row and slice of the four corners of each tetrahedron of the cell in column `u`, row of cells `v` and slice `w`.
pub fn tetrahedra(grid: &Grid, [u, v, w]: [usize; 3]) -> [[[usize; 3]; 4]; TETRAHEDRA] {
    let corners = cell_nodes(grid, [u, v, w]);
    PATHS.map(|[a, b, _]| [0, 1 << a, (1 << a) | (1 << b), 7].map(|corner| corners[corner % 8]))
}

/// Column, row and slice of the corners of a cell in the order of its paths.
pub(crate) fn cell_nodes(grid: &Grid, [u, v, w]: [usize; 3]) -> [[usize; 3]; 8] {
    let lower = grid.node_row(v);
    core::array::from_fn(|corner| {
        let (along, across, slice) = (corner & 1, (corner >> 1) & 1, corner >> 2);
        let u = if u < grid.centre { u + 1 - along } else { u + along };
        let w = if w < grid.centre_w { w + 1 - slice } else { w + slice };
        [u, lower + 1 - across, w]
    })
}

#[cfg(all(test, feature = "pads", feature = "solid"))]
mod tests {
    use super::*;
    use crate::scenario::{Formulation, Layer, preset};

    #[test]
    fn a_cell_beside_a_pad_is_of_the_layer_below_it() {
        for body in [Body::Prism, Body::Revolved] {
            let mut scenario = preset::study();
            (scenario.geometry.formulation, scenario.geometry.body) = (Formulation::Solid, body);
            scenario.add_layer(Layer { thickness: 6e-3, width: 60e-3, ..preset::spare_layer() }).unwrap();
            let grid = Grid::new(&scenario).unwrap();
            let edge = grid.columns_of(1).end;
            assert_eq!(grid.surface_row(edge, 0), grid.layer_top[1]);
            assert_eq!(grid.surface_row_of_cell(edge - 1, 0), grid.layer_top[1]);
            assert_eq!(grid.surface_row_of_cell(edge, 0), grid.layer_top[0]);
            let beyond = if body == Body::Revolved { grid.layer_top[0] } else { grid.layer_top[1] };
            assert_eq!(grid.surface_row_of_cell(0, edge), beyond);
        }
    }
}
