//! A simulated drop, recorded at every force sample.

use softanvil_kernel::scenario::Motion;
use softanvil_kernel::state::Scalars;
use softanvil_kernel::{Constants, ModelError, Output, Scenario, Simulation, StepError, StepInput};

use crate::failure::Failure;

/// A completed run.
#[derive(Debug)]
pub struct Run {
    /// Constants of the model.
    pub constants: Constants,
    /// The state at the start and at the end of every sampling interval; never empty.
    samples: Vec<Scalars>,
}

/// Why a run did not complete.
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
        "impactor.motion = driven is refused: a run has nothing that drives the impactor; legal is drop or prescribed"
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
pub struct Drop {
    simulation: Simulation,
    steps: u64,
}

impl Drop {
    /// Builds the model of `scenario`, which covers its `time.duration`.
    ///
    /// # Errors
    /// A scenario that is refused, or one whose impactor is driven from outside.
    pub fn new(scenario: &Scenario) -> Result<Self, RunError> {
        if scenario.impactor.motion == Motion::Driven {
            return Err(RunError::Driven);
        }
        let simulation = Simulation::new(scenario)?;
        let steps = simulation.constants().steps_in(scenario.time.duration);
        Ok(Self { simulation, steps })
    }

    /// Steps of the run.
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
        mut self,
        mut watch: impl FnMut(u64, &mut Simulation) -> Result<(), E>,
    ) -> Result<Run, E> {
        let mut samples = vec![*self.simulation.scalars()];
        watch(0, &mut self.simulation)?;
        while self.sample(&mut samples)? {
            watch(self.stride(), &mut self.simulation)?;
        }
        Ok(self.completed(samples))
    }

    /// The same as long as `progress` says that it is still wanted; nothing if it ends by that.
    ///
    /// # Errors
    /// The first step that fails.
    pub fn run_while(mut self, mut progress: impl FnMut(u64) -> bool) -> Result<Option<Run>, RunError> {
        let mut samples = vec![*self.simulation.scalars()];
        while self.sample(&mut samples)? {
            if !progress(self.stride()) {
                return Ok(None);
            }
        }
        Ok(Some(self.completed(samples)))
    }

    fn stride(&self) -> u64 {
        u64::from(self.steps_per_sample())
    }

    /// Simulates one sampling interval; false at the end.
    fn sample(&mut self, samples: &mut Vec<Scalars>) -> Result<bool, RunError> {
        let stride = self.stride();
        if samples.len() as u64 > self.steps / stride {
            return Ok(false);
        }
        self.simulation.step(stride, &StepInput::default())?;
        samples.push(*self.simulation.scalars());
        Ok(true)
    }

    fn completed(self, samples: Vec<Scalars>) -> Run {
        Run { constants: *self.simulation.constants(), samples }
    }
}

impl Run {
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
