//! The rigid impactor: one vertical degree of freedom, height above the undeformed anvil's top, upwards positive.

use crate::impactor::StepInput;
use crate::model::{Constants, Model};
use crate::number::real::Real;
use crate::scenario::{Motion, prescribed};

/// Motion of the impactor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactorState {
    /// Height of the face above the undeformed anvil's top, m; negative while it presses.
    pub position: Real,
    /// Velocity, m/s, upwards.
    ///
    /// That of a falling impactor holds the whole impulse of contact and external force of every step made, so
    /// m v = m v(0) + impulses - m g t to round-off. That of a driven one is what its input says of it or, if it says
    /// nothing, the mean over the last step.
    pub velocity: Real,
    /// Velocity half a step back, m/s, upwards: the mean over the last step.
    pub velocity_half: Real,
    /// Acceleration in the last step, m/s2, upwards.
    pub acceleration: Real,
}

impl ImpactorState {
    /// Of no state yet.
    pub(crate) const BLANK: Self = Self { position: 0.0, velocity: 0.0, velocity_half: 0.0, acceleration: 0.0 };

    /// At the gap, with the speed of the drop. The half step back makes free fall exact.
    pub(crate) fn start(model: &Model) -> Self {
        let impactor = &model.constants.scenario.impactor;
        let (velocity, acceleration) = match impactor.motion {
            Motion::Drop => (-impactor.start_speed(), -impactor.gravity),
            Motion::Driven | Motion::Prescribed => (0.0, 0.0),
        };
        let velocity_half = velocity - 0.5 * model.constants.dt * acceleration;
        Self { position: impactor.gap, velocity, velocity_half, acceleration }
    }

    /// Depth of the face below the undeformed anvil's top, m; 0 above it.
    pub fn deformation(&self) -> Real {
        if self.position < 0.0 { -self.position } else { 0.0 }
    }

    /// Where the face is at the end of step `step_index`, if no contact disturbs it.
    pub(crate) fn predict(&self, model: &Model, input: &StepInput, step_index: u64) -> Prediction {
        let constants = &model.constants;
        let impactor = &constants.scenario.impactor;
        match impactor.motion {
            Motion::Drop => {
                let acceleration = input.external_force / impactor.mass - impactor.gravity;
                // Damping takes the velocity at the end of the step, so that it never turns it round.
                let kept = impactor.mass / constants.moved_mass();
                let velocity_half = (self.velocity_half + constants.dt * acceleration) * kept;
                let position = self.position + constants.dt * velocity_half;
                Prediction { position, velocity: None, velocity_half, acceleration, free: true }
            }
            Motion::Driven => {
                let position = input.driven_position.unwrap_or(self.position);
                self.moved_to(position, input.driven_velocity, constants.dt)
            }
            Motion::Prescribed => {
                let time = constants.time(step_index + 1);
                let velocity = prescribed::velocity(impactor, time);
                self.moved_to(prescribed::height(impactor, time), Some(velocity), constants.dt)
            }
        }
    }

    /// The end of a step that leads to `position`, whatever the contact.
    fn moved_to(&self, position: Real, velocity: Option<Real>, dt: Real) -> Prediction {
        let velocity_half = (position - self.position) / dt;
        let acceleration = (velocity_half - self.velocity_half) / dt;
        Prediction { position, velocity, velocity_half, acceleration, free: false }
    }

    /// Completes the step with the contact force on the section, N, and gives the force of the rails, N upwards. With rails it
    /// leads to `face`, m, where [`Prediction::settle`] has found the face.
    pub(crate) fn advance(&mut self, model: &Model, prediction: &Prediction, face: Real, section_force: Real) -> Real {
        let (dt, impactor) = (model.constants.dt, &model.constants.scenario.impactor);
        if prediction.free && impactor.has_rails() {
            return self.slide_on_rails(model, prediction, face, section_force);
        }
        self.acceleration = prediction.acceleration;
        self.velocity_half = prediction.velocity_half;
        self.position = prediction.position;
        if prediction.free && section_force > 0.0 {
            let start = prediction.position - dt * prediction.velocity_half;
            let from_contact = section_force / model.constants.section_mass();
            self.acceleration += from_contact;
            self.velocity_half += dt * from_contact;
            self.position = start + dt * self.velocity_half;
        }
        self.velocity = match prediction.velocity {
            Some(velocity) => velocity,
            // Gravity goes on through the half step that is left.
            None if prediction.free => self.velocity_half - 0.5 * dt * impactor.gravity,
            None => self.velocity_half,
        };
        0.0
    }

    /// A step of a mass on rails: what its way to `face` takes besides the other forces is theirs.
    #[cold]
    #[inline(never)]
    fn slide_on_rails(&mut self, model: &Model, prediction: &Prediction, face: Real, section_force: Real) -> Real {
        let (constants, impactor) = (model.constants, &model.constants.scenario.impactor);
        let before = self.velocity_half;
        self.velocity_half = (face - self.position) / constants.dt;
        self.acceleration = (self.velocity_half - before) / constants.dt;
        self.position = face;
        let held = self.velocity_half == 0.0;
        self.velocity = if held { 0.0 } else { self.velocity_half - 0.5 * constants.dt * impactor.gravity };
        let contact = constants.symmetry_factor * section_force;
        impactor.mass * (self.acceleration - prediction.acceleration) - contact
    }
}

/// The end of a step without contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prediction {
    /// Height of the face, m.
    pub position: Real,
    /// Velocity at the end of the step, m/s, if it is known.
    pub velocity: Option<Real>,
    /// Velocity during the step, m/s.
    pub velocity_half: Real,
    /// Acceleration without contact, m/s2.
    pub acceleration: Real,
    /// Whether contact can change it.
    pub free: bool,
}

impl Prediction {
    /// Where the face is at the end of the step, m, if `contact` tells where the contact leaves a face that it would otherwise
    /// let go to a height, m: the higher that is, the higher it is left.
    ///
    /// The friction of the rails works against the motion and holds the mass where it is not enough to move it, so of three
    /// answers exactly one is true: the mass still rises against the whole friction, it still falls against the whole, or it stays.
    #[inline(always)]
    pub fn settle(&self, constants: &Constants, contact: impl Fn(Real) -> Real) -> Real {
        let impactor = &constants.scenario.impactor;
        if !self.free {
            return self.position;
        }
        let start = self.position - constants.dt * self.velocity_half;
        let held_back = impactor.rail_friction / constants.moved_mass() * (constants.dt * constants.dt);
        // In a loop, so that there is one copy of `contact`. Without friction the first answer is true.
        for shift in [-held_back, held_back] {
            let end = contact(self.position + shift);
            let moves = if shift < 0.0 { end > start } else { end < start };
            if moves || held_back == 0.0 {
                return end;
            }
        }
        start
    }
}
