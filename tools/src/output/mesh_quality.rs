//! How far the elements of a mesh at rest are from regular ones.
//!
//! Source: the mean ratio of A. Liu and B. Joe, Relationship between tetrahedron shape measures, BIT Numerical Mathematics 34
//! (1994): of a tetrahedron of volume V with edges l, 12 (3 V)^(2/3) / sum l^2; of a triangle of area A, 4 sqrt(3) A / sum l^2.

use softanvil_kernel::Scenario;
use softanvil_kernel::mesh::{CORNERS, Grid, reference_position, solid_position, tetrahedra, triangles};

/// Mean ratios, 1: that of a regular element is 1, of a flat one 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshQuality {
    /// Of the element that is farthest from a regular one.
    pub smallest: f64,
    /// Of all elements.
    pub mean: f64,
}

/// Of the elements of `scenario` on its `grid`.
pub fn mesh_quality(scenario: &Scenario, grid: &Grid) -> MeshQuality {
    let (mut smallest, mut sum) = (f64::INFINITY, 0.0);
    let mut add = |ratio: f64| {
        smallest = smallest.min(ratio);
        sum += ratio;
    };
    let at = |u: usize, v: usize| reference_position(scenario, grid, u, v);
    for (u, v) in (0..grid.n_v).flat_map(|v| (0..grid.n_u).map(move |u| (u, v))) {
        if grid.is_solid() {
            for corners in (0..grid.n_w).filter(|w| grid.has_cell(u, v, *w)).flat_map(|w| tetrahedra(grid, [u, v, w])) {
                add(of_tetrahedron(corners.map(|node| solid_position(scenario, grid, node))));
            }
        } else if grid.has_cell(u, v, 0) {
            let lower = grid.node_row(v);
            for corners in triangles(grid, u, v) {
                add(of_triangle(corners.map(|corner| at(u + CORNERS[corner].0, lower + CORNERS[corner].1))));
            }
        }
    }
    MeshQuality { smallest, mean: sum / grid.n_elem() as f64 }
}

fn of_triangle(corners: [[f64; 2]; 3]) -> f64 {
    let [[ax, ay], [bx, by], [cx, cy]] = corners;
    let area = 0.5 * ((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)).abs();
    4.0 * 3.0_f64.sqrt() * area / squares_of_edges(&corners)
}

fn of_tetrahedron(corners: [[f64; 3]; 4]) -> f64 {
    let [a, b, c] = [1, 2, 3].map(|i| [0, 1, 2].map(|k| corners[i][k] - corners[0][k]));
    let product =
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    12.0 * (0.5 * product.abs()).cbrt().powi(2) / squares_of_edges(&corners)
}

/// Sum of the squares of the lengths of all edges.
fn squares_of_edges<const D: usize>(corners: &[[f64; D]]) -> f64 {
    let pairs = corners.iter().enumerate().flat_map(|(i, a)| corners[..i].iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;
    use softanvil_kernel::scenario::{Formulation, Shape};

    #[test]
    fn regular_elements_have_one_and_flat_ones_nothing() {
        let height = 0.75_f64.sqrt();
        assert!((of_triangle([[0.0, 0.0], [1.0, 0.0], [0.5, height]]) - 1.0).abs() < 1e-14);
        assert_eq!(of_triangle([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]), 0.0);
        // Every other corner of a cube.
        let regular = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
        assert!((of_tetrahedron(regular) - 1.0).abs() < 1e-14);
        assert_eq!(of_tetrahedron([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]), 0.0);
    }

    /// Cells of a block are cubes; a path along the edges of one has three edges, two diagonals of faces and one of the cube.
    #[test]
    fn every_element_of_a_block_is_that_of_a_cube() {
        let mut scenario = preset::study();
        scenario.geometry.shape = Shape::Block;
        (scenario.geometry.block_width, scenario.geometry.length) = (0.03, 0.03);
        (scenario.layers[0].thickness, scenario.mesh.element_size) = (0.015, 0.003);
        for (formulation, ratio) in [
            (Formulation::PlaneStrain, 4.0 * 3.0_f64.sqrt() * 0.5 / 4.0),
            (Formulation::Solid, 12.0 * 0.5_f64.cbrt().powi(2) / 10.0),
        ] {
            scenario.geometry.formulation = formulation;
            let quality = mesh_quality(&scenario, &Grid::new(&scenario).unwrap());
            assert!((quality.smallest - ratio).abs() < 1e-6 && (quality.mean - ratio).abs() < 1e-6, "{quality:?}");
        }
    }
}
