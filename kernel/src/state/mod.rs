//! [`State`]: everything about a simulation that changes, in memory that the caller lends.

mod arrays;
mod energy;
mod memory;
mod metrics;
mod next_impact;
mod nodes;
mod pair;
mod sampler;
mod scalars;
mod snapshot;
mod solid;
mod solid_pair;
mod view;

pub use arrays::State;
pub use energy::EnergyBalance;
pub(crate) use energy::{ContactWork, ENERGY_WORDS, SOFTENING_WORDS, StepWork};
pub use memory::StateMemory;
pub use metrics::Metrics;
pub use next_impact::LONGEST_REST;
pub(crate) use nodes::{Rows, StateNodes, corners};
pub(crate) use pair::{
    ABREAST, FORCE, LEFT, MOBILITY, NORMAL, OPENING, PART, PairPack, PairRow, RESISTANCE, SHIFT, WEIGHT, columns,
    columns_mut,
};
pub use sampler::{Forces, Sample, Sampler};
pub use scalars::Scalars;
pub use snapshot::{restore, save, snapshot_size, state_digest, write_words};
pub(crate) use solid::{SolidState, SolidView, solid_corners, subtract_from_row};
pub(crate) use solid_pair::{SolidPair, SolidPairRow};
pub use view::{StateContent, StateView};
