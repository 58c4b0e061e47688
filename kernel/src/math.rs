//! Scalar mathematics with a fixed sequence of operations: the only user of `libm`, and the two roots of the hot loop.
//!
//! [`inverse_sqrt`] and [`inverse_cbrt`] use nothing but integer shifts, additions and multiplications, so that they
//! vectorise and give the same bits on every target, with or without a hardware square root.

/// e^x, from libm.
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// e^x - 1 without cancellation, from libm.
pub fn expm1(x: f64) -> f64 {
    libm::expm1(x)
}

/// Natural logarithm, from libm.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// ln(1 + x) without cancellation, from libm.
pub fn ln_1p(x: f64) -> f64 {
    libm::log1p(x)
}

/// Hyperbolic sine, from libm; accurate relative to itself down to zero.
pub fn sinh(x: f64) -> f64 {
    libm::sinh(x)
}

/// Inverse hyperbolic sine, from libm; accurate relative to itself down to zero.
pub fn asinh(x: f64) -> f64 {
    libm::asinh(x)
}

/// Square root, from libm (correctly rounded).
pub fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// Sine, from libm.
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine, from libm.
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Smallest integer not below x, from libm.
pub fn ceil(x: f64) -> f64 {
    libm::ceil(x)
}

/// Nearest integer, halves away from zero, from libm.
pub fn round(x: f64) -> f64 {
    libm::round(x)
}

/// Absolute value.
#[inline(always)]
pub fn abs(x: f64) -> f64 {
    if x < 0.0 { -x } else { x }
}

/// The larger of two numbers by comparison alone (no IEEE `max`, whose signed-zero case differs between targets).
#[inline(always)]
pub fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// x^(-1/2) for normal x > 0.
///
/// Method: a guess from the halved exponent (error below 3.5 %), then four Newton steps y <- y (3 - x y^2) / 2.
/// Error: below 4e-16 relative. Zero gives a large finite number, a negative number or NaN gives no meaningful value.
#[inline(always)]
pub fn inverse_sqrt(x: f64) -> f64 {
    let mut y = f64::from_bits(0x5fe6_eb50_c7b5_37a9_u64.wrapping_sub(x.to_bits() >> 1));
    let half = 0.5 * x;
    for _ in 0..4 {
        y *= 1.5 - half * y * y;
    }
    y
}

/// x^(-1/3) for x between 2^-8 and 2^8.
///
/// Method: a guess from a third of the exponent, the division by three written as shifts (error below 5.5 %), then
/// four Newton steps y <- y (4 - x y^3) / 3. Error: below 8e-16 relative. Zero, negative numbers and NaN give no
/// meaningful value; the caller checks the Jacobian.
#[inline(always)]
pub fn inverse_cbrt(x: f64) -> f64 {
    let bits = x.to_bits();
    let third = (bits >> 2) + (bits >> 4) + (bits >> 6) + (bits >> 8);
    let mut y = f64::from_bits(INVERSE_CBRT_MAGIC.wrapping_sub(third));
    for _ in 0..4 {
        y += y * (1.0 - x * (y * y * y)) * THIRD;
    }
    y
}

/// 1/3, rounded once.
const THIRD: f64 = 1.0 / 3.0;

/// Chosen so that the guess of [`inverse_cbrt`] has its smallest error around x = 1.
const INVERSE_CBRT_MAGIC: u64 = 0x5529_8000_0000_0000;

#[cfg(test)]
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
