//! Simulation

use core::ffi::{c_char, c_void};

use softanvil_kernel::{Constants, Model, Parameter, Size, State, StepInput, steps};

use crate::c_api::error::{SoftanvilError, report, status};
use crate::c_api::failure::Failure;
use crate::c_api::header::{ALIGNMENT, SoftanvilSimulation};
use crate::c_api::scenario::SoftanvilScenario;
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::tables::{find_output, output_row};
use crate::c_api::{block, ptr};
use crate::whole_steps::{SAME, nearest};

/// What acts on the impactor from outside during a call that makes steps, of one or of many. It always comes from
/// `softanvil_input_default`.
///
/// A driven face is at `driven_position` at the end of the call, that is, after its last step, and moves there from where it
/// is: along a straight line, or, if `driven_velocity` is given, along the cubic that starts with the velocity that
/// `impactor.velocity` tells before the call and ends with `driven_velocity`. So a master that cuts time into calls gives
/// with each where the face is to be at the end of that call, and the motion has no jump.
///
/// A value that is not legal, NaN among them, is refused as ILLEGAL_INPUT; the call makes no step then, changes nothing, and
/// the next one may go on. An input that does not act (a force on a driven impactor, a position of a falling one) may be
/// any finite number.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SoftanvilInput {
    /// Tells an initialised input; do not change.
    pub marker: u32,
    /// Bytes of this structure; do not change.
    pub struct_size: u32,
    /// Upward force on a falling impactor besides gravity and contact, from -1e6 to 1e6 N; held over the call.
    pub external_force: f64,
    /// Height of the face of a driven impactor above the undeformed anvil at the end of the call, from -1 to 1 m; negative
    /// presses.
    pub driven_position: f64,
    /// Always 0.
    pub reserved: [f64; 4],
    /// Upward velocity of the face of a driven impactor at the end of the call, from -100 to 100 m/s; NaN, which stands there
    /// at first, for a straight line.
    pub driven_velocity: f64,
}

impl SoftanvilInput {
    /// "SAIN", least significant byte first.
    const MARKER: u32 = u32::from_le_bytes(*b"SAIN");

    fn to_kernel(self) -> Result<StepInput, Failure> {
        if self.marker != Self::MARKER || self.struct_size as usize != size_of::<Self>() {
            return Err(Failure::Uninitialised { argument: "input" });
        }
        if let Some((slot, value)) = self.reserved.into_iter().enumerate().find(|(_, value)| *value != 0.0) {
            return Err(Failure::ReservedSlot { array: "reserved", slot, value });
        }
        Ok(StepInput {
            external_force: self.external_force,
            driven_position: Some(self.driven_position),
            driven_velocity: (!self.driven_velocity.is_nan()).then_some(self.driven_velocity),
        })
    }

    /// What `input` says; if nothing, that nothing acts and a driven impactor stays.
    pub(crate) fn or_hold(input: Option<&Self>) -> Result<StepInput, Failure> {
        input.map_or(Ok(StepInput::default()), |input| input.to_kernel())
    }
}

/// Tells how much memory a simulation of a scenario needs; checks the scenario.
///
/// @param scenario The scenario.
/// @param size Bytes.
/// @param alignment Bytes that the address must be a multiple of; any malloc gives at least as much. On a cache line
///        (64 bytes) steps are some per cents faster; simulations of different threads run best on pages of their own.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, or a status of the scenario (200 to 299).
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_memory_size(
    scenario: *const SoftanvilScenario,
    size: *mut usize,
    alignment: *mut usize,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, error) = unsafe { (ptr::shared(scenario, "scenario"), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let (size, alignment) = unsafe { (ptr::out(size, "size"), ptr::out(alignment, "alignment")) };
    report(error, || {
        let (scenario, size, alignment) = (scenario?, size?, alignment?);
        let scenario = scenario.kernel();
        let needed = block::bytes(&Size::of(scenario.as_ref().map_err(|failure| *failure)?)?);
        size.write(needed);
        alignment.write(ALIGNMENT);
        Ok(())
    })
}

/// Builds a simulation, at the start of its drop, in memory that the caller lends. The scenario is copied.
///
/// The simulation holds no address: between calls the memory may be copied or moved to any address of the same
/// alignment in the same process, and the copy is a simulation of its own at its address. If the function fails because
/// of the time step (STEP_TOO_SMALL, STEP_TOO_LARGE), the content of the memory is lost; if for anything else, untouched.
///
/// @param memory The memory; it stays the caller's, who keeps it until the simulation is no longer used.
/// @param size Bytes of it, at least those of `softanvil_memory_size`.
/// @param scenario The scenario.
/// @param simulation The simulation, which is the address of the memory.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, or a status of the scenario (200 to 299).
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_init(
    memory: *mut c_void,
    size: usize,
    scenario: *const SoftanvilScenario,
    simulation: *mut *mut SoftanvilSimulation,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (scenario, error) = unsafe { (ptr::shared(scenario, "scenario"), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let simulation = unsafe { ptr::out(simulation, "simulation") };
    report(error, || {
        let simulation = simulation?;
        // By reference, so that the stack holds it once.
        let scenario = scenario?.kernel();
        let scenario = scenario.as_ref().map_err(|failure| *failure)?;
        let counts = Size::of(scenario)?;
        // SAFETY: as above.
        let region = unsafe { ptr::zeroed(memory.cast(), size, block::bytes(&counts)) }?;
        simulation.write(block::build(scenario, &counts, region)?);
        Ok(())
    })
}

/// Ends a simulation: from now on its address is refused as UNINITIALISED, as long as the memory is not used otherwise.
/// There is nothing to free; forgetting this call leaks nothing.
///
/// @param simulation The simulation.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_close(simulation: *mut SoftanvilSimulation) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let block = unsafe { ptr::block(simulation) };
    status(|| {
        block?.0.marker = 0;
        Ok(())
    })
}

/// Takes a simulation back to the start of its drop.
///
/// @param simulation The simulation.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_reset(simulation: *mut SoftanvilSimulation) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let block = unsafe { ptr::block(simulation) };
    status(|| {
        block::with(block?, |model, state| {
            state.reset(model);
            Ok(())
        })
    })
}

/// Lets the anvil rest and the impactor fall again on it, as it is: time, samples, numbers of the test and energies begin anew.
///
/// The anvil keeps its damage (tears, and what has softened), comes back to its shape and stands still; overstresses decay
/// by e^(-rest/tau). It may be called at any time of an impact.
///
/// @param simulation The simulation.
/// @param rest Time between the impacts, 0 to 1e9 s.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, ILLEGAL_INPUT for a rest that is not legal, INVERTED or UNSTABLE of a
///         simulation that has failed.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_next_impact(
    simulation: *mut SoftanvilSimulation,
    rest: f64,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (block, error) = unsafe { (ptr::block(simulation), ptr::optional_out(error, "error")) };
    report(error, || block::with(block?, |model, state| state.next_impact(model, rest).map_err(Failure::from)))
}

/// Fills an input that leaves things as they are: no external force, and a driven impactor stays where it is, without a
/// velocity for the end.
///
/// @param simulation The simulation.
/// @param input The input to fill.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_input_default(
    simulation: *const SoftanvilSimulation,
    input: *mut SoftanvilInput,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (header, input) = unsafe { (ptr::header(simulation), ptr::out(input, "input")) };
    status(|| {
        let (header, input) = (header?, input?);
        input.write(SoftanvilInput {
            marker: SoftanvilInput::MARKER,
            struct_size: size_of::<SoftanvilInput>() as u32,
            external_force: 0.0,
            driven_position: header.scalars.impactor.position,
            reserved: [0.0; 4],
            driven_velocity: f64::NAN,
        });
        Ok(())
    })
}

/// Makes steps of the simulation's fixed time step: the force is held, and a driven face is at `driven_position` after the
/// last of them. The work of a step is bounded and does not depend on the state.
///
/// A step that fails (INVERTED, UNSTABLE) leaves the steps before it done and stops the simulation: every further step fails
/// alike until the simulation is reset or restored. Arguments that are refused, an ILLEGAL_INPUT among them, change nothing.
///
/// @param simulation The simulation.
/// @param steps Number of steps; 0 does nothing.
/// @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, RESERVED_SLOT, or a status of a step (300 to 399).
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_step(
    simulation: *mut SoftanvilSimulation,
    steps: u64,
    input: *const SoftanvilInput,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { advance(simulation, input, error, |_, _| Ok(steps)) }
}

/// Makes the steps up to the end of the running sampling interval of 50 us, where `contact.force` and `core.reaction`
/// get a new value, and where a driven face is at `driven_position`.
///
/// @param simulation The simulation.
/// @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
/// @param error Details of a failure, or NULL.
/// @return As `softanvil_step`.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_step_to_sample(
    simulation: *mut SoftanvilSimulation,
    input: *const SoftanvilInput,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { advance(simulation, input, error, |model, state| Ok(steps_to_sample(model, state))) }
}

/// Makes the steps that cover a time, rounded up to whole sampling intervals of 50 us, at whose end a driven face is at
/// `driven_position`. A drop of the study is over after the 15 ms of `time.duration`.
///
/// @param simulation The simulation.
/// @param duration Time, s, in the legal range of `time.duration`.
/// @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
/// @param error Details of a failure, or NULL.
/// @return As `softanvil_step`, and ILLEGAL_VALUE for the duration.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_run(
    simulation: *mut SoftanvilSimulation,
    duration: f64,
    input: *const SoftanvilInput,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { advance(simulation, input, error, |model, _| steps_in(model.constants, duration)) }
}

/// Makes the steps to the one nearest to a time, of two equally near to the later; none if the simulation is there. So it is
/// never more than half a step away from the time asked for, and makes the same steps however time is cut. A driven face is
/// at `driven_position` after the last step, at the time that `softanvil_time` tells then.
///
/// @param simulation The simulation.
/// @param time Time since the start of the drop, s: from half a step before the present to 100 s after it.
/// @param input What acts on the impactor, or NULL for the input of `softanvil_input_default` at the call.
/// @param error Details of a failure, or NULL.
/// @return As `softanvil_step`, and ILLEGAL_TIME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_run_until(
    simulation: *mut SoftanvilSimulation,
    time: f64,
    input: *const SoftanvilInput,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    report(unsafe { ptr::optional_out(error, "error") }, || {
        // SAFETY: as above.
        let (block, input) = unsafe { (ptr::block(simulation), ptr::optional_shared(input, "input")) };
        let input = input?;
        block::with(block?, |model, state| {
            let input = SoftanvilInput::or_hold(input)?;
            let count = steps_until(model.constants, state.scalars.step_index, time)?;
            steps(model, state, count as u64, &input).map_err(Failure::from)
        })
    })
}

/// Longest time that a run may cover, s: that of the table of parameters.
const LONGEST_RUN: f64 = 100.0;

/// Steps from `step_index` to the one nearest to `time`, if it is legal.
fn steps_until(constants: &Constants, step_index: u64, time: f64) -> Result<i64, Failure> {
    let (dt, present) = (constants.dt, constants.time(step_index));
    let (min, max) = (present - 0.5 * dt, present + LONGEST_RUN);
    let is_legal = time >= min - SAME * dt && time <= max;
    if !is_legal {
        return Err(Failure::Time { time, min, max });
    }
    Ok(nearest(time / dt - step_index as i64 as f64))
}

/// Steps that cover `duration`, if it is legal.
pub(crate) fn steps_in(constants: &Constants, duration: f64) -> Result<u64, Failure> {
    Parameter::find("time.duration").map_or(Ok(()), |row| row.check(duration))?;
    Ok(constants.steps_in(duration))
}

/// Makes as many steps as `count` says.
///
/// # Safety
/// The conventions of the header.
unsafe fn advance(
    simulation: *mut SoftanvilSimulation,
    input: *const SoftanvilInput,
    error: *mut SoftanvilError,
    count: impl FnOnce(&Model, &State) -> Result<u64, Failure>,
) -> SoftanvilStatus {
    // SAFETY: the caller's guarantee.
    report(unsafe { ptr::optional_out(error, "error") }, || {
        // SAFETY: the caller's guarantee.
        let (block, input) = unsafe { (ptr::block(simulation), ptr::optional_shared(input, "input")) };
        let input = input?;
        block::with(block?, |model, state| {
            let input = SoftanvilInput::or_hold(input)?;
            let count = count(model, state)?;
            steps(model, state, count, &input).map_err(Failure::from)
        })
    })
}

/// Steps to the end of the running sampling interval.
pub(crate) fn steps_to_sample(model: &Model, state: &State) -> u64 {
    let period = u64::from(model.constants.steps_per_sample);
    let into = state.scalars.step_index.checked_rem(period).unwrap_or_default();
    period.saturating_sub(into)
}

/// Reads an output at the current time.
///
/// @param simulation The simulation.
/// @param output A `SoftanvilOutput`.
/// @param value Value in the output's SI unit.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_ID.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_output(
    simulation: *const SoftanvilSimulation,
    output: u32,
    value: *mut f64,
) -> SoftanvilStatus {
    let read =
        |header: &SoftanvilSimulation| output_row(output).map(|row| (row.read)(&header.constants, &header.scalars));
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, value, read) }
}

/// As `softanvil_output`, by the output's name.
///
/// @param simulation The simulation.
/// @param name Name, such as "contact.force".
/// @param value Value in the output's SI unit.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, UNKNOWN_NAME.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_output_by_name(
    simulation: *const SoftanvilSimulation,
    name: *const c_char,
    value: *mut f64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let name = unsafe { ptr::name(name, "name") };
    let read = |header: &SoftanvilSimulation| {
        let row = find_output(&name?)?;
        Ok((row.read)(&header.constants, &header.scalars))
    };
    // SAFETY: as above.
    unsafe { tell(simulation, value, read) }
}

/// Tells the simulated time, from the number of steps made and never an accumulated sum: whole sampling intervals of 50 us,
/// for which it is the double nearest to the time, and the steps beyond them times the step.
///
/// @param simulation The simulation.
/// @param time Time since the start of the drop, s.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_time(simulation: *const SoftanvilSimulation, time: *mut f64) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, time, |header| Ok(header.constants.time(header.scalars.step_index))) }
}

/// Tells the number of steps made since the start of the drop.
///
/// @param simulation The simulation.
/// @param step_index Number of steps.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_step_index(
    simulation: *const SoftanvilSimulation,
    step_index: *mut u64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, step_index, |header| Ok(header.scalars.step_index)) }
}

/// Tells the fixed time step, a whole divisor of 50 us.
///
/// @param simulation The simulation.
/// @param dt Time step, s.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_dt(simulation: *const SoftanvilSimulation, dt: *mut f64) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, dt, |header| Ok(header.constants.dt)) }
}

/// Tells the number of steps in a sampling interval of 50 us.
///
/// @param simulation The simulation.
/// @param steps Number of steps.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_steps_per_sample(
    simulation: *const SoftanvilSimulation,
    steps: *mut u64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, steps, |header| Ok(u64::from(header.constants.steps_per_sample))) }
}

/// Tells the digest of all samples so far (FNV-1a, 64 bit, over the bits of contact force, core reaction and impactor
/// position at every 50 us): equal digests mean equal traces to the last bit, on whatever machine.
///
/// @param simulation The simulation.
/// @param trace_hash The digest.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_trace_hash(
    simulation: *const SoftanvilSimulation,
    trace_hash: *mut u64,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    unsafe { tell(simulation, trace_hash, |header| Ok(header.scalars.sampler.trace_hash)) }
}

/// Writes one number of a simulation.
///
/// # Safety
/// The conventions of the header.
unsafe fn tell<T>(
    simulation: *const SoftanvilSimulation,
    value: *mut T,
    read: impl FnOnce(&SoftanvilSimulation) -> Result<T, Failure>,
) -> SoftanvilStatus {
    // SAFETY: the caller's guarantee.
    let (header, value) = unsafe { (ptr::header(simulation), ptr::out(value, "value")) };
    status(|| {
        let (header, value) = (header?, value?);
        value.write(read(header)?);
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use softanvil_kernel::{Simulation, preset};

    use super::*;

    #[test]
    fn the_longest_run_is_that_of_the_table() {
        assert_eq!(Parameter::find("time.duration").unwrap().range().1, LONGEST_RUN);
    }

    #[test]
    fn a_time_is_legal_from_half_a_step_before_the_present_to_100_s_after_it() {
        let simulation = Simulation::new(&preset::study()).unwrap();
        let (constants, made) = (simulation.constants(), 400_000);
        let dt = constants.dt;
        let present = 400_000.0 * dt;
        assert!(present > 1.0, "{present} s");
        let until = |time: f64| steps_until(constants, made, time).ok();
        let ahead = |steps: f64| until(present + steps * dt);
        assert_eq!(
            [ahead(0.0), ahead(-0.49), ahead(0.49), ahead(0.51), ahead(7.0)].map(Option::unwrap),
            [0, 0, 0, 1, 7]
        );
        assert_eq!([ahead(-0.51), until(0.0), until(f64::NAN), until(present + 100.0 + dt)], [None; 4]);
        assert_eq!(until(present + 100.0 - dt), Some((100.0 / dt).round() as i64 - 1));
        let Err(Failure::Time { time, min, max }) = steps_until(constants, made, -1.0) else { panic!("legal") };
        assert_eq!(time, -1.0);
        assert!((min - (present - 0.5 * dt)).abs() < 1e-12 && (max - (present + 100.0)).abs() < 1e-9);
    }
}
