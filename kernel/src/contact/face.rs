//! ContactWork and friction between the impactor's flat face and the surface nodes.
//!
//! ContactWork is a constraint, not a penalty: the forces are those that leave every touching node on the face at the end
//! of the step, with the impactor's own reaction included (forward increment Lagrange multipliers, Carpenter, Taylor
//! and Katona 1991; here in closed form, because the lumped masses decouple). Nothing penetrates and no energy hides in
//! springs. A node that is caught loses the kinetic energy of its velocity relative to the face; the ledger counts it.
//!
//! Friction stops a node within the limit of Coulomb's law in the same step: a sticking node has exactly no velocity.

use crate::contact::friction::limited;
use crate::impactor::Prediction;
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Lane, ZERO, lanes, lanes_mut, sum};
use crate::number::real::Real;
use crate::number::vector::{Instructions, Vector};
use crate::state::{ContactWork, State, StateNodes};

/// Passes of the search for the touching nodes. The end position of the face rises with each, from below, by the ratio
/// of a node's mass to the impactor's; what is left after four passes is below rounding for any impactor heavier than
/// the layer, and momentum is exact after any number.
const PASSES: usize = 4;

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
#[inline(always)]
pub(crate) fn contact<S: Instructions>(
    set: S,
    model: &Model,
    state: &mut State,
    prediction: &Prediction,
) -> ContactWork {
    let (constants, impactor) = (&model.constants, &mut state.scalars.impactor);
    let Some(mut surface) = Surface::of(model, &mut state.nodes) else { return ContactWork::default() };
    surface.find_free_heights(set, constants);
    let face = surface.face_position(set, constants.section_mass(), prediction);
    let normal_force = surface.hold(set, constants.dt, face);
    let before = impactor.velocity_half;
    impactor.advance(model, prediction, normal_force);
    let [catching, sliding] = surface.slide(set, constants, [before, impactor.velocity_half]);
    ContactWork { normal_force, catching, sliding }
}

/// The nodes at the surface, in lanes of as many numbers each; x before y.
struct Surface<'s> {
    mass: &'s [Lane],
    inverse_mass: [&'s [Lane]; 2],
    reference: [&'s [Lane]; 2],
    displacement: [&'s [Lane]; 2],
    velocity: [&'s [Lane]; 2],
    force: [&'s mut [Lane]; 2],
    /// Normal forces, N. Until they are known, the height of each node above the undeformed anvil's top at the end of a step
    /// without contact, m; far below where it is not under the face.
    normal: &'s mut [Lane],
    tangential: &'s mut [Lane],
}

/// A height that no face reaches, m.
const FAR_BELOW: Real = -1e30;

impl<'s> Surface<'s> {
    /// None if a row is too short, which the sizes of [`crate::mesh::Grid`] exclude.
    #[inline(always)]
    fn of(model: &'s Model, nodes: &'s mut StateNodes) -> Option<Self> {
        let (grid, fixed) = (&model.constants.grid, &model.nodes);
        let (top, count) = (grid.n_v * grid.stride(), grid.stride() / LANES);
        Some(Self {
            mass: lanes(fixed.nodal_mass, top, count)?,
            inverse_mass: [lanes(fixed.inverse_mass_x, top, count)?, lanes(fixed.inverse_mass_y, top, count)?],
            reference: [lanes(fixed.reference_x, top, count)?, lanes(fixed.reference_y, top, count)?],
            displacement: [lanes(nodes.displacement_x, top, count)?, lanes(nodes.displacement_y, top, count)?],
            velocity: [lanes(nodes.velocity_x, top, count)?, lanes(nodes.velocity_y, top, count)?],
            force: [lanes_mut(nodes.force_x, top, count)?, lanes_mut(nodes.force_y, top, count)?],
            normal: lanes_mut(nodes.contact_normal, 0, count)?,
            tangential: lanes_mut(nodes.contact_tangential, 0, count)?,
        })
    }

    /// Fills `normal` with heights.
    #[inline(always)]
    fn find_free_heights<S: Instructions>(&mut self, set: S, constants: &Constants) {
        let impactor = &constants.scenario.impactor;
        let half_width = set.splat(0.5 * impactor.face_diameter);
        let (zero, far_below) = (set.splat(0.0), set.splat(FAR_BELOW));
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let change = set.load(&self.inverse_mass[1][i], chunk) * set.load(&self.force[1][i], chunk);
                let velocity = set.load(&self.velocity[1][i], chunk) + change.times(constants.dt);
                let level = set.load(&self.reference[1][i], chunk).plus(-constants.top_height);
                let height = level + set.load(&self.displacement[1][i], chunk) + velocity.times(constants.dt);
                let x = set.load(&self.reference[0][i], chunk) + set.load(&self.displacement[0][i], chunk);
                let from_centre = x.plus(-impactor.offset);
                let distance = from_centre.larger(from_centre.times(-1.0));
                let under_face = distance.if_greater(half_width, far_below, height);
                let height = set.load(&self.mass[i], chunk).if_greater(zero, under_face, far_below);
                set.store(height, &mut self.normal[i], chunk);
            }
        }
    }

    /// Height of the face at the end of the step, m, from the free heights.
    ///
    /// It is the root z of M (z - z_free) = sum m_i max(0, y_i - z), a concave rising function: Newton's method climbs to
    /// it from z_free through a shrinking set of touching nodes.
    #[inline(always)]
    fn face_position<S: Instructions>(&self, set: S, impactor_mass: Real, prediction: &Prediction) -> Real {
        let mut position = prediction.position;
        if !prediction.free {
            return position;
        }
        let (zero, start) = (set.splat(0.0), set.splat(prediction.position));
        for _ in 0..PASSES {
            let (face, mut masses, mut moments) = (set.splat(position), ZERO, ZERO);
            for i in 0..self.normal.len() {
                for chunk in 0..LANES / S::WIDTH {
                    let (mass, height) = (set.load(&self.mass[i], chunk), set.load(&self.normal[i], chunk));
                    set.add(height.if_greater(face, mass, zero), &mut masses, chunk);
                    set.add(height.if_greater(face, mass * (height - start), zero), &mut moments, chunk);
                }
            }
            position = prediction.position + sum(&moments) / (impactor_mass + sum(&masses));
        }
        position
    }

    /// The force that brings each penetrating node back to the face within the step; returns their sum in index order.
    #[inline(always)]
    fn hold<S: Instructions>(&mut self, set: S, dt: Real, face: Real) -> Real {
        let inverse_dt_squared = 1.0 / (dt * dt);
        let (zero, face, mut total) = (set.splat(0.0), set.splat(face), ZERO);
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let height = set.load(&self.normal[i], chunk);
                let force = (set.load(&self.mass[i], chunk) * (height - face)).times(inverse_dt_squared);
                let normal = height.if_greater(face, force, zero);
                set.store(normal, &mut self.normal[i], chunk);
                set.store(set.load(&self.force[1][i], chunk) - normal, &mut self.force[1][i], chunk);
                set.add(normal, &mut total, chunk);
            }
        }
        sum(&total)
    }

    /// Friction. Returns the energy that the normal forces take over their impulse, J, then that of friction; before and
    /// after it the face has the velocities `face`, m/s.
    #[inline(always)]
    fn slide<S: Instructions>(&mut self, set: S, constants: &Constants, face: [Real; 2]) -> [Real; 2] {
        let (dt, coefficient) = (constants.dt, constants.scenario.face.friction_coefficient);
        let (inverse_dt, face) = (1.0 / dt, face[0] + face[1]);
        let (zero, mut catching, mut sliding) = (set.splat(0.0), ZERO, ZERO);
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let (normal, mass) = (set.load(&self.normal[i], chunk), set.load(&self.mass[i], chunk));
                let (x, y) = (set.load(&self.velocity[0][i], chunk), set.load(&self.velocity[1][i], chunk));
                let (inverse_mass, force) =
                    (set.load(&self.inverse_mass[0][i], chunk), set.load(&self.force[0][i], chunk));
                // The force that stops the node in this step, where it can move at all.
                let stick = ((mass * x).times(inverse_dt) + force).times(-1.0);
                let limit = inverse_mass.if_greater(zero, normal.times(coefficient), zero);
                let friction = limited(stick, limit);
                let force = force + friction;
                set.store(friction, &mut self.tangential[i], chunk);
                set.store(force, &mut self.force[0][i], chunk);
                let after_x = x + (inverse_mass * force).times(dt);
                let acceleration = set.load(&self.inverse_mass[1][i], chunk) * set.load(&self.force[1][i], chunk);
                let after_y = y + acceleration.times(dt);
                set.add(normal * (y + after_y).plus(-face), &mut catching, chunk);
                set.add(zero - friction * (x + after_x), &mut sliding, chunk);
            }
        }
        [0.5 * dt * sum(&catching), 0.5 * dt * sum(&sliding)]
    }
}
