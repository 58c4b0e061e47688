//! Single nodes of a solid that something touches.

use crate::model::Model;
use crate::number::real::Real;

/// What a node has at the start of a step, along x, y and z.
pub(super) struct SolidNode {
    /// kg.
    pub mass: Real,
    /// 1/kg; 0 where fixed.
    pub inverse_mass: [Real; 3],
    /// m.
    pub position: [Real; 3],
    /// Half a step back, m/s.
    pub velocity: [Real; 3],
    /// Force of the step so far, N.
    pub force: [Real; 3],
}

impl SolidNode {
    /// Velocity after the force of the step so far, m/s.
    pub fn next_velocity(&self, dt: Real) -> [Real; 3] {
        core::array::from_fn(|i| self.velocity[i] + dt * (self.inverse_mass[i] * self.force[i]))
    }
}

/// The nodes of a solid: x, y and z of each quantity.
pub(super) struct SolidNodes<'s> {
    pub mass: &'s [Real],
    pub inverse_mass: [&'s [Real]; 3],
    pub reference: [&'s [Real]; 3],
    pub displacement: [&'s [Real]; 3],
    pub velocity: [&'s [Real]; 3],
    pub force: [&'s mut [Real]; 3],
}

impl<'s> SolidNodes<'s> {
    /// Of a model with displacements, velocities and forces of a state.
    pub fn new(
        model: &Model<'s>,
        displacement: [&'s [Real]; 3],
        velocity: [&'s [Real]; 3],
        force: [&'s mut [Real]; 3],
    ) -> Self {
        let (fixed, along) = (&model.nodes, model.solid());
        Self {
            mass: fixed.nodal_mass,
            inverse_mass: [fixed.inverse_mass_x, fixed.inverse_mass_y, along.inverse_mass_z],
            reference: [fixed.reference_x, fixed.reference_y, along.reference_z],
            displacement,
            velocity,
            force,
        }
    }

    /// The node of this `index`; none of padding, which has no mass.
    pub fn node(&self, index: usize) -> Option<SolidNode> {
        let at = |rows: &[&[Real]; 3]| Some([*rows[0].get(index)?, *rows[1].get(index)?, *rows[2].get(index)?]);
        let mass = *self.mass.get(index).filter(|mass| **mass > 0.0)?;
        let (rest, moved, [x, y, z]) = (at(&self.reference)?, at(&self.displacement)?, &self.force);
        Some(SolidNode {
            mass,
            inverse_mass: at(&self.inverse_mass)?,
            position: [rest[0] + moved[0], rest[1] + moved[1], rest[2] + moved[2]],
            velocity: at(&self.velocity)?,
            force: at(&[&**x, &**y, &**z])?,
        })
    }

    /// Adds `force`, N, to that of the node of this `index`.
    pub fn add_force(&mut self, index: usize, force: [Real; 3]) {
        for (row, force) in self.force.iter_mut().zip(force) {
            if let Some(total) = row.get_mut(index) {
                *total += force;
            }
        }
    }
}

/// a . b.
pub(super) fn dot(a: &[Real; 3], b: &[Real; 3]) -> Real {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// What is left of a `vector` across the unit vector `normal`.
pub(super) fn across(vector: &[Real; 3], normal: &[Real; 3]) -> [Real; 3] {
    let along = dot(vector, normal);
    core::array::from_fn(|i| vector[i] - along * normal[i])
}
