//! Contact and friction between two layers that are not bonded.
//!
//! Each node of either row is paired with the segment of the other one that it is over, which it follows as it slides. The forces
//! are Lagrange multipliers of the forward increment, as those of [`crate::contact::face`]: at the end of the step no node is
//! inside its segment, and one that sticks does not slide. Pairs share nodes, so the forces are found by passes over them, from
//! the forces of the last step: over those of one row at once, then over those of the other. A row that all of its nodes hold
//! up alike is done after one pass: the resistance of a pair is that against such a load, which a node of the other row shares
//! among the pairs that are on it (the splitting of masses; Tonge, Benevolenski and Voroshilov 2012, ACM Trans. Graph. 31, 105).
//! What a force does to a node, its opposite does to the ends of the segment, by the node's place over it: momentum is
//! kept whatever the number of passes.

use crate::contact::friction::limited;
use crate::contact::pairing::Side;
use crate::contact::segments::{take, under};
use crate::features::PADS;
use crate::model::Model;
use crate::number::pack::{LANES, Pack, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector, Work};
use crate::scenario::MAX_LAYERS;
use crate::state::{
    ContactWork, FORCE, MOBILITY, NORMAL, OPENING, PairPack, PairRow, RESISTANCE, State, StateNodes, columns,
    columns_mut,
};

/// Passes over the pairs. Each leaves a part of a change of the forces, most where light nodes lie between heavy ones, and the
/// next step goes on from there. With too few, thin layers shake between heavier ones, and nodes get into them
/// (`tests/verification/src/plausible.rs`).
pub(super) const PASSES: usize = 4;

/// Adds the forces between layers to those of the nodes, and says what they take over their impulse.
#[inline(always)]
pub(crate) fn press<S: Simd>(simd: S, model: &Model, state: &mut State) -> ContactWork {
    if PADS && !state.nodes.pairs.is_empty() {
        simd.apart(Press { model, nodes: &mut state.nodes })
    } else {
        ContactWork::default()
    }
}

/// The interfaces of a section that has some, as work of their own.
struct Press<'s, 'm, 'a> {
    model: &'s Model<'m>,
    nodes: &'s mut StateNodes<&'a mut [Real]>,
}

impl Work for Press<'_, '_, '_> {
    type Output = ContactWork;

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> ContactWork {
        press_all(simd, self.model, self.nodes)
    }
}

#[inline(always)]
fn press_all<S: Simd>(simd: S, model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    let (constants, mut work) = (model.constants, ContactWork::default());
    let (stride, pairs) = (constants.grid.stride(), core::mem::take(&mut nodes.pairs));
    let mut rows = pairs.chunks_exact_mut(PairRow::numbers(stride).max(1));
    for layer in 1..MAX_LAYERS {
        let (Some(sides), Some(upper)) = (Side::both(constants, layer), constants.scenario.layers.get(layer)) else {
            continue;
        };
        let coefficient = upper.sliding_coefficient();
        let mut row = || PairRow::of(rows.next()?, stride, constants.grid.n_u + 1);
        if let (Some(above), Some(below)) = (row(), row()) {
            Interface { simd, sides, rows: [above, below], coefficient }.press(model, nodes, &mut work);
        }
    }
    nodes.pairs = pairs;
    work
}

/// An interface that is not bonded, and the pairs of the nodes above and below it.
struct Interface<'p, S> {
    simd: S,
    sides: [Side; 2],
    rows: [PairRow<'p>; 2],
    /// Of friction.
    coefficient: Real,
}

impl<S: Simd> Interface<'_, S> {
    #[inline(always)]
    fn press(&mut self, model: &Model, nodes: &mut StateNodes<&mut [Real]>, work: &mut ContactWork) {
        let (simd, coefficient, sides) = (self.simd, self.coefficient, &self.sides);
        // Stage by stage, for the row above and then for the one below; loops, so that each stage is compiled once.
        for (side, own) in sides.iter().zip(&mut self.rows) {
            side.gather(simd, model, nodes, own);
        }
        for turn in 0..2 {
            let (own, other) = turned_to(turn, &mut self.rows);
            sides[turn].find(simd, own, other);
        }
        for pull in self.rows.iter_mut().flat_map(|row| &mut row.pull) {
            pull.fill(0.0);
        }
        for turn in 0..2 {
            let (own, other) = turned_to(turn, &mut self.rows);
            resist(simd, own, other);
        }
        for turn in 0..2 {
            let (own, other) = turned_to(turn, &mut self.rows);
            hold(simd, own, other);
        }
        for turn in 0..2 * PASSES {
            let (own, other) = turned_to(turn, &mut self.rows);
            touch(simd, own, other, coefficient);
        }
        for turn in 0..2 {
            let (own, other) = turned_to(turn, &mut self.rows);
            settle(simd, own, other);
        }
        for (side, own) in sides.iter().zip(&mut self.rows) {
            side.scatter(simd, model, nodes, own);
        }
        let dt = model.constants.dt;
        for turn in 0..2 {
            let (own, other) = turned_to(turn, &mut self.rows);
            let [pressed, rubbed] = power(simd, own, other);
            work.contact_dissipation -= dt * pressed;
            work.frictional_dissipation -= dt * rubbed;
        }
    }
}

/// The row whose turn it is, and the other one: first that above, then that below, and so on.
#[inline(always)]
fn turned_to<'r, 'p>(
    turn: usize,
    [above, below]: &'r mut [PairRow<'p>; 2],
) -> (&'r mut PairRow<'p>, &'r mut PairRow<'p>) {
    if turn.is_multiple_of(2) { (above, below) } else { (below, above) }
}

/// Turns what [`Side::find`] has left for the resistance of each pair of `own`, 1 where the node is over a segment, into it: one
/// over what a force moves the node by and, as far as it is its share, the neighbours.
#[inline(always)]
fn resist<S: Simd>(simd: S, own: &mut PairRow, other: &mut PairRow) {
    for pack in own.packs.iter() {
        take(simd, pack, &[-1.0; LANES], other.pull[0]);
    }
    // Nodes on the centre line, which are fixed across it, count as if they were not: nothing moves them that way.
    for (i, pack) in other.packs.iter().enumerate() {
        let Some(load) = columns_mut(other.pull[0], i) else { continue };
        for chunk in 0..LANES / S::WIDTH {
            simd.store(simd.load(load, chunk) * simd.load(&pack[MOBILITY[1]], chunk), load, chunk);
        }
    }
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    for pack in own.packs.iter_mut() {
        let shared = under(simd, pack, other.pull[0]);
        for chunk in 0..LANES / S::WIDTH {
            let mobility = simd.load(&pack[MOBILITY[1]], chunk) + simd.load(&shared, chunk);
            let found = mobility.select_greater(zero, one / mobility, zero);
            let there = simd.load(&pack[RESISTANCE], chunk);
            simd.store(there.select_greater(zero, found, zero), &mut pack[RESISTANCE], chunk);
        }
    }
    other.pull[0].fill(0.0);
}

/// Begins with the forces of the last step.
#[inline(always)]
fn hold<S: Simd>(simd: S, own: &mut PairRow, other: &mut PairRow) {
    for (i, pack) in own.packs.iter().enumerate() {
        push(simd, i, pack, &mut own.velocity, &mut other.pull, [&pack[FORCE[0]], &pack[FORCE[1]]]);
    }
    follow(simd, other);
}

/// Brings about the conditions of all pairs of `own`, by forces along their normals and across them: neither changes what the
/// other does.
#[inline(always)]
fn touch<S: Simd>(simd: S, own: &mut PairRow, other: &mut PairRow, coefficient: Real) {
    let zero = simd.splat(0.0);
    for (i, pack) in own.packs.iter_mut().enumerate() {
        let (moved, mut changes) = (relative_velocity(simd, i, pack, &own.velocity, &other.velocity), [ZERO; 2]);
        for chunk in 0..LANES / S::WIDTH {
            let [apart, sliding] = [simd.load(&moved[0], chunk), simd.load(&moved[1], chunk)];
            let resistance = simd.load(&pack[RESISTANCE], chunk);
            let before = [simd.load(&pack[FORCE[0]], chunk), simd.load(&pack[FORCE[1]], chunk)];
            let pressing = zero.max(before[0] - resistance * (simd.load(&pack[OPENING], chunk) + apart));
            let rubbing = limited(before[1] - resistance * sliding, pressing.mul_scalar(coefficient));
            simd.store(pressing - before[0], &mut changes[0], chunk);
            simd.store(rubbing - before[1], &mut changes[1], chunk);
            simd.store(pressing, &mut pack[FORCE[0]], chunk);
            simd.store(rubbing, &mut pack[FORCE[1]], chunk);
        }
        push(simd, i, pack, &mut own.velocity, &mut other.pull, [&changes[0], &changes[1]]);
    }
    follow(simd, other);
}

/// Velocity of the nodes of pack `i` relative to what is under them, along the normal and to the right of it, m/s.
#[inline(always)]
fn relative_velocity<S: Simd>(
    simd: S,
    i: usize,
    pack: &PairPack,
    velocity: &[&mut [Real]; 2],
    beneath: &[&mut [Real]; 2],
) -> [Pack; 2] {
    let (beneath, mut moved) = ([under(simd, pack, beneath[0]), under(simd, pack, beneath[1])], [ZERO; 2]);
    let [Some(x), Some(y)] = [columns(velocity[0], i), columns(velocity[1], i)] else { return moved };
    for chunk in 0..LANES / S::WIDTH {
        let (x, y) =
            (simd.load(x, chunk) - simd.load(&beneath[0], chunk), simd.load(y, chunk) - simd.load(&beneath[1], chunk));
        let normal = [simd.load(&pack[NORMAL[0]], chunk), simd.load(&pack[NORMAL[1]], chunk)];
        simd.store(x * normal[0] + y * normal[1], &mut moved[0], chunk);
        simd.store(x * normal[1] - y * normal[0], &mut moved[1], chunk);
    }
    moved
}

/// Forces along the normals of a pack and to the right of them as those of x and y, N.
#[inline(always)]
fn turned<S: Simd>(simd: S, pack: &PairPack, [pressing, rubbing]: [&Pack; 2]) -> [Pack; 2] {
    let mut force = [ZERO; 2];
    for chunk in 0..LANES / S::WIDTH {
        let [x, y] = [simd.load(&pack[NORMAL[0]], chunk), simd.load(&pack[NORMAL[1]], chunk)];
        let [along, across] = [simd.load(pressing, chunk), simd.load(rubbing, chunk)];
        simd.store(along * x + across * y, &mut force[0], chunk);
        simd.store(along * y - across * x, &mut force[1], chunk);
    }
    force
}

/// Changes the velocities of the nodes of pack `i` by forces along the normals and to the right of them, N, and pulls at what is
/// under them by the opposites.
#[inline(always)]
fn push<S: Simd>(
    simd: S,
    i: usize,
    pack: &PairPack,
    velocity: &mut [&mut [Real]; 2],
    pull: &mut [&mut [Real]; 2],
    force: [&Pack; 2],
) {
    let force = turned(simd, pack, force);
    for axis in 0..2 {
        take(simd, pack, &force[axis], pull[axis]);
        let Some(velocity) = columns_mut(velocity[axis], i) else { continue };
        for chunk in 0..LANES / S::WIDTH {
            simd.add(simd.load(&pack[MOBILITY[axis]], chunk) * simd.load(&force[axis], chunk), velocity, chunk);
        }
    }
}

/// Lets the nodes follow what pulls at them.
#[inline(always)]
fn follow<S: Simd>(simd: S, row: &mut PairRow) {
    for (i, pack) in row.packs.iter().enumerate() {
        for axis in 0..2 {
            let (Some(velocity), Some(pull)) = (columns_mut(row.velocity[axis], i), columns_mut(row.pull[axis], i))
            else {
                continue;
            };
            for chunk in 0..LANES / S::WIDTH {
                simd.add(simd.load(&pack[MOBILITY[axis]], chunk) * simd.load(pull, chunk), velocity, chunk);
            }
            *pull = ZERO;
        }
    }
}

/// Pulls at the nodes of `own` and at what is under them by all of the forces.
#[inline(always)]
fn settle<S: Simd>(simd: S, own: &mut PairRow, other: &mut PairRow) {
    for (i, pack) in own.packs.iter().enumerate() {
        let force = turned(simd, pack, [&pack[FORCE[0]], &pack[FORCE[1]]]);
        for axis in 0..2 {
            take(simd, pack, &force[axis], other.pull[axis]);
            let Some(pull) = columns_mut(own.pull[axis], i) else { continue };
            for chunk in 0..LANES / S::WIDTH {
                simd.add(simd.load(&force[axis], chunk), pull, chunk);
            }
        }
    }
}

/// What the forces of the pairs of `own` do to their relative velocities, W: along the normals, then friction.
#[inline(always)]
fn power<S: Simd>(simd: S, own: &PairRow, other: &PairRow) -> [Real; 2] {
    let mut work = [ZERO; 2];
    for (i, pack) in own.packs.iter().enumerate() {
        let moved = relative_velocity(simd, i, pack, &own.velocity, &other.velocity);
        for kind in 0..2 {
            for chunk in 0..LANES / S::WIDTH {
                let force = simd.load(&pack[FORCE[kind]], chunk);
                simd.add(force * simd.load(&moved[kind], chunk), &mut work[kind], chunk);
            }
        }
    }
    [sum(&work[0]), sum(&work[1])]
}
