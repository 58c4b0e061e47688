//! Corners of a cell, and of its two triangles.

use crate::mesh::Grid;

/// Offsets (u, v) of a cell's corners.
pub const CORNERS: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];

/// Corners of the two triangles of cell (u, v).
///
/// Diagonals alternate in plane strain, and the left half of a full section mirrors the right. In an axisymmetric cell the
/// hoop strain of the mean dilatation depends on the diagonal, so that alternating diagonals would excite a checkerboard
/// of the pressure near incompressibility: there all diagonals fall. Of a solid they are the faces of its cells in the plane z = 0.
pub fn triangles(grid: &Grid, u: usize, v: usize) -> [[usize; 3]; 2] {
    let diagonal = if grid.is_solid() {
        u < grid.centre
    } else if grid.axisymmetric {
        false
    } else if u >= grid.centre {
        (u - grid.centre + v).is_multiple_of(2)
    } else {
        !(grid.centre - 1 - u + v).is_multiple_of(2)
    };
    if diagonal { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] }
}
