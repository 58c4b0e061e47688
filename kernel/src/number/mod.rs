//! Numbers, mathematics with a fixed sequence of operations, and vectors of neighbours.

pub(crate) mod complex;
pub mod cube_root;
pub mod decimal;
pub mod digest;
pub(crate) mod dispatch;
pub mod erf;
pub mod instruction_set;
pub mod math;
pub mod pack;
pub mod power;
pub mod real;
pub(crate) mod text;
pub mod vector;

// The one condition for vectors. Miri has no instructions of processors, and `pulp`'s numbers here are of double precision.
#[cfg(all(
    feature = "dispatch",
    not(any(miri, feature = "single")),
    any(target_arch = "x86_64", target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128"))
))]
mod processor;
#[cfg(not(all(
    feature = "dispatch",
    not(any(miri, feature = "single")),
    any(target_arch = "x86_64", target_arch = "aarch64", all(target_arch = "wasm32", target_feature = "simd128"))
)))]
#[path = "scalar.rs"]
mod processor;
