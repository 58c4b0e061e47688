//! Contact and friction between two layers of a solid that are not bonded: as in the section ([`crate::contact::interface`]), with
//! cells of a surface in the place of segments, and friction in two directions.

use crate::contact::friction::limited_vector;
use crate::contact::interface::PASSES;
use crate::contact::solid_node::{SolidNodes, dot};
use crate::contact::solid_pairing::SolidSide;
use crate::features::PADS;
use crate::model::Model;
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::MAX_LAYERS;
use crate::state::{ContactWork, SolidPair, SolidPairRow, SolidState, StateNodes};

/// Adds the forces between layers to those of the nodes, and says what they take over their impulse.
pub(crate) fn press(model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    if PADS && !nodes.pairs.is_empty() { press_all(model, nodes) } else { ContactWork::default() }
}

#[inline(never)]
fn press_all(model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    let (constants, mut work) = (model.constants, ContactWork::default());
    let StateNodes { displacement: [ux, uy], velocity: [vx, vy], force: [fx, fy], pairs, solid, .. } = nodes;
    let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
    let mut nodes =
        SolidNodes::new(model, [ux, uy, solid.displacement], [vx, vy, solid.velocity], [fx, fy, solid.force]);
    let plane = constants.grid.plane();
    let mut rows = pairs.chunks_exact_mut(SolidPairRow::numbers(plane).max(1));
    for layer in 1..MAX_LAYERS {
        let (Some(sides), Some(upper)) = (SolidSide::both(constants, layer), constants.scenario.layers.get(layer))
        else {
            continue;
        };
        let mut row = || SolidPairRow::of(rows.next()?, plane);
        if let (Some(above), Some(below)) = (row(), row()) {
            let coefficient = upper.sliding_coefficient();
            Interface { sides, rows: [above, below], coefficient }.press(&mut nodes, &mut work);
        }
    }
    work
}

/// An interface that is not bonded, and the pairs of the nodes above and below it.
struct Interface<'p> {
    sides: [SolidSide<'p>; 2],
    rows: [SolidPairRow<'p>; 2],
    /// Of friction.
    coefficient: Real,
}

impl Interface<'_> {
    fn press(&mut self, nodes: &mut SolidNodes, work: &mut ContactWork) {
        for (side, own) in self.sides.iter().zip(&mut self.rows) {
            side.gather(nodes, own);
        }
        self.turns(1, |of| of.side.find(of.own, of.other));
        for row in &mut self.rows {
            row.pull.fill([0.0; 3]);
        }
        self.turns(1, |of| of.resist(nodes));
        self.turns(1, |of| of.hold(nodes));
        let coefficient = self.coefficient;
        self.turns(PASSES, |of| of.touch(nodes, coefficient));
        self.turns(1, |of| of.settle());
        for (side, own) in self.sides.iter().zip(&mut self.rows) {
            side.scatter(nodes, own);
        }
        self.turns(1, |of| {
            let [pressed, rubbed] = of.power();
            work.contact_dissipation -= of.side.dt * pressed;
            work.frictional_dissipation -= of.side.dt * rubbed;
        });
    }

    /// Does `work` for the row above and then for the one below, so many `times`.
    fn turns(&mut self, times: usize, mut work: impl FnMut(&mut Turn)) {
        let ([above, below], [upper, lower]) = (&mut self.rows, &self.sides);
        for _ in 0..times {
            work(&mut Turn { side: upper, opposite: lower, own: above, other: below });
            work(&mut Turn { side: lower, opposite: upper, own: below, other: above });
        }
    }
}

/// The row whose turn it is, and the other one.
struct Turn<'t, 'p> {
    side: &'t SolidSide<'p>,
    opposite: &'t SolidSide<'p>,
    own: &'t mut SolidPairRow<'p>,
    other: &'t mut SolidPairRow<'p>,
}

impl Turn<'_, '_> {
    /// Turns what [`SolidSide::find`] has left for the resistance of each pair, 1 where the node is over a cell, into it: one over
    /// what a force moves the node by and, as far as it is its share, the corners.
    fn resist(&mut self, nodes: &SolidNodes) {
        let along_y = |index: usize| nodes.inverse_mass[1].get(index).map_or(0.0, |inverse| self.side.dt * inverse);
        for (at, place) in self.side.places() {
            let Some(pair) = self.own.pairs.get(place).map(|numbers| SolidPair::of(*numbers)) else { continue };
            if pair.resistance > 0.0 {
                take(self.other.pull, self.side.corners(at, &pair), &pair.weights(), &[-1.0, 0.0, 0.0]);
            }
        }
        for (at, place) in self.side.places() {
            let Some(numbers) = self.own.pairs.get_mut(place) else { continue };
            let mut pair = SolidPair::of(*numbers);
            if pair.resistance > 0.0 {
                let corners = self.side.corners(at, &pair).into_iter().zip(pair.weights());
                // Nodes on planes of symmetry, which are fixed across them, count as if they were not.
                let mobility = corners.fold(along_y(self.side.first + place), |sum, (corner, weight)| {
                    let load = self.other.pull.get(corner).map_or(0.0, |load| load[0]);
                    sum + weight * (load * along_y(self.opposite.first + corner))
                });
                pair.resistance = if mobility > 0.0 { 1.0 / mobility } else { 0.0 };
                *numbers = pair.numbers();
            }
        }
        self.other.pull.fill([0.0; 3]);
    }

    /// Begins with the forces of the last step.
    fn hold(&mut self, nodes: &SolidNodes) {
        for (at, place) in self.side.places() {
            let Some(pair) = self.own.pairs.get(place).map(|numbers| SolidPair::of(*numbers)) else { continue };
            if pair.pressing > 0.0 {
                self.push(nodes, at, place, &pair, &pair.force());
            }
        }
        self.follow(nodes);
    }

    /// Brings about the conditions of all pairs, by forces along their normals and across them: neither changes what the other does.
    fn touch(&mut self, nodes: &SolidNodes, coefficient: Real) {
        for (at, place) in self.side.places() {
            let Some(mut pair) = self.own.pairs.get(place).map(|numbers| SolidPair::of(*numbers)) else { continue };
            if pair.resistance == 0.0 {
                continue;
            }
            let moved = self.relative_velocity(at, place, &pair);
            let apart = dot(&moved, &pair.normal);
            let before = pair.force();
            pair.pressing = math::max(0.0, pair.pressing - pair.resistance * (pair.opening + apart));
            let rubbing =
                core::array::from_fn(|i| pair.friction[i] - pair.resistance * (moved[i] - apart * pair.normal[i]));
            pair.friction = limited_vector(rubbing, coefficient * pair.pressing);
            let after = pair.force();
            if after != before {
                self.push(nodes, at, place, &pair, &core::array::from_fn(|i| after[i] - before[i]));
                if let Some(numbers) = self.own.pairs.get_mut(place) {
                    *numbers = pair.numbers();
                }
            }
        }
        self.follow(nodes);
    }

    /// Velocity of the node of a pair relative to what is under it, m/s.
    fn relative_velocity(&self, at: [usize; 2], place: usize, pair: &SolidPair) -> [Real; 3] {
        let mut moved = self.own.velocity.get(place).copied().unwrap_or_default();
        for (corner, weight) in self.side.corners(at, pair).into_iter().zip(pair.weights()) {
            let beneath = self.other.velocity.get(corner).copied().unwrap_or_default();
            moved = core::array::from_fn(|i| moved[i] - weight * beneath[i]);
        }
        moved
    }

    /// Changes the velocity of the node of a pair by a `force`, N, and pulls at what is under it by the opposite.
    fn push(&mut self, nodes: &SolidNodes, at: [usize; 2], place: usize, pair: &SolidPair, force: &[Real; 3]) {
        if let Some(velocity) = self.own.velocity.get_mut(place) {
            change(nodes, self.side.first + place, self.side.dt, velocity, force);
        }
        take(self.other.pull, self.side.corners(at, pair), &pair.weights(), force);
    }

    /// Lets the nodes of the other row follow what pulls at them.
    fn follow(&mut self, nodes: &SolidNodes) {
        for (place, (velocity, pull)) in self.other.velocity.iter_mut().zip(&mut *self.other.pull).enumerate() {
            change(nodes, self.opposite.first + place, self.side.dt, velocity, pull);
            *pull = [0.0; 3];
        }
    }

    /// Pulls at the nodes and at what is under them by all of the forces.
    fn settle(&mut self) {
        for (at, place) in self.side.places() {
            let Some(pair) = self.own.pairs.get(place).map(|numbers| SolidPair::of(*numbers)) else { continue };
            if pair.pressing > 0.0 {
                let force = pair.force();
                take(self.other.pull, self.side.corners(at, &pair), &pair.weights(), &force);
                if let Some(pull) = self.own.pull.get_mut(place) {
                    *pull = core::array::from_fn(|i| pull[i] + force[i]);
                }
            }
        }
    }

    /// What the forces of the pairs do to their relative velocities, W: along the normals, then friction.
    fn power(&self) -> [Real; 2] {
        let mut work = [0.0; 2];
        for (at, place) in self.side.places() {
            let Some(pair) = self.own.pairs.get(place).map(|numbers| SolidPair::of(*numbers)) else { continue };
            if pair.pressing > 0.0 {
                let moved = self.relative_velocity(at, place, &pair);
                work[0] += pair.pressing * dot(&moved, &pair.normal);
                work[1] += dot(&pair.friction, &moved);
            }
        }
        work
    }
}

/// Changes the `velocity` of the node of this `index`, m/s, by a `force`, N.
fn change(nodes: &SolidNodes, index: usize, dt: Real, velocity: &mut [Real; 3], force: &[Real; 3]) {
    for i in 0..3 {
        let inverse = nodes.inverse_mass[i].get(index).copied().unwrap_or_default();
        velocity[i] += dt * (inverse * force[i]);
    }
}

/// Takes a `force` from what pulls at the `corners` of a cell, by their weights.
fn take(pull: &mut [[Real; 3]], corners: [usize; 4], weights: &[Real; 4], force: &[Real; 3]) {
    for (corner, weight) in corners.into_iter().zip(weights) {
        if let Some(pull) = pull.get_mut(corner) {
            *pull = core::array::from_fn(|i| pull[i] - weight * force[i]);
        }
    }
}
