//! Communication steps: whole numbers of kernel steps. The count alone decides what is computed, never the last bits
//! of the master's times.

use softanvil_kernel::scenario::Motion;
use softanvil_kernel::{Parameter, Simulation, StepError, StepInput};

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

/// Longest communication step if the table of parameters did not limit the duration of a run, s.
const LONGEST_STEP: f64 = 100.0;

impl Instance {
    /// Simulated time in the master's terms, s.
    pub fn time(&self) -> f64 {
        self.experiment.start + self.simulation_at_work().map_or(0.0, Simulation::time)
    }

    /// Advances from `point` by `step`, s.
    ///
    /// # Errors
    /// A point where the instance is not, a step that is not a whole number of kernel steps, or one past the end of the
    /// experiment: the instance is as before. A step that the kernel cannot complete: the instance has failed.
    pub fn do_step(&mut self, point: f64, step: f64) -> Result<(), Error> {
        let count = self.check_step(point, step)?;
        let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
        advance(simulation, &self.inputs, count).map_err(|error| {
            self.mode = Mode::Failed;
            Error::Step(error)
        })
    }

    /// Number of kernel steps in a communication step.
    fn check_step(&self, point: f64, step: f64) -> Result<u64, Error> {
        let Some(simulation) = &self.simulation else { return Err(Error::Call { mode: self.mode }) };
        let dt = simulation.constants().dt;
        let expected = self.time();
        let at_point = (point - expected).abs() <= POINT_TOLERANCE * dt;
        if !at_point {
            return Err(Error::CommunicationPoint { given: point, expected });
        }
        let count = whole_steps(step, dt)?;
        let end = expected + step;
        match self.experiment.stop {
            Some(stop) if end > stop + POINT_TOLERANCE * dt => Err(Error::PastStop { end, stop }),
            _ => Ok(count),
        }
    }
}

/// The number of steps of `dt` that `step` is.
fn whole_steps(step: f64, dt: f64) -> Result<u64, Error> {
    let largest = Parameter::find("time.duration").map_or(LONGEST_STEP, |parameter| parameter.range().1);
    let refused = Error::StepSize { given: step, step: dt, largest };
    let in_range = step > 0.0 && step <= largest;
    if !in_range {
        return Err(refused);
    }
    let steps = step / dt;
    // In range, so the sum is far below what the integer holds, and the cast rounds to the nearest count.
    let count = (steps + 0.5) as u64;
    let distance = (steps - count as f64).abs();
    let is_whole = count > 0 && distance <= STEP_TOLERANCE + RELATIVE_STEP_TOLERANCE * steps;
    if is_whole { Ok(count) } else { Err(refused) }
}

fn advance(simulation: &mut Simulation, inputs: &Inputs, count: u64) -> Result<(), StepError> {
    match simulation.constants().scenario.impactor.motion {
        Motion::Drop => {
            simulation.step(count, &StepInput { external_force: inputs.external_force, ..StepInput::default() })
        }
        Motion::Driven => drive(simulation, inputs, count),
        Motion::Prescribed => simulation.step(count, &StepInput::default()),
    }
}

/// Moves a driven impactor evenly from where it is to where the master's position and velocity lead.
fn drive(simulation: &mut Simulation, inputs: &Inputs, count: u64) -> Result<(), StepError> {
    let from = simulation.scalars().impactor.position;
    let whole = count as f64;
    let to = inputs.driven_position + inputs.driven_velocity * (whole * simulation.constants().dt);
    (1..=count).try_for_each(|k| {
        let driven_position = from + (to - from) * (k as f64 / whole);
        simulation.step(1, &StepInput { driven_position, ..StepInput::default() })
    })
}
