//! Vectors as the crate `pulp` has them for an instruction set, a register of the processor each. Its token proves that the
//! processor has the instructions.

use core::ops::{Add, Div, Mul, Sub};

use crate::number::pack::{LANES, Pack};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector, Work};

/// Numbers beside the token of their instruction set. On lines as the widest are: one that lies across two of them is late,
/// which cost AVX-512 3 % of the study's drop.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub struct Register<S: pulp::Simd>(S, S::f64s);

/// One of the four operations as an operator.
macro_rules! operator {
    ($trait:ident, $method:ident, $operation:ident) => {
        impl<S: pulp::Simd> $trait for Register<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0, self.0.$operation(self.1, other.1))
            }
        }
    };
}

operator!(Add, add, add_f64s);
operator!(Sub, sub, sub_f64s);
operator!(Mul, mul, mul_f64s);
operator!(Div, div, div_f64s);

impl<S: pulp::Simd> Vector for Register<S> {
    type Set = S;

    #[inline(always)]
    fn set(self) -> S {
        self.0
    }

    #[inline(always)]
    fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
        Self(self.0, self.0.select_f64s(self.0.greater_than_f64s(self.1, other.1), then.1, otherwise.1))
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0, self.0.sqrt_f64s(self.1))
    }
}

impl<S: pulp::Simd> Simd for S {
    type Vector = Register<S>;
    const WIDTH: usize = S::F64_LANES;

    #[inline(always)]
    fn splat(self, number: Real) -> Register<S> {
        Register(self, self.splat_f64s(number))
    }

    #[inline(always)]
    fn load(self, lane: &Pack, chunk: usize) -> Register<S> {
        Register(self, S::as_simd_f64s(lane).0[chunk % (LANES / S::F64_LANES)])
    }

    #[inline(always)]
    fn store(self, vector: Register<S>, lane: &mut Pack, chunk: usize) {
        S::as_mut_simd_f64s(lane).0[chunk % (LANES / S::F64_LANES)] = vector.1;
    }

    #[inline(never)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        pulp::Simd::vectorize(self, Call(self, work))
    }
}

/// [`Work`] in the form that the crate asks for.
pub(crate) struct Call<S, W>(pub S, pub W);

impl<S: Simd, W: Work> pulp::NullaryFnOnce for Call<S, W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.1.run(self.0)
    }
}
