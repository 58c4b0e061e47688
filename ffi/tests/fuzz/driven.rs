//! Inputs of the impactor that no sane master gives: refused, with nothing changed, or good for finite outputs.

use std::cell::OnceCell;
use std::mem::MaybeUninit;
use std::ptr::null_mut;

use softanvil::c_api::scenario::softanvil_scenario_set_by_name;
use softanvil::c_api::simulation::*;
use softanvil::c_api::snapshot::*;
use softanvil::c_api::status::SoftanvilStatus as Status;
use softanvil::c_api::tables::softanvil_output_count;
use softanvil_kernel::scenario::{Formulation, Motion};

use super::{Input, Line, build, coarse, explained, memory};

/// Longest time of a call, s: some hundred steps.
const LONGEST: f64 = 5e-4;

thread_local! {
    /// Memory of simulations by motion and formulation, each built once: a copy of it is a simulation.
    static BUILT: [OnceCell<Vec<Line>>; 4] = const { [const { OnceCell::new() }; 4] };
}

fn built(motion: Motion, formulation: Formulation) -> Vec<Line> {
    let make = || {
        let mut scenario = coarse();
        let choices = [(c"impactor.motion", motion as u8), (c"geometry.formulation", formulation as u8)];
        for (name, choice) in choices {
            // SAFETY: the scenario is valid for writes, the name a text.
            let status =
                unsafe { softanvil_scenario_set_by_name(&mut scenario, name.as_ptr(), f64::from(choice), null_mut()) };
            assert_eq!(status, Status::Ok);
        }
        let mut memory = memory();
        build(&mut memory, &scenario).unwrap();
        memory
    };
    let place = usize::from(motion == Motion::Driven) + 2 * usize::from(formulation == Formulation::Axisymmetric);
    BUILT.with(|all| all[place].get_or_init(make).clone())
}

/// Bytes of the memory, to see whether anything has changed.
fn bytes(memory: &[Line]) -> &[u8] {
    // SAFETY: lines are bytes, all initialised by zeros or by the library.
    unsafe { std::slice::from_raw_parts(memory.as_ptr().cast(), size_of_val(memory)) }
}

/// Steps, jumps, turns, noise below a step's way, values at and beyond what is legal, no numbers.
fn hostile(input: &mut Input, now: f64, range: f64) -> f64 {
    match input.byte() % 8 {
        0 => input.number(),
        1 => now + f64::from(i16::from_le_bytes(input.bytes())) * 1e-12,
        2 => now + f64::from(i16::from_le_bytes(input.bytes())) * 1e-7,
        3 => -now,
        4 => [range, -range, range.next_up(), -range.next_up()][input.byte() as usize % 4],
        5 => [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, -0.0][input.byte() as usize % 6],
        6 => range * f64::from(i16::from_le_bytes(input.bytes())) / f64::from(i16::MAX),
        _ => now,
    }
}

/// Calls of all kinds with hostile inputs.
pub fn driven(data: &[u8]) {
    let mut input = Input(data);
    let which = input.byte();
    let motion = if which % 4 == 0 { Motion::Drop } else { Motion::Driven };
    let formulation = if which % 16 < 12 { Formulation::PlaneStrain } else { Formulation::Axisymmetric };
    let mut memory = built(motion, formulation);
    let simulation = memory.as_mut_ptr().cast();
    let mut given = MaybeUninit::<SoftanvilInput>::uninit();
    // SAFETY: the memory is that of a simulation; the input is written by the first call; lengths are those of the buffers.
    unsafe {
        assert_eq!(softanvil_input_default(simulation, given.as_mut_ptr()), Status::Ok);
        let mut given = given.assume_init();
        while !input.0.is_empty() {
            match input.byte() % 4 {
                0 => given.external_force = hostile(&mut input, given.external_force, 1e6),
                1 => given.driven_velocity = hostile(&mut input, given.driven_velocity, 100.0),
                _ => given.driven_position = hostile(&mut input, given.driven_position, 1.0),
            }
            let before = memory.clone();
            let status = call(&mut input, simulation, &given);
            match status {
                Status::Ok => assert_finite(simulation),
                Status::Inverted | Status::Unstable => start_anew(simulation, input.byte() % 2 == 0),
                Status::IllegalInput | Status::IllegalTime | Status::IllegalValue => {
                    assert!(bytes(&before) == bytes(&memory), "{status:?} has changed something");
                    softanvil_input_default(simulation, &mut given);
                }
                _ => panic!("{status:?}"),
            }
        }
    }
}

/// One call that makes steps.
///
/// # Safety
/// The simulation lives.
unsafe fn call(input: &mut Input, simulation: *mut super::SoftanvilSimulation, given: &SoftanvilInput) -> Status {
    let mut now = 0.0;
    // SAFETY: the caller's guarantee; the input is initialised.
    unsafe {
        assert_eq!(softanvil_time(simulation, &mut now), Status::Ok);
        let kind = input.byte();
        explained(|error| match kind % 5 {
            0 | 1 => softanvil_step(simulation, u64::from(input.byte() % 32), given, error),
            2 => softanvil_step_to_sample(simulation, given, error),
            3 => softanvil_run(simulation, hostile(input, LONGEST, LONGEST).min(LONGEST), given, error),
            _ => softanvil_run_until(simulation, now + hostile(input, 0.0, LONGEST).min(LONGEST), given, error),
        })
    }
}

/// Every output of a simulation that has not failed is a number.
///
/// # Safety
/// The simulation lives.
unsafe fn assert_finite(simulation: *const super::SoftanvilSimulation) {
    let mut value = 0.0;
    for output in 0..softanvil_output_count() {
        // SAFETY: the caller's guarantee.
        if unsafe { softanvil_output(simulation, output, &mut value) } == Status::Ok {
            assert!(value.is_finite(), "output {output} is {value} after a call that said it was well");
        }
    }
}

/// A simulation that has failed goes on failing and is not saved, until it is reset.
///
/// # Safety
/// The simulation lives.
unsafe fn start_anew(simulation: *mut super::SoftanvilSimulation, tries: bool) {
    // SAFETY: the caller's guarantee; the buffer has its length.
    unsafe {
        if tries {
            let mut size = 0;
            assert_eq!(softanvil_snapshot_size(simulation, &mut size), Status::Ok);
            let mut bytes = vec![0; size];
            let saved = softanvil_snapshot_save(simulation, bytes.as_mut_ptr(), size, null_mut());
            assert_eq!(saved, Status::SnapshotFailed);
            let again = softanvil_step(simulation, 1, std::ptr::null(), null_mut());
            assert!(matches!(again, Status::Inverted | Status::Unstable), "{again:?} after a failure");
        }
        assert_eq!(softanvil_reset(simulation), Status::Ok);
    }
}
