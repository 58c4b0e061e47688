//! Vectors: as many neighbours of a [`Pack`] as one register of the processor holds.
//!
//! The element loop is written once, for any [`Simd`]; compilers turn loops over lanes into vectors only where
//! they see fit. Every operation works lane by lane and rounds as IEEE 754 says, so the width changes no bit.

use core::ops::{Add, Div, Mul, Sub};

use crate::number::math;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::{self, Bits, FRACTION_BITS, Real, SignedBits};

/// The bits of 1.
const ONE: Bits = (1.0 as Real).to_bits();

/// Half the distance of the bits of a number and of its double.
const HALF_OCTAVE: Bits = 1 << (FRACTION_BITS - 1);

/// From here on, neighbouring numbers are one apart, and the low bits count them.
const INTEGERS: Real = ((1 as Bits) << FRACTION_BITS) as Real;

/// The exponent of 1 as it stands in the bits, above [`INTEGERS`].
const BIASED_INTEGERS: Real = INTEGERS + (ONE >> FRACTION_BITS) as Real;

/// What rounds a smaller number to an integer when it is added: the integer stands in the low bits of the sum.
pub const ROUNDING: Real = 1.5 * INTEGERS;

/// The whole number `x`, far below [`ROUNDING`]: without the look at its size that a conversion takes.
#[inline(always)]
pub fn small_integer(x: Real) -> isize {
    (x + ROUNDING).to_bits().wrapping_sub(ROUNDING.to_bits()) as SignedBits as isize
}

/// Numbers of neighbouring cells.
///
/// A set has the four operations, the square root and a choice. What is made of single numbers here (a shift, and integer
/// operations on the bits) compilers turn into vectors: with AVX2 a step takes no more instructions than with those written out.
pub trait Vector: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// The instruction set.
    type Set: Simd<Vector = Self>;

    /// The instruction set of these.
    fn set(self) -> Self::Set;

    /// `then` where this is larger than `other`, `otherwise` elsewhere and where either is not a number.
    fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self;

    /// Square root, rounded as IEEE 754 says.
    fn square_root(self) -> Self;

    /// Adds the same number to each.
    #[inline(always)]
    fn add_scalar(self, number: Real) -> Self {
        self + self.set().splat(number)
    }

    /// Multiplies each by the same number.
    #[inline(always)]
    fn mul_scalar(self, number: Real) -> Self {
        self * self.set().splat(number)
    }

    /// The larger number where this and `other` are numbers, `other` elsewhere.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.select_greater(other, self, other)
    }

    /// Each moved on by one place, the first from the end of `before`.
    #[inline(always)]
    fn shift(self, before: Self) -> Self {
        let (mut these, mut earlier, mut shifted) = (ZERO, ZERO, ZERO);
        self.set().store(self, &mut these, 0);
        self.set().store(before, &mut earlier, 0);
        for l in 0..Self::Set::WIDTH.min(LANES) {
            shifted[l] = if l > 0 { these[l - 1] } else { earlier[(Self::Set::WIDTH - 1) % LANES] };
        }
        self.set().load(&shifted, 0)
    }

    /// [`real::INVERSE_CBRT_MAGIC`] and a third of the bits from these to [`real::CBRT_END`].
    #[inline(always)]
    fn guess_inverse_cbrt(self) -> Self {
        let [guess] = self.set().map([self], |[x]| [guess_inverse_cbrt(x)]);
        guess
    }

    /// An integer k near the binary logarithm of this over `other`, and 2^k. It is the difference of the bits, which are
    /// that logarithm to a line between powers of two, rounded to whole exponents; 0 for numbers next to each other.
    #[inline(always)]
    fn binary_exponent(self, other: Self) -> [Self; 2] {
        self.set().map([self, other], |[x, y]| binary_exponent(x, y))
    }

    /// 2^k and 2^-k for this = [`ROUNDING`] + k with an integer k of at most [`real::LARGEST_EXPONENT`].
    #[inline(always)]
    fn powers_of_two(self) -> [Self; 2] {
        self.set().map([self], |[x]| powers_of_two(x))
    }
}

/// [`Vector::guess_inverse_cbrt`] of a number.
#[inline(always)]
fn guess_inverse_cbrt(x: Real) -> Real {
    let left = real::CBRT_END.wrapping_sub(x.to_bits());
    Real::from_bits(real::INVERSE_CBRT_MAGIC.wrapping_add(real::third(left)))
}

/// [`Vector::binary_exponent`] of numbers.
#[inline(always)]
fn binary_exponent(x: Real, other: Real) -> [Real; 2] {
    let bits = x.to_bits().wrapping_sub(other.to_bits()).wrapping_add(ONE + HALF_OCTAVE);
    let exponent = bits >> FRACTION_BITS;
    let integer = Real::from_bits(exponent | INTEGERS.to_bits());
    [integer - BIASED_INTEGERS, Real::from_bits(exponent << FRACTION_BITS)]
}

/// [`Vector::powers_of_two`] of a number.
#[inline(always)]
fn powers_of_two(x: Real) -> [Real; 2] {
    let exponent = x.to_bits() << FRACTION_BITS;
    [Real::from_bits(ONE.wrapping_add(exponent)), Real::from_bits(ONE.wrapping_sub(exponent))]
}

/// The vectors of an instruction set.
///
/// Everything between a token of a wide set and its instructions must be inlined, which closures and the methods of arrays
/// that take them are not for certain: the code of the element loop is made of functions that say so, and of plain loops.
pub trait Simd: Copy {
    /// A register.
    type Vector: Vector<Set = Self>;
    /// Numbers in it, a divisor of [`LANES`].
    const WIDTH: usize;

    /// The same number everywhere.
    fn splat(self, number: Real) -> Self::Vector;

    /// The `chunk`-th vector of a lane.
    fn load(self, lane: &Pack, chunk: usize) -> Self::Vector;

    /// Writes the `chunk`-th vector of a lane.
    fn store(self, vector: Self::Vector, lane: &mut Pack, chunk: usize);

    /// Does `work` with this set behind a call of its own: what is inlined into one function takes a compiler more than its share
    /// of time, the longer the more.
    fn apart<W: Work>(self, work: W) -> W::Output;

    /// Adds to the `chunk`-th vector of a lane.
    #[inline(always)]
    fn add(self, vector: Self::Vector, lane: &mut Pack, chunk: usize) {
        self.store(self.load(lane, chunk) + vector, lane, chunk);
    }

    /// The `chunk`-th vectors of a pair of lanes.
    #[inline(always)]
    fn load_pair(self, pair: &[Pack; 2], chunk: usize) -> [Self::Vector; 2] {
        [self.load(&pair[0], chunk), self.load(&pair[1], chunk)]
    }

    /// Applies a function without vector instructions to each of the neighbours.
    #[inline(always)]
    fn map<const I: usize, const O: usize>(
        self,
        inputs: [Self::Vector; I],
        function: impl Fn([Real; I]) -> [Real; O],
    ) -> [Self::Vector; O] {
        let (mut given, mut results) = ([ZERO; I], [ZERO; O]);
        for i in 0..I {
            self.store(inputs[i], &mut given[i], 0);
        }
        for l in 0..Self::WIDTH.min(LANES) {
            let mut numbers = [0.0; I];
            for i in 0..I {
                numbers[i] = given[i][l];
            }
            let result = function(numbers);
            for o in 0..O {
                results[o][l] = result[o];
            }
        }
        let mut vectors = [self.splat(0.0); O];
        for o in 0..O {
            vectors[o] = self.load(&results[o], 0);
        }
        vectors
    }
}

impl Vector for Real {
    type Set = Scalar;

    #[inline(always)]
    fn set(self) -> Scalar {
        Scalar
    }

    #[inline(always)]
    fn select_greater(self, other: Self, then: Self, otherwise: Self) -> Self {
        if self > other { then } else { otherwise }
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        math::sqrt(self)
    }
}

/// One number at a time: for processors whose vectors are not used.
#[derive(Clone, Copy, Debug)]
pub struct Scalar;

impl Simd for Scalar {
    type Vector = Real;
    const WIDTH: usize = 1;

    #[inline(always)]
    fn splat(self, number: Real) -> Real {
        number
    }

    #[inline(always)]
    fn load(self, lane: &Pack, chunk: usize) -> Real {
        lane[chunk % LANES]
    }

    #[inline(always)]
    fn store(self, vector: Real, lane: &mut Pack, chunk: usize) {
        lane[chunk % LANES] = vector;
    }

    #[inline(never)]
    fn apart<W: Work>(self, work: W) -> W::Output {
        work.run(self)
    }
}

/// Work that is compiled once per instruction set.
pub trait Work {
    /// What it gives.
    type Output;
    /// Does it with vectors of this set; must be inlined, so that it takes on the instruction set of the caller.
    fn run<S: Simd>(self, simd: S) -> Self::Output;
}
