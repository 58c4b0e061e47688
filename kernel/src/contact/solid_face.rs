//! Contact and friction between the surface nodes of a solid and a flat face.
//!
//! The forces are those of [`crate::contact::face`]: they leave every touching node on the face at the end of the step, and friction
//! stops a node in its two directions within the limit of Coulomb's law. Nodes beyond the edge of the face are free.

use crate::contact::face::{FAR_BELOW, Surface, Touching};
use crate::contact::friction::limited_pair;
use crate::impactor::Prediction;
use crate::model::{Constants, Model};
use crate::number::math;
use crate::number::pack::{LANES, Pack, packs, packs_mut};
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::scenario::FaceShape;
use crate::state::{ContactWork, SolidState, State, StateNodes};

/// Adds the contact forces to the forces of the surface nodes and returns what they did.
#[inline(always)]
pub(crate) fn contact<S: Simd>(simd: S, model: &Model, state: &mut State, prediction: &Prediction) -> ContactWork {
    let (constants, impactor) = (model.constants, &mut state.scalars.impactor);
    let StateNodes { displacement, velocity, force, contact, solid, .. } = &mut state.nodes;
    let Some(section) = Surface::of(model, displacement, velocity, force, contact) else {
        return ContactWork::default();
    };
    let solid = SolidState::of(&constants.grid, constants.solid_history_packs, solid);
    let Some(along) = AlongZ::of(model, solid) else { return ContactWork::default() };
    let mut surface = SolidSurface { section, along };
    surface.find_free_heights(constants);
    let impactor_mass = constants.moved_mass() / constants.symmetry_factor;
    let (masses, heights) = (surface.section.row.mass, &*surface.section.normal);
    let face = prediction.settle(constants, &Touching { simd, masses, heights, impactor_mass });
    let normal_force = surface.section.hold(simd, constants.dt, face);
    let before = impactor.velocity_half;
    let rail_force = impactor.advance(model, prediction, face, normal_force);
    let [contact_dissipation, frictional_dissipation] = surface.slide(constants, before + impactor.velocity_half);
    ContactWork { normal_force, contact_dissipation, frictional_dissipation, rail_force }
}

/// What the surface nodes have along z, in packs of neighbours.
struct AlongZ<'s> {
    reference: &'s [Pack],
    inverse_mass: &'s [Pack],
    displacement: &'s [Pack],
    velocity: &'s [Pack],
    force: &'s mut [Pack],
    friction: &'s mut [Pack],
}

impl<'s> AlongZ<'s> {
    /// None if an array is too short, which the sizes exclude.
    fn of(model: &Model<'s>, solid: SolidState<'s>) -> Option<Self> {
        let (grid, fixed) = (&model.constants.grid, model.solid());
        let (first, count) = ((grid.node_rows() - 1) * grid.plane(), grid.plane() / LANES);
        Some(Self {
            reference: packs(fixed.reference_z, first, count)?,
            inverse_mass: packs(fixed.inverse_mass_z, first, count)?,
            displacement: packs(solid.displacement, first, count)?,
            velocity: packs(solid.velocity, first, count)?,
            force: packs_mut(solid.force, first, count)?,
            friction: packs_mut(solid.friction, 0, count)?,
        })
    }
}

/// The nodes at the surface.
struct SolidSurface<'s> {
    section: Surface<'s>,
    along: AlongZ<'s>,
}

/// Where some point of the face is, from its centre, m.
fn is_under(constants: &Constants, x: Real, z: Real) -> bool {
    let impactor = &constants.scenario.impactor;
    let x = x - impactor.offset;
    match impactor.shape {
        FaceShape::Rectangular => {
            2.0 * math::abs(x) <= impactor.face_width && 2.0 * math::abs(z) <= impactor.face_length
        }
        _ => 4.0 * (x * x + z * z) <= impactor.face_diameter * impactor.face_diameter,
    }
}

impl SolidSurface<'_> {
    /// Fills the normal forces with the heights of the nodes above the undeformed anvil's top at the end of a step without contact,
    /// m; far below where they are not under the face.
    fn find_free_heights(&mut self, constants: &Constants) {
        let (dt, row, along) = (constants.dt, &self.section.row, &self.along);
        for i in 0..self.section.normal.len() {
            for l in 0..LANES {
                let velocity = row.velocity[1][i][l] + dt * (row.inverse_mass[1][i][l] * row.force[1][i][l]);
                let level = row.reference[1][i][l] - constants.top_height;
                let x = row.reference[0][i][l] + row.displacement[0][i][l];
                let z = along.reference[i][l] + along.displacement[i][l];
                let touches = row.mass[i][l] > 0.0 && is_under(constants, x, z);
                let height = level + row.displacement[1][i][l] + dt * velocity;
                self.section.normal[i][l] = if touches { height } else { FAR_BELOW };
            }
        }
    }

    /// Friction. Returns the energy that the normal forces take over their impulse, J, then that of friction; `face` is the sum of
    /// the velocities of the face before and after it, m/s.
    fn slide(&mut self, constants: &Constants, face: Real) -> [Real; 2] {
        let (dt, coefficient) = (constants.dt, constants.scenario.face.friction_coefficient);
        let (row, along) = (&mut self.section.row, &mut self.along);
        let (mut contact_dissipation, mut frictional_dissipation) = (0.0, 0.0);
        for i in 0..self.section.normal.len() {
            for l in 0..LANES {
                let (normal, mass) = (self.section.normal[i][l], row.mass[i][l]);
                if normal <= 0.0 {
                    (self.section.tangential[i][l], along.friction[i][l]) = (0.0, 0.0);
                    continue;
                }
                let inverse = [row.inverse_mass[0][i][l], along.inverse_mass[i][l]];
                let before = [row.velocity[0][i][l], along.velocity[i][l]];
                let force = [row.force[0][i][l], along.force[i][l]];
                // The force that stops the node in this step, where it can move at all.
                let stop = |j: usize| if inverse[j] > 0.0 { -(mass * before[j] / dt + force[j]) } else { 0.0 };
                let friction = limited_pair([stop(0), stop(1)], coefficient * normal);
                [row.force[0][i][l], along.force[i][l]] = [force[0] + friction[0], force[1] + friction[1]];
                [self.section.tangential[i][l], along.friction[i][l]] = friction;
                for j in 0..2 {
                    let after = before[j] + dt * (inverse[j] * (force[j] + friction[j]));
                    frictional_dissipation -= friction[j] * (before[j] + after);
                }
                let y = row.velocity[1][i][l];
                let after = y + dt * (row.inverse_mass[1][i][l] * row.force[1][i][l]);
                contact_dissipation += normal * (y + after - face);
            }
        }
        [0.5 * dt * contact_dissipation, 0.5 * dt * frictional_dissipation]
    }
}
