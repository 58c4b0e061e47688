//! The rigid core below a solid: its reaction, and unilateral contact with Coulomb friction where the layer is not bonded to it; as
//! [`crate::contact::rigid_core`], with two directions along the core.

use crate::contact::friction::limited_pair;
use crate::model::{Constants, Model};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{Body, Interface};
use crate::state::{ContactWork, SolidState, State, StateNodes};

/// What the core does in one step: its upward force on the solid, N, and the energy it takes.
pub(crate) fn react(model: &Model, state: &mut State) -> ContactWork {
    let constants = model.constants;
    let mut work = ContactWork::default();
    if constants.scenario.core.interface == Interface::Bonded {
        // The core balances the forces on nodes that are fixed.
        let forces = state.nodes.force[1].get(..constants.grid.plane()).unwrap_or_default();
        work.normal_force = forces.iter().fold(0.0, |sum, force| sum - force);
        return work;
    }
    for index in 0..constants.grid.plane() {
        let Some(mut node) = CoreNode::of(model, state, index) else { continue };
        node.touch(constants, &mut work);
        node.store(constants, state, index);
    }
    work.contact_dissipation *= 0.5 * constants.dt;
    work.frictional_dissipation *= 0.5 * constants.dt;
    work
}

/// A node at the core, along x, y and z.
struct CoreNode {
    mass: Real,
    inverse_mass: [Real; 3],
    position: [Real; 3],
    velocity: [Real; 3],
    force: [Real; 3],
}

impl CoreNode {
    /// None of padding, which has no mass.
    fn of(model: &Model, state: &mut State, index: usize) -> Option<Self> {
        let (constants, fixed, along) = (model.constants, &model.nodes, model.solid());
        let mass = *fixed.nodal_mass.get(index).filter(|mass| **mass > 0.0)?;
        let StateNodes { displacement, velocity, force, solid, .. } = &mut state.nodes;
        let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
        let at = |rows: [&[Real]; 3]| Some([*rows[0].get(index)?, *rows[1].get(index)?, *rows[2].get(index)?]);
        let rest = at([fixed.reference_x, fixed.reference_y, along.reference_z])?;
        let moved = at([displacement[0], displacement[1], solid.displacement])?;
        Some(Self {
            mass,
            inverse_mass: at([fixed.inverse_mass_x, fixed.inverse_mass_y, along.inverse_mass_z])?,
            position: [rest[0] + moved[0], rest[1] + moved[1], rest[2] + moved[2]],
            velocity: at([velocity[0], velocity[1], solid.velocity])?,
            force: at([force[0], force[1], solid.force])?,
        })
    }

    fn store(&self, constants: &Constants, state: &mut State, index: usize) {
        let StateNodes { force: [x, y], solid, .. } = &mut state.nodes;
        let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
        for (row, force) in [&mut **x, &mut **y, solid.force].into_iter().zip(self.force) {
            if let Some(place) = row.get_mut(index) {
                *place = force;
            }
        }
    }

    /// Outward normal of the core below the node, and how deep it lies in the core, m.
    fn surface_normal(&self, constants: &Constants) -> ([Real; 3], Real) {
        let [x, y, z] = self.position;
        let Some(radius) = constants.scenario.core_radius() else { return ([0.0, 1.0, 0.0], -y) };
        let z = if constants.scenario.geometry.body == Body::Revolved { z } else { 0.0 };
        let distance = math::max(math::sqrt(x * x + y * y + z * z), Real::MIN_POSITIVE);
        ([x / distance, y / distance, z / distance], radius - distance)
    }

    /// Adds the forces of the core to those of a node that may slide and, unless it is on rollers, lift.
    fn touch(&mut self, constants: &Constants, work: &mut ContactWork) {
        let (core, dt) = (&constants.scenario.core, constants.dt);
        let rollers = core.interface == Interface::Sliding;
        let (normal, depth) = self.surface_normal(constants);
        let free = self.velocity_after(dt);
        let approach = depth / dt - dot(&free, &normal);
        let pressure = if rollers || approach > 0.0 { self.mass * approach / dt } else { 0.0 };
        let mut shear = [0.0; 3];
        if !rollers {
            shear = self.friction(&free, &normal, core.friction_coefficient * pressure, dt);
        }
        let before = self.velocity;
        for i in 0..3 {
            self.force[i] += pressure * normal[i] + shear[i];
        }
        let after = self.velocity_after(dt);
        let twice_mean = [before[0] + after[0], before[1] + after[1], before[2] + after[2]];
        work.normal_force += pressure * normal[1] + shear[1];
        work.contact_dissipation -= pressure * dot(&twice_mean, &normal);
        work.frictional_dissipation -= dot(&shear, &twice_mean);
    }

    /// Velocity after the force of the step so far, m/s.
    fn velocity_after(&self, dt: Real) -> [Real; 3] {
        core::array::from_fn(|i| self.velocity[i] + dt * (self.inverse_mass[i] * self.force[i]))
    }

    /// The force that stops the node along the core within Coulomb's law, N, in the directions that are not fixed.
    fn friction(&self, free: &[Real; 3], normal: &[Real; 3], limit: Real, dt: Real) -> [Real; 3] {
        // Two directions along the core, of which one is upright or, at its top, along x.
        let first = perpendicular(normal);
        let second = [
            normal[1] * first[2] - normal[2] * first[1],
            normal[2] * first[0] - normal[0] * first[2],
            normal[0] * first[1] - normal[1] * first[0],
        ];
        let stop = [&first, &second].map(|direction| -self.mass * dot(free, direction) / dt);
        let [a, b] = limited_pair(stop, limit);
        core::array::from_fn(|i| if self.inverse_mass[i] > 0.0 { a * first[i] + b * second[i] } else { 0.0 })
    }
}

fn dot(a: &[Real; 3], b: &[Real; 3]) -> Real {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A direction across a `normal` that does not point down.
fn perpendicular([x, y, _]: &[Real; 3]) -> [Real; 3] {
    let length = math::sqrt(x * x + y * y);
    if length > 0.0 { [y / length, -x / length, 0.0] } else { [1.0, 0.0, 0.0] }
}
