//! The arrays of a state that only a solid has.

use crate::element::SolidCorners;
use crate::mesh::Grid;
use crate::model::{SolidArrays, split_row};
use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::state::nodes::{Span, span, subtract_ends};

/// What a solid has besides what a section has, laid out alike along z: to be changed.
pub(crate) struct SolidState<'s> {
    /// Displacement along z, m.
    pub displacement: &'s mut [Real],
    /// Velocity along z half a step back, m/s.
    pub velocity: &'s mut [Real],
    /// Force along z of the step, N.
    pub force: &'s mut [Real],
    /// Friction force of the face on the surface nodes along z, N.
    pub friction: &'s mut [Real],
    /// Histories of the tetrahedra of all blocks.
    pub history: &'s mut [Pack],
}

impl<'s> SolidState<'s> {
    /// Cuts the numbers of a state; nothing of those of a section.
    pub fn of(grid: &Grid, history_packs: usize, mut numbers: &'s mut [Real]) -> Self {
        let SolidArrays { nodes, surface, .. } = SolidArrays::of_state(grid, history_packs);
        let mut row = |n| split_row(&mut numbers, n).unwrap_or_default();
        let (displacement, velocity, force, friction) = (row(nodes), row(nodes), row(nodes), row(surface));
        Self { displacement, velocity, force, friction, history: numbers.as_chunks_mut().0 }
    }

    /// No displacement, no velocity and no force; histories stay.
    pub fn stand_still(self) {
        for row in [self.displacement, self.velocity, self.force, self.friction] {
            row.fill(0.0);
        }
    }
}

/// The same, to be read.
#[derive(Clone, Copy)]
pub(crate) struct SolidView<'s> {
    /// Displacement along z, m.
    pub displacement: &'s [Real],
    /// Velocity along z half a step back, m/s.
    pub velocity: &'s [Real],
    /// Force along z of the step, N.
    pub force: &'s [Real],
    /// Friction force of the face on the surface nodes along z, N.
    pub friction: &'s [Real],
    /// Histories of the tetrahedra of all blocks.
    pub history: &'s [Pack],
}

impl<'s> SolidView<'s> {
    /// Cuts the numbers of a state; nothing of those of a section.
    pub fn of(grid: &Grid, history_packs: usize, numbers: &'s [Real]) -> Self {
        let SolidArrays { nodes, surface, .. } = SolidArrays::of_state(grid, history_packs);
        let (displacement, rest) = numbers.split_at_checked(nodes).unwrap_or_default();
        let (velocity, rest) = rest.split_at_checked(nodes).unwrap_or_default();
        let (force, rest) = rest.split_at_checked(nodes).unwrap_or_default();
        let (friction, rest) = rest.split_at_checked(surface).unwrap_or_default();
        Self { displacement, velocity, force, friction, history: rest.as_chunks().0 }
    }
}

/// First nodes of the four rows about a block, in the order of [`SolidCorners`]: bit 0 is across the rows, bit 1 along z.
pub(crate) type SolidRows = [usize; 4];

/// Displacements of the corners of neighbouring cells whose first nodes are `rows`, from those of all nodes along x, y and z.
#[inline(always)]
pub(crate) fn solid_corners<S: Simd>(
    simd: S,
    chunk: usize,
    rows: &SolidRows,
    displacement: [&[Real]; 3],
    mirrored: Option<&Pack>,
) -> SolidCorners<S::Vector> {
    let zero = simd.splat(0.0);
    let mut corners = [[zero; 3]; 8];
    for place in 0..4 {
        for i in 0..3 {
            let nodes: &Span = span(displacement[i], rows[place]);
            let ([left @ .., _], [_, right @ ..]) = (nodes, nodes);
            let (left, right) = (simd.load(left, chunk), simd.load(right, chunk));
            (corners[2 * place][i], corners[2 * place + 1][i]) = match mirrored {
                Some(mask) => {
                    let mask = simd.load(mask, chunk);
                    (mask.select_greater(zero, right, left), mask.select_greater(zero, left, right))
                }
                None => (left, right),
            };
        }
    }
    corners
}

/// Subtracts the forces of the cells of a block at their ends on the left and on the right from those of a row of nodes, of which
/// theirs begin at `first`.
#[inline(always)]
pub(crate) fn subtract_from_row<S: Simd>(
    simd: S,
    row: &mut [Real],
    first: usize,
    [left, right]: [&Pack; 2],
    mirrored: Option<&Pack>,
) {
    let Some(mask) = mirrored else {
        return subtract_ends(simd, row, first, left, right);
    };
    let ([mut left, mut right], zero) = ([*left, *right], simd.splat(0.0));
    for chunk in 0..LANES / S::WIDTH {
        let mask = simd.load(mask, chunk);
        let (of_left, of_right) = (simd.load(&left, chunk), simd.load(&right, chunk));
        simd.store(mask.select_greater(zero, of_right, of_left), &mut left, chunk);
        simd.store(mask.select_greater(zero, of_left, of_right), &mut right, chunk);
    }
    subtract_ends(simd, row, first, &left, &right);
}
