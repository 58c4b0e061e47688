//! Vectors of two numbers, which a target has or lacks: there is nothing to find out at run time.

#[cfg(target_arch = "aarch64")]
use pulp::aarch64::Neon as Set;
#[cfg(target_arch = "wasm32")]
use pulp::wasm::Simd128 as Set;

use crate::number::instruction_set::InstructionSet;
use crate::number::processor::register::Call;
use crate::number::vector::{Scalar, Work};

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
