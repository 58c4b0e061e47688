//! The cube root of the element loop: nothing but integer operations, additions and multiplications, so that it becomes
//! vectors and gives the same bits on every target.

use crate::number::math::THIRD;
use crate::number::vector::Vector;

/// x^(-1/3) of a normal positive number.
///
/// Method: a guess from a third of the exponent (error below 3.7 %), then two steps of fourth order,
/// y <- y (1 + r/3 + 2 r^2/9 + 14 r^3/81) with r = 1 - x y^3, which wait less for each other than Newton's four.
/// Error: below 8e-16 (5e-7 in single precision) relative. Numbers below the smallest normal one, infinity and NaN give no
/// meaningful value; a step with such a Jacobian is an error.
#[inline(always)]
pub fn inverse_cbrt<V: Vector>(x: V) -> V {
    let mut y = x.guess_inverse_cbrt();
    for _ in 0..2 {
        // -r, so that it takes an addition.
        let r = ((y * y) * (x * y)).add_scalar(-1.0);
        let series = r.mul_scalar(2.0 / 9.0).add_scalar(-THIRD) - (r * r).mul_scalar(14.0 / 81.0);
        y = y + (y * r) * series;
    }
    y
}

#[cfg(test)]
#[allow(clippy::useless_conversion, reason = "only in double precision")]
mod tests {
    use super::*;
    use crate::number::real::Real;

    /// The error that the documentation states.
    const STATED: f64 = if cfg!(feature = "single") { 5e-7 } else { 8e-16 };

    /// Numbers from 2^-octaves to 2^octaves, every region of the mantissa, without a random source.
    fn samples(octaves: f64) -> impl Iterator<Item = Real> {
        (0..400_000).map(move |i| libm::exp2(octaves * (f64::from(i) / 200_000.0 - 1.0)) as Real)
    }

    fn assert_inverse_cbrt(x: Real) {
        let error = (f64::from(inverse_cbrt(x)) * libm::cbrt(f64::from(x)) - 1.0).abs();
        assert!(error < STATED, "inverse_cbrt({x:e}) is off by {error:e}");
    }

    #[test]
    fn inverse_cbrt_stays_within_its_stated_error() {
        let octaves = f64::from(Real::MAX_EXP - 2);
        samples(8.0).chain(samples(octaves)).for_each(assert_inverse_cbrt);
        [Real::MIN_POSITIVE, 511.0, 512.0, 513.0, 1e4, Real::MAX].into_iter().for_each(assert_inverse_cbrt);
    }
}
