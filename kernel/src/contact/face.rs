//! Contact and friction between the surface nodes and a flat face that covers them; [`rounded_face`] has the others.
//!
//! Contact is a constraint, not a penalty: the forces are those that leave every touching node on the face at the end
//! of the step, with the impactor's own reaction included (forward increment Lagrange multipliers, Carpenter, Taylor
//! and Katona 1991; here in closed form, because the lumped masses decouple). Nothing penetrates and no energy hides in
//! springs. A node that is caught loses the kinetic energy of its velocity relative to the face; the energy balance counts it.
//!
//! Friction stops a node within the limit of Coulomb's law in the same step: a sticking node has exactly no velocity.

use crate::contact::friction::limited;
use crate::contact::node_row::NodeRow;
use crate::contact::rounded_face;
use crate::impactor::{FaceContact, Prediction};
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Pack, ZERO, packs_mut, sum};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::state::{ContactWork, State, StateNodes};

/// Passes of the search for the touching nodes. The end position of the face rises with each, from below, by the ratio
/// of a node's mass to the impactor's; what is left after four passes is below rounding for any impactor heavier than
/// the layer, and momentum is exact after any number.
const PASSES: usize = 4;

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
#[inline(always)]
pub(crate) fn contact<S: Simd>(simd: S, model: &Model, state: &mut State, prediction: &Prediction) -> ContactWork {
    let (constants, impactor) = (&model.constants, &mut state.scalars.impactor);
    if constants.has_uneven_contact() {
        return rounded_face::contact(model, state, prediction);
    }
    let StateNodes { displacement, velocity, force, contact, .. } = &mut state.nodes;
    let surface = Surface::of(model, displacement, velocity, force, contact);
    let Some(mut surface) = surface else { return ContactWork::default() };
    surface.find_free_heights(simd, constants);
    let mass = constants.moved_mass() / constants.symmetry_factor;
    // Of the slices alone: the surface stays where the compiler sees that its rows are of one length.
    let touching = Touching { simd, masses: surface.row.mass, heights: surface.normal, impactor_mass: mass };
    let face = prediction.settle(constants, &touching);
    let normal_force = surface.hold(simd, constants.dt, face);
    let before = impactor.velocity_half;
    let rail_force = impactor.advance(model, prediction, face, normal_force);
    let [contact_dissipation, frictional_dissipation] =
        surface.slide(simd, constants, [before, impactor.velocity_half]);
    ContactWork { normal_force, contact_dissipation, frictional_dissipation, rail_force }
}

/// The nodes at the surface.
struct Surface<'s> {
    row: NodeRow<'s>,
    /// Normal forces, N. Until they are known, the height of each node above the undeformed anvil's top at the end of a step
    /// without contact, m; far below where it is not under the face.
    normal: &'s mut [Pack],
    tangential: &'s mut [Pack],
}

/// A height that no face reaches, m.
const FAR_BELOW: Real = -1e30;

impl<'s> Surface<'s> {
    /// None if a row is too short, which the sizes of [`crate::mesh::Grid`] exclude.
    #[inline(always)]
    fn of(
        model: &'s Model,
        displacement: &'s [&mut [Real]; 2],
        velocity: &'s [&mut [Real]; 2],
        force: &'s mut [&mut [Real]; 2],
        [normal, tangential]: &'s mut [&mut [Real]; 2],
    ) -> Option<Self> {
        let grid = &model.constants.grid;
        let plane = grid.plane();
        let count = plane / LANES;
        Some(Self {
            row: NodeRow::of(model, grid.node_rows() - 1, plane, displacement, velocity, force)?,
            normal: packs_mut(normal, 0, count)?,
            tangential: packs_mut(tangential, 0, count)?,
        })
    }

    /// Fills `normal` with heights.
    #[inline(always)]
    fn find_free_heights<S: Simd>(&mut self, simd: S, constants: &Constants) {
        let impactor = &constants.scenario.impactor;
        let half_width = simd.splat(0.5 * impactor.face_diameter);
        let (zero, far_below) = (simd.splat(0.0), simd.splat(FAR_BELOW));
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let change = simd.load(&self.row.inverse_mass[1][i], chunk) * simd.load(&self.row.force[1][i], chunk);
                let velocity = simd.load(&self.row.velocity[1][i], chunk) + change.mul_scalar(constants.dt);
                let level = simd.load(&self.row.reference[1][i], chunk).add_scalar(-constants.top_height);
                let height = level + simd.load(&self.row.displacement[1][i], chunk) + velocity.mul_scalar(constants.dt);
                let x = self.row.position(simd, 0, i, chunk);
                let from_centre = x.add_scalar(-impactor.offset);
                let distance = from_centre.max(from_centre.mul_scalar(-1.0));
                let under_face = distance.select_greater(half_width, far_below, height);
                let height = simd.load(&self.row.mass[i], chunk).select_greater(zero, under_face, far_below);
                simd.store(height, &mut self.normal[i], chunk);
            }
        }
    }

    /// The force that brings each penetrating node back to the face within the step; returns their sum in index order.
    #[inline(always)]
    fn hold<S: Simd>(&mut self, simd: S, dt: Real, face: Real) -> Real {
        let inverse_dt_squared = 1.0 / (dt * dt);
        let (zero, face, mut total) = (simd.splat(0.0), simd.splat(face), ZERO);
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let height = simd.load(&self.normal[i], chunk);
                let force = (simd.load(&self.row.mass[i], chunk) * (height - face)).mul_scalar(inverse_dt_squared);
                let normal = height.select_greater(face, force, zero);
                simd.store(normal, &mut self.normal[i], chunk);
                simd.store(simd.load(&self.row.force[1][i], chunk) - normal, &mut self.row.force[1][i], chunk);
                simd.add(normal, &mut total, chunk);
            }
        }
        sum(&total)
    }

    /// Friction. Returns the energy that the normal forces take over their impulse, J, then that of friction; before and
    /// after it the face has the velocities `face`, m/s.
    #[inline(always)]
    fn slide<S: Simd>(&mut self, simd: S, constants: &Constants, face: [Real; 2]) -> [Real; 2] {
        let (dt, coefficient) = (constants.dt, constants.scenario.face.friction_coefficient);
        let (inverse_dt, face) = (1.0 / dt, face[0] + face[1]);
        let (zero, mut contact_dissipation, mut frictional_dissipation) = (simd.splat(0.0), ZERO, ZERO);
        for i in 0..self.normal.len() {
            for chunk in 0..LANES / S::WIDTH {
                let (normal, mass) = (simd.load(&self.normal[i], chunk), simd.load(&self.row.mass[i], chunk));
                let (x, y) = (simd.load(&self.row.velocity[0][i], chunk), simd.load(&self.row.velocity[1][i], chunk));
                let (inverse_mass, force) =
                    (simd.load(&self.row.inverse_mass[0][i], chunk), simd.load(&self.row.force[0][i], chunk));
                // The force that stops the node in this step, where it can move at all.
                let stick = ((mass * x).mul_scalar(inverse_dt) + force).mul_scalar(-1.0);
                let limit = inverse_mass.select_greater(zero, normal.mul_scalar(coefficient), zero);
                let friction = limited(stick, limit);
                let force = force + friction;
                simd.store(friction, &mut self.tangential[i], chunk);
                simd.store(force, &mut self.row.force[0][i], chunk);
                let after_x = x + (inverse_mass * force).mul_scalar(dt);
                let acceleration =
                    simd.load(&self.row.inverse_mass[1][i], chunk) * simd.load(&self.row.force[1][i], chunk);
                let after_y = y + acceleration.mul_scalar(dt);
                simd.add(normal * (y + after_y).add_scalar(-face), &mut contact_dissipation, chunk);
                simd.add(zero - friction * (x + after_x), &mut frictional_dissipation, chunk);
            }
        }
        [0.5 * dt * sum(&contact_dissipation), 0.5 * dt * sum(&frictional_dissipation)]
    }
}

/// The masses of the surface nodes, kg, and their free heights, m, under a face of a mass, kg.
struct Touching<'s, S> {
    simd: S,
    masses: &'s [Pack],
    heights: &'s [Pack],
    impactor_mass: Real,
}

impl<S: Simd> FaceContact for Touching<'_, S> {
    /// The root z of M (z - z_free) = sum m_i max(0, y_i - z), a concave rising function: Newton's method climbs to it from
    /// z_free through a shrinking set of touching nodes.
    #[inline(always)]
    fn height(&self, free: Real) -> Real {
        let (simd, mut position) = (self.simd, free);
        let (zero, start) = (simd.splat(0.0), simd.splat(free));
        for _ in 0..PASSES {
            let (face, mut masses, mut moments) = (simd.splat(position), ZERO, ZERO);
            for (mass, height) in self.masses.iter().zip(self.heights) {
                for chunk in 0..LANES / S::WIDTH {
                    let (mass, height) = (simd.load(mass, chunk), simd.load(height, chunk));
                    simd.add(height.select_greater(face, mass, zero), &mut masses, chunk);
                    simd.add(height.select_greater(face, mass * (height - start), zero), &mut moments, chunk);
                }
            }
            position = free + sum(&moments) / (self.impactor_mass + sum(&masses));
        }
        position
    }
}
