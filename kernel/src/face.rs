//! Contact and friction between the impactor's flat face and the surface nodes.
//!
//! Contact is a constraint, not a penalty: the forces are those that leave every touching node on the face at the end
//! of the step, with the impactor's own reaction included (forward increment Lagrange multipliers, Carpenter, Taylor
//! and Katona 1991; here in closed form, because the lumped masses decouple). Nothing penetrates and no energy hides in
//! springs. A node that is caught loses the kinetic energy of its velocity relative to the face; the ledger counts it.
//!
//! Friction stops a node within the limit of Coulomb's law in the same step: a sticking node has exactly no velocity.

use crate::impactor::Prediction;
use crate::lanes::{LANES, ZERO, load, store, subtract_at, sum};
use crate::math;
use crate::model::Model;
use crate::real::Real;
use crate::state::State;

/// Passes of the search for the touching nodes. The end position of the face rises with each, from below, by the ratio
/// of a node's mass to the impactor's; what is left after four passes is below rounding for any impactor heavier than
/// the layer, and momentum is exact after any number.
const PASSES: usize = 4;

/// What the contact did in one step, on the section.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Contact {
    /// Sum of the normal forces, N.
    pub normal_force: Real,
    /// Energy lost in catching nodes, in the half step before and the half step after the forces, J.
    pub catching: [Real; 2],
    /// Energy lost in sliding, likewise, J.
    pub sliding: [Real; 2],
}

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
#[inline(always)]
pub(crate) fn contact(model: &Model, state: &mut State, prediction: &Prediction) -> Contact {
    free_heights(model, state);
    let top = model.constants.grid.n_v * model.constants.grid.stride();
    let mass = model.nodes.nodal_mass.get(top..).unwrap_or_default();
    let face = face_position(model.constants.section_mass(), mass, state.nodes.contact_normal, prediction);
    let normal_force = normal_forces(model.constants.dt, mass, state, top, face);
    let before = state.scalars.impactor.velocity_half;
    state.scalars.impactor.advance(model, prediction, normal_force);
    let velocity = [before, state.scalars.impactor.velocity_half];
    let mut contact = Contact { normal_force, ..Contact::default() };
    slide(model, state, top, velocity, &mut contact);
    contact
}

/// Leaves in the row of normal forces, until they are known, the height of each surface node above the undeformed anvil's
/// top at the end of a step without contact, m; far below where it is not under the face.
#[inline(always)]
fn free_heights(model: &Model, state: &mut State) {
    let (constants, fixed, nodes) = (&model.constants, &model.nodes, &mut state.nodes);
    let impactor = &constants.scenario.impactor;
    let (dt, half_width) = (constants.dt, 0.5 * impactor.face_diameter);
    let stride = constants.grid.stride();
    for index in (0..stride).step_by(LANES) {
        let node = constants.grid.n_v * stride + index;
        let (x, y) = (load(fixed.reference_x, node), load(fixed.reference_y, node));
        let (ux, uy) = (load(nodes.displacement_x, node), load(nodes.displacement_y, node));
        let (inverse_mass, force) = (load(fixed.inverse_mass_y, node), load(nodes.force_y, node));
        let (velocity, mass) = (load(nodes.velocity_y, node), load(fixed.nodal_mass, node));
        let mut height = ZERO;
        for l in 0..LANES {
            let velocity = velocity[l] + dt * (inverse_mass[l] * force[l]);
            let under = math::abs(x[l] + ux[l] - impactor.offset) <= half_width && mass[l] > 0.0;
            let free = (y[l] - constants.top_height + uy[l]) + dt * velocity;
            height[l] = if under { free } else { FAR_BELOW };
        }
        store(nodes.contact_normal, index, &height);
    }
}

/// A height that no face reaches, m.
const FAR_BELOW: Real = -1e30;

/// Height of the face at the end of the step, m, over surface nodes of `mass` and `free_height`.
///
/// It is the root z of M (z - z_free) = sum m_i max(0, y_i - z), a concave rising function: Newton's method climbs to
/// it from z_free through a shrinking set of touching nodes.
#[inline(always)]
fn face_position(impactor_mass: Real, mass: &[Real], free_height: &[Real], prediction: &Prediction) -> Real {
    let mut position = prediction.position;
    if !prediction.free {
        return position;
    }
    for _ in 0..PASSES {
        let (mut masses, mut moments) = (ZERO, ZERO);
        for index in (0..free_height.len()).step_by(LANES) {
            let (mass, height) = (load(mass, index), load(free_height, index));
            for l in 0..LANES {
                let touching = height[l] > position;
                masses[l] += if touching { mass[l] } else { 0.0 };
                moments[l] += if touching { mass[l] * (height[l] - prediction.position) } else { 0.0 };
            }
        }
        position = prediction.position + sum(&moments) / (impactor_mass + sum(&masses));
    }
    position
}

/// The force that brings each penetrating node back to the face within the step; returns their sum in index order.
#[inline(always)]
fn normal_forces(dt: Real, mass: &[Real], state: &mut State, top: usize, face: Real) -> Real {
    let inverse_dt_squared = 1.0 / (dt * dt);
    let mut total = ZERO;
    for index in (0..state.nodes.contact_normal.len()).step_by(LANES) {
        let (mass, height) = (load(mass, index), load(state.nodes.contact_normal, index));
        let mut normal = ZERO;
        for l in 0..LANES {
            let force = mass[l] * (height[l] - face) * inverse_dt_squared;
            normal[l] = if height[l] > face { force } else { 0.0 };
            total[l] += normal[l];
        }
        store(state.nodes.contact_normal, index, &normal);
        subtract_at(state.nodes.force_y, top + index, &normal);
    }
    sum(&total)
}

/// Friction of the surface nodes, and the energy that it and the normal forces take in this step.
#[inline(always)]
fn slide(model: &Model, state: &mut State, top: usize, face: [Real; 2], contact: &mut Contact) {
    let (fixed, nodes) = (&model.nodes, &mut state.nodes);
    let dt = model.constants.dt;
    let (inverse_dt, coefficient) = (1.0 / dt, model.constants.scenario.face.friction_coefficient);
    let (mut catching, mut sliding) = ([ZERO; 2], [ZERO; 2]);
    for index in (0..nodes.contact_normal.len()).step_by(LANES) {
        let node = top + index;
        let (normal, force_y) = (load(nodes.contact_normal, index), load(nodes.force_y, node));
        let (velocity_x, velocity_y) = (load(nodes.velocity_x, node), load(nodes.velocity_y, node));
        let (inverse_x, inverse_y) = (load(fixed.inverse_mass_x, node), load(fixed.inverse_mass_y, node));
        let (mass, mut force_x, mut tangential) = (load(fixed.nodal_mass, node), load(nodes.force_x, node), ZERO);
        for l in 0..LANES {
            // The force that stops the node in this step, where it can move at all.
            let stick = -(mass[l] * velocity_x[l] * inverse_dt + force_x[l]);
            let limit = if inverse_x[l] > 0.0 { coefficient * normal[l] } else { 0.0 };
            tangential[l] = limited(stick, limit);
            force_x[l] += tangential[l];
            let after_x = velocity_x[l] + dt * (inverse_x[l] * force_x[l]);
            let after_y = velocity_y[l] + dt * (inverse_y[l] * force_y[l]);
            catching[0][l] += normal[l] * (velocity_y[l] - face[0]);
            catching[1][l] += normal[l] * (after_y - face[1]);
            sliding[0][l] -= tangential[l] * velocity_x[l];
            sliding[1][l] -= tangential[l] * after_x;
        }
        store(nodes.contact_tangential, index, &tangential);
        store(nodes.force_x, node, &force_x);
    }
    contact.catching = catching.map(|lane| 0.5 * dt * sum(&lane));
    contact.sliding = sliding.map(|lane| 0.5 * dt * sum(&lane));
}

/// `force`, its size limited to `limit`.
#[inline(always)]
pub(crate) fn limited(force: Real, limit: Real) -> Real {
    if force > limit {
        limit
    } else if force < -limit {
        -limit
    } else {
        force
    }
}
