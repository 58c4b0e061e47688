//! What a master gives at communication points.

use softanvil_kernel::impactor::{INPUTS as ROWS, InputRow};
use softanvil_kernel::state::LONGEST_REST;
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
    /// How long the anvil has rested at the next impact, s.
    pub rest: f64,
    /// Whether the master asks for the next impact.
    pub next_impact: bool,
    /// Whether the master gives the position: whether it has ever set one.
    pub has_position: bool,
    /// Whether the master gives the velocity: whether it has ever set one.
    pub has_velocity: bool,
}

impl Inputs {
    /// No force, the impactor at rest where the preset has it, and no next impact, for which the anvil would rest a minute.
    pub fn start() -> Self {
        Self {
            external_force: 0.0,
            driven_position: preset::study().impactor.gap,
            driven_velocity: 0.0,
            rest: 60.0,
            next_impact: false,
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
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) range: (f64, f64),
    /// FMI's name for when it can change.
    pub(super) variability: &'static str,
    /// The field in the inputs.
    pub field: fn(&mut Inputs) -> &mut f64,
    pub(super) description: &'static str,
}

impl Input {
    /// What acts on the impactor while it moves.
    const fn of_kernel(
        reference: u32,
        row: &'static InputRow,
        field: fn(&mut Inputs) -> &mut f64,
        description: &'static str,
    ) -> Self {
        let InputRow { name, unit, range, .. } = *row;
        Self { reference, name, unit, range, variability: "continuous", field, description }
    }

    /// Sets `value` in `inputs`, if it is finite and in range.
    ///
    /// A velocity is given from the first one on that is not 0: importers that set every start value give none by that.
    ///
    /// # Errors
    /// The name, value, unit and legal range of a refused value.
    pub fn set(&self, inputs: &mut Inputs, value: f64) -> Result<(), ParameterError> {
        let (min, max) = self.range;
        let in_range = value >= min && value <= max;
        if !in_range {
            return Err(ParameterError { name: self.name.into(), value, unit: self.unit, min, max });
        }
        *(self.field)(inputs) = value;
        inputs.has_position |= self.reference == references::DRIVEN_POSITION;
        inputs.has_velocity |= inputs.driven_velocity != 0.0;
        Ok(())
    }
}

/// Every input that is a quantity.
pub static INPUTS: &[Input] = &[
    Input::of_kernel(
        references::EXTERNAL_FORCE,
        &ROWS[0],
        |inputs| &mut inputs.external_force,
        "upward force on a falling impactor besides gravity and contact, held over the kernel steps of a communication step",
    ),
    Input::of_kernel(
        references::DRIVEN_POSITION,
        &ROWS[1],
        |inputs| &mut inputs.driven_position,
        "height of the face of a driven impactor at the end of the communication step that follows, to which it moves from \
         where it is; impactor.gap until it is set",
    ),
    Input::of_kernel(
        references::DRIVEN_VELOCITY,
        &ROWS[2],
        |inputs| &mut inputs.driven_velocity,
        "upward velocity of a driven impactor at the end of the communication step that follows: once it has been other \
         than 0 the face moves along a cubic, before along straight lines",
    ),
    Input {
        reference: references::REST,
        name: "impact.rest",
        unit: "s",
        range: (0.0, LONGEST_REST),
        variability: "discrete",
        field: |inputs| &mut inputs.rest,
        description: "how long the anvil has rested when impact.next lets the impactor fall again; it takes none of the \
                      simulated time",
    },
];
