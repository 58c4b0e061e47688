//! Saving and restoring a state as bytes that mean the same on every target.
//!
//! Format: little-endian 64-bit words. Header: magic, format version, fingerprint of the model, number of words that
//! follow before the checksum; then the scalars (those of softening where a layer softens) and the arrays in the order of `visit`; last the FNV-1a digest of
//! everything before it. Equal states give equal bytes. A number of single precision is a word whose upper half is zero;
//! the fingerprints of the two precisions differ, so neither takes over a state of the other.

use crate::element::TriangleHistory;
use crate::error::SnapshotError;
use crate::model::{Constants, Model};
use crate::number::digest::Digest;
use crate::number::pack::{LANES, Pack};
use crate::number::real::{self, Real};
use crate::state::{ENERGY_WORDS, SOFTENING_WORDS, Scalars, State, StateView};
use crate::tensor::deviator::Deviator;

/// "SOFTANVL" in ASCII, least significant byte first.
const MAGIC: u64 = u64::from_le_bytes(*b"SOFTANVL");
/// Changes with the format. A snapshot of another version is refused, and the error names both.
const VERSION: u64 = 6;
const HEADER_WORDS: usize = 4;
const CHECKSUM_WORDS: usize = 1;
/// Words of the scalars that are whole numbers.
const COUNTERS: usize = 7;
/// Most steps that a state may have behind it: far from overflow, and every count is exact as a float of double
/// precision.
const MAX_STEPS: u64 = 1 << 53;
const SCALAR_WORDS: usize = COUNTERS + 21 + ENERGY_WORDS;
/// Lanes per triangle: stretch, elastic stress, slider stress, largest stretch, stored energy.
const HISTORY_LANES: usize = 4 + 3 + 3 + 1 + 1;

/// Bytes of a snapshot of a state of this model.
pub fn snapshot_size(constants: &Constants) -> usize {
    8 * (HEADER_WORDS + payload_words(constants) + CHECKSUM_WORDS)
}

fn payload_words(constants: &Constants) -> usize {
    let size = &constants.size;
    let softening = if constants.softens() { SOFTENING_WORDS } else { 0 };
    let rails = usize::from(constants.scenario.impactor.has_rails());
    SCALAR_WORDS
        + softening
        + rails
        + size.state_nodes
        + size.state_cells * 2 * HISTORY_LANES * LANES
        + size.state_viscous * 3 * LANES
}

/// Writes `state` into `bytes`, which has exactly [`snapshot_size`].
///
/// # Errors
/// A wrong length, or a state that has failed. Nothing is written then.
pub fn save(model: &Model, state: &State, bytes: &mut [u8]) -> Result<(), SnapshotError> {
    check_length(model, bytes.len())?;
    let (words, _) = bytes.as_chunks_mut::<8>();
    let mut words = words.iter_mut();
    write_words(model, &state.as_view(), &mut |word| {
        if let Some(chunk) = words.next() {
            *chunk = word.to_le_bytes();
        }
    })
}

/// Hands a snapshot of `state` to `put`, word by word, for memory that is no slice of bytes, and of a state that others may
/// read at the same time. The words make [`snapshot_size`] bytes, each with its least significant byte first.
///
/// # Errors
/// A state that has failed. Nothing is handed out then.
pub fn write_words(model: &Model, state: &StateView, put: &mut dyn FnMut(u64)) -> Result<(), SnapshotError> {
    if state.scalars.failure.is_some() {
        return Err(SnapshotError::Failed);
    }
    let payload = payload_words(model.constants) as u64;
    let mut digest = Digest::new();
    let mut put_and_digest = |word: u64| {
        digest.word(word);
        put(word);
    };
    [MAGIC, VERSION, model.constants.fingerprint, payload].into_iter().for_each(&mut put_and_digest);
    read(model, state, &mut put_and_digest);
    put(digest.value());
    Ok(())
}

/// Restores `state` from `bytes` that [`save`] wrote for the same model, on whatever target.
///
/// # Errors
/// Bytes that are not such a snapshot; the state is not touched then.
pub fn restore(model: &Model, state: &mut State, bytes: &[u8]) -> Result<(), SnapshotError> {
    check_version(bytes)?;
    check_length(model, bytes.len())?;
    check_content(model, bytes)?;
    let mut words = bytes.chunks_exact(8).skip(HEADER_WORDS).map(word_of);
    visit(model, state, &mut |word| {
        if let Some(saved) = words.next() {
            *word = saved;
        }
    });
    state.scalars.failure = None;
    Ok(())
}

/// Before the length, which is another one in other versions.
fn check_version(bytes: &[u8]) -> Result<(), SnapshotError> {
    let mut words = bytes.chunks_exact(8).map(word_of);
    match (words.next(), words.next()) {
        (Some(MAGIC), Some(given)) if given != VERSION => Err(SnapshotError::Version { given, expected: VERSION }),
        _ => Ok(()),
    }
}

fn check_length(model: &Model, given: usize) -> Result<(), SnapshotError> {
    let needed = snapshot_size(model.constants);
    if given == needed { Ok(()) } else { Err(SnapshotError::Length { given, needed }) }
}

fn check_content(model: &Model, bytes: &[u8]) -> Result<(), SnapshotError> {
    let mut words = bytes.chunks_exact(8).map(word_of);
    let header: [u64; HEADER_WORDS] = core::array::from_fn(|_| words.next().unwrap_or_default());
    let payload = payload_words(model.constants);
    if header[0] != MAGIC || header[3] != payload as u64 {
        return Err(SnapshotError::Format);
    }
    if header[2] != model.constants.fingerprint {
        return Err(SnapshotError::Foreign);
    }
    let counters: [u64; COUNTERS] = core::array::from_fn(|_| words.next().unwrap_or_default());
    let mut digest = Digest::new();
    header.into_iter().chain(counters).for_each(|word| digest.word(word));
    (&mut words).take(payload - COUNTERS).for_each(|word| digest.word(word));
    let whole = words.next() == Some(digest.value());
    if whole && counters_fit(model.constants, counters) { Ok(()) } else { Err(SnapshotError::Corrupt) }
}

/// Whether the counters at the front of the scalars can belong to one state. A checksum that fits is no proof: counters
/// that contradict each other would overflow in later steps.
fn counters_fit(constants: &Constants, counters: [u64; COUNTERS]) -> bool {
    let [step_index, sample, _, steps, first_sample, last_sample, first_step] = counters;
    let period = u64::from(constants.steps_per_sample);
    let whole = sample.checked_mul(period).and_then(|made| made.checked_add(steps)) == Some(step_index);
    whole
        && step_index <= MAX_STEPS
        && steps < period
        && first_sample <= last_sample
        && last_sample <= sample
        && first_step <= step_index
}

fn word_of(chunk: &[u8]) -> u64 {
    chunk.first_chunk::<8>().map_or(0, |bytes| u64::from_le_bytes(*bytes))
}

/// Digest of everything that a snapshot holds.
pub fn state_digest(model: &Model, state: &State) -> u64 {
    let mut digest = Digest::new();
    read(model, &state.as_view(), &mut |word| digest.word(word));
    digest.value()
}

/// Shows every word of the state to `f`, in the order of [`visit`], of which it changes only copies.
fn read(model: &Model, state: &StateView, f: &mut dyn FnMut(u64)) {
    let mut scalars = *state.scalars;
    visit_scalars(model, &mut scalars, &mut |word| f(*word));
    let mut nodes = state.nodes;
    for number in nodes.all().into_iter().flat_map(|row| *row) {
        f(real::to_word(*number));
    }
    for triangle in state.cells.iter().flat_map(|cell| &cell.triangle) {
        let mut triangle = *triangle;
        visit_triangle(&mut triangle, &mut |number| f(real::to_word(*number)));
    }
    for stress in state.viscous {
        let mut stress = *stress;
        visit_deviator(&mut stress, &mut |number| f(real::to_word(*number)));
    }
}

/// Shows every word of the state to `f`, always in the same order, and takes back what `f` makes of it.
fn visit(model: &Model, state: &mut State, f: &mut dyn FnMut(&mut u64)) {
    visit_scalars(model, state.scalars, f);
    let mut number = |value: &mut Real| {
        let mut bits = real::to_word(*value);
        f(&mut bits);
        *value = real::from_word(bits);
    };
    for row in state.nodes.all() {
        row.iter_mut().for_each(&mut number);
    }
    for triangle in state.cells.iter_mut().flat_map(|cell| &mut cell.triangle) {
        visit_triangle(triangle, &mut number);
    }
    for stress in state.viscous.iter_mut() {
        visit_deviator(stress, &mut number);
    }
}

fn visit_triangle(triangle: &mut TriangleHistory, number: &mut dyn FnMut(&mut Real)) {
    for lane in &mut triangle.stretch_prev {
        visit_lane(lane, number);
    }
    visit_deviator(&mut triangle.elastic_prev, number);
    visit_deviator(&mut triangle.slider_stress, number);
    visit_lane(&mut triangle.largest_stretch, number);
    visit_lane(&mut triangle.stored_prev, number);
}

fn visit_deviator(deviator: &mut Deviator, number: &mut dyn FnMut(&mut Real)) {
    for lane in [&mut deviator.mean, &mut deviator.difference, &mut deviator.shear] {
        visit_lane(lane, number);
    }
}

/// Behind a call: unrolled for every lane of a triangle, a board's flash would hold 30 kB of this.
#[inline(never)]
fn visit_lane(lane: &mut Pack, number: &mut dyn FnMut(&mut Real)) {
    lane.iter_mut().for_each(number);
}

fn visit_scalars(model: &Model, scalars: &mut Scalars, f: &mut dyn FnMut(&mut u64)) {
    let Scalars { step_index, impactor, force, contact_half_width, sampler, metrics, energy, failure: _ } = scalars;
    let mut steps = u64::from(sampler.steps);
    for word in [
        step_index,
        &mut sampler.last.number,
        &mut sampler.trace_hash,
        &mut steps,
        &mut metrics.first_sample,
        &mut metrics.last_sample,
        &mut metrics.first_step,
    ] {
        f(word);
    }
    sampler.steps = steps as u32;
    let [[x_1, x_2], [y_1, y_2]] = [&mut sampler.filter.x, &mut sampler.filter.y];
    let numbers = [
        &mut impactor.position,
        &mut impactor.velocity,
        &mut impactor.velocity_half,
        &mut impactor.acceleration,
        &mut force.contact,
        &mut force.core_reaction,
        contact_half_width,
        &mut sampler.last.contact_force,
        &mut sampler.last.core_reaction,
        &mut sampler.sum.contact,
        &mut sampler.sum.core_reaction,
        x_1,
        x_2,
        y_1,
        y_2,
        &mut metrics.peak_force,
        &mut metrics.max_deformation,
        &mut metrics.impulse,
        &mut metrics.impact_speed,
        &mut metrics.rebound_speed,
        &mut metrics.contact_time,
    ];
    let mut visit_number = |number: &mut Real| {
        let mut bits = real::to_word(*number);
        f(&mut bits);
        *number = real::from_word(bits);
    };
    numbers.into_iter().chain(energy.words_mut()).for_each(&mut visit_number);
    if model.constants.softens() {
        energy.softening_words_mut().into_iter().for_each(&mut visit_number);
    }
    if model.constants.scenario.impactor.has_rails() {
        visit_number(&mut energy.guide);
    }
}
