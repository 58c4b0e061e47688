//! Vectors of SSE2, which every x86-64 has and for which the crate `pulp` has no vectors, only a token and its instructions.

use core::arch::x86_64::__m128d;
use core::ops::{Add, Div, Mul, Sub};

use pulp::bytemuck::cast;
use pulp::core_arch::x86;

use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector, Work};

/// The instruction set.
#[derive(Clone, Copy)]
pub struct Sse2(x86::Sse2);

/// Two numbers.
#[derive(Clone, Copy)]
pub struct Two(x86::Sse2, __m128d);

impl Sse2 {
    /// The set, which is none where the processor lacks it.
    #[inline(always)]
    pub fn try_new() -> Option<Self> {
        x86::Sse2::try_new().map(Self)
    }
}

/// One of the four operations as an operator.
macro_rules! operator {
    ($trait:ident, $method:ident, $operation:ident) => {
        impl $trait for Two {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0, self.0.$operation(self.1, other.1))
            }
        }
    };
}

operator!(Add, add, _mm_add_pd);
operator!(Sub, sub, _mm_sub_pd);
operator!(Mul, mul, _mm_mul_pd);
operator!(Div, div, _mm_div_pd);

impl Vector for Two {
    type Set = Sse2;

    #[inline(always)]
    fn set(self) -> Sse2 {
        Sse2(self.0)
    }

    #[inline(always)]
    fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
        let mask = self.0._mm_cmpgt_pd(self.1, other.1);
        Self(self.0, self.0._mm_or_pd(self.0._mm_and_pd(mask, then.1), self.0._mm_andnot_pd(mask, otherwise.1)))
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0, self.0._mm_sqrt_pd(self.1))
    }
}

impl Simd for Sse2 {
    type Vector = Two;
    const WIDTH: usize = 2;

    #[inline(always)]
    fn splat(self, number: Real) -> Two {
        Two(self.0, cast([number; 2]))
    }

    #[inline(always)]
    fn load(self, lane: &Pack, chunk: usize) -> Two {
        Two(self.0, cast(lane.as_chunks::<2>().0[chunk % (LANES / 2)]))
    }

    #[inline(always)]
    fn store(self, vector: Two, lane: &mut Pack, chunk: usize) {
        lane.as_chunks_mut().0[chunk % (LANES / 2)] = cast::<_, [Real; 2]>(vector.1);
    }

    #[inline(never)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        work.run(self)
    }
}
