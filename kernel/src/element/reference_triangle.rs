//! Triangles at rest: gradients, volume, hoop weights.

use crate::element::TriangleConstants;
use crate::mesh::out_of_plane;
use crate::number::real::Real;
use crate::scenario::Scenario;

/// Constants of one triangle of one cell, before they are put into lanes.
pub(crate) struct Triangle {
    /// dN_a/dX of the four corners, 1/m.
    pub gradient: [[Real; 2]; 4],
    /// V0, m3.
    pub volume: Real,
    /// 1/(3 R) for the triangle's corners, 1/m.
    pub hoop: [Real; 4],
    /// 1/(2 A0), 1/m2.
    pub inverse_double_area: Real,
}

impl Triangle {
    /// The triangle of three of a cell's four `corners`, m.
    pub fn new(scenario: &Scenario, corners: &[[Real; 2]; 4], nodes: [usize; 3]) -> Self {
        // Corners are numbered 0 to 3; the remainder changes nothing and leaves no bound to check.
        let [a, b, c] = nodes.map(|node| corners[node % 4]);
        // The corners run counter-clockwise, so this is positive.
        let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let radius = (a[0] + b[0] + c[0]) / 3.0;
        let mut triangle = Self {
            gradient: [[0.0; 2]; 4],
            volume: 0.5 * double_area * out_of_plane(scenario, radius),
            hoop: [0.0; 4],
            inverse_double_area: 1.0 / double_area,
        };
        for (node, (p, q)) in nodes.into_iter().zip([(b, c), (c, a), (a, b)]) {
            triangle.gradient[node % 4] = [(p[1] - q[1]) / double_area, (q[0] - p[0]) / double_area];
            triangle.hoop[node % 4] = 1.0 / (3.0 * radius);
        }
        triangle
    }

    /// Writes the triangle into lane `l`.
    pub fn store(&self, l: usize, constants: &mut TriangleConstants, patch_volume: Real) {
        // Moving the end of an edge moves the corners beyond it, too: those on the right, those on top.
        for j in 0..2 {
            constants.shape_gradient[0][j][l] = self.gradient[1][j] + self.gradient[2][j];
            constants.shape_gradient[1][j][l] = self.gradient[2][j] + self.gradient[3][j];
        }
        constants.reference_volume[l] = self.volume;
        constants.inverse_double_area[l] = self.inverse_double_area;
        constants.volume_fraction[l] = self.volume / patch_volume;
    }
}
