//! What the element loop knows of the tetrahedra of a block of cells of a solid, as packs in memory of plain numbers.

use nalgebra::{Matrix3, Vector3};

use crate::material::MaterialModel;
use crate::mesh::{PATHS, TETRAHEDRA};
use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;

/// Packs of a tetrahedron of each cell: dF along its three edges, and V0.
pub(crate) const TETRAHEDRON_PACKS: usize = 10;
/// Packs of a block: of its tetrahedra, and 1/V0 of the cells.
pub(crate) const SOLID_BLOCK_PACKS: usize = TETRAHEDRA * TETRAHEDRON_PACKS + 1;
/// Place of 1/V0 of the cells.
pub(crate) const INVERSE_VOLUME: usize = TETRAHEDRA * TETRAHEDRON_PACKS;
/// Place of V0 among the packs of a tetrahedron.
pub(crate) const VOLUME: usize = 9;

/// Constants of a block; all zero in padding.
pub(crate) type SolidConstants = [Pack; SOLID_BLOCK_PACKS];

/// Vectors at the corners of neighbouring cells, from the corner at the start of all [`PATHS`] to the one at their end: bit 0 of the
/// place is along the row, bit 1 across the rows, bit 2 along z.
pub(crate) type SolidCorners<V> = [[V; 3]; 8];

/// What does not change in a block of cells of a solid.
#[derive(Clone, Copy)]
pub(crate) struct SolidBlock<'m> {
    /// Material model of its layer.
    pub laws: &'m MaterialModel,
    /// Its tetrahedra at rest.
    pub constants: &'m SolidConstants,
}

/// Corners of a path: the ends of its edges.
#[inline(always)]
pub(crate) const fn path_corners([a, b, _]: [usize; 3]) -> [usize; 4] {
    [0, 1 << a, (1 << a) | (1 << b), 7]
}

/// Writes the cell with these corners at rest, m, into lane `l`; gives its volume, m3, or the first tetrahedron without one.
/// `handed` is 1 or, of a mirrored cell, -1.
pub(crate) fn store_cell(
    corners: &[Vector3<Real>; 8],
    handed: Real,
    l: usize,
    constants: &mut SolidConstants,
) -> Result<Real, usize> {
    let mut volume = 0.0;
    for (t, (path, packs)) in PATHS.iter().zip(constants.as_chunks_mut::<TETRAHEDRON_PACKS>().0).enumerate() {
        let nodes = path_corners(*path).map(|corner| corners[corner % 8]);
        let edges = Matrix3::from_columns(&[nodes[1] - nodes[0], nodes[2] - nodes[1], nodes[3] - nodes[2]]);
        let even = path[1] == (path[0] + 1) % 3;
        let own = edges.determinant() * if even { handed } else { -handed } / 6.0;
        let Some(gradients) = edges.try_inverse().filter(|_| own > 0.0) else { return Err(t) };
        for edge in 0..3 {
            for j in 0..3 {
                packs[(3 * edge + j) % TETRAHEDRON_PACKS][l % LANES] = gradients[(edge, j)];
            }
        }
        packs[VOLUME][l % LANES] = own;
        volume += own;
    }
    constants[INVERSE_VOLUME][l % LANES] = 1.0 / volume;
    Ok(volume)
}
