//! What a master gives at communication points.

use softanvil_kernel::impactor::{INPUTS as ROWS, InputRow};
use softanvil_kernel::{ParameterError, Scenario, StepInput, preset};

use super::references;

/// What the master gives at communication points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs {
    /// Upward force on a falling impactor, N.
    pub external_force: f64,
    /// Height of a driven impactor at the end of the communication step, m.
    pub driven_position: f64,
    /// Velocity of a driven impactor at the end of the communication step, m/s.
    pub driven_velocity: f64,
    /// Whether the master gives the position: whether it has ever set one.
    pub has_position: bool,
    /// Whether the master gives the velocity: whether it has ever set one.
    pub has_velocity: bool,
}

impl Inputs {
    /// No force, and the impactor at rest where the preset has it.
    pub fn start() -> Self {
        Self {
            external_force: 0.0,
            driven_position: preset::study().impactor.gap,
            driven_velocity: 0.0,
            has_position: false,
            has_velocity: false,
        }
    }

    /// The same for the impactor of `scenario`, which stays where that puts it until the master gives a position.
    pub fn in_scenario(self, scenario: &Scenario) -> Self {
        let driven_position = if self.has_position { self.driven_position } else { scenario.impactor.gap };
        Self { driven_position, ..self }
    }

    /// What acts on the impactor during a communication step.
    pub fn to_kernel(self) -> StepInput {
        StepInput {
            external_force: self.external_force,
            driven_position: Some(self.driven_position),
            driven_velocity: self.has_velocity.then_some(self.driven_velocity),
        }
    }
}

/// One row of the table of inputs.
pub struct Input {
    pub(super) reference: u32,
    pub(super) row: &'static InputRow,
    /// The field in the inputs.
    pub field: fn(&mut Inputs) -> &mut f64,
    pub(super) description: &'static str,
}

impl Input {
    /// Sets `value` in `inputs`, if it is finite and in range.
    ///
    /// A velocity is given from the first one on that is not 0: importers that set every start value give none by that.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn set(&self, inputs: &mut Inputs, value: f64) -> Result<(), ParameterError> {
        self.row.check(value)?;
        *(self.field)(inputs) = value;
        inputs.has_position |= self.reference == references::DRIVEN_POSITION;
        inputs.has_velocity |= inputs.driven_velocity != 0.0;
        Ok(())
    }
}

/// Every input.
pub static INPUTS: &[Input] = &[
    Input {
        reference: references::EXTERNAL_FORCE,
        row: &ROWS[0],
        field: |inputs| &mut inputs.external_force,
        description: "upward force on a falling impactor besides gravity and contact, held over the kernel \
                      steps of a communication step",
    },
    Input {
        reference: references::DRIVEN_POSITION,
        row: &ROWS[1],
        field: |inputs| &mut inputs.driven_position,
        description: "height of the face of a driven impactor at the end of the communication step that follows, to which \
                      it moves from where it is; impactor.gap until it is set",
    },
    Input {
        reference: references::DRIVEN_VELOCITY,
        row: &ROWS[2],
        field: |inputs| &mut inputs.driven_velocity,
        description: "upward velocity of a driven impactor at the end of the communication step that follows: once it has \
                      been other than 0 the face moves along a cubic, before along straight lines",
    },
];
