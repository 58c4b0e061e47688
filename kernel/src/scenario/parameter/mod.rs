//! The table of parameters: name, unit, legal range and meaning of every field of a [`crate::Scenario`], in one place.
//!
//! Scenario files, the C ABI and the FMU are all generated from or checked against this table.

mod changes;
mod coefficient;
mod effect;
mod material;
mod row;
mod table;

pub use changes::Changes;
pub use row::{Kind, Parameter};
pub use table::PARAMETERS;
pub(crate) use table::ROWS;
