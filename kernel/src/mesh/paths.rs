//! The tetrahedra of a cell of a solid.

/// Tetrahedra of a cell of a solid.
pub const TETRAHEDRA: usize = 6;

/// The tetrahedra of a cell of a solid (Kuhn 1960): each goes from the corner nearest to the centre line, to z = 0 and to the
/// surface to the opposite one, along the row, across the rows and along z in one of the six orders.
///
/// The faces of neighbours match without a change from cell to cell, and those on the other side of the centre line or of z = 0 are
/// mirrored. All diagonals fall, as in axisymmetric cells: in a dome the volume of a cell depends on the diagonals of its faces.
/// In its squares about the centre, the diagonal of a corner divides an angle of 180 degrees.
pub const PATHS: [[usize; 3]; TETRAHEDRA] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
