//! Golden traces: what every target must compute to the last bit.
//!
//! 1. [`scenes`] is the table of what is simulated, with the trace of each (`traces/`, one text file a scene).
//! 2. [`run`] simulates a scene in [`memory`] without a heap and gives a [`record`] at every stride.
//! 3. [`check`] compares records with a trace and names the first step and quantity that differ.
//! 4. [`runner`] is the command line that programs on hosts and microcontrollers share.
//!
//! No function here allocates.

#![no_std]
#![forbid(unsafe_code)]

pub mod check;
pub mod memory;
pub mod record;
pub mod run;
pub mod runner;
pub mod scenes;

pub use check::{Checker, Difference};
pub use memory::Memory;
pub use record::{Header, Record};
pub use run::{Failure, Run};
pub use scenes::{SCENES, Scene};
