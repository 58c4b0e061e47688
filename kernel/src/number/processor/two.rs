//! Vectors of two numbers, which a target has or lacks: there is nothing to find out at run time.

#[cfg(target_arch = "aarch64")]
use core::arch::aarch64::float64x2_t;
#[cfg(target_arch = "wasm32")]
use core::arch::wasm32::v128;

#[cfg(target_arch = "aarch64")]
use pulp::aarch64::Neon as Set;
use pulp::bytemuck::{cast, cast_mut, cast_ref};
#[cfg(target_arch = "wasm32")]
use pulp::wasm::Simd128 as Set;

use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack};
use crate::number::processor::register::{Call, register};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Work};

#[cfg(target_arch = "aarch64")]
register!(
    /// Two numbers, of NEON.
    Two([float64x2_t; 2]) of Set,
    |set| set.neon, enter: Set::vectorize,
    vaddq_f64, vsubq_f64, vmulq_f64, vdivq_f64, vsqrtq_f64, vdupq_n_f64,
    |a > b, then, otherwise| set.neon.vbslq_f64(set.neon.vcgtq_f64(a, b), then, otherwise)
);
#[cfg(target_arch = "wasm32")]
register!(
    /// Two numbers, of simd128.
    Two([v128; 2]) of Set,
    |set| set.simd128, enter: Set::vectorize,
    f64x2_add, f64x2_sub, f64x2_mul, f64x2_div, f64x2_sqrt, f64x2_splat,
    |a > b, then, otherwise| set.simd128.v128_bitselect(then, otherwise, set.simd128.f64x2_gt(a, b))
);

/// The set of the target.
const SET: InstructionSet = if cfg!(target_arch = "aarch64") { InstructionSet::Neon } else { InstructionSet::Simd128 };

/// Whether these are the vectors of the target.
#[inline]
pub(crate) fn has(set: InstructionSet) -> bool {
    set == SET && Set::is_available()
}

/// Does `work` with the vectors of `set`, or without any.
#[inline]
pub(crate) fn run<W: Work>(set: InstructionSet, work: W) -> W::Output {
    match Set::try_new() {
        Some(simd) if set == SET => simd.vectorize(Call(simd, work)),
        _ => work.run(Scalar),
    }
}
