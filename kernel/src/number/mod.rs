//! Numbers, mathematics with a fixed sequence of operations, and vectors of neighbours.

pub(crate) mod complex;
pub mod cube_root;
pub mod decimal;
pub mod digest;
pub mod instruction_set;
pub mod math;
pub mod pack;
pub mod power;
pub mod real;
pub(crate) mod text;
pub mod vector;
#[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
pub(crate) mod x86;
