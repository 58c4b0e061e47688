//! A single node that something touches, where neighbours do not touch alike.

use crate::model::Model;
use crate::number::real::Real;
use crate::state::StateNodes;

/// What a node has at the start of a step, x before y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// 1/kg; 0 where fixed.
    pub inverse_mass: [Real; 2],
    /// m.
    pub position: [Real; 2],
    /// Half a step back, m/s.
    pub velocity: [Real; 2],
    /// Force of the step so far, N.
    pub force: [Real; 2],
}

impl Node {
    /// The node of this `index`; none past the last.
    #[inline(always)]
    pub fn of(model: &Model, nodes: &StateNodes<&mut [Real]>, index: usize) -> Option<Self> {
        let fixed = &model.nodes;
        let both = |[x, y]: [&[Real]; 2]| Some([*x.get(index)?, *y.get(index)?]);
        let of_state = |rows: &[&mut [Real]; 2]| Some([*rows[0].get(index)?, *rows[1].get(index)?]);
        let (rest, moved) = (both([fixed.reference_x, fixed.reference_y])?, of_state(&nodes.displacement)?);
        Some(Self {
            inverse_mass: both([fixed.inverse_mass_x, fixed.inverse_mass_y])?,
            position: [rest[0] + moved[0], rest[1] + moved[1]],
            velocity: of_state(&nodes.velocity)?,
            force: of_state(&nodes.force)?,
        })
    }

    /// Velocity after the force of the step so far, m/s.
    #[inline(always)]
    pub fn next_velocity(&self, dt: Real) -> [Real; 2] {
        let after = |i: usize| self.velocity[i] + dt * (self.inverse_mass[i] * self.force[i]);
        [after(0), after(1)]
    }
}

/// Adds `force`, N, to that of the node of this `index`.
#[inline(always)]
pub(super) fn add_force(nodes: &mut StateNodes<&mut [Real]>, index: usize, force: [Real; 2]) {
    for (row, force) in nodes.force.iter_mut().zip(force) {
        if let Some(total) = row.get_mut(index) {
            *total += force;
        }
    }
}
