//! The rigid core: its reaction, and unilateral contact with Coulomb friction where the layer is not bonded to it.
//!
//! The forces are those of [`crate::contact::face`], towards a fixed surface: the normal force leaves a penetrating node on the
//! surface at the end of the step, the tangential one stops it within the limit of Coulomb's law.

use crate::contact::friction::limited;
use crate::contact::node_row::NodeRow;
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Pack, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::scenario::Interface;
use crate::state::{ContactWork, State, StateNodes};

/// What the core does in one step: its upward force on the section, N, and the energy it takes.
#[inline(always)]
pub(crate) fn react<S: Simd>(simd: S, model: &Model, state: &mut State) -> ContactWork {
    match model.constants.scenario.core.interface {
        // The core balances the forces on nodes that are fixed.
        Interface::Bonded => {
            let forces = state.nodes.force[1].get(..=model.constants.grid.n_u).unwrap_or_default();
            ContactWork { normal_force: forces.iter().fold(0.0, |sum, force| sum - force), ..ContactWork::default() }
        }
        Interface::Frictional | Interface::Sliding | Interface::Separating => {
            let StateNodes { displacement, velocity, force, .. } = &mut state.nodes;
            match NodeRow::of(model, 0, model.constants.grid.plane(), displacement, velocity, force) {
                Some(row) => Base(row).touch(simd, model.constants),
                None => ContactWork::default(),
            }
        }
    }
}

/// The nodes at the core.
struct Base<'s>(NodeRow<'s>);

/// Forces of the core on neighbouring nodes, N, its outward normal below them, and the velocities before the forces, m/s.
struct Touch<V> {
    pressure: V,
    shear: V,
    normal: [V; 2],
    before: [V; 2],
}

impl Base<'_> {
    /// Adds the forces of the core to those of nodes that may slide and, unless they are on rollers, lift.
    #[inline(always)]
    fn touch<S: Simd>(&mut self, simd: S, constants: &Constants) -> ContactWork {
        let (mut total, mut contact_dissipation, mut frictional_dissipation) = (ZERO, ZERO, ZERO);
        let zero = simd.splat(0.0);
        for i in 0..self.0.mass.len() {
            for chunk in 0..LANES / S::WIDTH {
                let Touch { pressure, shear, normal, before } = self.forces(simd, constants, i, chunk);
                let pull = [pressure * normal[0] + shear * normal[1], pressure * normal[1] - shear * normal[0]];
                let [force_x, force_y] =
                    [simd.load(&self.0.force[0][i], chunk) + pull[0], simd.load(&self.0.force[1][i], chunk) + pull[1]];
                simd.store(force_x, &mut self.0.force[0][i], chunk);
                simd.store(force_y, &mut self.0.force[1][i], chunk);
                let after = [
                    before[0] + (simd.load(&self.0.inverse_mass[0][i], chunk) * force_x).mul_scalar(constants.dt),
                    before[1] + (simd.load(&self.0.inverse_mass[1][i], chunk) * force_y).mul_scalar(constants.dt),
                ];
                simd.add(pull[1], &mut total, chunk);
                let twice_mean = [before[0] + after[0], before[1] + after[1]];
                let outwards = twice_mean[0] * normal[0] + twice_mean[1] * normal[1];
                let along = twice_mean[0] * normal[1] - twice_mean[1] * normal[0];
                simd.add(zero - pressure * outwards, &mut contact_dissipation, chunk);
                simd.add(zero - shear * along, &mut frictional_dissipation, chunk);
            }
        }
        let energy = |lane: Pack| 0.5 * constants.dt * sum(&lane);
        ContactWork {
            normal_force: sum(&total),
            contact_dissipation: energy(contact_dissipation),
            frictional_dissipation: energy(frictional_dissipation),
            rail_force: 0.0,
        }
    }

    /// The forces on some nodes of lane `i`; none on padding, which has no mass.
    #[inline(always)]
    fn forces<S: Simd>(&self, simd: S, constants: &Constants, i: usize, chunk: usize) -> Touch<S::Vector> {
        let (core, inverse_dt) = (&constants.scenario.core, 1.0 / constants.dt);
        let (zero, mass) = (simd.splat(0.0), simd.load(&self.0.mass[i], chunk));
        let inverse = [simd.load(&self.0.inverse_mass[0][i], chunk), simd.load(&self.0.inverse_mass[1][i], chunk)];
        let before = [simd.load(&self.0.velocity[0][i], chunk), simd.load(&self.0.velocity[1][i], chunk)];
        let (x, y) = (self.0.position(simd, 0, i, chunk), self.0.position(simd, 1, i, chunk));
        let (normal, depth) = surface_normal(simd, constants.scenario.core_radius(), x, y);
        let change = |axis: usize| (inverse[axis] * simd.load(&self.0.force[axis][i], chunk)).mul_scalar(constants.dt);
        let free = [before[0] + change(0), before[1] + change(1)];
        // On the centre line the normal is vertical, so the fixed direction takes no part in it.
        let approach = depth.mul_scalar(inverse_dt) - (free[0] * normal[0] + free[1] * normal[1]);
        let stopping = (mass * approach).mul_scalar(inverse_dt);
        let pressure = if core.interface.holds() { stopping } else { approach.select_greater(zero, stopping, zero) };
        let along = free[0] * normal[1] - free[1] * normal[0];
        let shear = if core.interface.rubs() {
            let friction =
                limited((mass * along).mul_scalar(-inverse_dt), pressure.mul_scalar(core.friction_coefficient));
            inverse[0].select_greater(zero, friction, zero)
        } else {
            zero
        };
        Touch { pressure, shear, normal, before }
    }
}

/// Outward normal of the core of some radius, m, below (x, y), and how deep the point lies in the core, m; of a flat one
/// without a radius.
#[inline(always)]
fn surface_normal<S: Simd>(simd: S, radius: Option<Real>, x: S::Vector, y: S::Vector) -> ([S::Vector; 2], S::Vector) {
    match radius {
        Some(radius) => {
            let distance = (x * x + y * y).square_root().max(simd.splat(Real::MIN_POSITIVE));
            ([x / distance, y / distance], simd.splat(radius) - distance)
        }
        None => ([simd.splat(0.0), simd.splat(1.0)], y.mul_scalar(-1.0)),
    }
}
