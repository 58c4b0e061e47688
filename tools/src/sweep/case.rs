//! One simulation of a sweep, and what came of it.

use softanvil_kernel::Scenario;
use softanvil_kernel::scenario::Motion;

use crate::measurement::quantity::{self, COUNT, PEAK_FORCE};
use crate::measurement::reading::Reading;
use crate::measurement::series::{Sensor, Series};
use crate::run::{Drop, Ending, Run, RunError, Until};

/// What is to be simulated.
#[derive(Clone, Debug)]
pub struct Case {
    /// What tells it from the others: a text for each of the sweep's headings.
    pub settings: Vec<String>,
    /// The scenario.
    pub scenario: Scenario,
    /// Updates of elements that it will take, about.
    pub work: u64,
    /// Number of the case from which its changes are given.
    pub reference: usize,
}

/// What was simulated.
#[derive(Debug)]
pub struct Outcome {
    /// The run.
    pub run: Run,
    /// Its four numbers, in SI and in the order of [`quantity::QUANTITIES`].
    pub values: [f64; COUNT],
}

/// Channel frequency class of the filtered peak force, Hz.
pub const CHANNEL_CLASS: f64 = 600.0;

impl Outcome {
    /// Simulates `scenario` `until` then.
    ///
    /// # Errors
    /// A scenario that is refused, or that fails.
    pub fn simulate(scenario: &Scenario, until: Until) -> Result<Self, RunError> {
        Ok(Self::new(Drop::until(scenario, until)?.run(|_| {})?))
    }

    /// What came of a run.
    pub fn new(run: Run) -> Self {
        Self { values: quantity::measure(&run), run }
    }

    /// How the simulation ended.
    pub fn ending(&self) -> Ending {
        self.run.ending()
    }

    /// Peak force, N; of a press, the force that holds it.
    pub fn force(&self) -> f64 {
        self.held_force().unwrap_or(self.values[PEAK_FORCE])
    }

    /// Rebound speed over impact speed.
    pub fn restitution(&self) -> f64 {
        self.run.end().metrics.restitution()
    }

    /// Peak of the force through a channel filter of [`CHANNEL_CLASS`], N.
    pub fn filtered_peak(&self) -> f64 {
        let reading = Reading { channel_class: Some(CHANNEL_CLASS), ..Reading::PLAIN };
        reading.take(&self.run).map_or(f64::NAN, |record| record.values[PEAK_FORCE])
    }

    /// Mean force over the hold at the end of a press, N; none of a drop.
    pub fn held_force(&self) -> Option<f64> {
        let impactor = &self.run.constants.scenario.impactor;
        if impactor.motion != Motion::Prescribed {
            return None;
        }
        let depth = impactor.prescribed_depth;
        let held = self.run.samples().iter().filter(|sample| sample.impactor.deformation() >= depth);
        let (sum, count) = held.fold((0.0, 0.0), |(sum, count), s| (sum + s.sampler.last.contact_force, count + 1.0));
        (count > 0.0).then(|| sum / count)
    }

    /// How much the force rises and falls beyond one rise to the peak and one fall from it, in parts of the peak.
    pub fn vibration(&self) -> f64 {
        let force = Series::of_run(&self.run, Sensor::Contact).force;
        let travel: f64 = force.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
        let [first, last] = [force.first(), force.last()].map(|force| force.copied().unwrap_or_default());
        // A record that begins or ends under load has travelled that much less.
        // Rounding may take a single rise and fall below nothing.
        ((travel + first + last) / (2.0 * self.values[PEAK_FORCE]) - 1.0).max(0.0)
    }
}
