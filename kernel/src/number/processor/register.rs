//! Vectors in the form that a compiler knows them in, a register of the processor each. The crate `pulp` has the instructions, and
//! vectors that are arrays; those take a compiler half as long again to bring back into registers.

use crate::number::vector::{Simd, Work};

/// A register and its instruction set: the name of the register and what it holds, the token of the crate `pulp` that proves
/// that the processor has the set, the part of the token that has the instructions, and their names; `enter` does
/// [`Work`] in a function that has these instructions.
macro_rules! register {
    (
        $(#[$doc:meta])* $register:ident([$numbers:ty; $width:literal]) of $token:ty,
        |$set:ident| $of:expr, enter: $enter:expr,
        $add:ident, $subtract:ident, $multiply:ident, $divide:ident, $square_root:ident, $splat:ident,
        |$a:ident > $b:ident, $then:ident, $otherwise:ident| $select:expr
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $register($token, $numbers);

        register!(@operator $register, core::ops::Add, add, |$set| $of, $add);
        register!(@operator $register, core::ops::Sub, sub, |$set| $of, $subtract);
        register!(@operator $register, core::ops::Mul, mul, |$set| $of, $multiply);
        register!(@operator $register, core::ops::Div, div, |$set| $of, $divide);

        impl $crate::number::vector::Vector for $register {
            type Set = $token;

            #[inline(always)]
            fn set(self) -> $token {
                self.0
            }

            #[inline(always)]
            fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
                let ($set, $a, $b, $then, $otherwise) = (self.0, self.1, other.1, then.1, otherwise.1);
                Self($set, $select)
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                let $set = self.0;
                Self($set, $of.$square_root(self.1))
            }

            #[inline(always)]
            fn add_scalar(self, number: Real) -> Self {
                let $set = self.0;
                Self($set, $of.$add(self.1, $of.$splat(number)))
            }

            #[inline(always)]
            fn mul_scalar(self, number: Real) -> Self {
                let $set = self.0;
                Self($set, $of.$multiply(self.1, $of.$splat(number)))
            }
        }

        impl $crate::number::vector::Simd for $token {
            type Vector = $register;
            const WIDTH: usize = $width;

            #[inline(always)]
            fn splat(self, number: Real) -> $register {
                let $set = self;
                $register($set, $of.$splat(number))
            }

            #[inline(always)]
            fn load(self, lane: &Pack, chunk: usize) -> $register {
                let registers = cast_ref::<Pack, [[Real; $width]; LANES / $width]>(lane);
                $register(self, cast(registers[chunk % registers.len()]))
            }

            #[inline(always)]
            fn store(self, vector: $register, lane: &mut Pack, chunk: usize) {
                let registers = cast_mut::<Pack, [[Real; $width]; LANES / $width]>(lane);
                registers[chunk % registers.len()] = cast(vector.1);
            }

            #[inline(never)]
            fn apart<W: Work>(self, work: W) -> W::Output {
                $enter(self, Call(self, work))
            }
        }
    };
    (@operator $register:ident, $trait:path, $method:ident, |$set:ident| $of:expr, $operation:ident) => {
        impl $trait for $register {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let $set = self.0;
                Self($set, $of.$operation(self.1, other.1))
            }
        }
    };
}
pub(crate) use register;

/// [`Work`] in the form that the crate asks for.
pub(crate) struct Call<S, W>(pub S, pub W);

impl<S: Simd, W: Work> pulp::NullaryFnOnce for Call<S, W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.1.run(self.0)
    }
}
