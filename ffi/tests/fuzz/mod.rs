//! What bytes make of the C ABI: each target reads its input as something that a caller may hand over, and holds the
//! library to its promises. Used by the fuzzer (`ffi/fuzz`) and by the replay of its corpus (`ffi/tests/corpus.rs`).

pub mod driven;
pub mod fmi;

use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use softanvil::c_api::error::SoftanvilError;
use softanvil::c_api::fields::*;
use softanvil::c_api::header::SoftanvilSimulation;
use softanvil::c_api::library::softanvil_status_text;
use softanvil::c_api::scenario::*;
use softanvil::c_api::simulation::*;
use softanvil::c_api::snapshot::*;
use softanvil::c_api::status::SoftanvilStatus as Status;
use softanvil::c_api::tables::*;
use softanvil::c_api::text::SOFTANVIL_NAME_SIZE;
use softanvil::c_api::trace::softanvil_run_traced;
use softanvil_kernel::number::digest::Digest;
use softanvil_kernel::result::RETIRED_OUTPUTS;

/// Largest block that a target builds, bytes: enough for the study, small enough for many runs per second.
const MEMORY: usize = 1 << 18;

/// The slot of mesh.element_size in a scenario.
const ELEMENT_SIZE: usize = 23;

/// A target: its name, which is that of its corpus, and what it does with its input.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: [Target; 6] = [
    ("scenario", scenario),
    ("snapshot", snapshot),
    ("calls", calls),
    ("driven", driven::driven),
    ("fmi2", fmi::fmi2),
    ("fmi3", fmi::fmi3),
];

/// Input that runs out gives zeros.
pub struct Input<'a>(&'a [u8]);

impl Input<'_> {
    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let mut bytes = [0; N];
        let (head, tail) = self.0.split_at(N.min(self.0.len()));
        bytes[..head.len()].copy_from_slice(head);
        self.0 = tail;
        bytes
    }

    fn byte(&mut self) -> u8 {
        let [byte] = self.bytes();
        byte
    }

    fn word(&mut self) -> u16 {
        u16::from_le_bytes(self.bytes())
    }

    /// Any bits, or a number of ordinary size.
    fn number(&mut self) -> f64 {
        match self.byte() % 4 {
            0 => f64::from_le_bytes(self.bytes()),
            1 => f64::from(i16::from_le_bytes(self.bytes())) * 1e-3,
            2 => f64::from(self.byte()),
            _ => [0.0, -0.0, f64::NAN, f64::INFINITY, -1.0, 1e-300, 1e300, 1.0][self.byte() as usize % 8],
        }
    }
}

/// A piece of memory as C lends it.
#[repr(align(64))]
#[derive(Clone, Copy)]
struct Line {
    _bytes: [u8; 64],
}

fn memory() -> Vec<Line> {
    vec![Line { _bytes: [0; 64] }; MEMORY / 64]
}

/// A call of a function that explains itself: the error says the status, in one line that ends.
fn explained(call: impl FnOnce(*mut SoftanvilError) -> Status) -> Status {
    let mut error = MaybeUninit::<SoftanvilError>::zeroed();
    let status = call(error.as_mut_ptr());
    // SAFETY: numbers only, zeroed or written.
    let error = unsafe { error.assume_init() };
    if status == Status::Ok {
        assert!(error.status == 0 && error.text[0] == 0, "a success wrote an error");
    } else {
        assert_eq!(error.status, status as i32);
        assert!(error.text.contains(&0) && error.text[0] != 0, "an error without text");
        // SAFETY: the text ends within its array; status texts are static.
        let [text, general] = unsafe {
            [error.text.as_ptr(), softanvil_status_text(error.status)]
                .map(|text| CStr::from_ptr(text).to_str().unwrap())
        };
        assert!(!text.contains('\n') && general != "unknown status", "{text}");
    }
    status
}

/// The study on a mesh that takes little time.
fn coarse() -> SoftanvilScenario {
    let mut scenario = study();
    scenario.value[ELEMENT_SIZE] = 7e-3;
    scenario
}

/// Memory with a simulation of [`coarse`], built once: a copy of it is a simulation of its own.
fn built() -> Vec<Line> {
    thread_local!(static BUILT: std::cell::OnceCell<Vec<Line>> = const { std::cell::OnceCell::new() });
    BUILT.with(|built| {
        built
            .get_or_init(|| {
                let mut memory = memory();
                build(&mut memory, &coarse()).unwrap();
                memory
            })
            .clone()
    })
}

fn study() -> SoftanvilScenario {
    let mut scenario = MaybeUninit::uninit();
    // SAFETY: valid for writes; the study exists.
    unsafe {
        assert_eq!(softanvil_scenario_default(0, scenario.as_mut_ptr()), Status::Ok);
        scenario.assume_init()
    }
}

/// Builds a simulation if the scenario is legal and small; the size that was told is enough.
fn build(memory: &mut [Line], scenario: &SoftanvilScenario) -> Option<*mut SoftanvilSimulation> {
    let (mut size, mut alignment, mut simulation) = (0, 0, null_mut());
    // SAFETY: references are valid pointers, the memory has its length.
    unsafe {
        if explained(|error| softanvil_memory_size(scenario, &mut size, &mut alignment, error)) != Status::Ok {
            return None;
        }
        let status =
            explained(|error| softanvil_init(memory.as_mut_ptr().cast(), MEMORY, scenario, &mut simulation, error));
        assert_eq!(status == Status::ShortBuffer, size > MEMORY, "{size}");
        (status == Status::Ok).then_some(simulation)
    }
}

/// A scenario whose values are the input's: refused, or good for steps.
pub fn scenario(data: &[u8]) {
    let mut input = Input(data);
    let mut scenario = coarse();
    while !input.0.is_empty() {
        let slot = input.word();
        match slot {
            // The words that are not to be changed, changed.
            0xffff => scenario.count = u32::from(input.byte()),
            0xfffe => scenario.preset = u32::from(input.byte()),
            0xfffd => scenario.struct_size = u32::from_le_bytes(input.bytes()),
            0xfffc => scenario.layer_count = u32::from(input.byte()),
            _ => scenario.value[slot as usize % SOFTANVIL_PARAMETER_SLOTS] = input.number(),
        }
    }
    let mut memory = memory();
    if let Some(simulation) = build(&mut memory, &scenario) {
        // SAFETY: just built.
        unsafe { explained(|error| softanvil_step(simulation, 2, null(), error)) };
    }
}

/// A snapshot with the input written over it: refused if its checksum is wrong; if the input makes it right, steps
/// from whatever state it holds end with a status.
pub fn snapshot(data: &[u8]) {
    let mut memory = built();
    let simulation = memory.as_mut_ptr().cast();
    let mut size = 0;
    // SAFETY: the simulation lives; every length is that of its buffer.
    unsafe {
        assert_eq!(softanvil_step(simulation, 3, null(), null_mut()), Status::Ok);
        assert_eq!(softanvil_snapshot_size(simulation, &mut size), Status::Ok);
        let mut bytes = vec![0; size];
        assert_eq!(softanvil_snapshot_save(simulation, bytes.as_mut_ptr(), size, null_mut()), Status::Ok);
        let mut input = Input(data);
        let repair = input.byte() % 2 == 0;
        while !input.0.is_empty() {
            let at = u16::from_le_bytes(input.bytes()) as usize * 8 % size;
            bytes[at..at + 8].copy_from_slice(&input.number().to_le_bytes());
        }
        if repair {
            seal(&mut bytes);
        }
        let restored = explained(|error| softanvil_snapshot_restore(simulation, bytes.as_ptr(), size, error));
        assert!(restored == Status::Ok || restored as i32 >= 400, "{restored:?}");
        explained(|error| softanvil_step(simulation, 20, null(), error));
        explained(|error| softanvil_step_to_sample(simulation, null(), error));
        read_everything(simulation);
    }
}

/// Makes the checksum of a snapshot right.
fn seal(bytes: &mut [u8]) {
    let mut digest = Digest::new();
    let (content, checksum) = bytes.split_at_mut(bytes.len() - 8);
    content.chunks_exact(8).for_each(|word| digest.word(u64::from_le_bytes(word.try_into().unwrap())));
    checksum.copy_from_slice(&digest.value().to_le_bytes());
}

/// Outputs and fields, whatever they hold.
///
/// # Safety
/// The simulation lives.
unsafe fn read_everything(simulation: *const SoftanvilSimulation) {
    let mut value = 0.0;
    let mut view = MaybeUninit::<SoftanvilView>::uninit();
    for output in 0..softanvil_output_count() {
        let expected = if RETIRED_OUTPUTS.contains(&output) { Status::UnknownId } else { Status::Ok };
        // SAFETY: the caller's guarantee.
        assert_eq!(unsafe { softanvil_output(simulation, output, &mut value) }, expected);
    }
    for field in 0..softanvil_field_count() {
        // SAFETY: the caller's guarantee; the view is read after success; the vector has its length.
        unsafe {
            assert_eq!(softanvil_field_view(simulation, field, 0, view.as_mut_ptr()), Status::Ok);
            let view = view.assume_init();
            let mut values = vec![0.0; view.rows * view.columns];
            let status = softanvil_field_read(simulation, field, 0, values.as_mut_ptr(), values.len(), 1, null_mut());
            assert_eq!(status, Status::Ok);
        }
    }
}

unsafe extern "C" fn never_twice(_: *const SoftanvilSimulation, _: *mut std::ffi::c_void) -> i32 {
    1
}

/// Calls in an order and with arguments that the input chooses, on a simulation, a closed one, or none.
pub fn calls(data: &[u8]) {
    let mut input = Input(data);
    let mut memory = memory();
    let mut scenario = coarse();
    let mut bytes = vec![0_u8; 1 << 16];
    let (mut id, mut value, mut word, mut size) = (0, 0.0, 0, 0);
    let mut name = [0 as c_char; SOFTANVIL_NAME_SIZE];
    let mut given = MaybeUninit::<SoftanvilInput>::zeroed();
    let mut simulation: *mut SoftanvilSimulation = null_mut();
    // SAFETY: every pointer is null or points to what it says; lengths are those of the buffers.
    unsafe {
        while !input.0.is_empty() {
            let step_input = if input.byte() % 2 == 0 { null() } else { given.as_ptr() };
            match input.byte() % 21 {
                0 if scenario.value == coarse().value => {
                    memory = built();
                    simulation = memory.as_mut_ptr().cast();
                }
                0 => simulation = build(&mut memory, &scenario).unwrap_or(null_mut()),
                1 => drop(softanvil_close(simulation)),
                2 => drop(softanvil_reset(simulation)),
                3 => drop(explained(|error| {
                    softanvil_scenario_set(&mut scenario, u32::from(input.word()), input.number(), error)
                })),
                4 => drop(softanvil_scenario_get(&scenario, u32::from(input.word()), &mut value)),
                5 => drop(explained(|e| softanvil_step(simulation, u64::from(input.byte() % 8), step_input, e))),
                6 => drop(explained(|error| softanvil_step_to_sample(simulation, step_input, error))),
                7 if input.byte() % 2 == 0 => {
                    let time = input.number().clamp(-1.0, 1e-4);
                    explained(|error| softanvil_run_until(simulation, time, step_input, error));
                }
                7 => drop(explained(|e| softanvil_run(simulation, input.number().clamp(-1.0, 1e-4), step_input, e))),
                8 => drop(softanvil_input_default(simulation, given.as_mut_ptr())),
                9 => (*given.as_mut_ptr()).driven_position = input.number(),
                10 => {
                    let number = input.number();
                    ((*given.as_mut_ptr()).external_force, (*given.as_mut_ptr()).driven_velocity) = (number, number);
                }
                11 => drop(softanvil_output(simulation, u32::from(input.byte()), &mut value)),
                12 => drop(softanvil_snapshot_size(simulation, &mut size)),
                13 => drop(explained(|e| softanvil_snapshot_save(simulation, bytes.as_mut_ptr(), bytes.len(), e))),
                14 => drop(explained(|e| softanvil_snapshot_restore(simulation, bytes.as_ptr(), bytes.len(), e))),
                15 => {
                    let at = usize::from(input.word());
                    bytes[at] = input.byte();
                }
                16 if !simulation.is_null() => {
                    if softanvil_time(simulation, &mut value) == Status::Ok {
                        read_everything(simulation);
                    }
                }
                17 => {
                    name = input.bytes().map(|byte: u8| byte as c_char);
                    name[SOFTANVIL_NAME_SIZE - 1] = 0;
                    softanvil_parameter_find(name.as_ptr(), &mut id);
                    softanvil_output_by_name(simulation, name.as_ptr(), &mut value);
                }
                18 => {
                    let duration = input.number().clamp(-1.0, 1e-4);
                    explained(|e| {
                        softanvil_run_traced(simulation, duration, step_input, Some(never_twice), null_mut(), e)
                    });
                }
                19 => drop(softanvil_trace_hash(simulation, &mut word)),
                _ => drop(softanvil_parameter_choice(
                    u32::from(input.word()),
                    u32::from(input.word()),
                    name.as_mut_ptr(),
                    input.byte() as usize % SOFTANVIL_NAME_SIZE,
                )),
            }
        }
    }
}
