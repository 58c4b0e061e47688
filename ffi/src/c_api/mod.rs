//! The functions of `include/softanvil.h`, one file per section of the header, and what they stand on: the pointers of C
//! (`ptr`), the memory of a simulation (`header`, `block`), refusals (`failure`, `error`), and texts (`status`,
//! `text`).

pub mod block;
pub mod error;
pub mod failure;
pub mod fields;
pub mod header;
pub mod library;
mod ptr;
pub mod scenario;
pub mod simulation;
pub mod snapshot;
pub mod status;
pub mod tables;
pub mod text;
pub mod trace;
