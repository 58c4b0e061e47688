//! Prony series from stress relaxation.
//!
//! [`read`] takes time and load from a file, `ramp` tells a rise of the load from noise, [`history`] is what the load
//! relaxes from, [`prony`] the fit of a number of terms and [`choice`] how many.

pub mod choice;
pub mod history;
pub mod prony;
mod ramp;
pub mod read;
