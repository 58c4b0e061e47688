//! Contact and friction between the impactor's flat face and the surface nodes.
//!
//! Contact is a constraint, not a penalty: the forces are those that leave every touching node on the face at the end
//! of the step, with the impactor's own reaction included (forward increment Lagrange multipliers, Carpenter, Taylor
//! and Katona 1991; here in closed form, because the lumped masses decouple). Nothing penetrates and no energy hides in
//! springs. A node that is caught loses the kinetic energy of its velocity relative to the face; the ledger counts it.
//!
//! Friction stops a node within the limit of Coulomb's law in the same step: a sticking node has exactly no velocity.

use crate::impactor::Prediction;
use crate::math;
use crate::model::Model;
use crate::state::State;

/// Passes of the search for the touching nodes. The end position of the face rises with each, from below, by the ratio
/// of a node's mass to the impactor's; what is left after four passes is below rounding for any impactor heavier than
/// the layer, and momentum is exact after any number.
const PASSES: usize = 4;

/// What the contact did in one step, on the section.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Contact {
    /// Sum of the normal forces, N.
    pub normal_force: f64,
    /// Energy lost in catching nodes, in the half step before and the half step after the forces, J.
    pub catching: [f64; 2],
    /// Energy lost in sliding, likewise, J.
    pub sliding: [f64; 2],
}

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
pub(crate) fn contact(model: &Model, state: &mut State, prediction: &Prediction) -> Contact {
    let face = face_position(model, state, prediction);
    let normal_force = normal_forces(model, state, face);
    let before = state.scalars.impactor.velocity_half;
    state.scalars.impactor.advance(model, prediction, normal_force);
    let velocity = [before, state.scalars.impactor.velocity_half];
    let mut contact = Contact { normal_force, ..Contact::default() };
    for column in 0..=model.constants.grid.n_u {
        if slide(model, state, column, velocity, &mut contact).is_none() {
            break;
        }
    }
    contact
}

/// A surface node as the normal contact sees it.
struct SurfaceNode {
    /// Index in the node arrays.
    node: usize,
    /// Height above the undeformed anvil's top at the end of a step without contact, m.
    free_height: f64,
    /// Lumped mass, kg.
    mass: f64,
}

/// The surface node of a column if it is under the face.
fn surface_node(model: &Model, state: &State, column: usize) -> Option<SurfaceNode> {
    let (constants, fixed, nodes) = (&model.constants, &model.nodes, &state.nodes);
    let node = constants.grid.n_v * constants.grid.stride() + column;
    let impactor = &constants.scenario.impactor;
    let x = fixed.reference_x.get(node)? + nodes.displacement_x.get(node)?;
    if math::abs(x - impactor.offset) > 0.5 * impactor.face_diameter {
        return None;
    }
    let acceleration = fixed.inverse_mass_y.get(node)? * nodes.force_y.get(node)?;
    let velocity = nodes.velocity_y.get(node)? + constants.dt * acceleration;
    let height = fixed.reference_y.get(node)? - constants.top_height + nodes.displacement_y.get(node)?;
    Some(SurfaceNode { node, free_height: height + constants.dt * velocity, mass: *fixed.nodal_mass.get(node)? })
}

/// Height of the face at the end of the step, m.
///
/// It is the root z of M (z - z_free) = sum m_i max(0, y_i - z), a concave rising function: Newton's method climbs to
/// it from z_free through a shrinking set of touching nodes.
fn face_position(model: &Model, state: &State, prediction: &Prediction) -> f64 {
    let mut position = prediction.position;
    if !prediction.free {
        return position;
    }
    for _ in 0..PASSES {
        let mut mass = model.constants.section_mass();
        let mut moment = 0.0;
        for column in 0..=model.constants.grid.n_u {
            if let Some(surface) = surface_node(model, state, column)
                && surface.free_height > position
            {
                mass += surface.mass;
                moment += surface.mass * (surface.free_height - prediction.position);
            }
        }
        position = prediction.position + moment / mass;
    }
    position
}

/// The force that brings each penetrating node back to the face within the step; returns their sum in index order.
fn normal_forces(model: &Model, state: &mut State, face: f64) -> f64 {
    let inverse_dt_squared = 1.0 / (model.constants.dt * model.constants.dt);
    let mut sum = 0.0;
    for column in 0..=model.constants.grid.n_u {
        let surface = surface_node(model, state, column);
        let Some(normal) = state.nodes.contact_normal.get_mut(column) else { break };
        *normal = 0.0;
        if let Some(SurfaceNode { node, free_height, mass }) = surface
            && free_height > face
            && let Some(force) = state.nodes.force_y.get_mut(node)
        {
            *normal = mass * (free_height - face) * inverse_dt_squared;
            *force -= *normal;
            sum += *normal;
        }
    }
    sum
}

/// Friction of one surface node, and the energy that it and the normal force take in this step.
fn slide(model: &Model, state: &mut State, column: usize, face: [f64; 2], contact: &mut Contact) -> Option<()> {
    let constants = &model.constants;
    let dt = constants.dt;
    let node = constants.grid.n_v * constants.grid.stride() + column;
    let normal = *state.nodes.contact_normal.get(column)?;
    let tangential = state.nodes.contact_tangential.get_mut(column)?;
    let (force_x, force_y) = (state.nodes.force_x.get_mut(node)?, *state.nodes.force_y.get(node)?);
    let (velocity_x, velocity_y) = (*state.nodes.velocity_x.get(node)?, *state.nodes.velocity_y.get(node)?);
    let (inverse_x, inverse_y) = (*model.nodes.inverse_mass_x.get(node)?, *model.nodes.inverse_mass_y.get(node)?);
    *tangential = 0.0;
    if inverse_x > 0.0 {
        let stick = -(velocity_x / dt + inverse_x * *force_x) / inverse_x;
        *tangential = limited(stick, constants.scenario.face.friction_coefficient * normal);
        *force_x += *tangential;
    }
    let after_x = velocity_x + dt * inverse_x * *force_x;
    let after_y = velocity_y + dt * inverse_y * force_y;
    contact.catching[0] += 0.5 * dt * normal * (velocity_y - face[0]);
    contact.catching[1] += 0.5 * dt * normal * (after_y - face[1]);
    contact.sliding[0] -= 0.5 * dt * *tangential * velocity_x;
    contact.sliding[1] -= 0.5 * dt * *tangential * after_x;
    Some(())
}

/// `force`, its size limited to `limit`.
pub(crate) fn limited(force: f64, limit: f64) -> f64 {
    if force > limit {
        limit
    } else if force < -limit {
        -limit
    } else {
        force
    }
}
