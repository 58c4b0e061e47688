//! Softanvil's kernel: drop-weight impact of a rigid mass on a soft layer over a rigid core, by explicit finite elements
//! with a fixed step, bit-identical on every target.
//!
//! Each folder imports from those below it alone. From top to bottom:
//!
//! 1. `simulation` owns a model and its state.
//! 2. [`result`] holds the tables of what can be read: outputs and fields.
//! 3. `setup` builds a model of a scenario, with the time step that suits it.
//! 4. [`step()`] is the algorithm, with the monitor of its stability.
//! 5. [`contact`] holds the layer between face and core.
//! 6. [`state`] is everything that changes: nodes, histories, energies, measured numbers, and their snapshot.
//! 7. [`impactor`] is the motion of the face; [`model`] everything that does not change.
//! 8. [`element`] gives the forces of the cells, [`mesh`] their places.
//! 9. [`scenario`] describes a test: [`parameter`] has the tables of its parameters, [`preset`] ready-made ones.
//! 10. [`material`] has the laws, a file each, over the strains of [`tensor`].
//! 11. [`error`], [`cfc`], [`sampling`], [`identity`], and the ground, [`number`]: mathematics with a fixed sequence of operations, and
//!     vectors of neighbours.
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

pub mod cfc;
pub mod contact;
pub mod element;
pub mod error;
mod features;
pub mod identity;
pub mod impactor;
pub mod material;
pub mod mesh;
pub mod model;
pub mod number;
pub mod result;
pub mod sampling;
pub mod scenario;
mod setup;
#[cfg(feature = "alloc")]
pub mod simulation;
pub mod state;
pub mod step;
pub mod tensor;

pub use error::{MemoryError, ModelError, NoEffect, ParameterError, ScenarioError, SnapshotError, StepError};
pub use identity::KERNEL_DIGEST;
pub use impactor::{DrivenPath, INPUTS, StepInput};
pub use model::{Constants, Model, ModelMemory, Size};
pub use number::instruction_set::InstructionSet;
pub use result::{FIELDS, Field, OUTPUTS, Output};
pub use sampling::SAMPLING_INTERVAL;
pub use scenario::parameter::{Changes, Parameter};
pub use scenario::{Scenario, parameter};
#[cfg(feature = "alloc")]
pub use simulation::Simulation;
pub use state::{Scalars, State, StateContent, StateMemory, StateView};
pub use step::{step, step_along, step_with, steps};

/// Ready-made scenarios: the table of those that have a name, and what they are made of.
pub mod preset {
    pub use crate::scenario::preset::*;
    pub use crate::scenario::presets::*;
    #[cfg(feature = "pads")]
    pub use crate::scenario::standards::*;
}
