//! Scalar mathematics with a fixed sequence of operations: the only user of `libm`, and the two roots of the hot loop.
//!
//! [`inverse_sqrt`] and [`inverse_cbrt`] use nothing but integer shifts, additions and multiplications, so that they
//! vectorise and give the same bits on every target, with or without a hardware square root.

use crate::real::{self, Real};
use crate::vector::Vector;

pub use crate::real::{ceil, cos, exp, ln, round, sin, sqrt};

/// Absolute value.
#[inline(always)]
pub fn abs(x: Real) -> Real {
    if x < 0.0 { -x } else { x }
}

/// The larger of two numbers by comparison alone (no IEEE `max`, whose signed-zero case differs between targets).
#[inline(always)]
pub fn larger<V: Vector>(a: V, b: V) -> V {
    a.if_greater(b, a, b)
}

/// x^(-1/2) for normal x > 0.
///
/// Method: a guess from the halved exponent (error below 3.5 %), then four Newton steps y <- y (3 - x y^2) / 2.
/// Error: below 4e-16 relative. Zero gives a large finite number, a negative number or NaN gives no meaningful value.
#[inline(always)]
pub fn inverse_sqrt<V: Vector>(x: V) -> V {
    let mut y = x.guess_inverse_sqrt();
    let half = x.times(-0.5);
    for _ in 0..real::NEWTON_STEPS {
        y = y * (half * y * y).plus(1.5);
    }
    y
}

/// x^(-1/3) for x between 2^-8 and 2^8.
///
/// Method: a guess from a third of the exponent (error below 3.7 %), then four Newton steps y <- y + y (1 - x y^3) / 3.
/// Error: below 8e-16 relative. Zero, negative numbers and NaN give no meaningful value; the caller checks the Jacobian.
#[inline(always)]
pub fn inverse_cbrt<V: Vector>(x: V) -> V {
    let mut y = x.guess_inverse_cbrt();
    // A negative third of x, so that the step is a multiplication and two additions more.
    let third = x.times(-THIRD);
    for _ in 0..real::NEWTON_STEPS {
        y = y + y * (third * (y * y * y)).plus(THIRD);
    }
    y
}

/// 1/3, rounded once.
const THIRD: Real = 1.0 / 3.0;

#[cfg(all(test, not(feature = "single")))]
mod tests {
    use super::*;

    /// Numbers from 2^-octaves to 2^octaves, every region of the mantissa, without a random source.
    fn samples(octaves: f64) -> impl Iterator<Item = f64> {
        (0..400_000).map(move |i| libm::exp2(octaves * (f64::from(i) / 200_000.0 - 1.0)))
    }

    #[test]
    fn inverse_sqrt_stays_within_its_stated_error() {
        for x in samples(40.0) {
            let error = (inverse_sqrt(x) * libm::sqrt(x) - 1.0).abs();
            assert!(error < 4e-16, "inverse_sqrt({x}) is off by {error}");
        }
    }

    #[test]
    fn inverse_cbrt_stays_within_its_stated_error() {
        for x in samples(8.0) {
            let error = (inverse_cbrt(x) * libm::cbrt(x) - 1.0).abs();
            assert!(error < 8e-16, "inverse_cbrt({x}) is off by {error}");
        }
    }

    #[test]
    fn the_root_of_nothing_is_finite() {
        assert!(inverse_sqrt(0.0).is_finite());
    }
}
