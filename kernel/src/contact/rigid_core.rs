//! The rigid core: its reaction, and unilateral contact with Coulomb friction where the layer is not bonded to it.
//!
//! The forces are those of [`crate::contact::face`], towards a fixed surface: the normal force leaves a penetrating node on the
//! surface at the end of the step, the tangential one stops it within the limit of Coulomb's law.

use crate::contact::friction::limited;
use crate::model::{Constants, Model};
use crate::number::pack::{LANES, Lane, ZERO, lanes, lanes_mut, sum};
use crate::number::real::Real;
use crate::number::vector::{Instructions, Vector};
use crate::scenario::Interface;
use crate::state::ContactWork;
use crate::state::{State, StateNodes};

/// What the core does in one step: its upward force on the section, N, and the energy it takes.
#[inline(always)]
pub(crate) fn react<S: Instructions>(set: S, model: &Model, state: &mut State) -> ContactWork {
    match model.constants.scenario.core.interface {
        // The core balances the forces on nodes that are fixed.
        Interface::Bonded => {
            let forces = state.nodes.force_y.get(..=model.constants.grid.n_u).unwrap_or_default();
            ContactWork { normal_force: forces.iter().fold(0.0, |sum, force| sum - force), ..ContactWork::default() }
        }
        Interface::Frictional | Interface::Sliding => match Base::of(model, &mut state.nodes) {
            Some(mut base) => base.touch(set, model.constants),
            None => ContactWork::default(),
        },
    }
}

/// The nodes at the core, in lanes of as many numbers each; x before y.
struct Base<'s> {
    mass: &'s [Lane],
    inverse_mass: [&'s [Lane]; 2],
    reference: [&'s [Lane]; 2],
    displacement: [&'s [Lane]; 2],
    velocity: [&'s [Lane]; 2],
    force: [&'s mut [Lane]; 2],
}

/// Forces of the core on neighbouring nodes, N, its outward normal below them, and the velocities before the forces, m/s.
struct Touch<V> {
    pressure: V,
    shear: V,
    normal: [V; 2],
    before: [V; 2],
}

impl<'s> Base<'s> {
    /// None if a row is too short, which the sizes of [`crate::mesh::Grid`] exclude.
    #[inline(always)]
    fn of(model: &'s Model, nodes: &'s mut StateNodes) -> Option<Self> {
        let (fixed, count) = (&model.nodes, model.constants.grid.stride() / LANES);
        Some(Self {
            mass: lanes(fixed.nodal_mass, 0, count)?,
            inverse_mass: [lanes(fixed.inverse_mass_x, 0, count)?, lanes(fixed.inverse_mass_y, 0, count)?],
            reference: [lanes(fixed.reference_x, 0, count)?, lanes(fixed.reference_y, 0, count)?],
            displacement: [lanes(nodes.displacement_x, 0, count)?, lanes(nodes.displacement_y, 0, count)?],
            velocity: [lanes(nodes.velocity_x, 0, count)?, lanes(nodes.velocity_y, 0, count)?],
            force: [lanes_mut(nodes.force_x, 0, count)?, lanes_mut(nodes.force_y, 0, count)?],
        })
    }

    /// Adds the forces of the core to those of nodes that may slide and, unless they are on rollers, lift.
    #[inline(always)]
    fn touch<S: Instructions>(&mut self, set: S, constants: &Constants) -> ContactWork {
        let (mut total, mut catching, mut sliding) = (ZERO, ZERO, ZERO);
        let zero = set.splat(0.0);
        for i in 0..self.mass.len() {
            for chunk in 0..LANES / S::WIDTH {
                let Touch { pressure, shear, normal, before } = self.forces(set, constants, i, chunk);
                let pull = [pressure * normal[0] + shear * normal[1], pressure * normal[1] - shear * normal[0]];
                let [force_x, force_y] =
                    [set.load(&self.force[0][i], chunk) + pull[0], set.load(&self.force[1][i], chunk) + pull[1]];
                set.store(force_x, &mut self.force[0][i], chunk);
                set.store(force_y, &mut self.force[1][i], chunk);
                let after = [
                    before[0] + (set.load(&self.inverse_mass[0][i], chunk) * force_x).times(constants.dt),
                    before[1] + (set.load(&self.inverse_mass[1][i], chunk) * force_y).times(constants.dt),
                ];
                set.add(pull[1], &mut total, chunk);
                let double_mean = [before[0] + after[0], before[1] + after[1]];
                let outwards = double_mean[0] * normal[0] + double_mean[1] * normal[1];
                let along = double_mean[0] * normal[1] - double_mean[1] * normal[0];
                set.add(zero - pressure * outwards, &mut catching, chunk);
                set.add(zero - shear * along, &mut sliding, chunk);
            }
        }
        let energy = |lane: Lane| 0.5 * constants.dt * sum(&lane);
        ContactWork { normal_force: sum(&total), catching: energy(catching), sliding: energy(sliding) }
    }

    /// The forces on some nodes of lane `i`; none on padding, which has no mass.
    #[inline(always)]
    fn forces<S: Instructions>(&self, set: S, constants: &Constants, i: usize, chunk: usize) -> Touch<S::Vector> {
        let (core, inverse_dt) = (&constants.scenario.core, 1.0 / constants.dt);
        let rollers = core.interface == Interface::Sliding;
        let (zero, mass) = (set.splat(0.0), set.load(&self.mass[i], chunk));
        let inverse = [set.load(&self.inverse_mass[0][i], chunk), set.load(&self.inverse_mass[1][i], chunk)];
        let before = [set.load(&self.velocity[0][i], chunk), set.load(&self.velocity[1][i], chunk)];
        let (x, y) = (self.place(set, 0, i, chunk), self.place(set, 1, i, chunk));
        let (normal, depth) = surface_normal(set, constants.scenario.core_radius(), x, y);
        let change = |axis: usize| (inverse[axis] * set.load(&self.force[axis][i], chunk)).times(constants.dt);
        let free = [before[0] + change(0), before[1] + change(1)];
        // On the centre line the normal is vertical, so the fixed direction takes no part in it.
        let approach = depth.times(inverse_dt) - (free[0] * normal[0] + free[1] * normal[1]);
        let stopping = (mass * approach).times(inverse_dt);
        let pressure = if rollers { stopping } else { approach.if_greater(zero, stopping, zero) };
        let along = free[0] * normal[1] - free[1] * normal[0];
        let shear = if rollers {
            zero
        } else {
            let friction = limited((mass * along).times(-inverse_dt), pressure.times(core.friction_coefficient));
            inverse[0].if_greater(zero, friction, zero)
        };
        Touch { pressure, shear, normal, before }
    }

    /// Coordinate `axis` of some nodes of lane `i`, m.
    #[inline(always)]
    fn place<S: Instructions>(&self, set: S, axis: usize, i: usize, chunk: usize) -> S::Vector {
        set.load(&self.reference[axis][i], chunk) + set.load(&self.displacement[axis][i], chunk)
    }
}

/// Outward normal of the core of some radius, m, below (x, y), and how deep the point lies in the core, m; of a flat one
/// without a radius.
#[inline(always)]
fn surface_normal<S: Instructions>(
    set: S,
    radius: Option<Real>,
    x: S::Vector,
    y: S::Vector,
) -> ([S::Vector; 2], S::Vector) {
    match radius {
        Some(radius) => {
            let distance = (x * x + y * y).square_root().larger(set.splat(Real::MIN_POSITIVE));
            ([x / distance, y / distance], set.splat(radius) - distance)
        }
        None => ([set.splat(0.0), set.splat(1.0)], y.times(-1.0)),
    }
}
