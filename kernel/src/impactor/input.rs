//! What acts on the impactor from outside: [`StepInput`], its legal values, and [`DrivenPath`], the way of a driven face.

use crate::error::{ParameterError, StepError};
use crate::model::Constants;
use crate::number::real::Real;
use crate::scenario::Motion;

/// What acts on the impactor from outside during a call, of one step or of many. The default leaves things as they are: no
/// force, and a driven face stays where it is.
///
/// ```
/// use softanvil_kernel::scenario::Motion;
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut scenario = preset::study();
/// scenario.impactor.motion = Motion::Driven;
/// let mut anvil = Simulation::new(&scenario)?;
/// // Within 5 ms to 3 mm below the top of the anvil, and there at rest.
/// let input = StepInput { driven_position: Some(-3e-3), driven_velocity: Some(0.0), ..StepInput::default() };
/// anvil.run(5e-3, &input)?;
/// let impactor = &anvil.scalars().impactor;
/// assert_eq!([impactor.position, impactor.velocity], [-3e-3, 0.0]);
/// assert!(anvil.output("contact.force") > Some(100.0));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepInput {
    /// Upward force on a falling impactor besides gravity and contact, N; held over the steps of the call.
    pub external_force: Real,
    /// Height of the face of a driven impactor above the undeformed anvil at the end of the call, m; none: where it is.
    pub driven_position: Option<Real>,
    /// Upward velocity of the face of a driven impactor at the end of the call, m/s. With it, the face moves along the cubic
    /// from where and how fast it is to where and how fast it is to be; without it, along a straight line.
    pub driven_velocity: Option<Real>,
}

/// One row of the table of inputs.
pub struct InputRow {
    /// Structured name, `group.field`.
    pub name: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Smallest and largest legal value.
    pub range: (Real, Real),
    /// The only motion in which it acts. In others it may be any finite number.
    pub motion: Motion,
    /// The value, if there is one.
    read: fn(&StepInput) -> Option<Real>,
}

/// Every input.
pub static INPUTS: [InputRow; 3] = [
    InputRow {
        name: "impactor.external_force",
        unit: "N",
        range: (-1e6, 1e6),
        motion: Motion::Drop,
        read: |input| Some(input.external_force),
    },
    InputRow {
        name: "impactor.driven_position",
        unit: "m",
        range: (-1.0, 1.0),
        motion: Motion::Driven,
        read: |input| input.driven_position,
    },
    InputRow {
        name: "impactor.driven_velocity",
        unit: "m/s",
        range: (-100.0, 100.0),
        motion: Motion::Driven,
        read: |input| input.driven_velocity,
    },
];

impl InputRow {
    /// Refuses a `value` that is not finite or not in the range.
    fn check_within(&self, value: Real, (min, max): (Real, Real)) -> Result<(), ParameterError> {
        let in_range = value >= min && value <= max;
        if in_range { Ok(()) } else { Err(ParameterError { name: self.name.into(), value, unit: self.unit, min, max }) }
    }
}

impl StepInput {
    /// Refuses values that are not legal, at `time` s.
    ///
    /// # Errors
    /// The input, its value, its unit and what is legal.
    pub fn check(&self, constants: &Constants, time: Real) -> Result<(), StepError> {
        for row in &INPUTS {
            let acts = constants.scenario.impactor.motion == row.motion;
            let range = if acts { row.range } else { (Real::MIN, Real::MAX) };
            if let Some(value) = (row.read)(self) {
                row.check_within(value, range).map_err(|error| StepError::Input { error, time })?;
            }
        }
        Ok(())
    }
}
