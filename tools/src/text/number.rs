//! Numbers as people read them.

/// `value` with four significant digits, in powers of ten where it is small.
pub fn four_digits(value: f64) -> String {
    let magnitude = value.abs();
    if magnitude > 0.0 && magnitude < 1e-2 {
        return format!("{value:.3e}");
    }
    let power = if magnitude > 0.0 { magnitude.log10().floor() as i32 } else { 0 };
    format!("{value:.*}", usize::try_from(3 - power).unwrap_or_default())
}

/// A number as short as it goes, without the noise of a change of units.
pub fn short(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    if rounded == 0.0 { "0".into() } else { format!("{rounded}") }
}

/// The round numbers about `value`, which is positive: 1, 2, 5 and 10 times the power of ten below it.
pub fn round_numbers(value: f64) -> [f64; 4] {
    let power = 10f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power)
}

/// Digits after the point that tell multiples of a round `interval` apart.
pub fn decimals(interval: f64) -> usize {
    let is_whole = |value: f64| (value - value.round()).abs() < 1e-6 * value.abs();
    (0..9).find(|decimals| is_whole(interval * 10f64.powi(*decimals))).unwrap_or_default() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_show_four_significant_digits() {
        for (value, text) in [
            (5302.54, "5303"),
            (16.412, "16.41"),
            (0.77317, "0.7732"),
            (-0.018984, "-0.01898"),
            (1.438e-4, "1.438e-4"),
            (0.0, "0.000"),
            (123456.7, "123457"),
        ] {
            assert_eq!(four_digits(value), text);
        }
    }

    #[test]
    fn short_numbers_have_no_noise() {
        assert_eq!((short(0.1 + 0.2), short(-1e-9), short(1e3 * 0.0147)), ("0.3".into(), "0".into(), "14.7".into()));
    }
}
