//! The table of FMI variables. It serves the getters, the setters and the model descriptions of both versions alike.
//!
//! Parameters and outputs come from the kernel's tables; only what a master sees and the kernel does not stands here:
//! time, inputs, and what an instance knows about its model.

mod digest;
mod inputs;
pub mod profile;
pub mod references;
mod table;
mod token;
pub mod units;
mod variable;

pub use inputs::{INPUTS, Input, Inputs};
pub use table::Table;
pub(crate) use table::same_bits;
pub use token::token;
pub use variable::{Source, ValueType, Variable, Version};

#[cfg(test)]
mod tests;
