//! The error function with a fixed sequence of operations, for the softening of [`crate::material`].

use crate::number::power;
use crate::number::real::consts::LOG2_E;
use crate::number::real::{ERF, Real};
use crate::number::vector::{Simd, Vector};

/// The error function of a number and its integral from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorFunction<V> {
    /// erf(x).
    pub value: V,
    /// The integral of erf from 0 to x: x erf(x) + (e^(-x^2) - 1) / sqrt(pi).
    pub integral: V,
}

/// erf(x) and its integral for x >= 0.
///
/// Method: erf(x) = 1 - e^(-x^2) + x e^(-x^2) (1 - e^(x^2) erfc(x)) / x, a sum without a difference, whose last quotient is
/// 8 / (x + 4) times a polynomial of (x - 4) / (x + 4), of degree 16 (8 in single precision) through Chebyshev's points between 0
/// and 6. Beyond 6 the value is that of 6, which is 1 but for 2e-17.
/// Error: below 1e-15 (5e-7) relative, of the integral below 4e-15 (2e-6); both are 0 at 0. A NaN gives NaN.
#[inline(always)]
pub fn erf_of_positive<S: Simd>(simd: S, x: S::Vector) -> ErrorFunction<S::Vector> {
    let most = simd.splat(MOST);
    let near = x.select_greater(most, most, x);
    let [gauss, _] = power::exp2_of_both_signs((near * near).mul_scalar(-LOG2_E));
    let inverse = simd.splat(1.0) / near.add_scalar(CENTRE);
    let u = near.add_scalar(-CENTRE) * inverse;
    let mut sum = simd.splat(0.0);
    for coefficient in ERF.iter().rev() {
        sum = (sum * u).add_scalar(*coefficient);
    }
    let value = gauss.whole * (near * (inverse * sum)) - gauss.exp2_m1;
    ErrorFunction { value, integral: x * value + gauss.exp2_m1.mul_scalar(INVERSE_SQRT_PI) }
}

/// From here on erf is 1.
const MOST: Real = 6.0;

/// Where the polynomial's variable is 0.
const CENTRE: Real = 4.0;

/// 1 / sqrt(pi), rounded once.
#[allow(clippy::excessive_precision, reason = "more digits than single precision has")]
const INVERSE_SQRT_PI: Real = 0.564_189_583_547_756_3;

#[cfg(test)]
#[allow(clippy::useless_conversion, clippy::excessive_precision, reason = "only in one of the precisions")]
mod tests {
    use super::*;
    use crate::number::vector::Scalar;

    /// The errors that the documentation states, of value and integral.
    const STATED: [f64; 2] = if cfg!(feature = "single") { [5e-7, 2e-6] } else { [1e-15, 4e-15] };

    /// x with erf(x) and its integral from 0, to twenty digits.
    ///
    /// Source: mpmath 1.3 with 50 digits, of x as it is in both precisions.
    const REFERENCE: &[(f64, f64, f64)] = &[
        (9.313_225_746_154_785e-10, 1.050_884_991_041_862_01e-9, 4.893_564_577_409_355_01e-19),
        (9.536_743_164_062_5e-07, 1.076_106_230_826_540_46e-6, 5.131_274_370_320_814_03e-13),
        (0.000_976_562_5, 0.001_101_932_430_071_814_7, 5.380_530_298_922_101_55e-7),
        (0.031_25, 0.035_250_373_867_322_826, 0.000_550_876_732_175_816_161),
        (0.25, 0.276_326_390_168_236_933, 0.034_899_078_682_360_068),
        (0.5, 0.520_499_877_813_046_538, 0.135_451_644_826_489_379),
        (0.75, 0.711_155_633_653_515_132, 0.290_642_676_289_983_726),
        (1.0, 0.842_700_792_949_714_869, 0.486_064_958_112_255_934),
        (1.5, 0.966_105_146_475_310_727, 0.944_433_280_777_024_489),
        (2.0, 0.995_322_265_018_952_734, 1.436_788_439_167_195_21),
        (2.5, 0.999_593_047_982_555_041, 1.935_882_178_523_807_67),
        (3.0, 0.999_977_909_503_001_415, 2.435_813_771_487_221_33),
        (3.75, 0.999_999_886_272_743_43, 3.185_810_430_691_127_19),
        (4.5, 0.999_999_999_803_383_956, 3.935_810_416_473_124_46),
        (5.5, 0.999_999_999_999_992_642, 4.935_810_416_452_244_36),
        (6.0, 0.999_999_999_999_999_978, 5.435_810_416_452_243_71),
        (8.0, 1.0, 7.435_810_416_452_243_71),
        (100.0, 1.0, 99.435_810_416_452_243_7),
    ];

    #[test]
    fn values_and_integrals_stay_within_their_stated_errors() {
        for (x, value, integral) in REFERENCE {
            let found = erf_of_positive(Scalar, *x as Real);
            let errors = [f64::from(found.value) / value, f64::from(found.integral) / integral];
            for (error, bound) in errors.into_iter().zip(STATED) {
                assert!((error - 1.0).abs() < bound, "{x}: {found:?}, not {value} and {integral}");
            }
        }
    }

    /// Between the references, against `libm`.
    #[test]
    #[cfg(not(feature = "single"))]
    fn values_follow_those_of_libm() {
        for i in 1..200_000 {
            let x = 7.0 * f64::from(i) / 200_000.0;
            let (found, expected) = (erf_of_positive(Scalar, x).value, libm::erf(x));
            assert!((found / expected - 1.0).abs() < STATED[0], "{x}: {found}, not {expected}");
        }
    }

    #[test]
    fn ends_are_harmless() {
        assert_eq!(erf_of_positive(Scalar, 0.0), ErrorFunction { value: 0.0, integral: 0.0 });
        assert_eq!(erf_of_positive(Scalar, 1e9).value, 1.0);
        assert!(erf_of_positive(Scalar, Real::NAN).value.is_nan());
    }
}
