//! What can go wrong, one enum per operation. Every message names the value, its unit and what is legal.

mod memory;
mod model;
mod name;
mod parameter;
mod scenario;
mod snapshot;
mod step;

pub use memory::MemoryError;
pub use model::ModelError;
pub use name::Name;
pub(crate) use name::split_dot;
pub use parameter::{NoEffect, ParameterError, Says};
pub use scenario::ScenarioError;
pub use snapshot::SnapshotError;
pub use step::StepError;
