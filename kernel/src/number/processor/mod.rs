//! The vectors of the processor, by the crate `pulp`: which there are, and work done with them.

mod register;
#[cfg(not(target_arch = "x86_64"))]
mod two;
#[cfg(target_arch = "x86_64")]
mod x86_64;

#[cfg(not(target_arch = "x86_64"))]
pub(crate) use two::{has, run};
#[cfg(target_arch = "x86_64")]
pub(crate) use x86_64::{has, run};
