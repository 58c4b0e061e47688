//! The energy balance: where the impactor's energy is, term by term, and what the sum leaves unexplained.
//!
//! All terms belong to the end of the last step, as position and velocity of the impactor do. Its forces have then given
//! their whole impulse: kinetic energies are 1/2 m v^2 with the velocities after it, and against them balances exactly what
//! each force does over its impulse, F dt (v(n-1/2) + v(n+1/2)) / 2. Gravity works over the way of the impactor, whose
//! velocity holds it to the end of the step.
//!
//! Elastic and spring energy are evaluated from their potentials, viscous work and slip from the stresses, so the residual
//! compares the laws with the forces that they gave. They are known where the stresses were, at the positions before the
//! step, and are carried on by half of their last change: with the other half of the impulse to come, that is where the
//! impulse leaves them. What is dissipated never falls by that.
//!
//! The work on the viscous overstress is one term of the sum and stays whole: what of it is dissipated and what the
//! branches could still give back is not told apart. For additive terms it could be, with H : H / (4 G) in the spring of
//! each branch. A quasi-linear branch, though, has no energy at finite strain. Held until it has relaxed and then driven
//! around a closed loop of stretches faster than it relaxes, it gives work back in one direction and takes it in the
//! other, loop after loop, until the sum of its work is negative (`tests/verification`, `viscoelastic`): nothing between
//! zero and that sum could be called dissipated. At small strain it is a spring and a dashpot. With the overstress relaxed
//! after an impact nothing is stored, and what the branches took is gone.

use crate::element::ElementEnergy;
use crate::impactor::{ImpactorState, Prediction, StepInput};
use crate::model::Model;
use crate::number::math;
use crate::number::pack::sum;
use crate::number::real::Real;
use crate::scenario::Motion;

/// Numbers of an [`EnergyBalance`] in every snapshot; [`EnergyBalance::guide`] is in those of a mass on rails.
pub(crate) const ENERGY_WORDS: usize = 16;
/// Further ones of a model that softens.
pub(crate) const SOFTENING_WORDS: usize = 2;

/// Energies of the whole anvil and impactor at the end of the last step, J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyBalance {
    /// Kinetic energy of a falling impactor.
    pub impactor_kinetic: Real,
    /// Kinetic energy of the layer.
    pub layer_kinetic: Real,
    /// Long-term elastic energy of the layer.
    pub elastic: Real,
    /// Work done on the viscous overstress: dissipated, or still stored in its springs.
    pub viscous: Real,
    /// Energy in the damping springs.
    pub slider_stored: Real,
    /// Energy dissipated by the sliders.
    pub slider_dissipation: Real,
    /// Energy dissipated by tearing.
    pub tear: Real,
    /// Energy dissipated by softening.
    pub softening: Real,
    /// Energy dissipated by friction under the face, on the core and between layers.
    pub friction: Real,
    /// Energy lost in catching nodes at the face, on the core and between layers.
    pub contact: Real,
    /// Energy dissipated on the rails of a falling impactor.
    pub guide: Real,
    /// Energy brought in: kinetic energy at the start, work of gravity and of the external force, or the work of the
    /// drive.
    pub external: Real,
    /// What the last step knew at its forces.
    pub(crate) at_forces: AtForces,
}

/// Energies at the positions before a step, J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct AtForces {
    /// Of the layer, 1/2 m v(n-1/2) v(n+1/2), which a mode above its stability limit brings below zero.
    pub kinetic: Real,
    elastic: Real,
    viscous: Real,
    slider_stored: Real,
    slider_dissipation: Real,
    tear: Real,
    softening: Real,
}

impl EnergyBalance {
    /// Nothing at all.
    pub(crate) const ZERO: Self = Self {
        impactor_kinetic: 0.0,
        layer_kinetic: 0.0,
        elastic: 0.0,
        viscous: 0.0,
        slider_stored: 0.0,
        slider_dissipation: 0.0,
        tear: 0.0,
        softening: 0.0,
        friction: 0.0,
        contact: 0.0,
        guide: 0.0,
        external: 0.0,
        at_forces: AtForces {
            kinetic: 0.0,
            elastic: 0.0,
            viscous: 0.0,
            slider_stored: 0.0,
            slider_dissipation: 0.0,
            tear: 0.0,
            softening: 0.0,
        },
    };

    /// The start of the drop.
    pub(crate) fn start(model: &Model) -> Self {
        let impactor = &model.constants.scenario.impactor;
        let kinetic = match impactor.motion {
            Motion::Drop => 0.5 * impactor.mass * impactor.start_speed() * impactor.start_speed(),
            Motion::Driven | Motion::Prescribed => 0.0,
        };
        Self { impactor_kinetic: kinetic, external: kinetic, ..Self::ZERO }
    }

    /// What was brought in and is not accounted for, J.
    pub fn residual(&self) -> Real {
        let found = self.impactor_kinetic
            + self.layer_kinetic
            + self.elastic
            + self.viscous
            + self.slider_stored
            + self.slider_dissipation
            + self.tear
            + self.softening
            + self.friction
            + self.contact
            + self.guide;
        self.external - found
    }

    /// Every number but those of softening and of the rails, for snapshots.
    pub(crate) fn words_mut(&mut self) -> [&mut Real; ENERGY_WORDS] {
        let AtForces { kinetic, elastic, viscous, slider_stored, slider_dissipation, tear, softening: _ } =
            &mut self.at_forces;
        [
            &mut self.impactor_kinetic,
            &mut self.layer_kinetic,
            &mut self.elastic,
            &mut self.viscous,
            &mut self.slider_stored,
            &mut self.slider_dissipation,
            &mut self.tear,
            &mut self.friction,
            &mut self.contact,
            &mut self.external,
            kinetic,
            elastic,
            viscous,
            slider_stored,
            slider_dissipation,
            tear,
        ]
    }

    /// The numbers of softening, for snapshots of a model that softens.
    pub(crate) fn softening_words_mut(&mut self) -> [&mut Real; SOFTENING_WORDS] {
        [&mut self.softening, &mut self.at_forces.softening]
    }
}

/// What the contact did in one step, on the section.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactWork {
    /// Sum of the normal forces, N.
    pub normal_force: Real,
    /// Energy lost in catching nodes, over the impulse of the forces, J.
    pub contact_dissipation: Real,
    /// Energy lost in sliding, likewise, J.
    pub frictional_dissipation: Real,
    /// Force of the rails on the whole impactor, N, upwards.
    pub rail_force: Real,
}

/// What one step did, on the section.
pub(crate) struct StepWork<'w> {
    pub element: &'w ElementEnergy,
    pub face: &'w ContactWork,
    pub core: &'w ContactWork,
    pub interfaces: &'w ContactWork,
    /// Kinetic energy of the layer at the forces, from the velocities on both sides, and after their impulse, J.
    pub layer_kinetic: [Real; 2],
    /// Velocity of the impactor before and after the forces, m/s.
    pub impactor_velocity: [Real; 2],
    /// The impactor at the end of the step.
    pub impactor: &'w ImpactorState,
    pub prediction: &'w Prediction,
    pub input: &'w StepInput,
}

impl EnergyBalance {
    /// Books one step.
    pub(crate) fn update(&mut self, model: &Model, work: &StepWork) {
        let factor = model.constants.symmetry_factor;
        let (element, before) = (work.element, self.at_forces);
        let now = AtForces {
            kinetic: factor * work.layer_kinetic[0],
            elastic: factor * sum(&element.elastic),
            viscous: before.viscous + factor * sum(&element.viscous_increment),
            slider_stored: factor * sum(&element.slider_stored),
            slider_dissipation: before.slider_dissipation + factor * sum(&element.slider_increment),
            tear: before.tear + factor * sum(&element.tear_increment),
            softening: before.softening + factor * sum(&element.softening_increment),
        };
        self.at_forces = now;
        self.layer_kinetic = factor * work.layer_kinetic[1];
        self.elastic = carried(before.elastic, now.elastic);
        self.viscous = carried(before.viscous, now.viscous);
        self.slider_stored = carried(before.slider_stored, now.slider_stored);
        let slid = carried(before.slider_dissipation, now.slider_dissipation);
        self.slider_dissipation = math::max(self.slider_dissipation, slid);
        self.tear = math::max(self.tear, carried(before.tear, now.tear));
        self.softening = math::max(self.softening, carried(before.softening, now.softening));
        self.friction += factor
            * (work.face.frictional_dissipation
                + work.core.frictional_dissipation
                + work.interfaces.frictional_dissipation);
        self.contact += factor
            * (work.face.contact_dissipation + work.core.contact_dissipation + work.interfaces.contact_dissipation);
        let [before, after] = work.impactor_velocity;
        self.guide -= work.face.rail_force * (0.5 * model.constants.dt * (before + after));
        self.external += external_work(model, work);
        if work.prediction.free {
            let velocity = work.impactor.velocity;
            self.impactor_kinetic = 0.5 * model.constants.scenario.impactor.mass * velocity * velocity;
        }
    }
}

/// An energy half a step after its forces. One that was not there before is what a state starts with, and has no rate yet.
fn carried(before: Real, now: Real) -> Real {
    if before == 0.0 { now } else { now + 0.5 * (now - before) }
}

/// Work from outside in one step, J.
fn external_work(model: &Model, work: &StepWork) -> Real {
    let (constants, [before, after]) = (model.constants, work.impactor_velocity);
    let over_impulse = |force: Real| force * (0.5 * constants.dt * (before + after));
    if work.prediction.free {
        let impactor = &constants.scenario.impactor;
        over_impulse(work.input.external_force) - impactor.mass * impactor.gravity * (constants.dt * after)
    } else {
        over_impulse(-constants.symmetry_factor * work.face.normal_force)
    }
}
