//! [`Session`]: an instance together with its log, which is what the handles of both FMI versions point to, and the frame
//! of every call on it.

use core::ffi::CStr;

use crate::environment::neutral;
use crate::fmi::foreign::{Array, Handle, Room, Slot, Text};
use crate::fmi::log::{Category, Log};
use crate::fmi::status::Status;
use crate::fmi::updates::IntermediateUpdates;
use crate::instance::{Error, Function, HASH_DIGITS, Instance, SavedState};
use crate::variables::Version;

/// What `fmi2Component` and `fmi3Instance` point to.
pub struct Session {
    /// The simulation.
    pub instance: Instance,
    /// The way to the master's logger.
    pub log: Log,
    /// The trace hash that was read last, with its final zero: the master reads it until the next call.
    trace_hash: [u8; HASH_DIGITS + 1],
    /// Whether a step may end before its end (FMI 3.0).
    pub early_return_allowed: bool,
    /// Whom to show intermediate states (FMI 3.0).
    pub updates: IntermediateUpdates,
}

impl Session {
    /// A session of `instance`.
    pub fn new(instance: Instance, log: Log) -> Self {
        let updates = IntermediateUpdates { call: None, environment: core::ptr::null_mut() };
        Self { instance, log, trace_hash: [0; HASH_DIGITS + 1], early_return_allowed: false, updates }
    }

    /// Keeps the digits of a trace hash and gives out the text.
    pub fn keep_text(&mut self, digits: [u8; HASH_DIGITS]) -> &CStr {
        self.trace_hash.iter_mut().zip(digits).for_each(|(to, from)| *to = from);
        CStr::from_bytes_until_nul(&self.trace_hash).unwrap_or_default()
    }

    /// Switches the categories that are named, or all if there are none.
    pub fn switch_log(&mut self, on: bool, n_categories: usize, categories: &Array<Text>) -> Result<(), Error> {
        let names = categories.items(n_categories).ok_or(Error::Null { argument: "categories" })?;
        let mut chosen = if names.is_empty() { Category::ALL.bits } else { 0 };
        for (index, name) in names.iter().enumerate() {
            let name = name.get().ok_or(Error::Null { argument: "categories" })?;
            let unknown = Error::Argument { argument: "the name of category", value: index as i64 };
            chosen |= Category::find(name).ok_or(unknown)?.bits;
        }
        self.log.switch(on, chosen);
        Ok(())
    }

    /// Builds the model.
    pub fn exit_initialization(&mut self) -> Result<(), Error> {
        let changes = self.instance.exit_initialization()?;
        for no_effect in changes.without_effect(&self.instance.values().scenario()) {
            self.log.warning(&no_effect);
        }
        self.log.event(&self.instance.summary());
        Ok(())
    }

    /// Ends the simulation.
    pub fn terminate(&mut self) {
        if self.instance.is_cut_off() {
            self.log.warning(&"terminated in contact: the results are those so far, and result.complete is 0");
        }
        self.instance.terminate();
        self.log.event(&"terminated");
    }

    /// Back to a new instance.
    pub fn reset(&mut self) {
        self.instance.reset();
        self.log.event(&"reset");
    }
}

const NO_SLOT: Error = Error::Null { argument: "FMUState" };
const NO_HANDLE: Error = Error::NoMemory { bytes: size_of::<SavedState>() };
const NO_BYTES: Error = Error::Null { argument: "serializedState" };

/// Saves the state, into the handle that is given if it is not null.
pub fn save(session: &mut Session, mut slot: Slot<SavedState>) -> Result<(), Error> {
    let handle = slot.get().ok_or(NO_SLOT)?;
    handle.put(session.instance.save()?).ok_or(NO_HANDLE)
}

/// Goes back to a saved state.
pub fn restore(session: &mut Session, mut state: Handle<SavedState>) -> Result<(), Error> {
    session.instance.restore(state.get().ok_or(NO_SLOT)?)
}

/// Frees a saved state; null is fine.
pub fn free_state(mut slot: Slot<SavedState>) {
    if let Some(handle) = slot.get() {
        handle.free();
    }
}

/// Bytes of a saved state.
pub fn serialized_size(mut state: Handle<SavedState>, mut size: Room<usize>) -> Result<(), Error> {
    let state = state.get().ok_or(NO_SLOT)?;
    size.item().ok_or(Error::Null { argument: "size" })?.write(state.bytes().len());
    Ok(())
}

/// Writes a saved state as bytes.
pub fn serialize(mut state: Handle<SavedState>, mut to: Room<u8>, size: usize) -> Result<(), Error> {
    let bytes = state.get().ok_or(NO_SLOT)?.bytes();
    if size != bytes.len() {
        return Err(Error::StateSize { given: size, needed: bytes.len() });
    }
    let room = to.items(size).ok_or(NO_BYTES)?;
    for (to, from) in room.iter_mut().zip(bytes) {
        to.write(*from);
    }
    Ok(())
}

/// Reads back a saved state, into the handle that is given if it is not null.
pub fn deserialize(
    session: &mut Session,
    from: Array<u8>,
    size: usize,
    mut slot: Slot<SavedState>,
) -> Result<(), Error> {
    let bytes = from.items(size).ok_or(NO_BYTES)?;
    let handle = slot.get().ok_or(NO_SLOT)?;
    handle.put(session.instance.read_state(bytes)?).ok_or(NO_HANDLE)
}

/// Runs the body of `function` on a session, in the default floating-point environment; logs why it was refused.
pub fn enter(
    handle: &mut Handle<Session>,
    function: &Function,
    body: impl FnOnce(&mut Session) -> Result<(), Error>,
) -> Status {
    let Some(session) = handle.get() else { return Status::ERROR };
    match neutral(|| session.instance.check_call(function).and_then(|()| body(session))) {
        Ok(()) => Status::OK,
        Err(error) if is_discarded(session, &error) => {
            session.log.discard(function.name, &error);
            Status::DISCARD
        }
        Err(error) => {
            session.log.error(function.name, &error);
            Status::ERROR
        }
    }
}

/// Whether the master may go on after `error`: in FMI 3.0, where a call is discarded that leaves the state as before, a
/// step that another point or size would make legal. Not one past the stop time, for which both versions ask for an error;
/// and in FMI 2.0 none, where a discarded step is one of which a part was computed.
fn is_discarded(session: &Session, error: &Error) -> bool {
    let is_step = matches!(error, Error::CommunicationPoint { .. } | Error::StepSize { .. });
    is_step && session.instance.version() == Version::Fmi3
}
