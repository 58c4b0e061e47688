//! [`Component`]: an instance together with its log, and the frame of every call on it.

use core::ffi::CStr;

use super::log::Log;
use super::types::{self, Status};
use crate::environment::neutral;
use crate::instance::{Error, Function, HASH_DIGITS, Instance};

/// What `fmi2Component` points to.
pub struct Component {
    /// The simulation.
    pub instance: Instance,
    /// The way to the master's logger.
    pub log: Log,
    /// The trace hash that was read last, with its final zero: the master reads it until the next call.
    pub trace_hash: [u8; HASH_DIGITS + 1],
}

impl Component {
    /// A new instance of the preset.
    pub fn new(log: Log) -> Self {
        Self { instance: Instance::new(), log, trace_hash: [0; HASH_DIGITS + 1] }
    }

    /// Keeps the digits of a trace hash and gives out the text.
    pub fn keep_text(&mut self, digits: [u8; HASH_DIGITS]) -> &CStr {
        self.trace_hash.iter_mut().zip(digits).for_each(|(to, from)| *to = from);
        CStr::from_bytes_until_nul(&self.trace_hash).unwrap_or_default()
    }
}

/// Runs the body of `function` on a component, in the default floating-point environment; logs why it was refused.
pub fn enter(
    component: &mut types::Component,
    function: &Function,
    body: impl FnOnce(&mut Component) -> Result<(), Error>,
) -> Status {
    let Some(component) = component.get() else { return Status::ERROR };
    match neutral(|| component.instance.check_call(function).and_then(|()| body(component))) {
        Ok(()) => Status::OK,
        Err(error) => {
            component.log.error(function.name, &error);
            Status::ERROR
        }
    }
}
