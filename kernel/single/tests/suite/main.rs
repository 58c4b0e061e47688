//! What differs in single precision: the cube root, logarithms, powers and numbers as text. The physics is held by the traces of
//! `tests/golden/single` and by the comparison with double precision in `tests/verification`.

// The references are the platform's, in double precision.
#![allow(clippy::disallowed_methods)]

use softanvil_kernel_f32::SAMPLING_INTERVAL;
use softanvil_kernel_f32::cfc::Coefficients;
use softanvil_kernel_f32::number::cube_root;
use softanvil_kernel_f32::number::decimal::Decimal;
use softanvil_kernel_f32::number::power::{exp2_of_both_signs, log2, log2_of_quotient};
use softanvil_kernel_f32::number::real::LARGEST_EXPONENT;
use softanvil_kernel_f32::number::vector::Scalar;

/// Numbers from 2^-octaves to 2^octaves, every region of the mantissa, without a random source.
fn samples(octaves: f64) -> impl Iterator<Item = f32> {
    (0..400_000).map(move |i| (octaves * (f64::from(i) / 200_000.0 - 1.0)).exp2() as f32)
}

#[test]
fn inverse_cbrt_stays_within_its_stated_error() {
    for x in samples(8.0) {
        let error = (f64::from(cube_root::inverse_cbrt(x)) * f64::from(x).cbrt() - 1.0).abs();
        assert!(error < 2e-7, "inverse_cbrt({x}) is off by {error}");
    }
}

#[test]
fn logarithms_stay_within_their_stated_error() {
    for a in samples(100.0).filter(|a| *a != 1.0) {
        let error = (f64::from(log2(Scalar, a)) / f64::from(a).log2() - 1.0).abs();
        assert!(error < 3e-7, "log2({a}) is off by {error}");
    }
    for difference in samples(80.0).filter(|difference| *difference < 3.0) {
        let a = 1.5 + difference;
        // The sum rounds, which matters where the difference is not what is used.
        let difference = if difference < 1e-2 { difference } else { a - 1.5 };
        let expected = (f64::from(difference) / 1.5).ln_1p() / std::f64::consts::LN_2;
        let error = (f64::from(log2_of_quotient(Scalar, a, 1.5, difference)) / expected - 1.0).abs();
        assert!(error < 3e-7, "log2({a} / 1.5) is off by {error}");
    }
}

#[test]
fn powers_stay_within_their_stated_error() {
    for x in samples(100.0).filter(|x| *x < LARGEST_EXPONENT) {
        for (found, x) in exp2_of_both_signs(x).into_iter().zip([x, -x]) {
            let exponent = f64::from(x) * std::f64::consts::LN_2;
            for (found, expected) in [(found.whole, exponent.exp()), (found.exp2_m1, exponent.exp_m1())] {
                let error = (f64::from(found) / expected - 1.0).abs();
                assert!(error < 3e-7, "2^{x} is off by {error}");
            }
        }
    }
}

#[test]
fn short_numbers_read_as_they_are_written() {
    for (value, text) in [
        (0.0, "0"),
        (14.7, "14.7"),
        (5e-5, "0.00005"),
        (0.1 + 0.2, "0.3"),
        (999_999.96, "1000000"),
        (-1.0 / 3.0, "-0.333333"),
        (1e16, "1e16"),
        (f32::MAX, "3.40282e38"),
        (f32::MIN_POSITIVE, "1.17549e-38"),
        (f32::NAN, "NaN"),
        (f32::INFINITY, "inf"),
    ] {
        assert_eq!(Decimal(value).to_string(), text);
    }
}

#[test]
fn what_is_read_back_agrees_to_the_last_digit_shown() {
    let mut bits: u32 = 1;
    for _ in 0..100_000 {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let value = f32::from_bits(bits);
        if value.is_normal() {
            let read: f64 = Decimal(value).to_string().parse().unwrap();
            let error = (read / f64::from(value) - 1.0).abs();
            assert!(error <= 0.6e-5, "{value:e} reads {read:e}");
        }
    }
}

/// A tenth of the sampling rate is legal, though neither it nor the interval is a round number here.
#[test]
fn the_highest_channel_class_is_legal() {
    assert!(Coefficients::new(2000.0, SAMPLING_INTERVAL).is_ok());
    assert!(Coefficients::new(2001.0, SAMPLING_INTERVAL).is_err());
}
