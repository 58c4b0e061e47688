//! Trace

use core::ffi::c_void;

use softanvil_kernel::{StepInput, step};

use crate::block::{self, SoftanvilSimulation};
use crate::c_api::simulation::{SoftanvilInput, steps_in, steps_to_sample};
use crate::failure::{Failure, SoftanvilError, report};
use crate::ptr;
use crate::status::SoftanvilStatus;

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
        let input = SoftanvilInput::or_hold(input?, &header.scalars)?;
        let mut left = steps_in(&header.constants, duration)?;
        while left > 0 {
            // SAFETY: as above. The block is borrowed only while steps are made, not while the caller reads.
            let (made, sampled) = advance(unsafe { ptr::block(simulation) }?, left, &input)?;
            left -= made;
            // SAFETY: C gave the function for this.
            if sampled && unsafe { trace(simulation, context) } != 0 {
                break;
            }
        }
        Ok(())
    })
}

/// Makes the steps to the next sample, but at most `left`; tells how many, and whether the sample is reached.
fn advance(
    block: (&mut SoftanvilSimulation, ptr::Region),
    left: u64,
    input: &StepInput,
) -> Result<(u64, bool), Failure> {
    block::with(block, |model, state| {
        let whole = steps_to_sample(model, state).max(1);
        let steps = whole.min(left);
        (0..steps).try_for_each(|_| step(model, state, input))?;
        Ok((steps, steps == whole))
    })
}
