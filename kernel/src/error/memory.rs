//! Too little memory.

use core::fmt;

/// The memory given is smaller than [`crate::model::Size`] says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryError {
    /// What the memory is for.
    pub what: &'static str,
    /// Items given.
    pub given: usize,
    /// Items needed.
    pub needed: usize,
}

impl fmt::Display for MemoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, given, needed } = self;
        write!(f, "memory for {what} holds {given} items: legal is at least {needed}")
    }
}

impl core::error::Error for MemoryError {}
