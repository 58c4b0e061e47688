//! Softanvil's kernel: drop-weight impact of a rigid mass on a soft layer over a rigid core, by explicit finite elements
//! with a fixed step, bit-identical on every target.
//!
//! From top to bottom:
//!
//! 1. [`scenario`] describes a test; [`parameter`] is the table of its parameters, [`preset`] ready-made ones.
//! 2. [`model`] is everything that does not change ([`mesh`], element constants, masses, [`time_step`]), [`state`]
//!    everything that does; both live in memory that the caller lends ([`storage`]).
//! 3. [`step()`] is the algorithm: internal forces ([`element`], [`material`]), the core ([`core_contact`]), the
//!    face ([`face`]), motion ([`input`], [`impactor`], [`prescribed`]), the books ([`energy`], [`measurement`], [`cfc`]).
//! 4. [`output`] and [`field`] are the tables of what can be read ([`stress`], [`surface`]); [`snapshot`] saves and
//!    restores a state, [`digest`] fingerprints it.
//! 5. [`lanes`], [`stretch`], [`math`] and [`power`] are the ground: data in lanes, and mathematics with a fixed sequence
//!    of operations; [`real`] says in which precision.
//!
//! No function allocates or panics, and none reads anything but its arguments.

#![no_std]
#![forbid(unsafe_code)]
#![cfg_attr(
    feature = "single",
    allow(clippy::excessive_precision, reason = "constants have the digits of double precision")
)]
#![allow(clippy::needless_range_loop, reason = "loops over lanes read as what they compile to")]

#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!("x86 without SSE2 is excluded: x87 registers hold more bits than an f64");

#[cfg(feature = "alloc")]
extern crate alloc;

pub(crate) mod assembly;
pub(crate) mod cell_bound;
pub mod cfc;
pub(crate) mod complex;
mod construction;
pub mod core_contact;
pub mod decimal;
pub mod deformation;
pub mod digest;
pub mod element;
pub mod energy;
pub mod error;
pub mod face;
pub mod field;
pub mod impactor;
pub mod input;
pub mod instruction_set;
pub mod kinematics;
pub mod lanes;
pub mod material;
pub mod math;
pub mod measurement;
pub mod mesh;
pub mod model;
pub mod output;
pub mod parameter;
pub mod power;
pub mod prescribed;
pub mod preset;
pub mod real;
pub(crate) mod response;
pub mod sampling;
pub mod scenario;
#[cfg(feature = "alloc")]
pub mod simulation;
pub mod snapshot;
pub mod stability;
pub mod state;
pub mod state_view;
mod step;
pub mod storage;
pub mod stress;
pub mod stretch;
pub mod surface;
pub mod time_step;
pub(crate) mod trial;
pub mod vector;

pub use error::{MemoryError, ModelError, NoEffect, ParameterError, ScenarioError, SnapshotError, StepError};
pub use field::{FIELDS, Field};
pub use input::{DrivenPath, INPUTS, StepInput};
pub use instruction_set::InstructionSet;
pub use model::{Constants, Model};
pub use output::{OUTPUTS, Output};
pub use parameter::{Changes, PARAMETERS, Parameter};
pub use sampling::SAMPLING_INTERVAL;
pub use scenario::Scenario;
#[cfg(feature = "alloc")]
pub use simulation::Simulation;
pub use state::{Scalars, State};
pub use state_view::{StateContent, StateView};
pub use step::{step, step_along, step_with, steps};
pub use storage::{ModelMemory, Size, StateMemory};
