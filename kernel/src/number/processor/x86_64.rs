//! The vectors of x86-64, and the choice among them at run time. SSE2, which every such processor has, is a token of instructions
//! alone: there is nothing to enter.

use core::arch::x86_64::{__m128d, __m256d, __m512d, _CMP_GT_OQ};

use pulp::NullaryFnOnce;
use pulp::bytemuck::{cast, cast_mut, cast_ref};
use pulp::core_arch::x86::Sse2;
use pulp::x86::{V3, V4};

use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack};
use crate::number::processor::register::{Call, register};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Work};

register!(
    /// Two numbers, of SSE2.
    Two([__m128d; 2]) of Sse2,
    |set| set, enter: |_, call: Call<Sse2, W>| call.call(),
    _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd, _mm_sqrt_pd, _mm_set1_pd,
    |a > b, then, otherwise| {
        let mask = set._mm_cmpgt_pd(a, b);
        set._mm_or_pd(set._mm_and_pd(mask, then), set._mm_andnot_pd(mask, otherwise))
    }
);
register!(
    /// Four numbers, of AVX2.
    Four([__m256d; 4]) of V3,
    |set| set.avx, enter: V3::vectorize,
    _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_sqrt_pd, _mm256_set1_pd,
    |a > b, then, otherwise| set.avx._mm256_blendv_pd(otherwise, then, set.avx._mm256_cmp_pd::<_CMP_GT_OQ>(a, b))
);
register!(
    /// Eight numbers, of AVX-512.
    Eight([__m512d; 8]) of V4,
    |set| set.avx512f, enter: V4::vectorize,
    _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_sqrt_pd, _mm512_set1_pd,
    |a > b, then, otherwise| {
        set.avx512f._mm512_mask_blend_pd(set.avx512f._mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b), otherwise, then)
    }
);

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
