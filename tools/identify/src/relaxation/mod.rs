//! Prony series from stress relaxation.
//!
//! [`read`] takes time and load from a file, [`history`] is what the load relaxes from, [`prony`] the fit of a number of
//! terms and [`choice`] how many.

pub mod choice;
pub mod history;
pub mod prony;
pub mod read;
