//! The vectors of x86-64. A token of the crate `pulp` proves that the processor has the instructions.

use core::arch::x86_64::{__m128d, __m256d, __m512d, _CMP_GT_OQ};
use core::ops::{Add, Div, Mul, Sub};

use pulp::bytemuck::cast;
pub(crate) use pulp::core_arch::x86::Sse2;
pub(crate) use pulp::x86::{V3, V4};

use crate::instruction_set::Work;
use crate::lanes::{LANES, Lane};
use crate::real::{INVERSE_CBRT_MAGIC, INVERSE_SQRT_MAGIC, THIRD_OF_UPPER_HALF};
use crate::vector::{Instructions, Vector};

/// One of the four operations as an operator.
macro_rules! operator {
    ($vector:ident, $trait:ident, $method:ident, |$set:ident, $a:ident, $b:ident| $result:expr) => {
        impl $trait for $vector {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($set, $a, $b) = (self.0, self.1, other.1);
                Self($set, $result)
            }
        }
    };
}

/// Two numbers, with SSE2.
#[derive(Clone, Copy)]
pub struct Two(Sse2, __m128d);

/// Four numbers, with AVX2.
#[derive(Clone, Copy)]
pub struct Four(V3, __m256d);

/// Eight numbers, with AVX-512.
#[derive(Clone, Copy)]
pub struct Eight(V4, __m512d);

operator!(Two, Add, add, |set, a, b| set._mm_add_pd(a, b));
operator!(Two, Sub, sub, |set, a, b| set._mm_sub_pd(a, b));
operator!(Two, Mul, mul, |set, a, b| set._mm_mul_pd(a, b));
operator!(Two, Div, div, |set, a, b| set._mm_div_pd(a, b));
operator!(Four, Add, add, |set, a, b| set.avx._mm256_add_pd(a, b));
operator!(Four, Sub, sub, |set, a, b| set.avx._mm256_sub_pd(a, b));
operator!(Four, Mul, mul, |set, a, b| set.avx._mm256_mul_pd(a, b));
operator!(Four, Div, div, |set, a, b| set.avx._mm256_div_pd(a, b));
operator!(Eight, Add, add, |set, a, b| set.avx512f._mm512_add_pd(a, b));
operator!(Eight, Sub, sub, |set, a, b| set.avx512f._mm512_sub_pd(a, b));
operator!(Eight, Mul, mul, |set, a, b| set.avx512f._mm512_mul_pd(a, b));
operator!(Eight, Div, div, |set, a, b| set.avx512f._mm512_div_pd(a, b));

/// [`Vector`] and [`Instructions`] of a register of `$width` numbers.
macro_rules! vector {
    (
        $vector:ident, $token:ty, $width:literal,
        |$set:ident, $a:ident, $b:ident, $c:ident, $d:ident| $select:expr, $half:expr, $third:expr, $difference:expr
    ) => {
        impl Vector for $vector {
            #[inline(always)]
            fn plus(self, number: f64) -> Self {
                self + self.0.splat(number)
            }

            #[inline(always)]
            fn times(self, number: f64) -> Self {
                self * self.0.splat(number)
            }

            #[inline(always)]
            fn if_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
                let ($set, $a, $b, $c, $d) = (self.0, self.1, other.1, then.1, otherwise.1);
                Self($set, $select)
            }

            #[inline(always)]
            fn guess_inverse_sqrt(self) -> Self {
                let ($set, $a) = (self.0, cast(self.1));
                let ($a, $b) = (cast([INVERSE_SQRT_MAGIC; $width]), $half);
                Self($set, cast($difference))
            }

            #[inline(always)]
            fn guess_inverse_cbrt(self) -> Self {
                let ($set, $a, $b) = (self.0, cast(self.1), cast([THIRD_OF_UPPER_HALF; $width]));
                let ($a, $b) = (cast([INVERSE_CBRT_MAGIC; $width]), $third);
                Self($set, cast($difference))
            }
        }

        impl Instructions for $token {
            type Vector = $vector;
            const WIDTH: usize = $width;

            #[inline(always)]
            fn splat(self, number: f64) -> $vector {
                $vector(self, cast([number; $width]))
            }

            #[inline(always)]
            #[allow(clippy::modulo_one, reason = "the widest vector is a whole lane")]
            fn load(self, lane: &Lane, chunk: usize) -> $vector {
                let numbers: [f64; $width] = lane.as_chunks().0[chunk % (LANES / $width)];
                $vector(self, cast(numbers))
            }

            #[inline(always)]
            #[allow(clippy::modulo_one, reason = "the widest vector is a whole lane")]
            fn store(self, vector: $vector, lane: &mut Lane, chunk: usize) {
                let numbers: [f64; $width] = cast(vector.1);
                lane.as_chunks_mut().0[chunk % (LANES / $width)] = numbers;
            }
        }
    };
}

vector!(
    Two,
    Sse2,
    2,
    |set, a, b, c, d| {
        let mask = set._mm_cmpgt_pd(a, b);
        set._mm_or_pd(set._mm_and_pd(mask, c), set._mm_andnot_pd(mask, d))
    },
    set._mm_srli_epi64::<1>(a),
    set._mm_mul_epu32(set._mm_srli_epi64::<32>(a), b),
    set._mm_sub_epi64(a, b)
);

vector!(
    Four,
    V3,
    4,
    |set, a, b, c, d| set.avx._mm256_blendv_pd(d, c, set.avx._mm256_cmp_pd::<_CMP_GT_OQ>(a, b)),
    set.avx2._mm256_srli_epi64::<1>(a),
    set.avx2._mm256_mul_epu32(set.avx2._mm256_srli_epi64::<32>(a), b),
    set.avx2._mm256_sub_epi64(a, b)
);

vector!(
    Eight,
    V4,
    8,
    |set, a, b, c, d| set.avx512f._mm512_mask_blend_pd(set.avx512f._mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b), d, c),
    set.avx512f._mm512_srli_epi64::<1>(a),
    set.avx512f._mm512_mul_epu32(set.avx512f._mm512_srli_epi64::<32>(a), b),
    set.avx512f._mm512_sub_epi64(a, b)
);

/// [`Work`] in the form that the crate asks for.
pub(crate) struct Call<S, W>(pub S, pub W);

impl<S: Instructions, W: Work> pulp::NullaryFnOnce for Call<S, W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.1.run(self.0)
    }
}
