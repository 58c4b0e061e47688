//! A node at an interface and the segment of the other layer that it may touch.

use crate::model::PAIR_FIELDS;
use crate::number::math;
use crate::number::real::Real;

/// A node at an interface between two layers, and the segment of the other one's row of nodes that it is over.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// Column of the segment less that of the node, a whole number.
    pub shift: Real,
    /// Where the node is over the segment: 0 at its left end, 1 at its right end, and beyond where it is beside it.
    pub part: Real,
    /// Direction out of the segment.
    pub normal: [Real; 2],
    /// Distance from the segment at the start of the step over the step, m/s; negative inside.
    pub opening: Real,
    /// Force over the change of the relative velocity that it brings about, kg/s; 0 where the node is beside the other layer.
    pub resistance: Real,
    /// Force on the node along the normal, N, never negative.
    pub pressing: Real,
    /// Friction on the node, N, to the right of the normal.
    pub rubbing: Real,
}

impl Pair {
    /// The pair in memory.
    #[inline(always)]
    pub fn load(&[shift, part, x, y, opening, resistance, pressing, rubbing]: &[Real; PAIR_FIELDS]) -> Self {
        Self { shift, part, normal: [x, y], opening, resistance, pressing, rubbing }
    }

    /// The same, for memory.
    #[inline(always)]
    pub fn store(&self) -> [Real; PAIR_FIELDS] {
        let Self { shift, part, normal: [x, y], opening, resistance, pressing, rubbing } = *self;
        [shift, part, x, y, opening, resistance, pressing, rubbing]
    }

    /// How much of the velocity of the node, and of the left and the right end of its segment, the relative velocity holds; and
    /// of the force on the node, what is on each.
    #[inline(always)]
    pub fn weights(&self) -> [Real; 3] {
        let part = if self.part > 1.0 { 1.0 } else { math::max(0.0, self.part) };
        [1.0, part - 1.0, -part]
    }

    /// Direction of friction, to the right of the normal.
    #[inline(always)]
    pub fn tangent(&self) -> [Real; 2] {
        [self.normal[1], -self.normal[0]]
    }
}
