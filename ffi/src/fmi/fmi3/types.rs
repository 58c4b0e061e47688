//! The types of the FMI 3.0 headers.

use core::ffi::c_void;

use crate::fmi::foreign::{Handle, Slot};
use crate::fmi::session::Session;
use crate::instance::SavedState;

/// `fmi3Instance`.
pub type Instance = Handle<Session>;
/// `fmi3FMUState`.
pub type FmuState = Handle<SavedState>;
/// `fmi3FMUState*`.
pub type FmuStateSlot = Slot<SavedState>;
/// `fmi3InstanceEnvironment`.
pub type InstanceEnvironment = *mut c_void;
/// `fmi3ValueReference`.
pub type ValueReference = u32;
/// `fmi3Float64`.
pub type Float64 = f64;
/// `fmi3Int64`.
pub type Int64 = i64;
/// `fmi3UInt64`.
pub type UInt64 = u64;
/// `fmi3Int32`.
pub type Int32 = i32;
/// `fmi3Boolean` as an argument: a byte, because a master can pass any.
pub type Flag = u8;
/// `fmi3Boolean` as a result.
pub type Boolean = bool;
/// `fmi3Clock`, of which none is ever read.
pub type Clock = u8;
/// `fmi3Binary`.
pub type Binary = *const u8;
/// `fmi3DependencyKind` and `fmi3IntervalQualifier` as results, of which none is ever given.
pub type Kind = u32;

/// `fmi3ClockUpdateCallback`, which is never called.
pub type ClockUpdate = unsafe extern "C" fn(environment: InstanceEnvironment);
/// `fmi3LockPreemptionCallback`, which is never called.
pub type LockPreemption = unsafe extern "C" fn();
/// `fmi3UnlockPreemptionCallback`, which is never called.
pub type UnlockPreemption = unsafe extern "C" fn();
