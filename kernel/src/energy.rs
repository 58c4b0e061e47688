//! The energy ledger: where the impactor's energy is, term by term, and what the sum leaves unexplained.
//!
//! Kinetic energy is 1/2 m v(n-1/2) v(n+1/2), for which the central difference scheme balances exactly against the
//! trapezoidal work of the nodal forces. Elastic and spring energy are evaluated from their potentials, viscous work and
//! slip from the stresses, so the residual compares the laws with the forces that they gave.
//!
//! The work on the viscous overstress is one term of the sum and stays whole: what of it is dissipated and what the
//! branches could still give back is not told apart. For additive terms it could be, with H : H / (4 G) in the spring of
//! each branch. A quasi-linear branch, though, has no energy at finite strain. Held until it has relaxed and then driven
//! around a closed loop of stretches faster than it relaxes, it gives work back in one direction and takes it in the
//! other, loop after loop, until the sum of its work is negative (`tests/verification`, `viscoelastic`): nothing between
//! zero and that sum could be called dissipated. At small strain it is a spring and a dashpot. With the overstress relaxed
//! after an impact nothing is stored, and what the branches took is gone.

use crate::element::ElementEnergy;
use crate::face::Contact;
use crate::impactor::{Prediction, StepInput};
use crate::lanes::sum;
use crate::model::Model;
use crate::real::Real;
use crate::scenario::Motion;

/// Numbers of a [`Ledger`] in a snapshot.
pub(crate) const LEDGER_WORDS: usize = 13;

/// Energies of the whole anvil and impactor at the time of the last completed step's forces, J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ledger {
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
    /// Energy dissipated by friction under the face and on the core.
    pub friction: Real,
    /// Energy lost in catching nodes at the face and on the core.
    pub contact: Real,
    /// Energy brought in: kinetic energy at the start, work of gravity and of the external force, or the work of the
    /// drive.
    pub external: Real,
    /// The halves of this step's works that belong to the time after its forces: friction, contact, external.
    pending: [Real; 3],
}

impl Ledger {
    /// Nothing at all.
    pub(crate) const ZERO: Self = Self {
        impactor_kinetic: 0.0,
        layer_kinetic: 0.0,
        elastic: 0.0,
        viscous: 0.0,
        slider_stored: 0.0,
        slider_dissipation: 0.0,
        tear: 0.0,
        friction: 0.0,
        contact: 0.0,
        external: 0.0,
        pending: [0.0; 3],
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
            + self.friction
            + self.contact;
        self.external - found
    }

    /// Every number, for snapshots.
    pub(crate) fn words_mut(&mut self) -> [&mut Real; LEDGER_WORDS] {
        let [friction, contact, external] = &mut self.pending;
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
            friction,
            contact,
            external,
        ]
    }
}

/// What one step did, on the section.
pub(crate) struct StepWork<'w> {
    pub element: &'w ElementEnergy,
    pub face: &'w Contact,
    pub core: &'w Contact,
    pub layer_kinetic: Real,
    /// Velocity of the impactor before and after the forces, m/s.
    pub impactor_velocity: [Real; 2],
    pub prediction: &'w Prediction,
    pub input: &'w StepInput,
}

impl Ledger {
    /// Books one step.
    pub(crate) fn book(&mut self, model: &Model, work: &StepWork) {
        let factor = model.constants.section_factor;
        let element = work.element;
        self.layer_kinetic = factor * work.layer_kinetic;
        self.elastic = factor * sum(&element.elastic);
        self.slider_stored = factor * sum(&element.slider_stored);
        self.viscous += factor * sum(&element.viscous_increment);
        self.slider_dissipation += factor * sum(&element.slider_increment);
        self.tear += factor * sum(&element.tear_increment);
        let (friction, contact) = (halves(work, |c| c.sliding), halves(work, |c| c.catching));
        let external = external_work(model, work);
        let [pending_friction, pending_contact, pending_external] = self.pending;
        self.friction += pending_friction + factor * friction[0];
        self.contact += pending_contact + factor * contact[0];
        self.external += pending_external + external[0];
        self.pending = [factor * friction[1], factor * contact[1], external[1]];
        if work.prediction.free {
            let [before, after] = work.impactor_velocity;
            self.impactor_kinetic = 0.5 * model.constants.scenario.impactor.mass * before * after;
        }
    }
}

/// A pair of half-step works, at the face and the core together.
fn halves(work: &StepWork, which: fn(&Contact) -> [Real; 2]) -> [Real; 2] {
    let (face, core) = (which(work.face), which(work.core));
    [face[0] + core[0], face[1] + core[1]]
}

/// Work of the forces from outside in the half steps before and after, J.
fn external_work(model: &Model, work: &StepWork) -> [Real; 2] {
    let impactor = &model.constants.scenario.impactor;
    let force = if work.prediction.free {
        work.input.external_force - impactor.mass * impactor.gravity
    } else {
        -model.constants.section_factor * work.face.normal_force
    };
    work.impactor_velocity.map(|velocity| 0.5 * model.constants.dt * force * velocity)
}
