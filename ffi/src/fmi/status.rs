//! The status that every function of both versions returns.

use core::ffi::c_int;

/// `fmi2Status` and `fmi3Status`, whose numbers agree.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Status(c_int);

impl Status {
    /// All well.
    pub const OK: Self = Self(0);
    /// Done, with a remark.
    pub const WARNING: Self = Self(1);
    /// Nothing was done, and the master may try otherwise; or there is no answer.
    pub const DISCARD: Self = Self(2);
    /// Refused, or a step that could not be completed.
    pub const ERROR: Self = Self(3);
}
