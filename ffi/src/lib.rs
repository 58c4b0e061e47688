//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `c_api` and what it stands on (`ids`, `status`, `failure`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `foreign`, `fmi2`: the variable table, the instance behind the FMI versions, the pointers
//!   of their functions, and FMI 2.0.
//!
//! Without an operating system (targets that end in `-none-...`) the library is `no_std` and holds the C ABI alone.

#![cfg_attr(target_os = "none", no_std)]

#[cfg(not(target_os = "none"))]
extern crate alloc;

#[cfg(target_os = "none")]
mod bare_metal;
pub mod block;
pub mod c_api;
pub mod environment;
pub mod failure;
#[cfg(not(target_os = "none"))]
mod fmi2;
#[cfg(not(target_os = "none"))]
mod foreign;
pub mod ids;
#[cfg(not(target_os = "none"))]
pub mod instance;
mod ptr;
pub mod status;
#[cfg(not(target_os = "none"))]
pub mod variables;
