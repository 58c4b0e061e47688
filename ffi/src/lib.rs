//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `c_api` and what it stands on (`ids`, `status`, `failure`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `session`, `log`: the variable table and the instance behind both FMI versions, with its log.
//! * `foreign`, `fmi2`, `fmi3`: the pointers of the FMI functions, and the functions of each version.
//! * `bare`: what stands in for the standard library in the binary of an FMU.

#![cfg_attr(not(feature = "c-abi"), no_std)]

extern crate alloc;

#[cfg(not(feature = "c-abi"))]
mod bare;
#[cfg(feature = "c-abi")]
pub mod block;
#[cfg(feature = "c-abi")]
pub mod c_api;
pub mod environment;
#[cfg(feature = "c-abi")]
pub mod failure;
mod fmi2;
mod fmi3;
mod foreign;
#[cfg(feature = "c-abi")]
pub mod ids;
pub mod instance;
mod log;
#[cfg(feature = "c-abi")]
mod ptr;
mod session;
#[cfg(feature = "c-abi")]
pub mod status;
pub mod variables;
