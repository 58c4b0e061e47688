//! Intermediate states, which a master may ask to be shown (FMI 3.0).

use core::ffi::c_void;

/// `fmi3IntermediateUpdateCallback`.
pub type IntermediateUpdate = unsafe extern "C" fn(
    environment: *mut c_void,
    time: f64,
    variable_set_requested: bool,
    variable_get_allowed: bool,
    step_finished: bool,
    can_return_early: bool,
    early_return_requested: *mut u8,
    early_return_time: *mut f64,
);

/// The master's function for intermediate states.
#[derive(Clone, Copy)]
pub struct IntermediateUpdates {
    /// The function; none if the master does not ask for them.
    pub call: Option<IntermediateUpdate>,
    /// What it gets back.
    pub environment: *mut c_void,
}
