//! The arrays of the nodes.

use crate::element::Corners;
use crate::model::split_row;
use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};

/// The arrays of the nodes, rows of [`Grid::stride`] from the core to the surface.
pub(crate) struct StateNodes<'a> {
    /// Displacement along x, m.
    pub displacement_x: &'a mut [Real],
    /// Displacement along y, m.
    pub displacement_y: &'a mut [Real],
    /// Velocity along x half a step back, m/s.
    pub velocity_x: &'a mut [Real],
    /// Velocity along y half a step back, m/s.
    pub velocity_y: &'a mut [Real],
    /// Force of the step along x, N.
    pub force_x: &'a mut [Real],
    /// Force of the step along y, N.
    pub force_y: &'a mut [Real],
    /// Contact force on the surface nodes, downwards, N.
    pub contact_normal: &'a mut [Real],
    /// Friction force on the surface nodes, outwards, N.
    pub contact_tangential: &'a mut [Real],
}

impl StateNodes<'_> {
    /// Displacements of the rows of nodes below and above the block whose first nodes are `first`.
    #[inline(always)]
    pub(crate) fn rows(&self, [lower, upper]: [usize; 2]) -> Rows<'_> {
        let (x, y) = (&*self.displacement_x, &*self.displacement_y);
        [[span(x, lower), span(y, lower)], [span(x, upper), span(y, upper)]]
    }

    /// Takes the forces of the cells of a block from their corners.
    #[inline(always)]
    pub(crate) fn subtract_force<S: Simd>(&mut self, simd: S, [lower, upper]: [usize; 2], force: &Corners<Pack>) {
        let [c0, c1, c2, c3] = force;
        for i in 0..2 {
            let row = if i == 0 { &mut *self.force_x } else { &mut *self.force_y };
            subtract_ends(simd, row, lower, &c0[i], &c1[i]);
            subtract_ends(simd, row, upper, &c3[i], &c2[i]);
        }
    }
}

/// Numbers at the nodes of a row of cells of a block.
type Span = [Real; LANES + 1];
/// Two numbers at the nodes below and above the cells of a block.
pub(crate) type Rows<'r> = [[&'r Span; 2]; 2];

#[inline(always)]
fn span(row: &[Real], start: usize) -> &Span {
    row.get(start..).and_then(|tail| tail.first_chunk()).unwrap_or(&[0.0; LANES + 1])
}

/// The numbers at the corners of neighbouring cells of a block.
#[inline(always)]
pub(crate) fn corners<S: Simd>(simd: S, chunk: usize, rows: &Rows) -> Corners<S::Vector> {
    let mut corners = [[simd.splat(0.0); 2]; 4];
    for i in 0..2 {
        let ([left @ .., _], [_, right @ ..]) = (rows[0][i], rows[0][i]);
        corners[0][i] = simd.load(left, chunk);
        corners[1][i] = simd.load(right, chunk);
        let ([left @ .., _], [_, right @ ..]) = (rows[1][i], rows[1][i]);
        corners[2][i] = simd.load(right, chunk);
        corners[3][i] = simd.load(left, chunk);
    }
    corners
}

/// Subtracts from the numbers of a row of nodes at the left ends of the cells of a block, then at the right ends, which are
/// one place on. Without a store between: a processor is late to read what two stores have just written in parts.
#[inline(always)]
fn subtract_ends<S: Simd>(simd: S, row: &mut [Real], start: usize, left: &Pack, right: &Pack) {
    let Some(span) = row.get_mut(start..).and_then(|tail| tail.first_chunk_mut::<{ LANES + 1 }>()) else { return };
    let [lane @ .., last] = span;
    let mut before = simd.splat(0.0);
    for chunk in 0..LANES / S::WIDTH {
        let of_right = simd.load(right, chunk);
        let rest = simd.load(lane, chunk) - simd.load(left, chunk);
        simd.store(rest - of_right.shift(before), lane, chunk);
        before = of_right;
    }
    *last -= right[LANES - 1];
}

impl<'a> StateNodes<'a> {
    /// Cuts `memory` into rows of `n` numbers, one per node, and two of `surface`; none if it is too short.
    #[inline(always)]
    pub(crate) fn cut(mut memory: &'a mut [Real], n: usize, surface: usize) -> Option<Self> {
        let mut row = |n| split_row(&mut memory, n);
        Some(Self {
            displacement_x: row(n)?,
            displacement_y: row(n)?,
            velocity_x: row(n)?,
            velocity_y: row(n)?,
            force_x: row(n)?,
            force_y: row(n)?,
            contact_normal: row(surface)?,
            contact_tangential: row(surface)?,
        })
    }

    /// Every array, in the order of storage.
    pub(crate) fn arrays_mut(&mut self) -> [&mut [Real]; 8] {
        [
            self.displacement_x,
            self.displacement_y,
            self.velocity_x,
            self.velocity_y,
            self.force_x,
            self.force_y,
            self.contact_normal,
            self.contact_tangential,
        ]
    }
}
