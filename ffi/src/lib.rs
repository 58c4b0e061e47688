//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `c_api` and what it stands on (`ids`, `status`, `failure`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `session`, `log`: the variable table and the instance behind both FMI versions, with its log.
//! * `whole_steps`: how a time becomes a number of kernel steps, in both.
//! * `foreign`, `fmi2`, `fmi3`: the pointers of the FMI functions, and the functions of each version.
//! * `bare`: what stands in for the standard library in the binary of an FMU.
//!
//! Without an operating system (targets that end in `-none-...`) the library is `no_std` and holds the C ABI alone, with
//! `bare_metal` in place of the standard library.

#![cfg_attr(any(target_os = "none", not(feature = "c-abi")), no_std)]

#[cfg(not(target_os = "none"))]
extern crate alloc;

#[cfg(not(any(feature = "c-abi", target_os = "none")))]
mod bare;
#[cfg(target_os = "none")]
mod bare_metal;
#[cfg(feature = "c-abi")]
pub mod block;
#[cfg(feature = "c-abi")]
pub mod c_api;
pub mod environment;
#[cfg(feature = "c-abi")]
pub mod failure;
#[cfg(not(target_os = "none"))]
mod fmi2;
#[cfg(not(target_os = "none"))]
mod fmi3;
#[cfg(not(target_os = "none"))]
mod foreign;
#[cfg(feature = "c-abi")]
pub mod ids;
#[cfg(not(target_os = "none"))]
pub mod instance;
#[cfg(not(target_os = "none"))]
mod log;
#[cfg(feature = "c-abi")]
mod ptr;
#[cfg(not(target_os = "none"))]
mod session;
#[cfg(feature = "c-abi")]
pub mod status;
#[cfg(not(target_os = "none"))]
pub mod variables;
mod whole_steps;
