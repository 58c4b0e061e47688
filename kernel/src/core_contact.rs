//! The rigid core: its reaction, and unilateral contact with Coulomb friction where the layer is not bonded to it.
//!
//! The forces are those of [`crate::face`], towards a fixed surface: the normal force leaves a penetrating node on the
//! surface at the end of the step, the tangential one stops it within the limit of Coulomb's law.

use crate::face::{Contact, limited};
use crate::math;
use crate::model::{Model, core_radius};
use crate::real::Real;
use crate::scenario::Interface;
use crate::state::State;

/// What the core does in one step: its upward force on the section, N, and the energy it takes.
pub(crate) fn react(model: &Model, state: &mut State) -> Contact {
    let nodes = 0..=model.constants.grid.n_u;
    let mut contact = Contact::default();
    match model.constants.scenario.core.interface {
        // The core balances the forces on nodes that are fixed.
        Interface::Bonded => {
            let forces = state.nodes.force_y.get(nodes).unwrap_or_default();
            contact.normal_force = forces.iter().fold(0.0, |sum, force| sum - force);
        }
        Interface::Frictional | Interface::Sliding => {
            for node in nodes {
                touch(model, state, node, &mut contact);
            }
        }
    }
    contact
}

/// A node that may slide and, unless it is on rollers, lift.
fn touch(model: &Model, state: &mut State, node: usize, contact: &mut Contact) -> Option<()> {
    let dt = model.constants.dt;
    let nodes = &mut state.nodes;
    let (x, y) = (
        model.nodes.reference_x.get(node)? + nodes.displacement_x.get(node)?,
        model.nodes.reference_y.get(node)? + nodes.displacement_y.get(node)?,
    );
    let (normal, depth) = surface_normal(model, x, y);
    let (force_x, force_y) = (nodes.force_x.get_mut(node)?, nodes.force_y.get_mut(node)?);
    let before = [*nodes.velocity_x.get(node)?, *nodes.velocity_y.get(node)?];
    let inverse = [*model.nodes.inverse_mass_x.get(node)?, *model.nodes.inverse_mass_y.get(node)?];
    let mass = *model.nodes.nodal_mass.get(node)?;
    let free = [before[0] + dt * inverse[0] * *force_x, before[1] + dt * inverse[1] * *force_y];
    // On the centre line the normal is vertical, so the fixed direction takes no part in it.
    let approach = depth / dt - (free[0] * normal[0] + free[1] * normal[1]);
    let sliding = model.constants.scenario.core.interface == Interface::Sliding;
    let pressure = if approach > 0.0 || sliding { mass * approach / dt } else { 0.0 };
    let along = free[0] * normal[1] - free[1] * normal[0];
    let shear = if inverse[0] > 0.0 && !sliding {
        limited(-mass * along / dt, model.constants.scenario.core.friction_coefficient * pressure)
    } else {
        0.0
    };
    let (pull_x, pull_y) = (pressure * normal[0] + shear * normal[1], pressure * normal[1] - shear * normal[0]);
    *force_x += pull_x;
    *force_y += pull_y;
    contact.normal_force += pull_y;
    let after = [before[0] + dt * inverse[0] * *force_x, before[1] + dt * inverse[1] * *force_y];
    for (half, velocity) in [before, after].into_iter().enumerate() {
        let speed_normal = velocity[0] * normal[0] + velocity[1] * normal[1];
        let speed_along = velocity[0] * normal[1] - velocity[1] * normal[0];
        contact.catching[half] -= 0.5 * dt * pressure * speed_normal;
        contact.sliding[half] -= 0.5 * dt * shear * speed_along;
    }
    Some(())
}

/// Outward normal of the core below (x, y), and how deep the point lies in the core, m.
fn surface_normal(model: &Model, x: Real, y: Real) -> ([Real; 2], Real) {
    match core_radius(&model.constants.scenario) {
        Some(radius) => {
            let distance = math::larger(math::sqrt(x * x + y * y), Real::MIN_POSITIVE);
            ([x / distance, y / distance], radius - distance)
        }
        None => ([0.0, 1.0], -y),
    }
}
