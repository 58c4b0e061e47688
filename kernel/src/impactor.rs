//! The rigid impactor: one vertical degree of freedom, height above the undeformed anvil's top, upwards positive.

use crate::error::StepError;
use crate::model::Model;
use crate::prescribed;
use crate::real::Real;
use crate::scenario::Motion;

/// What acts on the impactor from outside during one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepInput {
    /// Upward force on a falling impactor besides gravity and contact, N.
    pub external_force: Real,
    /// Height of the face of a driven impactor above the undeformed anvil at the end of the step, m.
    pub driven_position: Real,
}

/// Motion of the impactor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactorState {
    /// Height of the face above the undeformed anvil's top, m; negative while it presses.
    pub position: Real,
    /// Velocity half a step back, m/s, upwards.
    pub velocity_half: Real,
    /// Acceleration in the last step, m/s2, upwards.
    pub acceleration: Real,
}

impl ImpactorState {
    /// At the gap, with the speed of the drop. The half step back makes free fall exact.
    pub(crate) fn start(model: &Model) -> Self {
        let impactor = &model.constants.scenario.impactor;
        let (velocity, acceleration) = match impactor.motion {
            Motion::Drop => (-impactor.start_speed(), -impactor.gravity),
            Motion::Driven | Motion::Prescribed => (0.0, 0.0),
        };
        Self { position: impactor.gap, velocity_half: velocity - 0.5 * model.constants.dt * acceleration, acceleration }
    }

    /// Velocity at the current time, m/s, upwards: exact under constant acceleration.
    pub fn velocity(&self, dt: Real) -> Real {
        self.velocity_half + 0.5 * dt * self.acceleration
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
                let velocity = self.velocity_half + constants.dt * acceleration;
                Prediction { position: self.position + constants.dt * velocity, velocity, acceleration, free: true }
            }
            Motion::Driven => self.moved_to(input.driven_position, constants.dt),
            Motion::Prescribed => {
                self.moved_to(prescribed::height(impactor, constants.time(step_index + 1)), constants.dt)
            }
        }
    }

    /// The end of a step that leads to `position`, whatever the contact.
    fn moved_to(&self, position: Real, dt: Real) -> Prediction {
        let velocity = (position - self.position) / dt;
        let acceleration = (velocity - self.velocity_half) / dt;
        Prediction { position, velocity, acceleration, free: false }
    }

    /// Completes the step with the contact force on the section, N.
    pub(crate) fn advance(&mut self, model: &Model, prediction: &Prediction, section_force: Real) {
        let dt = model.constants.dt;
        self.acceleration = prediction.acceleration;
        self.velocity_half = prediction.velocity;
        self.position = prediction.position;
        if prediction.free && section_force > 0.0 {
            let start = prediction.position - dt * prediction.velocity;
            let from_contact = section_force / model.constants.section_mass();
            self.acceleration += from_contact;
            self.velocity_half += dt * from_contact;
            self.position = start + dt * self.velocity_half;
        }
    }
}

/// The end of a step without contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prediction {
    /// Height of the face, m.
    pub position: Real,
    /// Velocity during the step, m/s.
    pub velocity: Real,
    /// Acceleration without contact, m/s2.
    pub acceleration: Real,
    /// Whether contact can change it.
    pub free: bool,
}

impl StepInput {
    /// Refuses values that are not finite.
    pub(crate) fn check(&self, time: Real) -> Result<(), StepError> {
        for value in [self.external_force, self.driven_position] {
            if !value.is_finite() {
                return Err(StepError::Input { value, time });
            }
        }
        Ok(())
    }
}
