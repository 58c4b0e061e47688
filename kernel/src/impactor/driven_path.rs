//! How a driven face moves within a call of several steps.

use crate::impactor::{ImpactorState, StepInput};
use crate::model::Constants;
use crate::number::real::Real;

/// The way of a driven face over the steps of a call: a straight line to a position, or a cubic to a position and a velocity.
///
/// With the time from 0 to 1, that of a call, the cubic has the given positions and velocities at both ends (Hermite's
/// form); after the end it goes on along its tangent, and a straight line goes on straight.
///
/// ```
/// use softanvil_kernel::scenario::Motion;
/// use softanvil_kernel::{DrivenPath, Simulation, StepError, StepInput, preset, step_along};
///
/// let mut scenario = preset::study();
/// scenario.impactor.motion = Motion::Driven;
/// let mut at_once = Simulation::new(&scenario)?;
/// let mut watched = at_once.clone();
/// let input = StepInput { driven_position: Some(-1e-3), ..StepInput::default() };
/// at_once.step(1000, &input)?;
///
/// // The same steps, with a look at the force after each.
/// let path = DrivenPath::new(watched.constants(), &watched.scalars().impactor, &input, 1000.0);
/// let touched = watched.with(|model, state| {
///     let mut touched = None;
///     for number in 1..=1000 {
///         step_along(model, state, &path, number)?;
///         if touched.is_none() && state.scalars.force.contact > 0.0 {
///             touched = Some(number);
///         }
///     }
///     Ok::<_, StepError>(touched)
/// })??;
/// // Two of the three millimetres from the gap are in the air.
/// assert!(touched.is_some_and(|number| (600..700).contains(&number)));
/// assert_eq!(watched.scalars(), at_once.scalars());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivenPath {
    input: StepInput,
    /// Position, m, and velocity, m/s, at the start.
    start: [Real; 2],
    /// Steps until the end of the call, of which there may be a part.
    steps: Real,
    /// Time until the end of the call, s.
    duration: Real,
}

impl DrivenPath {
    /// From where `impactor` is to where `input` wants it after `steps` steps, a number that need not be whole.
    pub fn new(constants: &Constants, impactor: &ImpactorState, input: &StepInput, steps: Real) -> Self {
        let start = [impactor.position, impactor.velocity];
        Self { input: *input, start, steps, duration: steps * constants.dt }
    }

    /// The input of step `number` of the call, from 1.
    pub fn input(&self, number: u64) -> StepInput {
        // Signed, since processors turn only signed integers into floats at once.
        let part = number as i64 as Real / self.steps;
        let (left, [start, velocity]) = (1.0 - part, self.start);
        let end = self.input.driven_position.unwrap_or(start);
        let Some(end_velocity) = self.input.driven_velocity else {
            return StepInput { driven_position: Some(end + (start - end) * left), ..self.input };
        };
        if left <= 0.0 {
            let driven_position = Some(end - self.duration * end_velocity * left);
            return StepInput { driven_position, ..self.input };
        }
        // Times the duration, of the velocities.
        let bend = velocity * (part * left) - end_velocity * (part * part);
        let position = end + left * ((start - end) * (left * (1.0 + 2.0 * part)) + self.duration * bend);
        let mean = (end - start) / self.duration;
        let velocity = mean * (6.0 * part * left)
            + velocity * (left * (1.0 - 3.0 * part))
            + end_velocity * (part * (3.0 * part - 2.0));
        StepInput { driven_position: Some(position), driven_velocity: Some(velocity), ..self.input }
    }
}
