//! The types of the FMI 2.0 headers.

use core::ffi::{c_int, c_void};

use crate::fmi::foreign::{Handle, Slot};
use crate::fmi::log::FormatLogger;
use crate::fmi::session::Session;
use crate::fmi::status::Status;
use crate::instance::SavedState;

/// `fmi2Component`.
pub type Component = Handle<Session>;
/// `fmi2FMUstate`.
pub type FmuState = Handle<SavedState>;
/// `fmi2FMUstate*`.
pub type FmuStateSlot = Slot<SavedState>;
/// `fmi2ValueReference`.
pub type ValueReference = u32;
/// `fmi2Real`.
pub type Real = f64;
/// `fmi2Integer`.
pub type Integer = c_int;
/// `fmi2Boolean`.
pub type Boolean = c_int;
/// `fmi2Byte`, a character in C.
pub type Byte = u8;
/// `fmi2EventInfo`, of which none is ever filled.
pub type EventInfo = c_void;
/// `fmi2Type`: an integer, because a master can pass any.
pub type FmuType = c_int;
/// `fmi2StatusKind`: an integer, because a master can pass any.
pub type StatusKind = c_int;

/// `fmi2CoSimulation` of `fmi2Type`.
pub const CO_SIMULATION: FmuType = 1;
/// `fmi2DoStepStatus` of `fmi2StatusKind`.
pub const DO_STEP_STATUS: StatusKind = 0;
/// `fmi2LastSuccessfulTime` of `fmi2StatusKind`.
pub const LAST_SUCCESSFUL_TIME: StatusKind = 2;
/// `fmi2Terminated` of `fmi2StatusKind`.
pub const TERMINATED: StatusKind = 3;

/// `fmi2CallbackFunctions`.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CallbackFunctions {
    /// Takes log messages.
    pub logger: Option<FormatLogger>,
    /// Not used: the library allocates by itself.
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    /// Not used.
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    /// Not used: steps are complete when they return.
    pub step_finished: Option<unsafe extern "C" fn(*mut c_void, Status)>,
    /// Handed back to the logger.
    pub environment: *mut c_void,
}
