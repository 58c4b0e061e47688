//! Contact and friction between the impactor's flat face and the surface nodes.
//!
//! Contact is a constraint, not a penalty: the forces are those that leave every touching node on the face at the end
//! of the step, with the impactor's own reaction included (forward increment Lagrange multipliers, Carpenter, Taylor
//! and Katona 1991; here in closed form, because the lumped masses decouple). Nothing penetrates and no energy hides in
//! springs. A node that is caught loses the kinetic energy of its velocity relative to the face; the ledger counts it.
//!
//! Friction stops a node within the limit of Coulomb's law in the same step: a sticking node has exactly no velocity.

use crate::impactor::Prediction;
use crate::lanes::{LANES, ZERO, lanes, lanes_mut, sum};
use crate::model::Model;
use crate::real::Real;
use crate::state::State;
use crate::vector::{Instructions, Vector};

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
pub(crate) fn contact<S: Instructions>(set: S, model: &Model, state: &mut State, prediction: &Prediction) -> Contact {
    free_heights(set, model, state);
    let face = face_position(set, model, state.nodes.contact_normal, prediction);
    let normal_force = normal_forces(set, model, state, face);
    let before = state.scalars.impactor.velocity_half;
    state.scalars.impactor.advance(model, prediction, normal_force);
    slide(set, model, state, [before, state.scalars.impactor.velocity_half], normal_force)
}

/// Leaves in the row of normal forces, until they are known, the height of each surface node above the undeformed anvil's
/// top at the end of a step without contact, m; far below where it is not under the face.
#[inline(always)]
fn free_heights<S: Instructions>(set: S, model: &Model, state: &mut State) {
    let (constants, fixed, nodes) = (&model.constants, &model.nodes, &mut state.nodes);
    let impactor = &constants.scenario.impactor;
    let half_width = set.splat(0.5 * impactor.face_diameter);
    let (zero, far_below) = (set.splat(0.0), set.splat(FAR_BELOW));
    let top = constants.grid.top();
    let place = lanes(fixed.reference_x, top).zip(lanes(nodes.displacement_x, top));
    let level = lanes(fixed.reference_y, top).zip(lanes(nodes.displacement_y, top));
    let motion = lanes(fixed.inverse_mass_y, top).zip(lanes(nodes.force_y, top)).zip(lanes(nodes.velocity_y, top));
    let rows = lanes(fixed.nodal_mass, top).zip(place).zip(level).zip(motion);
    for (height, (((mass, (x, ux)), (y, uy)), ((inverse_mass, force), velocity))) in
        lanes_mut(nodes.contact_normal, 0).zip(rows)
    {
        for chunk in 0..LANES / S::WIDTH {
            let change = (set.load(inverse_mass, chunk) * set.load(force, chunk)).times(constants.dt);
            let velocity = set.load(velocity, chunk) + change;
            let free =
                (set.load(y, chunk).plus(-constants.top_height) + set.load(uy, chunk)) + velocity.times(constants.dt);
            let from_centre = (set.load(x, chunk) + set.load(ux, chunk)).plus(-impactor.offset);
            let distance = zero.if_greater(from_centre, from_centre.times(-1.0), from_centre);
            let under = distance.if_greater(half_width, far_below, free);
            set.store(set.load(mass, chunk).if_greater(zero, under, far_below), height, chunk);
        }
    }
}

/// A height that no face reaches, m.
const FAR_BELOW: Real = -1e30;

/// Height of the face at the end of the step, m, over surface nodes of `free_height`.
///
/// It is the root z of M (z - z_free) = sum m_i max(0, y_i - z), a concave rising function: Newton's method climbs to
/// it from z_free through a shrinking set of touching nodes.
#[inline(always)]
fn face_position<S: Instructions>(set: S, model: &Model, free_height: &[Real], prediction: &Prediction) -> Real {
    let mut position = prediction.position;
    if !prediction.free {
        return position;
    }
    let (zero, start) = (set.splat(0.0), set.splat(prediction.position));
    for _ in 0..PASSES {
        let (face, mut masses, mut moments) = (set.splat(position), ZERO, ZERO);
        for (mass, height) in lanes(model.nodes.nodal_mass, model.constants.grid.top()).zip(lanes(free_height, 0)) {
            for chunk in 0..LANES / S::WIDTH {
                let (mass, height) = (set.load(mass, chunk), set.load(height, chunk));
                let touching = height.if_greater(face, mass, zero);
                let moment = height.if_greater(face, mass * (height - start), zero);
                set.add(touching, &mut masses, chunk);
                set.add(moment, &mut moments, chunk);
            }
        }
        position = prediction.position + sum(&moments) / (model.constants.section_mass() + sum(&masses));
    }
    position
}

/// The force that brings each penetrating node back to the face within the step; returns their sum in index order.
#[inline(always)]
fn normal_forces<S: Instructions>(set: S, model: &Model, state: &mut State, face: Real) -> Real {
    let top = model.constants.grid.top();
    let inverse_dt_squared = 1.0 / (model.constants.dt * model.constants.dt);
    let (zero, face, mut total) = (set.splat(0.0), set.splat(face), ZERO);
    let rows = lanes_mut(state.nodes.contact_normal, 0).zip(lanes_mut(state.nodes.force_y, top));
    for (mass, (normal, force)) in lanes(model.nodes.nodal_mass, top).zip(rows) {
        for chunk in 0..LANES / S::WIDTH {
            let height = set.load(normal, chunk);
            let holding = (set.load(mass, chunk) * (height - face)).times(inverse_dt_squared);
            let holding = height.if_greater(face, holding, zero);
            set.store(holding, normal, chunk);
            set.store(set.load(force, chunk) - holding, force, chunk);
            set.add(holding, &mut total, chunk);
        }
    }
    sum(&total)
}

/// Friction of the surface nodes, and the energy that it and the normal forces take in this step, with the velocity of the
/// `face` before and after.
#[inline(always)]
fn slide<S: Instructions>(set: S, model: &Model, state: &mut State, face: [Real; 2], normal_force: Real) -> Contact {
    let (fixed, nodes, top) = (&model.nodes, &mut state.nodes, model.constants.grid.top());
    let dt = model.constants.dt;
    let (inverse_dt, coefficient) = (1.0 / dt, model.constants.scenario.face.friction_coefficient);
    let (zero, mut catching, mut sliding) = (set.splat(0.0), [ZERO; 2], [ZERO; 2]);
    let across = lanes(fixed.inverse_mass_y, top).zip(lanes(nodes.force_y, top)).zip(lanes(nodes.velocity_y, top));
    let along = lanes(fixed.inverse_mass_x, top).zip(lanes_mut(nodes.force_x, top)).zip(lanes(nodes.velocity_x, top));
    let contact = lanes(nodes.contact_normal, 0).zip(lanes_mut(nodes.contact_tangential, 0));
    for (((mass, contact), ((inverse_x, force_x), velocity_x)), ((inverse_y, force_y), velocity_y)) in
        lanes(fixed.nodal_mass, top).zip(contact).zip(along).zip(across)
    {
        let (normal, tangential) = contact;
        for chunk in 0..LANES / S::WIDTH {
            let (normal, mass) = (set.load(normal, chunk), set.load(mass, chunk));
            let (velocity_x, inverse_x) = (set.load(velocity_x, chunk), set.load(inverse_x, chunk));
            let (velocity_y, inverse_y) = (set.load(velocity_y, chunk), set.load(inverse_y, chunk));
            let internal = set.load(force_x, chunk);
            // The force that stops the node in this step, where it can move at all.
            let stick = ((mass * velocity_x).times(inverse_dt) + internal).times(-1.0);
            let limit = inverse_x.if_greater(zero, normal.times(coefficient), zero);
            let friction = limited(stick, limit);
            let force = internal + friction;
            let after_x = velocity_x + (inverse_x * force).times(dt);
            let after_y = velocity_y + (inverse_y * set.load(force_y, chunk)).times(dt);
            set.store(friction, tangential, chunk);
            set.store(force, force_x, chunk);
            let against = zero - friction;
            set.add(normal * velocity_y.plus(-face[0]), &mut catching[0], chunk);
            set.add(normal * after_y.plus(-face[1]), &mut catching[1], chunk);
            set.add(against * velocity_x, &mut sliding[0], chunk);
            set.add(against * after_x, &mut sliding[1], chunk);
        }
    }
    Contact {
        normal_force,
        catching: [0.5 * dt * sum(&catching[0]), 0.5 * dt * sum(&catching[1])],
        sliding: [0.5 * dt * sum(&sliding[0]), 0.5 * dt * sum(&sliding[1])],
    }
}

/// `force`, its size limited to `limit`.
#[inline(always)]
pub(crate) fn limited<V: Vector>(force: V, limit: V) -> V {
    let opposite = limit.times(-1.0);
    force.if_greater(limit, limit, opposite.if_greater(force, opposite, force))
}
