//! What every step ends with: the motion of the nodes, and what the laboratory would read.

use crate::model::Model;
use crate::number::pack::{LANES, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::state::{ContactWork, Forces, State, StateNodes};

/// Moves the nodes under their forces; returns the kinetic energy of the section at the forces, from the velocities on both
/// sides, and after their impulse.
#[inline(always)]
pub(super) fn move_nodes<S: Simd>(simd: S, model: &Model, state: &mut State) -> [Real; 2] {
    let dt = model.constants.dt;
    let (fixed, nodes) = (&model.nodes, &mut state.nodes);
    let StateNodes { displacement: [ux, uy], velocity: [vx, vy], force: [fx, fy], .. } = nodes;
    let mass = fixed.nodal_mass;
    let along_x = Moving { mass, inverse_mass: fixed.inverse_mass_x, force: fx, velocity: vx, displacement: ux };
    let along_y = Moving { mass, inverse_mass: fixed.inverse_mass_y, force: fy, velocity: vy, displacement: uy };
    let [along_x, along_y] = [along_x, along_y].map(|nodes| nodes.advance(simd, dt));
    [along_x[0] + along_y[0], along_x[1] + along_y[1]]
}

/// Nodes that move along one direction.
pub(super) struct Moving<'s> {
    /// Mass, kg.
    pub mass: &'s [Real],
    /// Its inverse, 1/kg; 0 where the node is held.
    pub inverse_mass: &'s [Real],
    /// Force, N.
    pub force: &'s [Real],
    /// Velocity half a step back, m/s.
    pub velocity: &'s mut [Real],
    /// Displacement, m.
    pub displacement: &'s mut [Real],
}

impl<'s> Moving<'s> {
    /// The same by parts of `size` nodes, a multiple of [`LANES`], but for the last one.
    pub fn parts(self, size: usize) -> impl Iterator<Item = Self> {
        let fixed = self.mass.chunks(size).zip(self.inverse_mass.chunks(size)).zip(self.force.chunks(size));
        let moving = self.velocity.chunks_mut(size).zip(self.displacement.chunks_mut(size));
        fixed.zip(moving).map(|(((mass, inverse_mass), force), (velocity, displacement))| Self {
            mass,
            inverse_mass,
            force,
            velocity,
            displacement,
        })
    }

    /// Advances them by one step of `dt`, s; their kinetic energy by the velocities on both sides of the forces, and after them, J.
    #[inline(always)]
    pub fn advance<S: Simd>(self, simd: S, dt: Real) -> [Real; 2] {
        let mut double_kinetic = [ZERO; 2];
        let fixed = self.mass.as_chunks().0.iter().zip(self.inverse_mass.as_chunks().0).zip(self.force.as_chunks().0);
        let moving = self.velocity.as_chunks_mut().0.iter_mut().zip(self.displacement.as_chunks_mut().0);
        for (((mass, inverse_mass), force), (velocity, displacement)) in fixed.zip(moving) {
            for chunk in 0..LANES / S::WIDTH {
                let before = simd.load(velocity, chunk);
                let after = before + (simd.load(inverse_mass, chunk) * simd.load(force, chunk)).mul_scalar(dt);
                simd.store(after, velocity, chunk);
                simd.store(simd.load(displacement, chunk) + after.mul_scalar(dt), displacement, chunk);
                let momentum = simd.load(mass, chunk) * after;
                simd.add(momentum * before, &mut double_kinetic[0], chunk);
                simd.add(momentum * after, &mut double_kinetic[1], chunk);
            }
        }
        double_kinetic.map(|lane| 0.5 * sum(&lane))
    }
}

/// Records the forces of the step and what the laboratory would read.
#[inline(always)]
pub(super) fn measure(model: &Model, state: &mut State, face: &ContactWork, core: &ContactWork, velocity_before: Real) {
    let constants = &model.constants;
    let scalars = &mut state.scalars;
    scalars.force = Forces {
        contact: constants.symmetry_factor * face.normal_force,
        core_reaction: constants.symmetry_factor * core.normal_force,
    };
    let velocity = [velocity_before, scalars.impactor.velocity_half];
    let depth = scalars.impactor.deformation();
    scalars.metrics.take_step(constants, scalars.step_index, scalars.force.contact, velocity, depth);
    if let Some(sample) = scalars.sampler.take(constants, &scalars.force, scalars.impactor.position) {
        scalars.metrics.take_sample(&sample, constants.scenario.measurement.force_threshold);
    }
}
