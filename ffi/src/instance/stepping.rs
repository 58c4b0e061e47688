//! Communication steps: whole numbers of kernel steps. The count alone decides what is computed, never the last bits
//! of the master's times.

use softanvil_kernel::scenario::Motion;
use softanvil_kernel::{Simulation, StepError, StepInput, step};

use super::{Error, Instance, Mode};
use crate::variables::Inputs;

/// How far the master's time may be from the instance's, in kernel steps: what rounding adds up to in a master that
/// accumulates its step stays far below, and anything below a half cannot mean another step.
const POINT_TOLERANCE: f64 = 0.25;

/// How far a communication step may be from a whole number of kernel steps, in kernel steps: rounding of the difference
/// of two large times stays below.
const STEP_TOLERANCE: f64 = 1e-3;

/// The same, relative to the number of kernel steps: rounding of a step that was given in a few decimals less than all.
const RELATIVE_STEP_TOLERANCE: f64 = 1e-9;

/// Longest communication step, s: the longest run that the table of parameters allows.
pub(super) const LONGEST_STEP: f64 = 100.0;

/// A communication step on its way.
#[derive(Clone, Copy, Debug)]
pub struct Advance {
    /// Kernel steps made. Signed, as is their number, since processors turn only signed integers into floats at once.
    done: i64,
    /// Kernel steps in all.
    count: i64,
    /// Heights of a driven face at the start and at the end, m.
    heights: [f64; 2],
}

impl Advance {
    /// Whether every kernel step has been made.
    pub fn is_complete(&self) -> bool {
        self.done == self.count
    }

    /// The input of the next kernel step, which counts it.
    fn next(&mut self, inputs: &Inputs) -> StepInput {
        self.done += 1;
        let [from, to] = self.heights;
        let driven_position = from + (to - from) * (self.done as f64 / self.count as f64);
        StepInput { external_force: inputs.external_force, driven_position }
    }
}

/// Where to stop before a communication step is complete.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pause {
    /// Nowhere.
    Never,
    /// After the kernel step in which contact begins or ends.
    AtEvents,
    /// After every kernel step.
    AtSteps,
}

impl Instance {
    /// Simulated time in the master's terms, s.
    pub fn time(&self) -> f64 {
        self.experiment.start + self.simulation_at_work().map_or(0.0, Simulation::time)
    }

    /// Advances from `point` by `step`, s.
    ///
    /// # Errors
    /// As [`Instance::begin_step`] and [`Instance::advance`].
    pub fn do_step(&mut self, point: f64, step: f64) -> Result<(), Error> {
        let mut advance = self.begin_step(point, step)?;
        self.advance(&mut advance, Pause::Never).map(|_| ())
    }

    /// Begins a step from `point` by `step`, s, of which nothing is made yet.
    ///
    /// # Errors
    /// A point where the instance is not, a step that is not a whole number of kernel steps, or one past the end of the
    /// experiment: the instance is as before.
    pub fn begin_step(&self, point: f64, step: f64) -> Result<Advance, Error> {
        let Some(simulation) = self.simulation_at_work() else { return Err(Error::Call { mode: self.mode }) };
        let (dt, expected) = (simulation.constants().dt, self.experiment.start + simulation.time());
        let at_point = (point - expected).abs() <= POINT_TOLERANCE * dt;
        if !at_point {
            return Err(Error::CommunicationPoint { given: point, expected });
        }
        let count = whole_steps(step, dt)?;
        let end = expected + step;
        if let Some(stop) = self.experiment.stop
            && end > stop + POINT_TOLERANCE * dt
        {
            return Err(Error::PastStop { end, stop });
        }
        let from = simulation.scalars().impactor.position;
        let to = self.inputs.driven_position + self.inputs.driven_velocity * (count as f64 * dt);
        Ok(Advance { done: 0, count, heights: [from, to] })
    }

    /// Goes on with a step until it is complete or pauses. Tells whether contact began or ended.
    ///
    /// # Errors
    /// A step that the kernel cannot complete: the instance has failed.
    #[inline(always)]
    pub fn advance(&mut self, advance: &mut Advance, pause: Pause) -> Result<bool, Error> {
        let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
        march(simulation, &self.inputs, advance, pause).map_err(|error| {
            self.mode = Mode::Failed;
            Error::Step(error)
        })
    }
}

/// The number of steps of `dt` that `step` is.
fn whole_steps(step: f64, dt: f64) -> Result<i64, Error> {
    let refused = Error::StepSize { given: step, step: dt, largest: LONGEST_STEP };
    let in_range = step > 0.0 && step <= LONGEST_STEP;
    if !in_range {
        return Err(refused);
    }
    let steps = step / dt;
    // In range, so the sum is far below what the integer holds, and the cast rounds to the nearest count.
    let count = (steps + 0.5) as i64;
    let distance = (steps - count as f64).abs();
    let is_whole = count > 0 && distance <= STEP_TOLERANCE + RELATIVE_STEP_TOLERANCE * steps;
    if is_whole { Ok(count) } else { Err(refused) }
}

/// Makes kernel steps. In drop motion the force is held; a driven face moves evenly from where it was to where the
/// master's position and velocity lead.
#[inline(always)]
fn march(simulation: &mut Simulation, inputs: &Inputs, advance: &mut Advance, pause: Pause) -> Result<bool, StepError> {
    let inputs = match simulation.constants().scenario.impactor.motion {
        Motion::Drop => *inputs,
        _ => Inputs { external_force: 0.0, ..*inputs },
    };
    let all = simulation.with(|model, state| {
        let mut has_changed = false;
        while !advance.is_complete() {
            let was_touching = state.scalars.force.contact > 0.0;
            step(model, state, &advance.next(&inputs))?;
            let changed = was_touching != (state.scalars.force.contact > 0.0);
            has_changed |= changed;
            if pause == Pause::AtSteps || (pause == Pause::AtEvents && changed) {
                break;
            }
        }
        Ok(has_changed)
    });
    all.unwrap_or(Err(StepError::Input { value: f64::NAN, time: 0.0 }))
}
