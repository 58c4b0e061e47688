//! A node at an interface and the segment of the other layer that it may touch.

use crate::model::PAIR_FIELDS;
use crate::number::math;
use crate::number::real::Real;

/// A node at an interface between two layers, and the segment of the other one's row of nodes that it is over. What a step
/// starts from is that it follows the segment and the forces; all else is of one step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// Column of the segment less that of the node, a whole number.
    pub shift: Real,
    /// Where the node is over the segment: 0 at its left end, 1 at its right end, and beyond where it is beside it.
    pub part: Real,
    /// Force on the node along the normal, N, never negative.
    pub pressing: Real,
    /// Friction on the node, N, to the right of the normal.
    pub rubbing: Real,
    /// Direction out of the segment.
    pub normal: [Real; 2],
    /// Distance from the segment at the start of the step over the step, m/s; negative inside.
    pub opening: Real,
    /// Force over the change of the relative velocity that it brings about, kg/s; 0 where the node is beside the other layer.
    pub resistance: Real,
    /// What the node moves by.
    pub node: PairedNode,
}

/// A node at an interface, in one step; x before y.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairedNode {
    /// At the start of the step, m.
    pub position: [Real; 2],
    /// With the forces so far, m/s; when they are all known, its mean over them.
    pub velocity: [Real; 2],
    /// Step over mass, s/kg; 0 where fixed.
    pub mobility: [Real; 2],
    /// Across the interface so far, N.
    pub force: [Real; 2],
}

impl Pair {
    /// The pair in memory.
    #[inline(always)]
    pub fn load(memory: &[Real; PAIR_FIELDS]) -> Self {
        let [shift, part, pressing, rubbing, a, b, opening, resistance, node @ ..] = memory;
        let node = PairedNode::load(node);
        let (shift, part, pressing, rubbing) = (*shift, *part, *pressing, *rubbing);
        Self { shift, part, pressing, rubbing, normal: [*a, *b], opening: *opening, resistance: *resistance, node }
    }

    /// The same, for memory.
    #[inline(always)]
    pub fn store(&self, memory: &mut [Real; PAIR_FIELDS]) {
        let Self { shift, part, pressing, rubbing, normal: [a, b], opening, resistance, node } = *self;
        let PairedNode { position: [c, d], velocity: [e, f], mobility: [g, h], force: [i, j] } = node;
        *memory = [shift, part, pressing, rubbing, a, b, opening, resistance, c, d, e, f, g, h, i, j];
    }

    /// How much of what is on the node is on the left and on the right end of its segment.
    #[inline(always)]
    pub fn weights(&self) -> [Real; 2] {
        let right = if self.part > 1.0 { 1.0 } else { math::max(0.0, self.part) };
        [1.0 - right, right]
    }
}

impl PairedNode {
    /// The node in the memory of its pair.
    #[inline(always)]
    fn load([c, d, e, f, g, h, i, j]: &[Real; PAIR_FIELDS / 2]) -> Self {
        Self { position: [*c, *d], velocity: [*e, *f], mobility: [*g, *h], force: [*i, *j] }
    }

    /// The same, of the memory of a whole pair.
    #[inline(always)]
    pub fn of(memory: &[Real; PAIR_FIELDS]) -> Self {
        let [_, _, _, _, _, _, _, _, node @ ..] = memory;
        Self::load(node)
    }

    /// Adds a force, N, times a weight.
    #[inline(always)]
    pub fn push(&mut self, weight: Real, [x, y]: [Real; 2]) {
        let ([velocity_x, velocity_y], [force_x, force_y]) = (&mut self.velocity, &mut self.force);
        *velocity_x += self.mobility[0] * (weight * x);
        *velocity_y += self.mobility[1] * (weight * y);
        *force_x += weight * x;
        *force_y += weight * y;
    }

    /// The same, of the memory of a whole pair.
    #[inline(always)]
    pub fn push_in(memory: &mut [Real; PAIR_FIELDS], weight: Real, force: [Real; 2]) {
        let mut node = Self::of(memory);
        node.push(weight, force);
        let Self { velocity: [e, f], force: [i, j], .. } = node;
        let [_, _, _, _, _, _, _, _, _, _, velocity_x, velocity_y, _, _, force_x, force_y] = memory;
        (*velocity_x, *velocity_y, *force_x, *force_y) = (e, f, i, j);
    }
}
