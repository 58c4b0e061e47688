//! Logarithms and powers of base 2 with a fixed sequence of operations, for the laws with real exponents.
//!
//! Like the roots of [`crate::number::math`], they are made of integer operations on the bits and of the four operations of IEEE
//! 754, without a branch or a table: the same bits in vectors of every width and on every target. With base 2, splitting off
//! the exponent rounds nothing. The coefficients in [`crate::number::real`] interpolate at Chebyshev's points.

use crate::number::real::{COSH, LOG2, Real, SINH};
use crate::number::vector::{ROUNDING, Simd, Vector};

/// Binary logarithm of a normal positive number.
///
/// Method: with an integer k near the logarithm, a = 2^k (1 + t) / (1 - t) where |t| < 0.2004, and the logarithm is
/// k + 2 atanh(t) / ln 2, of which eight terms are taken (four in single precision).
/// Error: below 6e-16 (3e-7) relative, near 1 as well. Zero and negative numbers give no meaningful value, a NaN gives NaN.
#[inline(always)]
pub fn log2<S: Simd>(simd: S, a: S::Vector) -> S::Vector {
    let [exponent, power] = a.binary_exponent(simd.splat(1.0));
    exponent + log2_of_ratio((a - power) / (a + power))
}

/// [`log2`] of many numbers, of the same bits: side by side, so that none waits and each constant is fetched once.
#[inline(always)]
pub fn log2_of_all<S: Simd, const M: usize, const N: usize>(simd: S, a: [[S::Vector; M]; N]) -> [[S::Vector; M]; N] {
    let (one, mut exponents, mut ratios, mut squares) = (simd.splat(1.0), a, a, a);
    for i in 0..N {
        for j in 0..M {
            let [exponent, power] = a[i][j].binary_exponent(one);
            let ratio = (a[i][j] - power) / (a[i][j] + power);
            (exponents[i][j], ratios[i][j], squares[i][j]) = (exponent, ratio, ratio * ratio);
        }
    }
    let sums = polynomials(squares, &LOG2);
    for i in 0..N {
        for j in 0..M {
            exponents[i][j] = exponents[i][j] + ratios[i][j] * sums[i][j];
        }
    }
    exponents
}

/// Binary logarithm of a / b for normal positive numbers, given `difference` = a - b; as [`log2`], whose error it has
/// however near to each other a and b are, if `difference` is exact.
#[inline(always)]
pub fn log2_of_quotient<S: Simd>(simd: S, a: S::Vector, b: S::Vector, difference: S::Vector) -> S::Vector {
    let [exponent, power] = a.binary_exponent(b);
    let scaled = power * b;
    let numerator = (exponent * exponent).select_greater(simd.splat(0.0), a - scaled, difference);
    exponent + log2_of_ratio(numerator / (a + scaled))
}

/// log2((1 + t) / (1 - t)) for |t| < 0.2004.
#[inline(always)]
fn log2_of_ratio<V: Vector>(t: V) -> V {
    t * polynomial(t * t, &LOG2)
}

/// A power of 2, and how far it is from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power<V> {
    /// 2^x.
    pub whole: V,
    /// 2^x - 1.
    pub exp2_m1: V,
}

/// 2^x and 2^-x for x between plus and minus [`crate::number::real::LARGEST_EXPONENT`].
///
/// Method: x = k + f with an integer k and |f| <= 1/2; then cosh(f ln 2) - 1 and sinh(f ln 2), of which five and six terms
/// are taken (three and four in single precision), serve both.
/// Error: below 5e-16 (3e-7) relative, in the difference from 1 as well, however small x is. Beyond the domain there is no
/// meaningful value, a NaN gives NaN.
#[inline(always)]
pub fn exp2_of_both_signs<V: Vector>(x: V) -> [Power<V>; 2] {
    let rounded = x.add_scalar(ROUNDING);
    let fraction = x - rounded.add_scalar(-ROUNDING);
    let [power, inverse] = rounded.powers_of_two();
    let square = fraction * fraction;
    let odd = fraction * polynomial(square, &SINH);
    let even = square * polynomial(square, &COSH);
    let (more, further) = (power * (even + odd), inverse * (even - odd));
    [
        Power { whole: power + more, exp2_m1: power.add_scalar(-1.0) + more },
        Power { whole: inverse + further, exp2_m1: inverse.add_scalar(-1.0) + further },
    ]
}

/// 2^x - 1 of many numbers as [`exp2_of_both_signs`] gives it, of the same bits: side by side, so that none waits and each
/// constant is fetched once.
#[inline(always)]
pub fn exp2_m1_of_all<V: Vector, const M: usize, const N: usize>(x: [[V; M]; N]) -> [[V; M]; N] {
    let (mut powers, mut fractions, mut squares) = (x, x, x);
    for i in 0..N {
        for j in 0..M {
            let rounded = x[i][j].add_scalar(ROUNDING);
            let fraction = x[i][j] - rounded.add_scalar(-ROUNDING);
            let [power, _] = rounded.powers_of_two();
            (powers[i][j], fractions[i][j], squares[i][j]) = (power, fraction, fraction * fraction);
        }
    }
    let (odd, even) = (polynomials(squares, &SINH), polynomials(squares, &COSH));
    for i in 0..N {
        for j in 0..M {
            let more = powers[i][j] * (squares[i][j] * even[i][j] + fractions[i][j] * odd[i][j]);
            powers[i][j] = powers[i][j].add_scalar(-1.0) + more;
        }
    }
    powers
}

/// [`polynomial`] of many numbers.
#[inline(always)]
fn polynomials<V: Vector, const M: usize, const N: usize, const C: usize>(
    x: [[V; M]; N],
    coefficients: &[Real; C],
) -> [[V; M]; N] {
    let mut sums = x;
    for i in 0..N {
        for j in 0..M {
            sums[i][j] = x[i][j].mul_scalar(coefficients[C - 1]);
        }
    }
    for k in 2..C {
        for i in 0..N {
            for j in 0..M {
                sums[i][j] = sums[i][j].add_scalar(coefficients[C - k]) * x[i][j];
            }
        }
    }
    for i in 0..N {
        for j in 0..M {
            sums[i][j] = sums[i][j].add_scalar(coefficients[0]);
        }
    }
    sums
}

/// Horner's scheme, from the coefficient of 1 on.
#[inline(always)]
fn polynomial<V: Vector, const N: usize>(x: V, coefficients: &[Real; N]) -> V {
    let mut sum = x.mul_scalar(coefficients[N - 1]);
    for i in 2..N {
        sum = sum.add_scalar(coefficients[N - i]) * x;
    }
    sum.add_scalar(coefficients[0])
}

#[cfg(test)]
#[allow(clippy::useless_conversion, reason = "only in double precision")]
mod tests {
    use core::f64::consts::{LN_2, LOG2_E};

    use super::*;
    use crate::number::real::LARGEST_EXPONENT;
    use crate::number::vector::Scalar;

    /// The errors that the documentation states, of logarithms and of powers.
    const STATED: [f64; 2] = if cfg!(feature = "single") { [3e-7; 2] } else { [6e-16, 5e-16] };

    /// What the constants lack.
    const LN_2_REST: f64 = 2.319_046_813_846_299_6e-17;
    const LOG2_E_REST: f64 = 2.035_527_374_093_103_3e-17;

    /// log2(1 + d) by `libm`, with the rounding of the product by 1 / ln 2 made good.
    fn reference_log2(d: f64) -> f64 {
        let ln = libm::log1p(d);
        let product = ln * LOG2_E;
        product + (libm::fma(ln, LOG2_E, -product) + ln * LOG2_E_REST)
    }

    /// 2^x - 1 by `libm`, with the rounding of the product by ln 2 made good.
    fn reference_exp2_m1(x: f64) -> f64 {
        if x.abs() > 1.0 {
            return libm::exp2(x) - 1.0;
        }
        let product = x * LN_2;
        let rest = libm::fma(x, LN_2, -product) + x * LN_2_REST;
        libm::expm1(product) + rest * libm::exp(product)
    }

    /// Sizes from 2^-`octaves` to 1, every region of the mantissa, without a random source.
    fn sizes(octaves: f64) -> impl Iterator<Item = Real> {
        (0..200_000).map(move |i| libm::exp2(octaves * (f64::from(i) / 200_000.0 - 1.0)) as Real)
    }

    fn assert_close(found: Real, expected: f64, bound: f64, of: Real) {
        let error = (f64::from(found) / expected - 1.0).abs();
        assert!(error < bound, "{found} of {of} is off by {error}, expected {expected}");
    }

    #[test]
    fn logarithms_stay_within_their_stated_error() {
        for (size, sign) in sizes(60.0).flat_map(|size| [(size, 1.0), (size, -0.999)]) {
            let a = 1.0 + sign * size;
            if a != 1.0 {
                assert_close(log2(Scalar, a), reference_log2(f64::from(a) - 1.0), STATED[0], a);
            }
        }
        for size in sizes(f64::from(LARGEST_EXPONENT)).filter(|size| *size < 0.5) {
            for a in [size, 1.0 / size] {
                assert_close(log2(Scalar, a), libm::log2(f64::from(a)), STATED[0], a);
                assert_eq!(log2_of_all(Scalar, [[a, 1.0 + a]]), [[log2(Scalar, a), log2(Scalar, 1.0 + a)]]);
            }
        }
    }

    /// Whatever the size of both numbers, and on both sides of where the integer changes.
    #[test]
    fn logarithms_of_quotients_stay_within_their_stated_error() {
        let far = if cfg!(feature = "single") { [3e-20, 5e20] } else { [3e-200, 5e200].map(|b: f64| b as Real) };
        for b in [1.0, 1.499_999, 1.5, 1.999_999].into_iter().chain(far) {
            for d in sizes(70.0).map(|size| 3.0 * size) {
                let a = b + b * d;
                // The sum rounds, which matters where the difference is not what is used.
                let difference = if d < 1e-3 { b * d } else { a - b };
                let expected = reference_log2(f64::from(difference) / f64::from(b));
                assert_close(log2_of_quotient(Scalar, a, b, difference), expected, STATED[0], d);
                assert_close(log2_of_quotient(Scalar, b, a, -difference), -expected, STATED[0], d);
            }
        }
    }

    #[test]
    fn powers_stay_within_their_stated_error() {
        for x in sizes(60.0).chain(sizes(10.0).map(|size| LARGEST_EXPONENT * size)) {
            let found = exp2_of_both_signs(x);
            for (found, x) in found.into_iter().zip([x, -x]) {
                assert_close(found.whole, libm::exp2(f64::from(x)), STATED[1], x);
                assert_close(found.exp2_m1, reference_exp2_m1(f64::from(x)), STATED[1], x);
            }
            let [power, inverse] = found;
            assert_eq!(exp2_of_both_signs(-x), [inverse, power]);
            assert_eq!(exp2_m1_of_all([[x], [-x]]), [[power.exp2_m1], [inverse.exp2_m1]]);
        }
    }

    #[test]
    fn known_values_are_exact() {
        assert_eq!(log2(Scalar, 1.0), 0.0);
        assert_eq!(exp2_of_both_signs(0.0), [Power { whole: 1.0, exp2_m1: 0.0 }; 2]);
        let largest = LARGEST_EXPONENT as i32;
        for k in -largest..=largest {
            let (k, power) = (k as Real, libm::exp2(f64::from(k)) as Real);
            assert_eq!(log2(Scalar, power), k);
            let exact = [power, 1.0 / power].map(|whole| Power { whole, exp2_m1: whole - 1.0 });
            assert_eq!(exp2_of_both_signs(k), exact);
        }
    }

    /// Nothing is a panic, and what is not a number stays so.
    #[test]
    fn beyond_their_domain_they_are_harmless() {
        let (least, most) = (Real::from_bits(1), Real::MAX);
        let numbers =
            [0.0, -0.0, 1.0, -1.0, least, 0.1 * most, -0.1 * most, most, Real::INFINITY, -Real::INFINITY, Real::NAN];
        for (a, b) in numbers.into_iter().flat_map(|a| numbers.map(|b| (a, b))) {
            let log = log2_of_quotient(Scalar, a, b, a - b);
            assert!(log.is_nan() || !(a.is_nan() || b.is_nan()), "{a} over {b} is {log}");
        }
        for x in numbers {
            let powers = exp2_of_both_signs(x);
            assert!(powers.iter().all(|power| power.whole.is_nan()) || !x.is_nan(), "{x} is {powers:?}");
        }
    }
}
