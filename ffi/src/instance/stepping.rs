//! Communication steps: the kernel steps that each makes.

use softanvil_kernel::{DrivenPath, Simulation, StepError, step_along};

use super::clock::Clock;
use super::{Error, Experiment, Instance, Mode};
use crate::whole_steps::SAME;

/// Longest communication step, s: the longest run that the table of parameters allows.
pub(super) const LONGEST_STEP: f64 = 100.0;

/// A communication step on its way.
#[derive(Clone, Copy, Debug)]
pub struct Advance {
    /// Kernel steps made. Signed, as is their number, since processors turn only signed integers into floats at once.
    done: i64,
    /// Kernel steps in all, which may be none.
    count: i64,
    /// What acts on the impactor.
    path: DrivenPath,
    /// The clock at the start.
    clock: Clock,
    /// Length, s.
    step: f64,
}

impl Advance {
    /// Whether every kernel step has been made.
    pub fn is_complete(&self) -> bool {
        self.done == self.count
    }

    /// The clock after the kernel steps made so far, with the kernel at `kernel` s.
    fn clock(&self, dt: f64, kernel: f64) -> Clock {
        if self.is_complete() {
            self.clock.complete(self.step, self.count, dt, kernel)
        } else {
            self.clock.interrupted(self.done, dt, kernel)
        }
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
    /// The master's time, s: that of the communication point, or of the kernel within a step.
    pub fn time(&self) -> f64 {
        self.clock.point
    }

    /// The kernel's time in the master's terms, s.
    pub fn kernel_time(&self) -> f64 {
        let Some(simulation) = self.simulation_at_work() else { return self.clock.point };
        self.clock.kernel_time(simulation.constants().dt, self.impact.start + simulation.time())
    }

    /// The kernel's step, s; none where there is no simulation.
    pub fn time_step(&self) -> f64 {
        self.simulation_at_work().map_or(0.0, |simulation| simulation.constants().dt)
    }

    /// Advances from `point` by `step`, s.
    ///
    /// # Errors
    /// As [`Instance::begin_step`] and [`Instance::advance`].
    pub fn do_step(&mut self, point: f64, step: f64) -> Result<(), Error> {
        let mut advance = self.begin_step(point, step)?;
        self.advance(&mut advance, Pause::Never).map(|_| ())
    }

    /// Begins a step from `point` by `step`, s, of which nothing is made yet, with the next impact if it is asked for.
    ///
    /// # Errors
    /// A point where the instance is not, a step that is none or too long, or one past the end of the experiment: the
    /// instance is as before.
    pub fn begin_step(&mut self, point: f64, step: f64) -> Result<Advance, Error> {
        let Some(simulation) = self.simulation_at_work() else { return Err(Error::Call { mode: self.mode }) };
        let dt = simulation.constants().dt;
        let clock = self.clock.follow(point, self.experiment.start, dt)?;
        let in_range = step > 0.0 && step <= LONGEST_STEP;
        if !in_range {
            return Err(Error::StepSize { given: step, largest: LONGEST_STEP });
        }
        self.experiment.check_end(&clock, step, self.impact.start, simulation)?;
        let count = clock.steps_in(step, dt);
        self.follow_request(&clock)?;
        let Some(simulation) = &self.simulation else { return Err(Error::Call { mode: self.mode }) };
        let (constants, impactor) = (simulation.constants(), &simulation.scalars().impactor);
        // Setters have checked the inputs.
        let (input, steps) = (self.inputs.to_kernel(), clock.steps_until_end(step, count, dt));
        let path = DrivenPath::new(constants, impactor, &input, steps);
        Ok(Advance { done: 0, count, path, clock, step })
    }

    /// Lets the next impact begin if it is asked for since the last step; the master's clock is `clock`. Before the first step
    /// the first impact has not been yet.
    fn follow_request(&mut self, clock: &Clock) -> Result<(), Error> {
        let asked = self.inputs.next_impact;
        if asked && !self.impact.asked && clock.point > self.experiment.start {
            let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
            let start = clock.kernel_time(simulation.constants().dt, self.impact.start + simulation.time());
            simulation.next_impact(self.inputs.rest).map_err(Error::Step)?;
            self.impact = self.impact.next(start);
        }
        self.impact.asked = asked;
        Ok(())
    }

    /// Goes on with a step until it is complete or pauses. Tells whether contact began or ended.
    ///
    /// # Errors
    /// A step that the kernel cannot complete: the instance has failed, at the last kernel step that succeeded.
    #[inline(always)]
    pub fn advance(&mut self, advance: &mut Advance, pause: Pause) -> Result<bool, Error> {
        let Some(simulation) = &mut self.simulation else { return Err(Error::Call { mode: self.mode }) };
        self.is_fresh = false;
        let made = march(simulation, advance, pause);
        self.clock = advance.clock(simulation.constants().dt, self.impact.start + simulation.time());
        made.map_err(|error| {
            self.mode = Mode::Failed;
            Error::Step(error)
        })
    }
}

impl Experiment {
    /// Refuses a step past the end, by the master's clock as well as by the sum of its steps: what the one has rounded, the
    /// other has not. The kernel counts its time from `kernel_start` s on.
    fn check_end(&self, clock: &Clock, step: f64, kernel_start: f64, simulation: &Simulation) -> Result<(), Error> {
        let Some(stop) = self.stop else { return Ok(()) };
        let end = clock.point + step;
        let margin = SAME * simulation.constants().dt + Clock::at(stop).rounding(self.start);
        let elapsed = simulation.time() + (clock.ahead + step);
        if end > stop + margin && elapsed > stop - kernel_start + margin {
            return Err(Error::PastStop { end, stop });
        }
        Ok(())
    }
}

/// Makes kernel steps. In drop motion the force is held; a driven face is on the way to where the master wants it at the end
/// of the communication step.
#[inline(always)]
fn march(simulation: &mut Simulation, advance: &mut Advance, pause: Pause) -> Result<bool, StepError> {
    let all = simulation.with(|model, state| {
        let mut has_changed = false;
        while !advance.is_complete() {
            let was_touching = state.scalars.force.contact > 0.0;
            step_along(model, state, &advance.path, advance.done as u64 + 1)?;
            advance.done += 1;
            let changed = was_touching != (state.scalars.force.contact > 0.0);
            has_changed |= changed;
            if pause == Pause::AtSteps || (pause == Pause::AtEvents && changed) {
                break;
            }
        }
        Ok(has_changed)
    });
    all?
}

#[cfg(test)]
mod tests;
