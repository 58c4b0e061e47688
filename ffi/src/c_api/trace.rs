//! Trace

use core::ffi::c_void;

use softanvil_kernel::{Constants, DrivenPath, Scalars, StepInput, step_along};

use crate::c_api::error::{SoftanvilError, report};
use crate::c_api::failure::Failure;
use crate::c_api::header::SoftanvilSimulation;
use crate::c_api::simulation::{SoftanvilInput, steps_in, steps_to_sample};
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::{block, ptr};

/// What `softanvil_run_traced` calls after every sample. It may call every function that takes a `const` simulation; it
/// must not change the simulation, throw, or jump out.
///
/// @param simulation The simulation, at the time of the sample.
/// @param context What was given to `softanvil_run_traced`.
/// @return 0 to go on, anything else to end the run here.
pub type SoftanvilTrace =
    Option<unsafe extern "C" fn(simulation: *const SoftanvilSimulation, context: *mut c_void) -> i32>;

/// As `softanvil_run`, and calls `trace` after every sampling interval of 50 us. A run that `trace` ends early has
/// succeeded; the simulation stands at that sample.
///
/// @param simulation The simulation.
/// @param duration Time, s, in the legal range of `time.duration`.
/// @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
/// @param trace What to call.
/// @param context Handed to `trace` untouched; may be NULL.
/// @param error Details of a failure, or NULL.
/// @return As `softanvil_run`.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_run_traced(
    simulation: *mut SoftanvilSimulation,
    duration: f64,
    input: *const SoftanvilInput,
    trace: SoftanvilTrace,
    context: *mut c_void,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (header, error) = unsafe { (ptr::header(simulation), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let input = unsafe { ptr::optional_shared(input, "input") };
    report(error, || {
        let header = header?;
        let trace = trace.ok_or(Failure::Null { argument: "trace" })?;
        let input = SoftanvilInput::or_hold(input?)?;
        let mut call = Call::new(&header.constants, &header.scalars, &input, duration)?;
        while call.left > 0 {
            // SAFETY: as above. The block is borrowed only while steps are made, not while the caller reads.
            let sampled = call.advance(unsafe { ptr::block(simulation) }?)?;
            // SAFETY: C gave the function for this.
            if sampled && unsafe { trace(simulation, context) } != 0 {
                break;
            }
        }
        Ok(())
    })
}

/// The steps of a traced run.
struct Call {
    path: DrivenPath,
    made: u64,
    left: u64,
}

impl Call {
    /// Of a run of `duration` s from where the simulation is.
    fn new(constants: &Constants, scalars: &Scalars, input: &StepInput, duration: f64) -> Result<Self, Failure> {
        input.check(constants, constants.time(scalars.step_index))?;
        let left = steps_in(constants, duration)?;
        Ok(Self { path: DrivenPath::new(constants, &scalars.impactor, input, left as f64), made: 0, left })
    }

    /// Makes the steps to the next sample, but no more than are left; tells whether the sample is reached.
    fn advance(&mut self, block: (&mut SoftanvilSimulation, ptr::Region)) -> Result<bool, Failure> {
        block::with(block, |model, state| {
            let whole = steps_to_sample(model, state).max(1);
            let count = whole.min(self.left);
            (1..=count).try_for_each(|number| step_along(model, state, &self.path, self.made + number))?;
            self.made += count;
            self.left -= count;
            Ok(count == whole)
        })
    }
}
