//! Triangles at rest: gradients, volume, hoop weights.

use nalgebra::{Matrix2x4, Point2, Vector2, Vector4};

use crate::element::TriangleConstants;
use crate::mesh::out_of_plane;
use crate::number::real::Real;
use crate::scenario::Scenario;

/// Constants of one triangle of one cell, before they are put into lanes.
pub(crate) struct Triangle {
    /// dN_a/dX of the four corners, shape (2 x 4), 1/m.
    pub gradient: Matrix2x4<Real>,
    /// V0, m3.
    pub volume: Real,
    /// 1/(3 R) for the triangle's corners, 1/m.
    pub hoop: Vector4<Real>,
    /// 1/(2 A0), 1/m2.
    pub inverse_double_area: Real,
}

impl Triangle {
    /// The triangle of three of a cell's four `corners`, m.
    pub fn new(scenario: &Scenario, corners: &[Point2<Real>; 4], nodes: [usize; 3]) -> Self {
        // Corners are numbered 0 to 3; the remainder changes nothing and leaves no bound to check.
        let [a, b, c] = nodes.map(|node| corners[node % 4]);
        // The corners run counter-clockwise, so this is positive.
        let double_area = (b - a).perp(&(c - a));
        let radius = (a.x + b.x + c.x) / 3.0;
        let (mut gradient, mut hoop) = (Matrix2x4::zeros(), Vector4::zeros());
        for (node, opposite) in nodes.into_iter().zip([c - b, a - c, b - a]) {
            gradient.set_column(node % 4, &(Vector2::new(-opposite.y, opposite.x) / double_area));
            hoop[node % 4] = 1.0 / (3.0 * radius);
        }
        let volume = 0.5 * double_area * out_of_plane(scenario, radius);
        Self { gradient, volume, hoop, inverse_double_area: 1.0 / double_area }
    }

    /// Writes the triangle into lane `l`.
    pub fn store(&self, l: usize, constants: &mut TriangleConstants, patch_volume: Real) {
        // Moving the end of an edge moves the corners beyond it, too: those on the right, those on top.
        for j in 0..2 {
            constants.shape_gradient[0][j][l] = self.gradient[(j, 1)] + self.gradient[(j, 2)];
            constants.shape_gradient[1][j][l] = self.gradient[(j, 2)] + self.gradient[(j, 3)];
        }
        constants.reference_volume[l] = self.volume;
        constants.inverse_double_area[l] = self.inverse_double_area;
        constants.volume_fraction[l] = self.volume / patch_volume;
    }
}
