//! A drop made in several ways that change no bit: cut into calls of any length, saved and restored on the way, with every
//! instruction set, and on another number of threads.

use rayon::{ThreadPool, ThreadPoolBuilder};
use softanvil_kernel::state::state_digest;
use softanvil_kernel::{InstructionSet, Simulation, StepInput, step_with};

use crate::deformation::Samples;

/// Threads of a pool that is not the machine's own: other than its cores, and more than most.
const THREADS: usize = 3;

/// Longest call in steps, where time is cut.
const LONGEST_CALL: f64 = 400.0;

/// A drop at its start, which is made again and again.
pub struct Start {
    simulation: Simulation,
    steps: u64,
    pool: Option<ThreadPool>,
}

impl Start {
    /// Of `simulation`, for its whole duration.
    ///
    /// # Errors
    /// Threads that cannot be had.
    pub fn new(simulation: &Simulation) -> Result<Self, String> {
        let constants = simulation.constants();
        let pool = constants.grid.is_solid().then(|| ThreadPoolBuilder::new().num_threads(THREADS).build());
        let pool = pool.transpose().map_err(|error| error.to_string())?;
        Ok(Self { simulation: simulation.clone(), steps: constants.steps_in(constants.scenario.time.duration), pool })
    }

    /// Compares the end of the drop cut into calls, saved and restored, and on another number of threads, with `digest`.
    ///
    /// # Errors
    /// Another digest, or a drop that fails.
    pub fn check_calls(&self, digest: u64, samples: &mut Samples) -> Result<(), String> {
        let seed = 1 + (1e6 * (1.0 + samples.number())) as u64;
        let cut = || self.cut_and_restored(&mut Samples::new(seed));
        let cut = self.pool.as_ref().map_or_else(cut, |pool| pool.install(cut))?;
        agree(cut, digest, "cut into calls, saved and restored")
    }

    /// Compares the end of the drop with every instruction set but the best.
    ///
    /// # Errors
    /// Another digest, or a drop that fails.
    pub fn check_sets(&self, digest: u64) -> Result<(), String> {
        let mut sets = InstructionSet::ALL.into_iter().filter(|set| set.available() && *set != InstructionSet::best());
        sets.try_for_each(|set| agree(self.with_set(set)?, digest, &format!("with the instruction set {set:?}")))
    }

    /// Calls of any number of steps; once, in the middle of an interval, the state is saved, left behind and restored.
    fn cut_and_restored(&self, samples: &mut Samples) -> Result<u64, String> {
        let mut unit = || 0.5 * (1.0 + samples.number());
        let mut simulation = self.simulation.clone();
        let restored_at = (unit() * self.steps as f64) as u64;
        let (mut done, mut restored) = (0, false);
        while done < self.steps {
            let next = if restored { self.steps } else { restored_at };
            if done == restored_at && !restored {
                restored = true;
                let bytes = simulation.save().map_err(|error| error.to_string())?;
                simulation
                    .step(1 + (20.0 * unit()) as u64, &StepInput::default())
                    .map_err(|error| error.to_string())?;
                simulation.restore(&bytes).map_err(|error| error.to_string())?;
                continue;
            }
            let count = (1 + (LONGEST_CALL * unit()) as u64).min(next - done);
            simulation.step(count, &StepInput::default()).map_err(|error| error.to_string())?;
            done += count;
        }
        digest(&mut simulation)
    }

    fn with_set(&self, set: InstructionSet) -> Result<u64, String> {
        let mut simulation = self.simulation.clone();
        let made = simulation
            .with(|model, state| (0..self.steps).try_for_each(|_| step_with(set, model, state, &StepInput::default())));
        made.map_err(|error| error.to_string())?.map_err(|error| error.to_string())?;
        digest(&mut simulation)
    }
}

fn digest(simulation: &mut Simulation) -> Result<u64, String> {
    simulation.with(|model, state| state_digest(model, state)).map_err(|error| error.to_string())
}

fn agree(other: u64, digest: u64, way: &str) -> Result<(), String> {
    if other == digest { Ok(()) } else { Err(format!("other bits {way}: {other:016x} instead of {digest:016x}")) }
}
