//! Which segment a node at an interface is over, and how both move.

use core::ops::{Range, RangeInclusive};

use crate::contact::node::{Node, add_force};
use crate::model::{Constants, Model, PAIR_FIELDS};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::Section;
use crate::state::{Pair, PairedNode, StateNodes};

/// A node this part of a segment beside the last one still touches it.
const BESIDE: Real = 0.01;

/// A node deeper inside than this part of the segment has come around the end of the row and is not pushed out.
const DEEPEST: Real = 0.5;

/// A node that has come around the end of a row is pushed out by at most this part of a segment in a step.
const PUSHED_OUT: Real = 1e-3;

/// The pairs of a row of nodes, by column, in memory.
pub(super) type Row = [[Real; PAIR_FIELDS]];

/// One row of nodes at an interface and the row of segments that it may touch.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// First node of the row.
    first: usize,
    /// Columns of cells of the layer of the nodes.
    cells: Range<usize>,
    /// Columns of cells of that of the segments.
    segments: Range<usize>,
    /// 1 where the nodes are above the segments, -1 where they are below.
    upwards: Real,
    /// Whether the section goes on beyond the first column, by symmetry.
    mirrored: bool,
    /// Time step, s.
    dt: Real,
}

impl Side {
    /// The nodes above the interface below `layer` and those below it; none if it is bonded.
    pub fn both(constants: &Constants, layer: usize) -> Option<[Self; 2]> {
        let grid = &constants.grid;
        let [below, above] = grid.interface_rows(layer)?.map(|row| row * grid.stride());
        let [of_below, of_above] = [grid.columns_of(layer.checked_sub(1)?), grid.columns_of(layer)];
        let mirrored = constants.scenario.geometry.section == Section::Half;
        let side = |first, cells: &Range<usize>, segments: &Range<usize>, upwards| Self {
            first,
            cells: cells.clone(),
            segments: segments.clone(),
            upwards,
            mirrored,
            dt: constants.dt,
        };
        Some([side(above, &of_above, &of_below, 1.0), side(below, &of_below, &of_above, -1.0)])
    }

    /// Columns of the nodes.
    pub fn columns(&self) -> RangeInclusive<usize> {
        self.cells.start..=self.cells.end
    }

    /// Column of the segment of `pair`, of the node of `column`: one of those that are there.
    #[inline(always)]
    pub fn segment(&self, column: usize, pair: &Pair) -> usize {
        let wanted = column.saturating_add_signed(pair.shift as isize);
        wanted.max(self.segments.start).min(self.segments.end.saturating_sub(1))
    }

    /// Takes the nodes as they are at the start of a step, with the forces so far.
    pub fn gather(&self, model: &Model, nodes: &StateNodes<&mut [Real]>, row: &mut Row) {
        for column in self.columns() {
            let (Some(memory), Some(node)) = (row.get_mut(column), Node::of(model, nodes, self.first + column)) else {
                continue;
            };
            let mut pair = Pair::load(memory);
            let mobility = node.inverse_mass.map(|inverse| self.dt * inverse);
            let velocity = node.next_velocity(self.dt);
            pair.node = PairedNode { position: node.position, velocity, mobility, force: [0.0; 2] };
            pair.store(memory);
        }
    }

    /// Adds the forces across the interface to those of the nodes, and leaves the means of their velocities over them.
    pub fn scatter(&self, nodes: &mut StateNodes<&mut [Real]>, row: &mut Row) {
        for column in self.columns() {
            let (Some(memory), index) = (row.get_mut(column), self.first + column) else { continue };
            let mut pair = Pair::load(memory);
            add_force(nodes, index, pair.node.force);
            for (mean, before) in pair.node.velocity.iter_mut().zip(&nodes.velocity) {
                *mean = 0.5 * (*mean + before.get(index).copied().unwrap_or_default());
            }
            pair.store(memory);
        }
    }

    /// Finds where the node of `column` is over the other row at the start of a step, and begins with the forces of the last one.
    ///
    /// It goes on to the next segment where it was found beside the last one a step ago, in which it slides by far less than a
    /// segment.
    #[inline(always)]
    pub fn find(&self, column: usize, pair: &mut Pair, other: &mut Row) {
        let (last, Range { start, end }) = (self.segment(column, pair), self.segments.clone());
        let segment = if pair.part < 0.0 && last > start {
            last - 1
        } else if pair.part > 1.0 && last + 1 < end {
            last + 1
        } else {
            last
        };
        pair.shift = segment as Real - column as Real;
        let Some([left, right]) = ends(other, segment) else { return };
        let (a, b) = (PairedNode::of(left), PairedNode::of(right));
        let along = [b.position[0] - a.position[0], b.position[1] - a.position[1]];
        let from = [pair.node.position[0] - a.position[0], pair.node.position[1] - a.position[1]];
        let inverse_length = 1.0 / math::sqrt(along[0] * along[0] + along[1] * along[1]);
        let direction = [along[0] * inverse_length, along[1] * inverse_length];
        pair.part = (from[0] * direction[0] + from[1] * direction[1]) * inverse_length;
        pair.normal = [-self.upwards * direction[1], self.upwards * direction[0]];
        let distance = from[0] * pair.normal[0] + from[1] * pair.normal[1];
        let depth = -distance * inverse_length;
        let beside = (segment == start && !self.mirrored && pair.part < -BESIDE)
            || (segment + 1 == end && pair.part > 1.0 + BESIDE)
            || depth > DEEPEST;
        pair.opening = if depth > PUSHED_OUT { -PUSHED_OUT / inverse_length } else { distance } / self.dt;
        if beside {
            (pair.resistance, pair.pressing, pair.rubbing) = (0.0, 0.0, 0.0);
            return;
        }
        // Nodes on the centre line, which are fixed across it, count as if they were not: nothing moves them that way.
        let [of_left, of_right] = pair.weights();
        let mobility = pair.node.mobility[1] + of_left * of_left * a.mobility[1] + of_right * of_right * b.mobility[1];
        pair.resistance = if mobility > 0.0 { 1.0 / mobility } else { 0.0 };
        exert(pair, [left, right], pair.pressing, pair.rubbing);
    }
}

/// Both ends of a segment, in the row of its nodes.
#[inline(always)]
pub(super) fn ends(row: &mut Row, segment: usize) -> Option<[&mut [Real; PAIR_FIELDS]; 2]> {
    let [left, right] = row.get_mut(segment..)?.first_chunk_mut()?;
    Some([left, right])
}

/// Velocity of the node of `pair` relative to the ends of its segment, along the normal and to the right of it, m/s.
#[inline(always)]
pub(super) fn relative_velocity(pair: &Pair, [left, right]: [&[Real; PAIR_FIELDS]; 2]) -> [Real; 2] {
    let (a, b, [of_left, of_right]) = (PairedNode::of(left), PairedNode::of(right), pair.weights());
    let along = |i: usize| pair.node.velocity[i] - of_left * a.velocity[i] - of_right * b.velocity[i];
    let ([x, y], [normal_x, normal_y]) = ([along(0), along(1)], pair.normal);
    [x * normal_x + y * normal_y, x * normal_y - y * normal_x]
}

/// Adds forces to the node of `pair`, N, along the normal and to the right of it, and their opposites to the ends of its segment.
#[inline(always)]
pub(super) fn exert(pair: &mut Pair, [left, right]: [&mut [Real; PAIR_FIELDS]; 2], pressing: Real, rubbing: Real) {
    let ([x, y], [of_left, of_right]) = (pair.normal, pair.weights());
    let force = [pressing * x + rubbing * y, pressing * y - rubbing * x];
    pair.node.push(1.0, force);
    PairedNode::push_in(left, -of_left, force);
    PairedNode::push_in(right, -of_right, force);
}
