//! Numbers as text, without a path to a panic, which the formatting of floats in `core` has.

use core::fmt::{self, Write};

use crate::number::real::{self, Real};

/// Shows a number with up to `DIGITS` significant digits: plain where it is short, with a power of ten elsewhere.
#[derive(Clone, Copy, Debug)]
pub struct Decimal(pub Real);

/// Significant digits.
const DIGITS: i32 = real::SHOWN_DIGITS;
/// 10 to the power of [`DIGITS`].
const WHOLE: u64 = 10_u64.pow(DIGITS as u32);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.0;
        if value.is_nan() {
            return f.write_str("NaN");
        }
        if value < 0.0 {
            f.write_char('-')?;
        }
        if value == 0.0 {
            return f.write_char('0');
        }
        if value.is_infinite() {
            return f.write_str("inf");
        }
        let (digits, exponent) = digits(value.abs());
        match exponent {
            0..=15 => plain(f, digits, exponent),
            -6..0 => {
                f.write_str("0.")?;
                (exponent + 1..0).try_for_each(|_| f.write_char('0'))?;
                significant(f, digits, DIGITS)
            }
            _ => scientific(f, digits, exponent),
        }
    }
}

/// The digits of a positive finite number as an integer of [`DIGITS`] digits, and the power of ten of the first.
fn digits(value: Real) -> (u64, i32) {
    let (mut mantissa, mut exponent) = (value, 0);
    for &(power, ten) in real::POWERS_OF_TEN {
        if mantissa >= ten {
            mantissa /= ten;
            exponent += power;
        }
    }
    if mantissa < 1.0 {
        for &(power, ten) in real::POWERS_OF_TEN {
            if mantissa * ten < 10.0 {
                mantissa *= ten;
                exponent -= power;
            }
        }
    }
    let digits = (mantissa * (WHOLE / 10) as Real + 0.5) as u64;
    if digits >= WHOLE { (WHOLE / 10, exponent + 1) } else { (digits, exponent) }
}

/// Digits with the point after the first `exponent + 1`.
fn plain(f: &mut fmt::Formatter<'_>, digits: u64, exponent: i32) -> fmt::Result {
    let before = exponent + 1;
    let mut rest = digits;
    for _ in 0..before {
        rest = leading(f, rest)?;
    }
    if rest == 0 {
        return Ok(());
    }
    f.write_char('.')?;
    significant(f, rest, DIGITS - before)
}

fn scientific(f: &mut fmt::Formatter<'_>, digits: u64, exponent: i32) -> fmt::Result {
    let rest = leading(f, digits)?;
    if rest != 0 {
        f.write_char('.')?;
        significant(f, rest, DIGITS - 1)?;
    }
    f.write_char('e')?;
    if exponent < 0 {
        f.write_char('-')?;
    }
    let size = exponent.unsigned_abs();
    for place in [100, 10, 1] {
        if size >= place {
            f.write_char(digit(u64::from(size / place % 10)))?;
        }
    }
    Ok(())
}

/// At most `count` digits, without zeros at the end.
fn significant(f: &mut fmt::Formatter<'_>, digits: u64, count: i32) -> fmt::Result {
    let mut rest = digits;
    for _ in 0..count {
        if rest == 0 {
            break;
        }
        rest = leading(f, rest)?;
    }
    Ok(())
}

/// Writes the first of [`DIGITS`] digits and moves the others up by one.
fn leading(f: &mut fmt::Formatter<'_>, digits: u64) -> Result<u64, fmt::Error> {
    f.write_char(digit(digits / (WHOLE / 10)))?;
    Ok(digits % (WHOLE / 10) * 10)
}

fn digit(value: u64) -> char {
    char::from(b'0' + (value % 10) as u8)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use std::format;

    /// Of both precisions.
    const SHORT: [(Real, &str); 12] = [
        (0.0, "0"),
        (-1.0, "-1"),
        (14.7, "14.7"),
        (0.001, "0.001"),
        (5e-5, "0.00005"),
        (10000.0, "10000"),
        (0.1 + 0.2, "0.3"),
        (1e16, "1e16"),
        (-2.5e-9, "-2.5e-9"),
        (1e30, "1e30"),
        (Real::NAN, "NaN"),
        (Real::NEG_INFINITY, "-inf"),
    ];

    #[cfg(not(feature = "single"))]
    const LONG: [(Real, &str); 7] = [
        (999_999.999_999_9, "1000000"),
        (1.0 / 3.0, "0.333333333333"),
        (123_456_789_012_345.0, "123456789012000"),
        (1e300, "1e300"),
        (Real::MAX, "1.79769313486e308"),
        (Real::MIN_POSITIVE, "2.22507385851e-308"),
        (5e-324, "4.94065645841e-324"),
    ];
    #[cfg(feature = "single")]
    const LONG: [(Real, &str); 5] = [
        (999_999.94, "1000000"),
        (1.0 / 3.0, "0.333333"),
        (123_456_789.0, "123457000"),
        (Real::MAX, "3.40282e38"),
        (Real::MIN_POSITIVE, "1.17549e-38"),
    ];

    #[test]
    fn short_numbers_read_as_they_are_written() {
        for (value, text) in SHORT.into_iter().chain(LONG) {
            assert_eq!(format!("{}", Decimal(value)), text);
        }
    }

    #[test]
    fn what_is_read_back_agrees_to_the_last_digit_shown() {
        // Half of the last digit, and what the scaling loses.
        let bound = if cfg!(feature = "single") { 0.6e-5 } else { 0.51e-11 };
        let mut bits: u64 = 1;
        for _ in 0..100_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // The upper bits, which are the better ones.
            let value = Real::from_bits((bits >> (u64::BITS - real::Bits::BITS)) as real::Bits);
            if value.is_normal() {
                let read: Real = format!("{}", Decimal(value)).parse().unwrap();
                assert!(((read - value) / value).abs() <= bound, "{value} {read}");
            }
        }
    }
}
