//! The arrays of the nodes.

use crate::element::Corners;
use crate::model::{Constants, NodeArrays, SolidArrays};
use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};

/// The arrays of the nodes, rows of [`crate::mesh::Grid::stride`] from the core to the surface, x before y: to be changed
/// (`&mut [Real]`) or to be read.
#[derive(Clone, Copy)]
pub(crate) struct StateNodes<R> {
    /// Displacement, m.
    pub displacement: [R; 2],
    /// Velocity half a step back, m/s.
    pub velocity: [R; 2],
    /// Force of the step, N.
    pub force: [R; 2],
    /// Contact force on the surface nodes, downwards, N, then friction on them, outwards.
    pub contact: [R; 2],
    /// Of every surface node under a face that is round or has edges, its depth in it at the end of the step without contact,
    /// m, the direction out of the face, to the right and downwards, and its mass, kg.
    pub rounding: R,
    /// Of every interface that is not bonded, from the core, the nodes above it, then those below it: a [`super::PairRow`]
    /// each, of a solid a [`super::SolidPairRow`].
    pub pairs: R,
    /// What only a solid has: [`super::SolidState`].
    pub solid: R,
}

impl<R> StateNodes<R> {
    /// The arrays that `row` gives by their `lengths`, in the order of storage; none if there is one that it does not give.
    #[inline(always)]
    pub(crate) fn of(lengths: &NodeArrays, mut row: impl FnMut(usize) -> Option<R>) -> Option<Self> {
        let NodeArrays { nodes: n, surface, rounding, pairs, solid } = *lengths;
        Some(Self {
            displacement: [row(n)?, row(n)?],
            velocity: [row(n)?, row(n)?],
            force: [row(n)?, row(n)?],
            contact: [row(surface)?, row(surface)?],
            rounding: row(rounding)?,
            pairs: row(pairs)?,
            solid: row(solid)?,
        })
    }

    /// Every array, in the order of storage.
    pub(crate) fn all(&mut self) -> [&mut R; 11] {
        let Self { displacement: [a, b], velocity: [c, d], force: [e, f], contact: [g, h], rounding, pairs, solid } =
            self;
        [a, b, c, d, e, f, g, h, rounding, pairs, solid]
    }
}

impl StateNodes<&mut [Real]> {
    /// The same, to be read.
    #[inline(always)]
    pub(crate) fn as_read(&self) -> StateNodes<&[Real]> {
        StateNodes {
            displacement: self.displacement.each_ref().map(|row| &**row),
            velocity: self.velocity.each_ref().map(|row| &**row),
            force: self.force.each_ref().map(|row| &**row),
            contact: self.contact.each_ref().map(|row| &**row),
            rounding: &*self.rounding,
            pairs: &*self.pairs,
            solid: &*self.solid,
        }
    }

    /// The same without the histories of a solid, and these.
    pub(crate) fn without_history(&mut self, constants: &Constants) -> (StateNodes<&mut [Real]>, &[Pack]) {
        let of_nodes = SolidArrays::of_state(&constants.grid, constants.solid_history_packs).at_nodes();
        let (solid, history) = self.solid.split_at_mut_checked(of_nodes).unwrap_or_default();
        let nodes = StateNodes {
            displacement: self.displacement.each_mut().map(|row| &mut **row),
            velocity: self.velocity.each_mut().map(|row| &mut **row),
            force: self.force.each_mut().map(|row| &mut **row),
            contact: self.contact.each_mut().map(|row| &mut **row),
            rounding: &mut *self.rounding,
            pairs: &mut *self.pairs,
            solid,
        };
        (nodes, history.as_chunks().0)
    }

    /// Displacements of the rows of nodes below and above the block whose first nodes are `first`.
    #[inline(always)]
    pub(crate) fn rows(&self, [lower, upper]: [usize; 2]) -> Rows<'_> {
        let [x, y] = &self.displacement;
        [[span(x, lower), span(y, lower)], [span(x, upper), span(y, upper)]]
    }

    /// Takes the forces of the cells of a block from their corners.
    #[inline(always)]
    pub(crate) fn subtract_force<S: Simd>(&mut self, simd: S, [lower, upper]: [usize; 2], force: &Corners<Pack>) {
        let [c0, c1, c2, c3] = force;
        for i in 0..2 {
            let row = &mut *self.force[i];
            subtract_ends(simd, row, lower, &c0[i], &c1[i]);
            subtract_ends(simd, row, upper, &c3[i], &c2[i]);
        }
    }
}

/// Numbers at the nodes of a row of cells of a block.
pub(super) type Span = [Real; LANES + 1];
/// Two numbers at the nodes below and above the cells of a block.
pub(crate) type Rows<'r> = [[&'r Span; 2]; 2];

#[inline(always)]
pub(super) fn span(row: &[Real], start: usize) -> &Span {
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
pub(super) fn subtract_ends<S: Simd>(simd: S, row: &mut [Real], start: usize, left: &Pack, right: &Pack) {
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
