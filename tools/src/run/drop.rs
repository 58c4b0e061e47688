//! A simulated drop, recorded at every force sample.

use std::slice;

use softanvil_kernel::scenario::{Motion, prescribed};
use softanvil_kernel::state::Scalars;
use softanvil_kernel::{Constants, ModelError, Output, Scenario, Simulation, StepError, StepInput};

use super::ending::Ending;
use crate::failure::Failure;

/// When a run ends.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Until {
    /// At `time.duration`.
    #[default]
    Duration,
    /// There, or as soon after it as the impact is over or a press has come to its depth, and at [`LONGEST_EXTENSION`] times
    /// that time at the latest.
    Over,
}

/// How many times `time.duration` a run lasts at most that waits for the end of the impact: contacts of soft layers under
/// heavy impactors last some of it, and what comes to rest on the layer never leaves it.
pub const LONGEST_EXTENSION: u64 = 20;

/// Samples that room is made for before a run, at most.
const MOST_AT_ONCE: u64 = 10_000;

/// Samples without force after which an impact counts as over: the layer rings and may touch once more.
const CLEAR: usize = 10;

/// A completed run.
///
/// ```
/// use softanvil_kernel::{Output, preset};
/// use softanvil_tools::run::Drop;
///
/// let run = Drop::new(&preset::study())?.run(|_| {})?;
/// let peak = run.result(Output::find("result.peak_force").unwrap());
/// let forces = run.samples().iter().map(|sample| sample.sampler.last.contact_force);
/// assert_eq!(peak, forces.fold(0.0, f64::max));
/// # Ok::<(), softanvil_tools::run::RunError>(())
/// ```
#[derive(Debug)]
pub struct Run {
    /// Constants of the model.
    pub constants: Constants,
    /// When it was to end.
    pub until: Until,
    /// The state at the start and at the end of every sampling interval; never empty.
    samples: Vec<Scalars>,
}

/// Why a run did not complete.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_kernel::scenario::Motion;
/// use softanvil_tools::run::{Drop, RunError};
///
/// let mut scenario = preset::study();
/// scenario.impactor.motion = Motion::Driven;
/// assert!(matches!(Drop::new(&scenario).err(), Some(RunError::Driven)));
/// ```
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The scenario is refused.
    #[error("{0}")]
    Model(#[from] ModelError),
    /// A step failed.
    #[error("the simulation failed: {0}")]
    Step(#[from] StepError),
    /// Nothing here moves a driven impactor.
    #[error(
        "impactor.motion = driven is refused: a run has nothing that drives the impactor; expected drop or prescribed"
    )]
    Driven,
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        match error {
            RunError::Model(_) | RunError::Driven => Self::Input(error.to_string()),
            RunError::Step(_) => Self::Failed(error.to_string()),
        }
    }
}

/// A drop that is ready to run.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::run::Ending;
/// use softanvil_tools::run::{Drop, Until};
///
/// let mut scenario = preset::study();
/// scenario.impactor = scenario.impactor.with_energy(9.8);
/// scenario.time.duration = 5e-3;
/// let cut = Drop::new(&scenario)?.run(|_| {})?;
/// assert_eq!(cut.ending(), Ending::InContact);
///
/// let drop = Drop::until(&scenario, Until::Over)?;
/// let (planned, mut made) = (drop.steps(), 0);
/// let whole = drop.run(|steps| made += steps)?;
/// assert!(whole.ending() == Ending::Complete && made > planned);
///
/// // Sample by sample.
/// let mut drop = Drop::new(&preset::study())?;
/// while drop.simulation().time() < 5e-3 && drop.sample()? {}
/// let early = drop.so_far();
/// while drop.sample()? {}
/// let whole = drop.so_far();
/// assert!(early.ending() == Ending::InContact && whole.ending() == Ending::Complete);
/// assert_eq!(whole.first(early.samples().len()).trace_hash(), early.trace_hash());
/// # Ok::<(), softanvil_tools::run::RunError>(())
/// ```
pub struct Drop {
    simulation: Simulation,
    steps: u64,
    until: Until,
    /// The state at the start and after every sample.
    samples: Vec<Scalars>,
}

impl Drop {
    /// Builds the model of `scenario`, which covers its `time.duration`.
    ///
    /// # Errors
    /// A scenario that is refused, or one whose impactor is driven from outside.
    pub fn new(scenario: &Scenario) -> Result<Self, RunError> {
        Self::until(scenario, Until::Duration)
    }

    /// Builds the model of `scenario`, which runs `until` then.
    ///
    /// # Errors
    /// As [`Drop::new`].
    pub fn until(scenario: &Scenario, until: Until) -> Result<Self, RunError> {
        if scenario.impactor.motion == Motion::Driven {
            return Err(RunError::Driven);
        }
        let simulation = Simulation::new(scenario)?;
        let steps = simulation.constants().steps_in(scenario.time.duration);
        let stride = u64::from(simulation.constants().steps_per_sample);
        let mut samples = Vec::with_capacity((steps / stride + 1).min(MOST_AT_ONCE) as usize);
        samples.extend_from_slice(slice::from_ref(simulation.scalars()));
        Ok(Self { simulation, steps, until, samples })
    }

    /// Steps of the run up to `time.duration`.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Steps in a sampling interval of 50 us.
    pub fn steps_per_sample(&self) -> u32 {
        self.simulation.constants().steps_per_sample
    }

    /// Triangles of the mesh.
    pub fn elements(&self) -> usize {
        self.simulation.constants().grid.n_elem()
    }

    /// Runs to the end; `progress` hears of every completed sample how many steps it took.
    ///
    /// # Errors
    /// The first step that fails.
    pub fn run(self, mut progress: impl FnMut(u64)) -> Result<Run, RunError> {
        self.run_watched(|steps, _| {
            progress(steps);
            Ok(())
        })
    }

    /// Runs to the end; `watch` sees the simulation at the start and after every sample, with the steps that it took.
    ///
    /// # Errors
    /// The first step that fails, or what `watch` refuses.
    pub fn run_watched<E: From<RunError>>(
        self,
        watch: impl FnMut(u64, &mut Simulation) -> Result<(), E>,
    ) -> Result<Run, E> {
        Ok(self.run_to_state(watch)?.0)
    }

    /// The same, with the simulation as it is at the end.
    ///
    /// # Errors
    /// As [`Drop::run_watched`].
    pub fn run_to_state<E: From<RunError>>(
        mut self,
        watch: impl FnMut(u64, &mut Simulation) -> Result<(), E>,
    ) -> Result<(Run, Simulation), E> {
        self.impact(watch)?;
        Ok((self.record(), self.simulation))
    }

    /// Runs several impacts on the same anvil to the end of each, with `rest` s between one and the next; `watch` sees them all.
    /// Returns the runs of those before the last, that of the last, and the simulation as it is then.
    ///
    /// # Errors
    /// The first step that fails, a rest that is refused, or what `watch` refuses.
    pub fn run_impacts<E: From<RunError>>(
        mut self,
        impacts: u32,
        rest: f64,
        mut watch: impl FnMut(u64, &mut Simulation) -> Result<(), E>,
    ) -> Result<(Vec<Run>, Run, Simulation), E> {
        let mut runs = Vec::new();
        for _ in 1..impacts {
            self.impact(&mut watch)?;
            runs.push(self.record());
            self.simulation.next_impact(rest).map_err(RunError::from)?;
            self.keep();
        }
        let (last, state) = self.run_to_state(watch)?;
        Ok((runs, last, state))
    }

    /// One impact.
    fn impact<E: From<RunError>>(
        &mut self,
        mut watch: impl FnMut(u64, &mut Simulation) -> Result<(), E>,
    ) -> Result<(), E> {
        watch(0, &mut self.simulation)?;
        while self.sample()? {
            watch(self.stride(), &mut self.simulation)?;
        }
        Ok(())
    }

    /// The same as long as `progress` says that it is still wanted; nothing if it ends by that.
    ///
    /// # Errors
    /// The first step that fails.
    pub fn run_while(mut self, mut progress: impl FnMut(u64) -> bool) -> Result<Option<Run>, RunError> {
        while self.sample()? {
            if !progress(self.stride()) {
                return Ok(None);
            }
        }
        Ok(Some(self.record()))
    }

    fn stride(&self) -> u64 {
        u64::from(self.steps_per_sample())
    }

    /// Simulates one sampling interval; false at the end of the run, where it does nothing.
    ///
    /// # Errors
    /// A step that fails.
    pub fn sample(&mut self) -> Result<bool, RunError> {
        let stride = self.stride();
        let (done, planned) = (self.samples.len() as u64 - 1, self.steps / stride);
        let given_up = self.until == Until::Duration || done >= LONGEST_EXTENSION * planned;
        if done >= planned && (given_up || is_over(self.constants(), &self.samples)) {
            return Ok(false);
        }
        self.simulation.step(stride, &StepInput::default())?;
        self.keep();
        Ok(true)
    }

    /// Keeps the state. Copied once, also where nothing is optimised: it is some kilobytes.
    fn keep(&mut self) {
        self.samples.extend_from_slice(slice::from_ref(self.simulation.scalars()));
    }

    /// The simulation as it is now.
    pub fn simulation(&mut self) -> &mut Simulation {
        &mut self.simulation
    }

    /// Constants of the model.
    pub fn constants(&self) -> &Constants {
        self.simulation.constants()
    }

    /// The state at the start and after every sample up to now.
    pub fn samples(&self) -> &[Scalars] {
        &self.samples
    }

    /// The run up to now.
    pub fn so_far(&self) -> Run {
        self.run_of(self.samples.clone())
    }

    /// The run, whose samples are gone from here then.
    fn record(&mut self) -> Run {
        let samples = std::mem::take(&mut self.samples);
        self.run_of(samples)
    }

    fn run_of(&self, samples: Vec<Scalars>) -> Run {
        Run { constants: self.simulation.constants().clone(), until: self.until, samples }
    }
}

/// Whether nothing more is to come: the impactor is clear of the layer, or a press at its depth.
fn is_over(constants: &Constants, samples: &[Scalars]) -> bool {
    let Some(end) = samples.last() else { return false };
    let impactor = &constants.scenario.impactor;
    if impactor.motion == Motion::Prescribed {
        return constants.time(end.step_index) >= prescribed::end(impactor);
    }
    let clear = samples.iter().rev().take(CLEAR).all(|sample| sample.sampler.last.contact_force <= 0.0);
    clear && end.contact_has_ended()
}

impl Run {
    /// How it ended.
    pub fn ending(&self) -> Ending {
        let (impactor, end) = (&self.constants.scenario.impactor, self.end());
        match end.metrics.has_touched() {
            false => Ending::NoContact,
            true if end.contact_has_ended() => Ending::Complete,
            true if impactor.motion == Motion::Prescribed && self.time(end) >= prescribed::end(impactor) => {
                Ending::Held
            }
            true => Ending::InContact,
        }
    }

    /// Whether it went on beyond `time.duration`.
    pub fn was_extended(&self) -> bool {
        self.end().step_index > self.constants.steps_in(self.constants.scenario.time.duration)
    }

    /// The run as it was after its first `count` samples, that of the start counted.
    pub fn first(&self, count: usize) -> Self {
        let samples = self.samples.iter().take(count.max(1)).copied().collect();
        Self { constants: self.constants.clone(), until: self.until, samples }
    }

    /// The state at the start and at the end of every sampling interval.
    pub fn samples(&self) -> &[Scalars] {
        &self.samples
    }

    /// The state at the end.
    pub fn end(&self) -> &Scalars {
        &self.samples[self.samples.len() - 1]
    }

    /// Simulated time of a sample, s.
    pub fn time(&self, sample: &Scalars) -> f64 {
        self.constants.time(sample.step_index)
    }

    /// An output at the end, in SI.
    pub fn result(&self, output: &Output) -> f64 {
        (output.read)(&self.constants, self.end())
    }

    /// Fingerprint of the trace: equal for equal bits of all samples.
    pub fn trace_hash(&self) -> String {
        format!("{:016x}", self.end().sampler.trace_hash)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    /// Source: the trace. The results are final once a sample after the first contact is without force.
    #[test]
    fn the_kernel_tells_when_its_results_are_final() {
        let run = Drop::new(&preset::study()).unwrap().run(|_| {}).unwrap();
        let complete = Output::find("result.complete").unwrap();
        let force: Vec<f64> = run.samples().iter().map(|sample| sample.sampler.last.contact_force).collect();
        let first = force.iter().position(|force| *force > 0.0).unwrap();
        let last = force.iter().rposition(|force| *force > 0.0).unwrap();
        for (i, sample) in run.samples().iter().enumerate() {
            let value = (complete.read)(&run.constants, sample);
            // Within the contact a node may let go for a sample.
            if i < first || force[i] > 0.0 || i > last {
                assert_eq!(value, if i > last { 1.0 } else { 0.0 }, "sample {i}");
            }
        }
        assert!(first > 10 && last + 10 < force.len());
        assert_eq!(run.ending(), Ending::Complete);
    }
}
