//! What the element loop knows of the triangles of a block of cells.

use crate::material::MaterialModel;
use crate::number::pack::{Pack, ZERO};

/// Constants of the triangles of a block of cells; all zero in padding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellConstants {
    /// 1 where the diagonal runs from corner 0 to corner 2, 0 where it runs from corner 1 to corner 3.
    pub diagonal: Pack,
    /// First and second triangle of each cell: the first has the bottom edge, the second the top edge.
    pub triangle: [TriangleConstants; 2],
}

/// Constants of one triangle of each cell of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleConstants {
    /// dN/dX_j for the two edges that the triangle shares with its cell, shape (2 x 2), 1/m: the one along the row, then
    /// the one across. F = I + sum (difference of u along the edge, as x and y grow) (x) gradient.
    pub shape_gradient: [[Pack; 2]; 2],
    /// V0, m3.
    pub reference_volume: Pack,
    /// Part of the cell's volume.
    pub volume_fraction: Pack,
    /// 1/(2 A0), 1/m2.
    pub inverse_double_area: Pack,
}

/// Derivative of the hoop stretch with respect to the radial displacement of each corner, shape (2 x 4), 1/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoopConstants {
    /// 1/(3 R) for the corners of each triangle, R its centroid's radius.
    pub weight: [[Pack; 4]; 2],
}

impl CellConstants {
    /// Padding: no volume.
    pub const ZERO: Self = Self {
        diagonal: ZERO,
        triangle: [TriangleConstants {
            shape_gradient: [[ZERO; 2]; 2],
            reference_volume: ZERO,
            volume_fraction: ZERO,
            inverse_double_area: ZERO,
        }; 2],
    };
}

impl HoopConstants {
    /// Padding.
    pub const ZERO: Self = Self { weight: [[ZERO; 4]; 2] };
}

/// What does not change in a block of cells.
#[derive(Clone, Copy)]
pub struct Block<'m> {
    /// Material model of its layer.
    pub laws: &'m MaterialModel,
    /// Its triangles at rest.
    pub constants: &'m CellConstants,
    /// Hoop constants, if axisymmetric.
    pub hoop: Option<&'m HoopConstants>,
}

/// Differences of displacement along two edges of a triangle, shape (2 x 2), m: along the row, then across. Or the forces
/// that pull at their ends, N.
pub(crate) type Edges<V> = [[V; 2]; 2];

/// Displacements of the four corners of neighbouring cells, shape (4 x 2), m, or the forces on them, N.
pub type Corners<V> = [[V; 2]; 4];
