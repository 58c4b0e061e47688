//! The choice among the vectors of x86-64, at run time.

use pulp::x86::{V3, V4};

use crate::number::instruction_set::InstructionSet;
use crate::number::processor::register::Call;
use crate::number::processor::sse2::Sse2;
use crate::number::vector::{Scalar, Simd, Work};

/// Whether the processor has `set`, wider than the two numbers of every x86-64.
#[inline]
pub(crate) fn has(set: InstructionSet) -> bool {
    match set {
        InstructionSet::Avx2 => V3::is_available(),
        InstructionSet::Avx512 => V4::is_available(),
        _ => false,
    }
}

/// Does `work` with `set`, or with SSE2 where that is not available.
#[inline]
pub(crate) fn run<W: Work>(set: InstructionSet, work: W) -> W::Output {
    if set == InstructionSet::Avx512
        && let Some(simd) = V4::try_new()
    {
        return simd.vectorize(Call(simd, work));
    }
    if set == InstructionSet::Avx2
        && let Some(simd) = V3::try_new()
    {
        return simd.vectorize(Call(simd, work));
    }
    match Sse2::try_new() {
        Some(simd) => simd.apart(work),
        None => work.run(Scalar),
    }
}
