//! The parameters of a scenario: name, unit, legal range and meaning of every value of a [`crate::Scenario`], in one place.
//!
//! Scenario files, the C ABI and the FMU are all generated from or checked against these tables. What every layer has is written
//! once, for all of them.

mod changes;
mod effect;
mod general;
mod handle;
mod layer;
mod number;
mod row;
mod values;

#[cfg(test)]
mod tests;

pub use crate::error::{Name, Says};
pub use changes::Changes;
pub use handle::{Kind, Parameter};
pub use number::{LAYER_NUMBERS, NUMBERS, TEST_NUMBERS};
pub use values::Values;
