//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `c_api` and what it stands on (`ids`, `status`, `failure`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `foreign`, `fmi2`: the variable table, the instance behind the FMI versions, the pointers
//!   of their functions, and FMI 2.0.

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
mod foreign;
#[cfg(feature = "c-abi")]
pub mod ids;
pub mod instance;
#[cfg(feature = "c-abi")]
mod ptr;
#[cfg(feature = "c-abi")]
pub mod status;
pub mod variables;
