//! The C ABI and the FMI entry points of Softanvil, over the kernel.
//!
//! * `c_api` and what it stands on (`status`, `ptr`, `block`): the functions of `include/softanvil.h`.
//! * `variables`, `instance`, `fmi2`: the variable table, the instance behind the FMI versions, and FMI 2.0.
