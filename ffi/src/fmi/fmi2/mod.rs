//! The functions of FMI 2.0 for co-simulation: a thin translation between the standard's C types and
//! [`crate::instance`]. Nothing here knows physics.
//!
//! A refused call is logged and returns `fmi2Error`; it changes nothing. So does a refused step: `fmi2Discard` would say that
//! a part of it was computed.

mod absent;
mod calls;
mod lifecycle;
mod state;
mod status;
mod step;
pub mod types;
mod values;
