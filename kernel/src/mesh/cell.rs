//! Corners of a cell, of its two triangles, and of its tetrahedra.

use crate::mesh::Grid;

/// Offsets (u, v) of a cell's corners.
pub const CORNERS: [(usize, usize); 4] = [(0, 0), (1, 0), (1, 1), (0, 1)];

/// Tetrahedra of a cell of a solid.
pub const TETRAHEDRA: usize = 6;

/// The tetrahedra of a cell of a solid (Kuhn 1960): each goes from the corner nearest to the centre line, to z = 0 and to the
/// surface to the opposite one, along the row, across the rows and along z in one of the six orders.
///
/// The faces of neighbours match without a change from cell to cell, and those on the other side of the centre line or of z = 0 are
/// mirrored. All diagonals fall, as in axisymmetric cells: in a dome the volume of a cell depends on the diagonals of its faces.
/// In its squares about the centre, the diagonal of a corner divides an angle of 180 degrees.
pub const PATHS: [[usize; 3]; TETRAHEDRA] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Corners of the two triangles of cell (u, v).
///
/// Diagonals alternate in plane strain, and the left half of a full section mirrors the right. In an axisymmetric cell the
/// hoop strain of the mean dilatation depends on the diagonal, so that alternating diagonals would excite a checkerboard
/// of the pressure near incompressibility: there all diagonals fall.
pub fn triangles(grid: &Grid, u: usize, v: usize) -> [[usize; 3]; 2] {
    let diagonal = if grid.axisymmetric {
        false
    } else if u >= grid.centre {
        (u - grid.centre + v).is_multiple_of(2)
    } else {
        !(grid.centre - 1 - u + v).is_multiple_of(2)
    };
    if diagonal { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] }
}
