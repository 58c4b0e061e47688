//! The functions of FMI 3.0 for co-simulation: a thin translation between the standard's C types and
//! [`crate::instance`]. Nothing here knows physics.
//!
//! A refused call is logged and returns `fmi3Error`; it changes nothing. A step that is refused for its point or its size
//! returns `fmi3Discard`, so that the master may go on with another. What belongs to model exchange, scheduled
//! execution, clocks or derivatives is refused always (`absent`).

mod absent;
mod calls;
mod lifecycle;
mod state;
mod step;
pub mod types;
mod values;
