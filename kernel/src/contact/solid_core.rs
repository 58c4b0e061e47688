//! The rigid core below a solid: its reaction, and unilateral contact with Coulomb friction where the layer is not bonded to it; as
//! [`crate::contact::rigid_core`], with two directions along the core.

use crate::contact::friction::limited_vector;
use crate::contact::solid_node::{SolidNode, SolidNodes, across, dot};
use crate::model::{Constants, Model};
use crate::number::math;
use crate::number::real::Real;
use crate::scenario::{Body, Interface};
use crate::state::{ContactWork, SolidState, StateNodes};

/// What the core does in one step: its upward force on the solid, N, and the energy it takes.
pub(crate) fn react(model: &Model, nodes: &mut StateNodes<&mut [Real]>) -> ContactWork {
    let constants = model.constants;
    let mut work = ContactWork::default();
    let StateNodes { displacement: [ux, uy], velocity: [vx, vy], force: [fx, fy], solid, .. } = nodes;
    if constants.scenario.core.interface == Interface::Bonded {
        // The core balances the forces on nodes that are fixed.
        let forces = fy.get(..constants.grid.plane()).unwrap_or_default();
        work.normal_force = forces.iter().fold(0.0, |sum, force| sum - force);
        return work;
    }
    let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
    let mut nodes =
        SolidNodes::new(model, [ux, uy, solid.displacement], [vx, vy, solid.velocity], [fx, fy, solid.force]);
    for index in 0..constants.grid.plane() {
        if let Some(node) = nodes.node(index) {
            nodes.add_force(index, touch(constants, &node, &mut work));
        }
    }
    work.contact_dissipation *= 0.5 * constants.dt;
    work.frictional_dissipation *= 0.5 * constants.dt;
    work
}

/// Outward normal of the core below a node, and how deep that lies in the core, m.
fn surface_normal(constants: &Constants, [x, y, z]: [Real; 3]) -> ([Real; 3], Real) {
    let Some(radius) = constants.scenario.core_radius() else { return ([0.0, 1.0, 0.0], -y) };
    let z = if constants.scenario.geometry.body == Body::Revolved { z } else { 0.0 };
    let distance = math::max(math::sqrt(x * x + y * y + z * z), Real::MIN_POSITIVE);
    ([x / distance, y / distance, z / distance], radius - distance)
}

/// The force of the core on a node that may slide and, unless it is on rollers, lift, N; adds what it does, but for half a step.
fn touch(constants: &Constants, node: &SolidNode, work: &mut ContactWork) -> [Real; 3] {
    let (core, dt) = (&constants.scenario.core, constants.dt);
    let (normal, depth) = surface_normal(constants, node.position);
    let free = node.next_velocity(dt);
    // In planes of symmetry the normal lies in them, so the fixed directions take no part in it.
    let approach = depth / dt - dot(&free, &normal);
    let pressure = if core.interface.holds() || approach > 0.0 { node.mass * approach / dt } else { 0.0 };
    let mut shear = [0.0; 3];
    if core.interface.rubs() {
        let stick = across(&free, &normal).map(|along| -node.mass * along / dt);
        shear = limited_vector(stick, core.friction_coefficient * pressure);
    }
    let pull = core::array::from_fn(|i| pressure * normal[i] + shear[i]);
    let twice_mean: [Real; 3] =
        core::array::from_fn(|i| node.velocity[i] + free[i] + dt * (node.inverse_mass[i] * pull[i]));
    work.normal_force += pull[1];
    work.contact_dissipation -= pressure * dot(&twice_mean, &normal);
    work.frictional_dissipation -= dot(&shear, &twice_mean);
    pull
}
