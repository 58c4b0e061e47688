//! The vectors of x86-64. A token of the crate `pulp` proves that the processor has the instructions.

use core::arch::x86_64::{__m128d, __m128i, __m256d, __m256i, __m512d, __m512i, _CMP_GT_OQ};
use core::ops::{Add, Div, Mul, Sub};

use pulp::bytemuck::cast;
pub(crate) use pulp::core_arch::x86::Sse2;
pub(crate) use pulp::x86::{V3, V4};

use crate::number::pack::{LANES, Pack};
use crate::number::real::{CBRT_END, INVERSE_CBRT_MAGIC, THIRD_OF_UPPER_HALF};
use crate::number::vector::{BIASED_INTEGERS, HALF_OCTAVE, INTEGERS, ONE, Simd, Vector, Work};

/// One of the four operations as an operator.
macro_rules! operator {
    ($vector:ident, $trait:ident, $method:ident, |$simd:ident, $a:ident, $b:ident| $result:expr) => {
        impl $trait for $vector {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($simd, $a, $b) = (self.0, self.1, other.1);
                Self($simd, $result)
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

operator!(Two, Add, add, |simd, a, b| simd._mm_add_pd(a, b));
operator!(Two, Sub, sub, |simd, a, b| simd._mm_sub_pd(a, b));
operator!(Two, Mul, mul, |simd, a, b| simd._mm_mul_pd(a, b));
operator!(Two, Div, div, |simd, a, b| simd._mm_div_pd(a, b));
operator!(Four, Add, add, |simd, a, b| simd.avx._mm256_add_pd(a, b));
operator!(Four, Sub, sub, |simd, a, b| simd.avx._mm256_sub_pd(a, b));
operator!(Four, Mul, mul, |simd, a, b| simd.avx._mm256_mul_pd(a, b));
operator!(Four, Div, div, |simd, a, b| simd.avx._mm256_div_pd(a, b));
operator!(Eight, Add, add, |simd, a, b| simd.avx512f._mm512_add_pd(a, b));
operator!(Eight, Sub, sub, |simd, a, b| simd.avx512f._mm512_sub_pd(a, b));
operator!(Eight, Mul, mul, |simd, a, b| simd.avx512f._mm512_mul_pd(a, b));
operator!(Eight, Div, div, |simd, a, b| simd.avx512f._mm512_div_pd(a, b));

/// The bits of a vector as integers of 64 bits.
macro_rules! integers {
    (
        $integers:ident, $token:ty, $register:ty, |$simd:ident, $a:ident, $b:ident|
        $sum:expr, $difference:expr, $or:expr, $product:expr,
        $upper_half:expr, $exponent:expr, $to_exponent:expr
    ) => {
        #[derive(Clone, Copy)]
        struct $integers($token, $register);

        integers!($integers, sum, |$simd, $a, $b| $sum);
        integers!($integers, difference, |$simd, $a, $b| $difference);
        integers!($integers, or, |$simd, $a, $b| $or);
        integers!($integers, product_of_lower_halves, |$simd, $a, $b| $product);
        integers!($integers, upper_half, |$simd, $a| $upper_half);
        integers!($integers, exponent, |$simd, $a| $exponent);
        integers!($integers, to_exponent, |$simd, $a| $to_exponent);
    };
    ($integers:ident, $method:ident, |$simd:ident, $a:ident, $b:ident| $result:expr) => {
        impl $integers {
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($simd, $a, $b) = (self.0, self.1, other.1);
                Self($simd, $result)
            }
        }
    };
    ($integers:ident, $method:ident, |$simd:ident, $a:ident| $result:expr) => {
        impl $integers {
            #[inline(always)]
            fn $method(self) -> Self {
                let ($simd, $a) = (self.0, self.1);
                Self($simd, $result)
            }
        }
    };
}

integers!(
    TwoIntegers,
    Sse2,
    __m128i,
    |simd, a, b| simd._mm_add_epi64(a, b),
    simd._mm_sub_epi64(a, b),
    simd._mm_or_si128(a, b),
    simd._mm_mul_epu32(a, b),
    simd._mm_srli_epi64::<32>(a),
    simd._mm_srli_epi64::<52>(a),
    simd._mm_slli_epi64::<52>(a)
);

integers!(
    FourIntegers,
    V3,
    __m256i,
    |simd, a, b| simd.avx2._mm256_add_epi64(a, b),
    simd.avx2._mm256_sub_epi64(a, b),
    simd.avx2._mm256_or_si256(a, b),
    simd.avx2._mm256_mul_epu32(a, b),
    simd.avx2._mm256_srli_epi64::<32>(a),
    simd.avx2._mm256_srli_epi64::<52>(a),
    simd.avx2._mm256_slli_epi64::<52>(a)
);

integers!(
    EightIntegers,
    V4,
    __m512i,
    |simd, a, b| simd.avx512f._mm512_add_epi64(a, b),
    simd.avx512f._mm512_sub_epi64(a, b),
    simd.avx512f._mm512_or_si512(a, b),
    simd.avx512f._mm512_mul_epu32(a, b),
    simd.avx512f._mm512_srli_epi64::<32>(a),
    simd.avx512f._mm512_srli_epi64::<52>(a),
    simd.avx512f._mm512_slli_epi64::<52>(a)
);

/// [`Vector`] and [`Simd`] of a register of `$width` numbers.
macro_rules! vector {
    (
        $vector:ident, $integers:ident, $token:ty, $width:literal,
        |$simd:ident, $a:ident, $b:ident, $c:ident, $d:ident|
        $select:expr, $larger:expr, $square_root:expr, $shift:expr
    ) => {
        impl $vector {
            #[inline(always)]
            fn to_bits(self) -> $integers {
                $integers(self.0, cast(self.1))
            }

            /// The same integer everywhere.
            #[inline(always)]
            fn integers(self, integer: u64) -> $integers {
                $integers(self.0, cast([integer; $width]))
            }
        }

        impl $integers {
            #[inline(always)]
            fn numbers(self) -> $vector {
                $vector(self.0, cast(self.1))
            }
        }

        impl Vector for $vector {
            #[inline(always)]
            fn add_scalar(self, number: f64) -> Self {
                self + self.0.splat(number)
            }

            #[inline(always)]
            fn mul_scalar(self, number: f64) -> Self {
                self * self.0.splat(number)
            }

            #[inline(always)]
            fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
                let ($simd, $a, $b, $c, $d) = (self.0, self.1, other.1, then.1, otherwise.1);
                Self($simd, $select)
            }

            #[inline(always)]
            fn max(self, other: Self) -> Self {
                let ($simd, $a, $b) = (self.0, self.1, other.1);
                Self($simd, $larger)
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                let ($simd, $a) = (self.0, self.1);
                Self($simd, $square_root)
            }

            #[inline(always)]
            fn shift(self, before: Self) -> Self {
                let ($simd, $a, $b) = (self.0, self.1, before.1);
                Self($simd, $shift)
            }

            #[inline(always)]
            fn guess_inverse_cbrt(self) -> Self {
                // A sum with the third, for a difference the compiler would multiply by all digits of its opposite.
                let left = self.integers(CBRT_END).difference(self.to_bits()).upper_half();
                let third = left.product_of_lower_halves(self.integers(THIRD_OF_UPPER_HALF));
                self.integers(INVERSE_CBRT_MAGIC).sum(third).numbers()
            }

            #[inline(always)]
            fn binary_exponent(self, other: Self) -> [Self; 2] {
                let difference = self.to_bits().difference(other.to_bits());
                let exponent = difference.sum(self.integers(ONE + HALF_OCTAVE)).exponent();
                let integer = exponent.or(self.integers(INTEGERS.to_bits())).numbers();
                [integer.add_scalar(-BIASED_INTEGERS), exponent.to_exponent().numbers()]
            }

            #[inline(always)]
            fn powers_of_two(self) -> [Self; 2] {
                let (one, exponent) = (self.integers(ONE), self.to_bits().to_exponent());
                [one.sum(exponent).numbers(), one.difference(exponent).numbers()]
            }
        }

        impl Simd for $token {
            type Vector = $vector;
            const WIDTH: usize = $width;

            #[inline(always)]
            fn splat(self, number: f64) -> $vector {
                $vector(self, cast([number; $width]))
            }

            #[inline(always)]
            #[allow(clippy::modulo_one, reason = "the widest vector is a whole lane")]
            fn load(self, lane: &Pack, chunk: usize) -> $vector {
                let numbers: [f64; $width] = lane.as_chunks().0[chunk % (LANES / $width)];
                $vector(self, cast(numbers))
            }

            #[inline(always)]
            #[allow(clippy::modulo_one, reason = "the widest vector is a whole lane")]
            fn store(self, vector: $vector, lane: &mut Pack, chunk: usize) {
                let numbers: [f64; $width] = cast(vector.1);
                lane.as_chunks_mut().0[chunk % (LANES / $width)] = numbers;
            }
        }
    };
}

vector!(
    Two,
    TwoIntegers,
    Sse2,
    2,
    |simd, a, b, c, d| {
        let mask = simd._mm_cmpgt_pd(a, b);
        simd._mm_or_pd(simd._mm_and_pd(mask, c), simd._mm_andnot_pd(mask, d))
    },
    simd._mm_max_pd(a, b),
    simd._mm_sqrt_pd(a),
    simd._mm_shuffle_pd::<0b01>(b, a)
);

vector!(
    Four,
    FourIntegers,
    V3,
    4,
    |simd, a, b, c, d| simd.avx._mm256_blendv_pd(d, c, simd.avx._mm256_cmp_pd::<_CMP_GT_OQ>(a, b)),
    simd.avx._mm256_max_pd(a, b),
    simd.avx._mm256_sqrt_pd(a),
    simd.avx._mm256_shuffle_pd::<0b0101>(simd.avx._mm256_permute2f128_pd::<0x21>(b, a), a)
);

vector!(
    Eight,
    EightIntegers,
    V4,
    8,
    |simd, a, b, c, d| simd.avx512f._mm512_mask_blend_pd(simd.avx512f._mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b), d, c),
    simd.avx512f._mm512_max_pd(a, b),
    simd.avx512f._mm512_sqrt_pd(a),
    cast(simd.avx512f._mm512_alignr_epi64::<7>(cast(a), cast(b)))
);

/// [`Work`] in the form that the crate asks for.
pub(crate) struct Call<S, W>(pub S, pub W);

impl<S: Simd, W: Work> pulp::NullaryFnOnce for Call<S, W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.1.run(self.0)
    }
}
