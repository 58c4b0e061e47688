//! [`Model`]: everything about a simulation that does not change, in memory that the caller lends.

mod constants;
mod memory;
mod size;
mod view;

pub use constants::Constants;
pub use memory::ModelMemory;
pub(crate) use memory::{ModelArrays, split_row, take};
pub use size::Size;
pub(crate) use size::{
    END_FIELDS, MODEL_NODE_FIELDS, NodeArrays, PAIR_PACKS, SOLID_END_FIELDS, SOLID_PAIR_FIELDS, SOLID_TOUCH_FIELDS,
    SolidArrays, history_packs,
};
pub use view::Model;
