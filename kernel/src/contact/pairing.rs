//! Which segment a node at an interface is over, and how both move.

use core::ops::Range;

use crate::contact::node_row::NodeRow;
use crate::contact::segments::{are_abreast, line_up, neighbours};
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::scenario::Section;
use crate::state::{
    ABREAST, FORCE, LEFT, MOBILITY, NORMAL, OPENING, PART, PairPack, PairRow, RESISTANCE, SHIFT, StateNodes, WEIGHT,
    columns, columns_mut,
};

/// A node this part of a segment within its end, or beside it, is held by that end alone: so that of a row that sticks all
/// stay over segments next to each other, and so that the last one holds what stands at its edge.
pub(super) const BESIDE: Real = 0.01;

/// A node deeper inside than this part of the segment has come around the end of the row and is not pushed out.
pub(super) const DEEPEST: Real = 0.5;

/// A node that has come around the end of a row is pushed out by at most this part of a segment in a step.
pub(super) const PUSHED_OUT: Real = 1e-3;

/// One row of nodes at an interface and the row of segments that it may touch.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// Row of the nodes from the core.
    row: usize,
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
        let [below, above] = grid.interface_rows(layer)?;
        let [of_below, of_above] = [grid.columns_of(layer.checked_sub(1)?), grid.columns_of(layer)];
        let mirrored = constants.scenario.geometry.section == Section::Half;
        let side = |row, cells: &Range<usize>, segments: &Range<usize>, upwards| Self {
            row,
            cells: cells.clone(),
            segments: segments.clone(),
            upwards,
            mirrored,
            dt: constants.dt,
        };
        Some([side(above, &of_above, &of_below, 1.0), side(below, &of_below, &of_above, -1.0)])
    }

    /// Takes the nodes as they are at the start of a step, with the forces so far.
    #[inline(always)]
    pub fn gather<S: Simd>(&self, simd: S, model: &Model, nodes: &mut StateNodes<&mut [Real]>, row: &mut PairRow) {
        let StateNodes { displacement, velocity, force, .. } = nodes;
        let Some(nodes) = NodeRow::of(model, self.row, model.constants.grid.plane(), displacement, velocity, force)
        else {
            return;
        };
        for axis in 0..2 {
            let of_nodes = nodes.inverse_mass[axis].iter().zip(nodes.velocity[axis]).zip(&*nodes.force[axis]);
            let places = nodes.reference[axis].iter().zip(nodes.displacement[axis]);
            for (i, (((inverse_mass, before), force), (rest, moved))) in of_nodes.zip(places).enumerate() {
                let Some(pack) = row.packs.get_mut(i) else { continue };
                let (Some(velocity), Some(position)) =
                    (columns_mut(row.velocity[axis], i), columns_mut(row.pull[axis], i))
                else {
                    continue;
                };
                for chunk in 0..LANES / S::WIDTH {
                    let inverse_mass = simd.load(inverse_mass, chunk);
                    let change = (inverse_mass * simd.load(force, chunk)).mul_scalar(self.dt);
                    simd.store(simd.load(before, chunk) + change, velocity, chunk);
                    simd.store(inverse_mass.mul_scalar(self.dt), &mut pack[MOBILITY[axis]], chunk);
                    simd.store(simd.load(rest, chunk) + simd.load(moved, chunk), position, chunk);
                }
            }
        }
    }

    /// Adds the forces across the interface to those of the nodes, and leaves the means of their velocities over them.
    #[inline(always)]
    pub fn scatter<S: Simd>(&self, simd: S, model: &Model, nodes: &mut StateNodes<&mut [Real]>, row: &mut PairRow) {
        let StateNodes { displacement, velocity, force, .. } = nodes;
        let Some(nodes) = NodeRow::of(model, self.row, model.constants.grid.plane(), displacement, velocity, force)
        else {
            return;
        };
        for (axis, force) in nodes.force.into_iter().enumerate() {
            for (i, (force, before)) in force.iter_mut().zip(nodes.velocity[axis]).enumerate() {
                let (Some(pull), Some(mean)) = (columns(row.pull[axis], i), columns_mut(row.velocity[axis], i)) else {
                    continue;
                };
                for chunk in 0..LANES / S::WIDTH {
                    simd.add(simd.load(pull, chunk), force, chunk);
                    let twice = simd.load(mean, chunk) + simd.load(before, chunk);
                    simd.store(twice.mul_scalar(0.5), mean, chunk);
                }
            }
        }
    }

    /// Finds where the nodes of `own` are over the other row at the start of a step, whose positions are in the place of what
    /// pulls at them.
    #[inline(always)]
    pub fn find<S: Simd>(&self, simd: S, own: &mut PairRow, other: &PairRow) {
        for (i, pack) in own.packs.iter_mut().enumerate() {
            self.follow_segments(simd, i, pack);
            let [Some(x), Some(y)] = [columns(own.pull[0], i), columns(own.pull[1], i)] else { continue };
            let (mut x_ends, mut y_ends) = ([ZERO; 2], [ZERO; 2]);
            let [ax, bx] = neighbours(pack, other.pull[0], &mut x_ends);
            let [ay, by] = neighbours(pack, other.pull[1], &mut y_ends);
            for chunk in 0..LANES / S::WIDTH {
                let node = [simd.load(x, chunk), simd.load(y, chunk)];
                let left = [simd.load(ax, chunk), simd.load(ay, chunk)];
                let right = [simd.load(bx, chunk), simd.load(by, chunk)];
                self.locate(simd, chunk, i, pack, &[node, left, right]);
            }
            if !are_abreast(&pack[LEFT]) {
                line_up(pack);
            }
        }
    }

    /// Goes on to the next segment where a node was found beside the last one a step ago, in which it slides by far less than a
    /// segment: of those that are there.
    #[inline(always)]
    fn follow_segments<S: Simd>(&self, simd: S, i: usize, pack: &mut PairPack) {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let first = simd.splat(self.segments.start as Real);
        let last = simd.splat(self.segments.end.saturating_sub(1) as Real);
        for chunk in 0..LANES / S::WIDTH {
            let column = simd.load(&COLUMNS, chunk).add_scalar((i * LANES) as Real);
            let part = simd.load(&pack[PART], chunk);
            let on = part.select_greater(simd.splat(1.0 + BESIDE), one, zero);
            let step = simd.splat(-BESIDE).select_greater(part, zero - one, on);
            let wanted = (column + simd.load(&pack[SHIFT], chunk)).max(first);
            let held = wanted.select_greater(last, last, wanted);
            let next = (held + step).max(first);
            let next = next.select_greater(last, last, next);
            simd.store(next, &mut pack[LEFT], chunk);
            simd.store(next - column, &mut pack[SHIFT], chunk);
        }
        pack[ABREAST][0] = if are_abreast(&pack[LEFT]) { 1.0 } else { 0.0 };
    }

    /// Where the nodes of a part of pack `i` are over their segments from `a` to `b`.
    #[inline(always)]
    fn locate<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        i: usize,
        pack: &mut PairPack,
        [node, a, b]: &[[S::Vector; 2]; 3],
    ) {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let along = [b[0] - a[0], b[1] - a[1]];
        let from = [node[0] - a[0], node[1] - a[1]];
        let inverse_length = one / (along[0] * along[0] + along[1] * along[1]).square_root();
        let direction = [along[0] * inverse_length, along[1] * inverse_length];
        let part = (from[0] * direction[0] + from[1] * direction[1]) * inverse_length;
        let normal = [direction[1].mul_scalar(-self.upwards), direction[0].mul_scalar(self.upwards)];
        let distance = from[0] * normal[0] + from[1] * normal[1];
        let depth = zero - distance * inverse_length;
        let pushed = simd.splat(-PUSHED_OUT) / inverse_length;
        let opening = depth.select_greater(simd.splat(PUSHED_OUT), pushed, distance) / simd.splat(self.dt);
        let over = self.over(simd, chunk, i, pack, part, depth);
        let (near, far) = (simd.splat(BESIDE), simd.splat(1.0 - BESIDE));
        let right = part.select_greater(far, one, part.select_greater(near, part, zero));
        for (field, value) in [
            (PART, part),
            (NORMAL[0], normal[0]),
            (NORMAL[1], normal[1]),
            (OPENING, opening),
            (WEIGHT[0], one - right),
            (WEIGHT[1], right),
            (RESISTANCE, one),
            (FORCE[0], simd.load(&pack[FORCE[0]], chunk)),
            (FORCE[1], simd.load(&pack[FORCE[1]], chunk)),
        ] {
            // What is not over a segment has no number there either.
            let kept = if field == PART { over[0] } else { over[1] };
            simd.store(kept.select_greater(zero, value, zero), &mut pack[field], chunk);
        }
    }

    /// 1 where there is a node, 0 elsewhere; then where it is over its segment and not past an end of the row.
    #[inline(always)]
    fn over<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        i: usize,
        pack: &PairPack,
        part: S::Vector,
        depth: S::Vector,
    ) -> [S::Vector; 2] {
        let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
        let (column, segment) =
            (simd.load(&COLUMNS, chunk).add_scalar((i * LANES) as Real), simd.load(&pack[LEFT], chunk));
        let there = simd.splat(self.cells.start as Real).select_greater(column, zero, one);
        let there = column.select_greater(simd.splat(self.cells.end as Real), zero, there);
        let mut over = depth.select_greater(simd.splat(DEEPEST), zero, there);
        if !self.mirrored {
            let first = segment.select_greater(simd.splat(self.segments.start as Real), zero, one);
            let past = simd.splat(-BESIDE).select_greater(part, first, zero);
            over = past.select_greater(zero, zero, over);
        }
        let last = simd.splat(self.segments.end as Real - 1.5).select_greater(segment, zero, one);
        let past = part.select_greater(simd.splat(1.0 + BESIDE), last, zero);
        [there, past.select_greater(zero, zero, over)]
    }
}

/// Columns of the first pack.
const COLUMNS: Pack = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
