//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `environment`: the floating-point environment of every call.
//! * `c_api` and what it stands on (`ids`, `status`, `failure`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `foreign`, `fmi2`: the variable table, the instance behind the FMI versions, the pointers
//!   of their functions, and FMI 2.0.

extern crate alloc;

pub mod block;
pub mod c_api;
pub mod environment;
pub mod failure;
mod fmi2;
mod foreign;
pub mod ids;
pub mod instance;
mod ptr;
pub mod status;
pub mod variables;
