//! The C ABI called from Rust, misused on purpose: what a caller in C can get wrong without breaking its contract, and
//! what the unsafe code must get right. The rigs in `tests/c` and `tests/cpp` do the same from outside.

use std::alloc::{Layout, alloc, dealloc};
use std::ffi::{CStr, c_void};
use std::mem::MaybeUninit;
use std::ptr::{null, null_mut};

use softanvil::c_api::error::SoftanvilError;
use softanvil::c_api::fields::*;
use softanvil::c_api::header::SoftanvilSimulation;
use softanvil::c_api::library::{
    softanvil_kernel_digest, softanvil_status_text, softanvil_version, softanvil_version_text,
};
use softanvil::c_api::scenario::*;
use softanvil::c_api::simulation::*;
use softanvil::c_api::snapshot::*;
use softanvil::c_api::status::SoftanvilStatus as Status;
use softanvil::c_api::tables::*;
use softanvil::c_api::trace::softanvil_run_traced;
use softanvil_kernel::material::NeoHookean;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::result::{RETIRED_FIELDS, RETIRED_OUTPUTS};
use softanvil_kernel::{FIELDS, OUTPUTS, Parameter, Simulation, StepInput, preset};

/// Number of impactor.mass.
const MASS: u32 = 7;

/// Samples that a run takes: few where an interpreter checks every access.
const SAMPLES: usize = if cfg!(miri) { 1 } else { 20 };
/// And the time that they cover, s.
const DURATION: f64 = 50e-6 * SAMPLES as f64;

/// A block of exactly the size and alignment that was asked for, uninitialised as malloc gives it.
struct Block {
    pointer: *mut c_void,
    layout: Layout,
}

impl Block {
    fn new(size: usize, alignment: usize) -> Self {
        let layout = Layout::from_size_align(size, alignment).unwrap();
        // SAFETY: the layout is not of zero size.
        Self { pointer: unsafe { alloc(layout) }.cast(), layout }
    }
}

impl Drop for Block {
    fn drop(&mut self) {
        // SAFETY: allocated in `new` with this layout.
        unsafe { dealloc(self.pointer.cast(), self.layout) }
    }
}

/// A scenario with a coarse mesh, for speed.
fn coarse() -> SoftanvilScenario {
    let mut scenario = MaybeUninit::uninit();
    // SAFETY: valid for writes, and written when the status is checked.
    unsafe {
        assert_eq!(softanvil_scenario_default(0, scenario.as_mut_ptr()), Status::Ok);
        let mut scenario = scenario.assume_init();
        assert_eq!(
            softanvil_scenario_set_by_name(&mut scenario, c"mesh.element_size".as_ptr(), 7e-3, null_mut()),
            Status::Ok
        );
        scenario
    }
}

fn size(scenario: &SoftanvilScenario) -> (usize, usize) {
    let (mut size, mut alignment) = (0, 0);
    // SAFETY: references are valid pointers.
    let status = unsafe { softanvil_memory_size(scenario, &mut size, &mut alignment, null_mut()) };
    assert_eq!(status, Status::Ok);
    (size, alignment)
}

fn build(block: &Block, scenario: &SoftanvilScenario) -> *mut SoftanvilSimulation {
    let mut simulation = null_mut();
    // SAFETY: the block is as long as its layout says.
    let status = unsafe { softanvil_init(block.pointer, block.layout.size(), scenario, &mut simulation, null_mut()) };
    assert_eq!(status, Status::Ok);
    simulation
}

#[test]
fn the_smallest_legal_block_gives_the_kernels_trace() {
    let scenario = coarse();
    let (size, alignment) = size(&scenario);
    let block = Block::new(size, alignment);
    let simulation = build(&block, &scenario);
    let mut hash = 0;
    // SAFETY: the simulation lives in the block.
    unsafe {
        assert_eq!(softanvil_run(simulation, DURATION, null(), null_mut()), Status::Ok);
        assert_eq!(softanvil_trace_hash(simulation, &mut hash), Status::Ok);
    }
    let mut kernel = preset::study();
    kernel.mesh.element_size = 7e-3;
    let mut kernel = Simulation::new(&kernel).unwrap();
    let steps = kernel.constants().steps_in(DURATION);
    kernel.step(steps, &StepInput::default()).unwrap();
    assert_eq!(hash, kernel.scalars().sampler.trace_hash);
}

#[test]
fn the_slices_of_time_do_not_matter() {
    let scenario = coarse();
    let (size, alignment) = size(&scenario);
    let (first, second) = (Block::new(size, alignment), Block::new(size, alignment));
    let (first, second) = (build(&first, &scenario), build(&second, &scenario));
    let (mut hashes, mut steps) = ([0; 2], 0);
    // SAFETY: the simulations live in their blocks.
    unsafe {
        assert_eq!(softanvil_run(first, DURATION, null(), null_mut()), Status::Ok);
        assert_eq!(softanvil_step_index(first, &mut steps), Status::Ok);
        for _ in 0..3 {
            assert_eq!(softanvil_step(second, 1, null(), null_mut()), Status::Ok);
        }
        for _ in 0..SAMPLES {
            assert_eq!(softanvil_step_to_sample(second, null(), null_mut()), Status::Ok);
        }
        assert_eq!(softanvil_trace_hash(first, &mut hashes[0]), Status::Ok);
        assert_eq!(softanvil_trace_hash(second, &mut hashes[1]), Status::Ok);
        let mut other = 0;
        assert_eq!(softanvil_step_index(second, &mut other), Status::Ok);
        assert_eq!(steps, other);
    }
    assert_eq!(hashes[0], hashes[1]);
}

#[test]
fn an_error_is_written_whole_and_a_success_leaves_it_alone() {
    let mut scenario = coarse();
    let mut error = MaybeUninit::<SoftanvilError>::uninit();
    // SAFETY: valid for writes; read only after a failure has written it.
    let error = unsafe {
        let status = softanvil_scenario_set(&mut scenario, MASS, f64::NAN, error.as_mut_ptr());
        assert_eq!(status, Status::IllegalValue);
        let before = error.assume_init();
        assert_eq!(softanvil_scenario_set(&mut scenario, MASS, 6.0, error.as_mut_ptr()), Status::Ok);
        let after = error.assume_init();
        assert_eq!(before.text, after.text);
        after
    };
    // SAFETY: the library ends it with a NUL.
    let text = unsafe { CStr::from_ptr(error.text.as_ptr()) }.to_str().unwrap();
    assert_eq!(text, "impactor.mass = NaN kg is refused: expected 0.001 to 10000 kg");
    assert_eq!((error.status, error.parameter, error.min, error.max), (200, MASS, 1e-3, 1e4));
    assert!(error.value.is_nan() && error.time.is_nan());
}

#[test]
fn every_row_of_the_tables_fits_and_is_found() {
    let mut numbers = Vec::new();
    for (place, parameter) in (0..softanvil_parameter_count()).zip(Parameter::all()) {
        let mut info = MaybeUninit::<SoftanvilParameterInfo>::uninit();
        let (mut id, mut found) = (u32::MAX, u32::MAX);
        // SAFETY: valid for writes; read after success.
        let info = unsafe {
            assert_eq!(softanvil_parameter_at(place, &mut id), Status::Ok);
            assert_eq!(softanvil_parameter_info(id, info.as_mut_ptr()), Status::Ok, "{}", parameter.name());
            assert_eq!(softanvil_parameter_find((*info.as_ptr()).name.as_ptr(), &mut found), Status::Ok);
            info.assume_init()
        };
        assert_eq!((found, info.id, (info.min, info.max)), (id, id, parameter.range()));
        assert_eq!(parameter.name(), text(&info.name));
        assert_eq!(text(&info.description), parameter.description());
        assert_eq!(text(&info.unit), parameter.unit());
        assert_eq!(info.choices as usize, parameter.labels().len());
        assert_eq!(info.is_whole == 1, parameter.kind() != Kind::Quantity);
        assert_eq!(info.layer, parameter.layer().map_or(u32::MAX, |layer| layer as u32));
        numbers.push(id);
    }
    assert_eq!(numbers.len(), Parameter::COUNT);
    let mut id = 0;
    // SAFETY: valid for writes.
    unsafe {
        assert_eq!(softanvil_parameter_at(softanvil_parameter_count(), &mut id), Status::UnknownId);
        for gap in (0..500).filter(|number| !numbers.contains(number)) {
            let status = softanvil_parameter_info(gap, MaybeUninit::uninit().as_mut_ptr());
            assert_eq!(status, Status::UnknownId, "{gap}");
        }
    }
    for id in 0..softanvil_output_count() {
        let Some(row) = OUTPUTS.iter().find(|row| row.id == id) else {
            // SAFETY: valid for writes.
            let status = unsafe { softanvil_output_info(id, MaybeUninit::uninit().as_mut_ptr()) };
            assert_eq!(status, Status::UnknownId, "the retired {id}");
            assert!(RETIRED_OUTPUTS.contains(&id));
            continue;
        };
        let mut info = MaybeUninit::<SoftanvilOutputInfo>::uninit();
        let mut found = u32::MAX;
        // SAFETY: valid for writes; read after success.
        let info = unsafe {
            assert_eq!(softanvil_output_info(id, info.as_mut_ptr()), Status::Ok, "{}", row.name);
            assert_eq!(softanvil_output_find((*info.as_ptr()).name.as_ptr(), &mut found), Status::Ok);
            info.assume_init()
        };
        assert_eq!((found, text(&info.description), text(&info.unit)), (id, row.description, row.unit));
    }
}

#[test]
fn numbers_of_rows_are_unique_and_none_is_retired() {
    fn check(ids: impl Iterator<Item = u32> + Clone, retired: &[u32]) {
        for (i, id) in ids.clone().enumerate() {
            assert!(ids.clone().take(i).all(|other| other != id) && !retired.contains(&id), "{id}");
        }
    }
    check(OUTPUTS.iter().map(|row| row.id), RETIRED_OUTPUTS);
    check(FIELDS.iter().map(|row| row.id), RETIRED_FIELDS);
    check(preset::PRESETS.iter().map(|row| row.id), preset::RETIRED);
}

/// The last number below a count is given or retired, and the count itself is not.
#[test]
fn counts_end_with_the_last_number() {
    fn check(count: u32, ids: &[u32], retired: &[u32]) {
        let is_given = |id: &u32| ids.contains(id) || retired.contains(id);
        assert!(is_given(&(count - 1)) && !is_given(&count));
        assert!(ids.iter().chain(retired).all(|id| *id < count));
    }
    check(softanvil_output_count(), &OUTPUTS.iter().map(|row| row.id).collect::<Vec<_>>(), RETIRED_OUTPUTS);
    check(softanvil_field_count(), &FIELDS.iter().map(|row| row.id).collect::<Vec<_>>(), RETIRED_FIELDS);
}

/// Three layers, said in any order and one of them by its number: the same simulation as the kernel's own.
#[test]
fn layers_are_said_by_number_or_name() {
    let mut scenario = coarse();
    let thickness = SOFTANVIL_LAYERS_BEGIN + SOFTANVIL_LAYER_NUMBERS * 2;
    let mut error = MaybeUninit::<SoftanvilError>::zeroed();
    // SAFETY: valid for writes; zeroed.
    unsafe {
        for (name, value) in [(c"layers[1].thickness", 2e-3), (c"layers[1].c10", 3e5), (c"layers.count", 3.0)] {
            assert_eq!(softanvil_scenario_set_by_name(&mut scenario, name.as_ptr(), value, null_mut()), Status::Ok);
        }
        let (mut size, mut alignment) = (0, 0);
        let status = softanvil_memory_size(&scenario, &mut size, &mut alignment, error.as_mut_ptr());
        assert_eq!((status, error.assume_init().parameter), (Status::LayerThickness, thickness));
        let refused = "layers[2].thickness = 0 m is refused: expected at least 0.00001 m";
        assert_eq!(text(&error.assume_init().text), refused);
        assert_eq!(softanvil_scenario_set(&mut scenario, thickness, 1e-3, null_mut()), Status::Ok);
    }
    let mut kernel = preset::study();
    kernel.mesh.element_size = 7e-3;
    kernel.set_layer_count(3);
    kernel.layers[1].thickness = 2e-3;
    kernel.layers[1].material = kernel.layers[1].material.with(NeoHookean { c10: 3e5 });
    kernel.layers[2].thickness = 1e-3;
    let mut own = Simulation::new(&kernel).unwrap();
    own.run(DURATION, &StepInput::default()).unwrap();
    let (size, alignment) = size(&scenario);
    let block = Block::new(size, alignment);
    let simulation = build(&block, &scenario);
    let mut hash = 0;
    // SAFETY: the simulation lives in its block.
    unsafe {
        assert_eq!(softanvil_run(simulation, DURATION, null(), null_mut()), Status::Ok);
        assert_eq!(softanvil_trace_hash(simulation, &mut hash), Status::Ok);
    }
    assert_eq!(hash, own.scalars().sampler.trace_hash);
}

fn text(characters: &[std::ffi::c_char]) -> &str {
    // SAFETY: the library ends every text with a NUL inside its array, which the slice covers.
    unsafe { CStr::from_ptr(characters.as_ptr()) }.to_str().unwrap()
}

/// A refusal by several parameters tells value and range as that of one does.
#[test]
fn an_offset_in_half_a_section_is_told_with_its_range() {
    let mut scenario = coarse();
    scenario.value[Parameter::find("impactor.offset").unwrap().number() as usize] = 0.01;
    let (mut size, mut alignment) = (0, 0);
    let mut error = MaybeUninit::<SoftanvilError>::zeroed();
    // SAFETY: the arguments are initialised and outlive the call; a failure fills the error, which zeros are a value of.
    unsafe {
        let status = softanvil_memory_size(&scenario, &mut size, &mut alignment, error.as_mut_ptr());
        assert_eq!(status, Status::OffsetOfHalf);
        let error = error.assume_init();
        assert_eq!([error.value, error.min, error.max], [0.01, 0.0, 0.0]);
    }
}

#[test]
fn a_wrong_marker_is_refused_and_a_moved_block_is_not() {
    let scenario = coarse();
    let (size, alignment) = size(&scenario);
    let (block, other) = (Block::new(size, alignment), Block::new(size, alignment));
    let simulation = build(&block, &scenario);
    let mut time = -1.0;
    // SAFETY: both blocks have `size` bytes; the first is initialised.
    unsafe {
        std::ptr::write_bytes(other.pointer.cast::<u8>(), 0, size);
        assert_eq!(softanvil_time(other.pointer.cast(), &mut time), Status::Uninitialised);
        assert_eq!(time, -1.0);
        std::ptr::copy_nonoverlapping(simulation.cast::<u8>(), other.pointer.cast(), size);
        std::ptr::write_bytes(block.pointer.cast::<u8>(), 0xFF, size);
        assert_eq!(softanvil_step(other.pointer.cast(), 5, null(), null_mut()), Status::Ok);
        assert_eq!(softanvil_close(other.pointer.cast()), Status::Ok);
        assert_eq!(softanvil_time(other.pointer.cast(), &mut time), Status::Uninitialised);
    }
}

#[test]
fn a_snapshot_of_exactly_its_size_is_enough_and_one_byte_less_is_not() {
    let scenario = coarse();
    let (bytes, alignment) = size(&scenario);
    let block = Block::new(bytes, alignment);
    let simulation = build(&block, &scenario);
    let mut size = 0;
    // SAFETY: the simulation lives in the block, the vector has `size` bytes.
    unsafe {
        assert_eq!(softanvil_snapshot_size(simulation, &mut size), Status::Ok);
        let mut snapshot = vec![0_u8; size];
        assert_eq!(
            softanvil_snapshot_save(simulation, snapshot.as_mut_ptr(), size - 1, null_mut()),
            Status::ShortBuffer
        );
        assert!(snapshot.iter().all(|byte| *byte == 0));
        assert_eq!(softanvil_snapshot_save(simulation, snapshot.as_mut_ptr(), size, null_mut()), Status::Ok);
        assert_eq!(
            softanvil_snapshot_restore(simulation, snapshot.as_ptr(), size - 1, null_mut()),
            Status::ShortBuffer
        );
        assert_eq!(softanvil_snapshot_restore(simulation, snapshot.as_ptr(), size, null_mut()), Status::Ok);
    }
}

#[test]
fn versions_and_texts_are_those_of_the_package() {
    let [major, minor, patch] =
        [env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR"), env!("CARGO_PKG_VERSION_PATCH")]
            .map(|part| part.parse::<u32>().unwrap());
    assert_eq!(softanvil_kernel_digest(), softanvil_kernel::KERNEL_DIGEST);
    assert_eq!(softanvil_version(), major * 1_000_000 + minor * 1_000 + patch);
    // SAFETY: static strings.
    unsafe {
        assert_eq!(CStr::from_ptr(softanvil_version_text()).to_str(), Ok(env!("CARGO_PKG_VERSION")));
        assert_eq!(CStr::from_ptr(softanvil_status_text(0)), c"done");
        assert_eq!(CStr::from_ptr(softanvil_status_text(-1)), c"unknown status");
    }
}

/// What a trace has seen: calls, and displacement of the top of the centre line from the view and from a copy, m.
#[derive(Default)]
struct Seen {
    calls: usize,
    top: Vec<[f64; 2]>,
}

unsafe extern "C" fn watch(simulation: *const SoftanvilSimulation, context: *mut c_void) -> i32 {
    let mut view = MaybeUninit::<SoftanvilView>::uninit();
    // SAFETY: the context is what the test handed over; the view is read after success and shows live memory.
    unsafe {
        let seen = &mut *context.cast::<Seen>();
        assert_eq!(softanvil_field_view(simulation, 2, 1, view.as_mut_ptr()), Status::Ok);
        let view = view.assume_init();
        let (top, count) = ((view.rows - 1) * view.columns, view.rows * view.columns);
        let mut copy = vec![f64::NAN; 3 * count];
        let status = softanvil_field_read(simulation, 2, 1, copy.as_mut_ptr().add(1), copy.len() - 1, 3, null_mut());
        assert_eq!(status, Status::Ok);
        assert!((0..count).all(|i| copy[3 * i].is_nan() && copy[3 * i + 2].is_nan() && !copy[3 * i + 1].is_nan()));
        seen.top.push([*view.data.add((view.rows - 1) * view.row_stride), copy[3 * top + 1]]);
        seen.calls += 1;
    }
    i32::from(context.is_null())
}

#[test]
fn a_trace_sees_every_sample_and_reads_the_fields() {
    let mut scenario = coarse();
    // Without the gap, so that the very first samples show contact.
    scenario.value[10] = 0.0;
    let (size, alignment) = size(&scenario);
    let block = Block::new(size, alignment);
    let simulation = build(&block, &scenario);
    let mut seen = Seen::default();
    // SAFETY: the simulation lives in the block; the context outlives the call.
    let status =
        unsafe { softanvil_run_traced(simulation, DURATION, null(), Some(watch), (&raw mut seen).cast(), null_mut()) };
    assert_eq!((status, seen.calls), (Status::Ok, SAMPLES));
    assert!(seen.top.iter().all(|[view, copy]| view == copy && *view < 0.0), "{:?}", seen.top);
}
