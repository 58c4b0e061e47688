//! Saved states: bytes without pointers that mean the same on every platform.
//!
//! Format: little-endian 64-bit words. Magic, format version, digest of the variable table, length of the whole in
//! bytes; mode, start, whether there is a stop, stop, communication point, by how much it is ahead of the kernel, number and
//! start of the impact, whether the next one had been asked for, points of the profiles; the inputs, and 1 or 0 for whether the
//! master gives a position, and a velocity, and asks for the next impact; the parameters in the order
//! of the kernel's tables, those of all layers that there can be; the kernel's own snapshot, which is empty before the first step can be made; last the FNV-1a digest
//! of everything before.

use alloc::vec::Vec;

use softanvil_kernel::number::digest::Digest;
use softanvil_kernel::parameter::Values;
use softanvil_kernel::state::{restore, save, snapshot_size};
use softanvil_kernel::{Parameter, SAMPLING_INTERVAL, Scenario, Simulation, SnapshotError, preset};

use super::clock::Clock;
use super::impact::Impact;
use super::{Error, Experiment, Instance, Mode, memory};
use crate::variables::profile::POINTS;
use crate::variables::{INPUTS, Inputs, Version, same_bits};

/// "SOFTAFMU" in ASCII, least significant byte first.
const MAGIC: u64 = u64::from_le_bytes(*b"SOFTAFMU");
/// Changes with the format. A state of another version is refused, and the error names both.
const VERSION: u64 = 7;

/// A saved state, checked to be whole and of this version.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SavedState(Vec<u8>);

/// What a saved state says besides the kernel's snapshot.
struct Content<'a> {
    mode: Mode,
    experiment: Experiment,
    clock: Clock,
    impact: Impact,
    points: u64,
    inputs: Inputs,
    values: Values,
    snapshot: &'a [u8],
}

impl SavedState {
    /// The bytes, which any process on any platform can read back.
    pub fn bytes(&self) -> &[u8] {
        &self.0
    }

    fn content(&self) -> Result<Content<'_>, Error> {
        let corrupt = Error::Snapshot(SnapshotError::Corrupt);
        let (header, mut rest) = self.0.split_at_checked(8 * HEADER_WORDS).ok_or(corrupt)?;
        let mut words = header.chunks_exact(8).map(word).skip(4);
        let mut next = || words.next().unwrap_or_default();
        let mode = Mode::from_code(next()).ok_or(corrupt)?;
        let (start, has_stop, stop) = (f64::from_bits(next()), next() != 0, f64::from_bits(next()));
        let experiment = Experiment { start, stop: has_stop.then_some(stop) };
        let clock = Clock { point: f64::from_bits(next()), ahead: f64::from_bits(next()) };
        let number = u32::try_from(next()).ok().filter(|number| *number > 0).ok_or(corrupt)?;
        let impact = Impact { number, start: f64::from_bits(next()), asked: next() != 0 };
        let points = next();
        let (inputs, values) = (read_inputs(&mut rest)?, read_values(&mut rest)?);
        let snapshot = rest.len().checked_sub(8).and_then(|end| rest.get(..end)).ok_or(corrupt)?;
        let is_stepping = matches!(mode, Mode::Step | Mode::Event | Mode::Terminated);
        // A clock is at most a kernel step away from the kernel, and no kernel step is longer than a sampling interval.
        let has_clock = [start, clock.point, impact.start].into_iter().all(f64::is_finite)
            && clock.ahead.abs() <= SAMPLING_INTERVAL;
        if snapshot.is_empty() == is_stepping || !has_clock || points < POINTS.0 || points > POINTS.1 {
            return Err(corrupt);
        }
        Ok(Content { mode, experiment, clock, impact, points, inputs, values, snapshot })
    }
}

/// Words before the inputs.
const HEADER_WORDS: usize = 14;
/// Words that say which inputs the master gives, and what he asks for.
const GIVEN: usize = 3;

/// The header's words, if the bytes claim to be of this format and of their length.
fn header(bytes: &[u8]) -> Result<[u64; 4], SnapshotError> {
    let header: [u64; 4] = core::array::from_fn(|i| bytes.get(8 * i..8 * i + 8).map_or(0, word));
    let whole = bytes.len().is_multiple_of(8) && header[3] == bytes.len() as u64;
    match header {
        [MAGIC, given, ..] if whole && given != VERSION => Err(SnapshotError::Version { given, expected: VERSION }),
        [MAGIC, ..] if whole => Ok(header),
        _ => Err(SnapshotError::Format),
    }
}

/// An empty list with room for `length` bytes.
fn room(length: usize) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(length).map_err(|_| Error::NoMemory { bytes: length })?;
    Ok(bytes)
}

fn word(chunk: &[u8]) -> u64 {
    chunk.first_chunk::<8>().map_or(0, |bytes| u64::from_le_bytes(*bytes))
}

fn digest_of(bytes: &[u8]) -> u64 {
    let mut digest = Digest::new();
    bytes.chunks_exact(8).for_each(|chunk| digest.word(word(chunk)));
    digest.value()
}

/// Takes one number off the front.
fn read_number(rest: &mut &[u8]) -> Result<f64, Error> {
    let (head, tail) = rest.split_at_checked(8).ok_or(Error::Snapshot(SnapshotError::Corrupt))?;
    *rest = tail;
    Ok(f64::from_bits(word(head)))
}

fn read_inputs(rest: &mut &[u8]) -> Result<Inputs, Error> {
    let mut inputs = Inputs::start();
    for input in INPUTS {
        input.set(&mut inputs, read_number(rest)?)?;
    }
    inputs.has_position = read_number(rest)? != 0.0;
    inputs.has_velocity = read_number(rest)? != 0.0;
    inputs.next_impact = read_number(rest)? != 0.0;
    Ok(inputs)
}

fn read_values(rest: &mut &[u8]) -> Result<Values, Error> {
    let mut values = Values::of(&preset::study());
    for parameter in Parameter::all() {
        values.set(parameter, read_number(rest)?)?;
    }
    Ok(values)
}

impl Instance {
    /// The state, to go back to later.
    ///
    /// # Errors
    /// A state that has failed, or no memory.
    pub fn save(&mut self) -> Result<SavedState, Error> {
        let snapshot = self.snapshot()?;
        let Experiment { start, stop } = self.experiment;
        let words = HEADER_WORDS + INPUTS.len() + GIVEN + Parameter::COUNT + 1;
        let length = 8 * words + snapshot.len();
        let mut bytes = room(length)?;
        let mut put = |word: u64| bytes.extend_from_slice(&word.to_le_bytes());
        [MAGIC, VERSION, self.table.digest(), length as u64].into_iter().for_each(&mut put);
        put(self.mode as u64);
        [start.to_bits(), u64::from(stop.is_some()), stop.unwrap_or_default().to_bits()].into_iter().for_each(&mut put);
        [self.clock.point.to_bits(), self.clock.ahead.to_bits()].into_iter().for_each(&mut put);
        let Impact { number, start, asked } = self.impact;
        [u64::from(number), start.to_bits(), u64::from(asked), self.points].into_iter().for_each(&mut put);
        INPUTS.iter().for_each(|input| put((input.field)(&mut self.inputs).to_bits()));
        let Inputs { has_position, has_velocity, next_impact, .. } = self.inputs;
        let given: [bool; GIVEN] = [has_position, has_velocity, next_impact];
        given.into_iter().for_each(|given| put(f64::from(u8::from(given)).to_bits()));
        Parameter::all().for_each(|parameter| put(self.values.get(parameter).to_bits()));
        bytes.extend_from_slice(&snapshot);
        let checksum = digest_of(&bytes);
        bytes.extend_from_slice(&checksum.to_le_bytes());
        Ok(SavedState(bytes))
    }

    /// The kernel's part; empty before the first step can be made.
    fn snapshot(&mut self) -> Result<Vec<u8>, Error> {
        if self.simulation_at_work().is_none() {
            return Ok(Vec::new());
        }
        let Some(simulation) = &mut self.simulation else { return Ok(Vec::new()) };
        let length = snapshot_size(simulation.constants());
        let mut bytes = room(length)?;
        bytes.resize(length, 0);
        simulation.with(|model, state| save(model, state, &mut bytes)).map_err(memory)?.map_err(Error::Snapshot)?;
        Ok(bytes)
    }

    /// Reads back the bytes of a saved state.
    ///
    /// # Errors
    /// Bytes that are no saved state, of another version, cut short or altered; or no memory.
    pub fn read_state(&self, bytes: &[u8]) -> Result<SavedState, Error> {
        let header = header(bytes).map_err(Error::Snapshot)?;
        if header[2] != self.table.digest() {
            return Err(Error::Snapshot(SnapshotError::Foreign));
        }
        let corrupt = Error::Snapshot(SnapshotError::Corrupt);
        let (content, checksum) = bytes.split_last_chunk::<8>().ok_or(corrupt)?;
        if u64::from_le_bytes(*checksum) != digest_of(content) {
            return Err(corrupt);
        }
        let mut copy = room(bytes.len())?;
        copy.extend_from_slice(bytes);
        let state = SavedState(copy);
        state.content()?;
        Ok(state)
    }

    /// Goes back to a saved state, also one of another instance or process.
    ///
    /// # Errors
    /// A state that does not fit together; the instance is as before.
    pub fn restore(&mut self, state: &SavedState) -> Result<(), Error> {
        let content = state.content()?;
        self.check_mode(content.mode)?;
        if !content.snapshot.is_empty() {
            self.restore_simulation(&content.values.scenario(), content.snapshot)?;
        }
        self.mode = content.mode;
        self.experiment = content.experiment;
        self.clock = content.clock;
        self.impact = content.impact;
        self.points = content.points;
        self.inputs = content.inputs;
        self.values = content.values;
        Ok(())
    }

    /// Refuses a state in a mode that this instance cannot be in.
    fn check_mode(&self, mode: Mode) -> Result<(), Error> {
        let is_possible = match mode {
            Mode::Event => self.event_mode_used,
            Mode::Configuration => self.version == Version::Fmi3,
            _ => true,
        };
        if is_possible { Ok(()) } else { Err(Error::Snapshot(SnapshotError::Foreign)) }
    }

    /// Restores into the model at hand if it is the right one, else into a new one.
    fn restore_simulation(&mut self, scenario: &Scenario, snapshot: &[u8]) -> Result<(), Error> {
        self.is_fresh = false;
        let fill = |simulation: &mut Simulation| {
            simulation.with(|model, state| restore(model, state, snapshot)).map_err(memory)?.map_err(Error::Snapshot)
        };
        match &mut self.simulation {
            Some(simulation) if same_bits(&simulation.constants().scenario, scenario) => fill(simulation),
            other => {
                let mut simulation = Simulation::new(scenario).map_err(Error::Model)?;
                fill(&mut simulation)?;
                *other = Some(simulation);
                Ok(())
            }
        }
    }
}

#[cfg(test)]
mod tests;
