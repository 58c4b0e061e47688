//! What can be read from a simulation: the tables of outputs and fields, and the stresses behind them.

mod field;
mod output;
mod solid_stress;
pub mod stress;

pub use field::{FIELDS, Field, Location, RETIRED_FIELDS, Source, Strided};
pub use output::{OUTPUTS, Output, RETIRED_OUTPUTS};
