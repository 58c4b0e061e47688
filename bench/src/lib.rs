//! What the benchmarks share: scenarios, and hosts that make steps through the kernel, the C ABI and the FMU.

pub mod host;
pub mod pages;
pub mod registers;
pub mod results;
pub mod scene;
