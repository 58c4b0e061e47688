//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `whole_steps`: how a time becomes a number of kernel steps.
//! * `c_api`: the functions of `include/softanvil.h`.
//! * `variables`, `instance`: the variable table and the instance behind both FMI versions.
//! * `fmi`: the functions of both versions.
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
pub mod c_api;
pub mod environment;
#[cfg(not(target_os = "none"))]
mod fmi;
#[cfg(not(target_os = "none"))]
pub mod instance;
#[cfg(not(target_os = "none"))]
pub mod variables;
mod whole_steps;
