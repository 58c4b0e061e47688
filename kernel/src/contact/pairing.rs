//! Which segment a node at an interface is over, and how both move.

use core::ops::{Range, RangeInclusive};

use crate::contact::node::{Node, add_force};
use crate::model::{Constants, Model};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::Section;
use crate::state::{Pair, StateNodes};

/// A node this part of a segment beside the last one still touches it.
const BESIDE: Real = 0.01;

/// A node deeper inside than this part of the segment has come around the end of the row and is not pushed out.
const DEEPEST: Real = 0.5;

/// A node that has come around the end of a row is pushed out by at most this part of a segment in a step.
const PUSHED_OUT: Real = 1e-3;

/// One row of nodes at an interface and the row of segments that it may touch.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// First node of the row of nodes, and of that of segments.
    first: [usize; 2],
    /// Columns of cells of the layer of the nodes, and of that of the segments.
    cells: [Range<usize>; 2],
    /// 1 where the nodes are above the segments, -1 where they are below.
    upwards: Real,
    /// Whether the section goes on beyond the first column, by symmetry.
    mirrored: bool,
}

impl Side {
    /// The nodes above the interface below `layer` and those below it; none if it is bonded.
    pub fn both(constants: &Constants, layer: usize) -> Option<[Self; 2]> {
        let grid = &constants.grid;
        let [below, above] = grid.interface_rows(layer)?.map(|row| row * grid.stride());
        let [of_below, of_above] = [grid.columns_of(layer.checked_sub(1)?), grid.columns_of(layer)];
        let mirrored = constants.scenario.geometry.section == Section::Half;
        let upper = Self { first: [above, below], cells: [of_above.clone(), of_below.clone()], upwards: 1.0, mirrored };
        let lower = Self { first: [below, above], cells: [of_below, of_above], upwards: -1.0, mirrored };
        Some([upper, lower])
    }

    /// Columns of the nodes.
    pub fn columns(&self) -> RangeInclusive<usize> {
        self.cells[0].start..=self.cells[0].end
    }

    /// Column of the segment of `pair`, of the node of `column`: one of those that are there.
    fn segment(&self, column: usize, pair: &Pair) -> usize {
        let Range { start, end } = self.cells[1];
        let wanted = column.saturating_add_signed(pair.shift as isize);
        wanted.max(start).min(end.saturating_sub(1))
    }

    /// The node of `column` and both ends of its segment.
    #[inline(always)]
    pub fn nodes_of(&self, column: usize, pair: &Pair) -> [usize; 3] {
        let left = self.first[1] + self.segment(column, pair);
        [self.first[0] + column, left, left + 1]
    }

    /// Finds where the node of `column` is at the start of a step.
    ///
    /// It goes on to the next segment where it was found beside the last one a step ago, in which it slides by far less than a
    /// segment.
    pub fn find(&self, bodies: &Bodies, column: usize, pair: &mut Pair) {
        let (last, Range { start, end }) = (self.segment(column, pair), self.cells[1].clone());
        let segment = if pair.part < 0.0 && last > start {
            last - 1
        } else if pair.part > 1.0 && last + 1 < end {
            last + 1
        } else {
            last
        };
        pair.shift = segment as Real - column as Real;
        let nodes = self.nodes_of(column, pair);
        let [node, left, right] = nodes.map(|index| bodies.position(index));
        let (along, from) = ([right[0] - left[0], right[1] - left[1]], [node[0] - left[0], node[1] - left[1]]);
        let squared = along[0] * along[0] + along[1] * along[1];
        let length = math::sqrt(squared);
        pair.part = (from[0] * along[0] + from[1] * along[1]) / squared;
        pair.normal = [-self.upwards * along[1] / length, self.upwards * along[0] / length];
        let distance = from[0] * pair.normal[0] + from[1] * pair.normal[1];
        let beside = (segment == start && !self.mirrored && pair.part < -BESIDE)
            || (segment + 1 == end && pair.part > 1.0 + BESIDE)
            || distance < -DEEPEST * length;
        pair.opening = math::max(distance, -PUSHED_OUT * length) / bodies.model.constants.dt;
        pair.resistance = if beside { 0.0 } else { bodies.resistance(nodes, pair) };
    }
}

/// The layers on both sides of an interface.
pub(super) struct Bodies<'b, 'm, 'a> {
    pub model: &'b Model<'m>,
    pub nodes: &'b mut StateNodes<&'a mut [Real]>,
}

impl Bodies<'_, '_, '_> {
    /// Current position of a node, m.
    fn position(&self, index: usize) -> [Real; 2] {
        Node::of(self.model, self.nodes, index).map_or([0.0; 2], |node| node.position)
    }

    /// Force on a node and against the ends of its segment over the relative velocity that it brings about, kg/s. Nodes on the
    /// centre line, which are fixed across it, count as if they were not: nothing moves them that way.
    fn resistance(&self, nodes: [usize; 3], pair: &Pair) -> Real {
        let weights = pair.weights();
        let inverse = |i: usize| self.model.nodes.inverse_mass_y.get(nodes[i]).copied().unwrap_or_default();
        let mobility = (0..3).fold(0.0, |sum, i| sum + weights[i] * weights[i] * inverse(i));
        if mobility > 0.0 { 1.0 / (self.model.constants.dt * mobility) } else { 0.0 }
    }

    /// Velocity of a node relative to its segment along `direction` at the end of the step, with the forces so far, m/s.
    #[inline(always)]
    pub fn relative_velocity(&self, nodes: [usize; 3], pair: &Pair, direction: [Real; 2]) -> Real {
        self.relative(nodes, pair, direction, 1.0)
    }

    /// The same, mean over the impulse of the forces, m/s.
    pub fn mean_velocity(&self, nodes: [usize; 3], pair: &Pair, direction: [Real; 2]) -> Real {
        self.relative(nodes, pair, direction, 0.5)
    }

    #[inline(always)]
    fn relative(&self, nodes: [usize; 3], pair: &Pair, direction: [Real; 2], part: Real) -> Real {
        let (weights, time) = (pair.weights(), part * self.model.constants.dt);
        let (fixed, of_state) = (&self.model.nodes, &self.nodes);
        let inverse_mass = [fixed.inverse_mass_x, fixed.inverse_mass_y];
        let along = |index: usize, i: usize| {
            let (inverse, velocity) = (inverse_mass[i].get(index), of_state.velocity[i].get(index));
            let force = of_state.force[i].get(index);
            let (Some(inverse), Some(velocity), Some(force)) = (inverse, velocity, force) else { return 0.0 };
            direction[i] * (velocity + time * (inverse * force))
        };
        (0..3).fold(0.0, |sum, i| sum + weights[i] * (along(nodes[i], 0) + along(nodes[i], 1)))
    }

    /// Adds `force`, N, to that of a node, and its opposite to the ends of its segment.
    #[inline(always)]
    pub fn exert(&mut self, nodes: [usize; 3], pair: &Pair, force: [Real; 2]) {
        for (index, weight) in nodes.into_iter().zip(pair.weights()) {
            add_force(self.nodes, index, force.map(|part| weight * part));
        }
    }
}
