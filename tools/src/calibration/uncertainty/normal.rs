//! The normal distribution: probabilities of intervals, and quantiles of mixtures.

use std::f64::consts::{PI, SQRT_2};

/// Distance in standard deviations beyond which the probability of a tail is its density over the distance, with the next term of
/// that series: the function itself ends where numbers do. What is left out is 4e-6 of it at most.
const FAR: f64 = 30.0;
/// Width of an interval, in standard deviations over which its density falls by e, below which the density is the same all over it.
const NARROW: f64 = 1e-6;

/// Logarithm of the probability that a standard normal number lies between `low` and `high`; of the density where they
/// are the same.
pub fn ln_probability(low: f64, high: f64) -> f64 {
    let middle = 0.5 * (low + high);
    let width = high - low;
    let ln_density = |at: f64| -0.5 * at * at - 0.5 * (2.0 * PI).ln();
    if width <= 0.0 {
        return ln_density(middle);
    }
    if width * middle.abs().max(1.0) < NARROW {
        return ln_density(middle) + width.ln();
    }
    // On the side of the tail, where the difference keeps its digits.
    let (near, far) = if middle >= 0.0 { (low, high) } else { (-high, -low) };
    if near > FAR {
        let tail = |at: f64| (1.0 - 1.0 / (at * at)) / at;
        // Of the far tail against the near one.
        let rest = (-0.5 * width * (near + far)).exp() * tail(far) / tail(near);
        return ln_density(near) + (tail(near) * (1.0 - rest)).ln();
    }
    (0.5 * (libm::erfc(near / SQRT_2) - libm::erfc(far / SQRT_2))).ln()
}

/// The `part` (0 to 1) quantile of a mixture of normal distributions with these means and standard deviations, each of the
/// same weight.
pub fn mixture_quantile(components: &[(f64, f64)], part: f64) -> f64 {
    let below = |value: f64| {
        let parts = components.iter().map(|(mean, deviation)| 0.5 * libm::erfc((mean - value) / (deviation * SQRT_2)));
        parts.sum::<f64>() / components.len() as f64
    };
    let reach = |sign: f64| components.iter().map(move |(mean, deviation)| mean + sign * 8.0 * deviation);
    let mut low = reach(-1.0).fold(f64::INFINITY, f64::min);
    let mut high = reach(1.0).fold(f64::NEG_INFINITY, f64::max);
    // As far as the digits go.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if below(middle) < part { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// The `part` (0 to 1) quantile of numbers, interpolated between neighbours; NaN of none.
pub fn quantile(values: &[f64], part: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = part * last as f64;
    let (below, share) = (place.floor() as usize, place.fract());
    sorted[below] + share * (sorted[(below + 1).min(last)] - sorted[below])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: tables of the normal distribution.
    #[test]
    fn probabilities_are_those_of_the_tables() {
        for (low, high, probability) in
            [(-1.0, 1.0, 0.682_689_492_137), (1.0, 2.0, 0.135_905_121_983), (-9.0, 0.0, 0.5)]
        {
            assert!((ln_probability(low, high).exp() - probability).abs() < 1e-10);
            assert!((ln_probability(-high, -low) - ln_probability(low, high)).abs() < 1e-12);
        }
        // Far out, where the tail is exp(-x^2/2) / (x sqrt(2 pi)) (1 - 1/x^2).
        let tail = -0.5 * 20f64.powi(2) - (20.0 * (2.0 * PI).sqrt()).ln() + (1.0 - 1.0 / 400.0f64).ln();
        assert!((ln_probability(20.0, 25.0) - tail).abs() < 1e-4);
        assert!(ln_probability(200.0, 201.0).is_finite());
    }

    /// Source: all of a half is 1/2, and the tail begins where the function ends.
    #[test]
    fn a_wide_interval_is_all_of_its_side_however_far_its_middle_is() {
        assert!((ln_probability(0.0, 100.0) - 0.5f64.ln()).abs() < 1e-12);
        assert!(ln_probability(-100.0, 300.0).abs() < 1e-12);
        assert!((ln_probability(-1e3, -20.0) - ln_probability(20.0, 25.0)).abs() < 1e-12);
        for far in [FAR + 1e-4, FAR + 0.1, 1e3] {
            let (last, next) = (ln_probability(FAR - 1e-9, far), ln_probability(FAR + 1e-9, far));
            assert!((last - next).abs() < 1e-4, "{far}: {last} and {next}");
        }
    }

    #[test]
    fn a_narrow_interval_has_the_density_times_its_width() {
        let width = 1e-4;
        assert!((ln_probability(0.7, 0.7 + width) - (ln_probability(0.7, 0.7) + width.ln())).abs() < 1e-4);
    }

    #[test]
    fn quantiles_of_one_normal_and_of_a_mixture() {
        assert!((mixture_quantile(&[(2.0, 0.5)], 0.95) - (2.0 + 0.5 * 1.644_853_627)).abs() < 1e-8);
        let two = [(-1.0, 0.3), (1.0, 0.3)];
        assert!(mixture_quantile(&two, 0.5).abs() < 1e-9);
        assert!((mixture_quantile(&two, 0.25) + 1.0).abs() < 1e-3);
        assert_eq!((quantile(&[3.0, 1.0, 2.0], 0.5), quantile(&[1.0, 2.0], 0.25)), (2.0, 1.25));
    }
}
