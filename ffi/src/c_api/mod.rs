//! The functions of `include/softanvil.h`, one file per section of the header.

pub mod fields;
pub mod library;
pub mod scenario;
pub mod simulation;
pub mod snapshot;
pub mod tables;
pub mod trace;
