//! How alike two force traces are: numbers, coefficient of determination, and the ratings of CORA's cross-correlation.
//!
//! A laboratory's clock knows nothing of ours, so both traces are first shifted until their rising flanks have the same part of
//! the peak at the same time, and then until their normalised cross-correlation is largest: all samples tell the shift, none
//! of them alone, so that noise before the contact moves nothing. CORA ("CORrelation and Analysis", Gehre,
//! Gades and Wernicke, ESV 2009, paper 09-0389) rates what is left: the *phase* by the shift from the flanks to the best
//! correlation, the *size* by the ratio of the areas under the squares, the *progression* by the correlation K at that shift,
//! as ((1 + K)/2)^K_V; each from 0 (unlike) to 1 (the same). The parameters are the program's defaults (as parameter files of
//! CORAplus 4.0.5 list them).

use crate::measurement::contact::{self, Floor};
use crate::measurement::series::Series;

/// How alike a simulated trace is to a measured one.
#[derive(Clone, Copy, Debug)]
pub struct CurveScore {
    /// Coefficient of determination R2 of the aligned traces; 1 if they are the same, negative if worse than a constant.
    pub r_squared: f64,
    /// Root mean square of the difference over the measured peak.
    pub difference: f64,
    /// CORA: phase.
    pub phase: f64,
    /// CORA: size.
    pub size: f64,
    /// CORA: progression.
    pub progression: f64,
    /// How the traces were aligned.
    pub alignment: Alignment,
}

/// Which times of two traces belong together.
#[derive(Clone, Copy, Debug)]
pub struct Alignment {
    /// A time of the simulated trace less that of the measured one, s, where the cross-correlation is largest.
    pub lag: f64,
    /// The part of it that the rising flanks do not tell, s.
    pub beyond_flanks: f64,
}

/// Shift beyond which the phase rates 0, as a part of the duration: CORA's D_max.
const LARGEST_SHIFT: f64 = 0.12;
/// Shift that is tried, as a part of the duration.
const SEARCHED: f64 = 0.25;
/// Samples of it, at most: a quarter of an impact of 200 ms, the longest that is likely.
const FARTHEST: f64 = 1000.0;
/// Shift within which the phase rates 1, as a part of the duration: CORA's D_min.
const SMALLEST_SHIFT: f64 = 0.01;
/// Exponent of the progression: CORA's K_V. Those of size and phase are 1.
const PROGRESSION_EXPONENT: i32 = 10;

/// `threshold`, N, or the least force that is no noise of the measured trace, if that is more.
pub fn clear_threshold(measured: &Series, threshold: f64) -> f64 {
    threshold.max(Floor::of(measured).clear())
}

/// Part of the time above the noise that a force below it may take at either end.
const BELOW_NOISE: f64 = 0.5;

/// First sample and number of samples of the measured trace that are compared.
fn window(measured: &Series, simulated: &Series, threshold: f64) -> Option<(usize, usize)> {
    let clear = clear_threshold(measured, threshold);
    let ([first, last], [ours, end]) = (measured.contact(clear)?, simulated.contact(clear)?);
    let length = measured.force.len();
    if clear > threshold {
        // Were it to hang on the simulated trace, the one would score best whose window has the least noise by chance.
        let beyond = (BELOW_NOISE * (last - first) as f64) as usize;
        let first = first.saturating_sub(beyond);
        return Some((first, length.min(last + 1 + beyond) - first));
    }
    // From the last sample below on.
    let (first, count) = (first.saturating_sub(1), (last - first).max(end - ours) + 2);
    // What a record that ends in contact would have gone on to is not known.
    let cut = measured.force.last().is_some_and(|force| *force >= clear);
    Some((first, if cut { count.min(length - first) } else { count }))
}

impl CurveScore {
    /// Compares over the time in which either trace is at or above `threshold`, N; if noise reaches above it, over one that
    /// the measured trace alone tells. None if one trace never is above.
    pub fn new(measured: &Series, simulated: &Series, threshold: f64) -> Option<Self> {
        let (first, count) = window(measured, simulated, threshold)?;
        let times: Vec<f64> = (first..first + count).map(|i| measured.time(i)).collect();
        let reference: Vec<f64> =
            (first..first + count).map(|i| measured.force.get(i).copied().unwrap_or_default()).collect();
        let sample = |lag: f64| -> Vec<f64> { times.iter().map(|time| simulated.at(time + lag)).collect() };
        let flanks = contact::rise(simulated)? - contact::rise(measured)?;
        let correlate = |samples: f64| correlation(&reference, &sample(flanks + samples * measured.interval));
        let shift = best_shift((SEARCHED * count as f64).ceil().min(FARTHEST) as i32, correlate);
        let alignment = Alignment { lag: flanks + shift * measured.interval, beyond_flanks: shift * measured.interval };
        let aligned = sample(alignment.lag);
        let squares = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let mean = reference.iter().sum::<f64>() / reference.len() as f64;
        let spread = squares(&reference, &vec![mean; reference.len()]);
        let [a, b] = [&reference, &aligned].map(|samples| samples.iter().map(|force| force * force).sum::<f64>());
        let late = shift.abs() / count as f64;
        Some(Self {
            r_squared: 1.0 - squares(&reference, &aligned) / spread,
            difference: (squares(&reference, &aligned) / reference.len() as f64).sqrt() / measured.peak(),
            phase: ((LARGEST_SHIFT - late) / (LARGEST_SHIFT - SMALLEST_SHIFT)).clamp(0.0, 1.0),
            size: (a / b).min(b / a),
            progression: (0.5 * (1.0 + correlation(&reference, &aligned))).powi(PROGRESSION_EXPONENT),
            alignment,
        })
    }

    /// CORA's rating: half progression, a quarter each size and phase.
    pub fn rating(&self) -> f64 {
        0.5 * self.progression + 0.25 * (self.size + self.phase)
    }
}

/// The shift in samples, up to `reach` in either direction, at which `correlate` is largest.
fn best_shift(reach: i32, correlate: impl Fn(f64) -> f64) -> f64 {
    /// Sections of the golden ratio that leave a millionth of a sample.
    const SECTIONS: usize = 30;
    /// A gain below the rounding of a correlation is none: traces that differ by whole samples are shifted by whole samples.
    const ROUNDING: f64 = 1e-12;
    let whole = (-reach..=reach)
        .map(|shift| (f64::from(shift), correlate(f64::from(shift))))
        // The smaller of two shifts that correlate as well.
        .fold((0.0, f64::NEG_INFINITY), |best: (f64, f64), next| {
            let better = next.1 > best.1 || (next.1 == best.1 && next.0.abs() < best.0.abs());
            if better { next } else { best }
        });
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut low, mut high) = (whole.0 - 1.0, whole.0 + 1.0);
    let inner = |low: f64, high: f64| [high - ratio * (high - low), low + ratio * (high - low)];
    let [mut a, mut b] = inner(low, high).map(|shift| (shift, correlate(shift)));
    for _ in 0..SECTIONS {
        if a.1 > b.1 {
            (high, b) = (b.0, a);
            let shift = inner(low, high)[0];
            a = (shift, correlate(shift));
        } else {
            (low, a) = (a.0, b);
            let shift = inner(low, high)[1];
            b = (shift, correlate(shift));
        }
    }
    let between = if a.1 > b.1 { a } else { b };
    if between.1 > whole.1 + ROUNDING { between.0 } else { whole.0 }
}

/// Normalised cross-correlation.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    product(a, b) / (product(a, a) * product(b, b)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// A half sine of 8 ms and `peak` N that begins at `start`, s.
    fn half_sine(peak: f64, start: f64) -> Series {
        let force = (0..400).map(|i| {
            let time = i as f64 * 5e-5 - start;
            if (0.0..8e-3).contains(&time) { peak * (PI * time / 8e-3).sin() } else { 0.0 }
        });
        Series { start: 0.0, interval: 5e-5, force: force.collect() }
    }

    #[test]
    fn the_same_trace_at_another_time_is_the_same() {
        let score = CurveScore::new(&half_sine(1e3, 2e-3), &half_sine(1e3, 5e-3), 20.0).unwrap();
        assert!((score.rating() - 1.0).abs() < 1e-9 && (score.r_squared - 1.0).abs() < 1e-9, "{score:?}");
    }

    #[test]
    fn a_smaller_trace_of_the_same_shape_loses_size_alone() {
        let score = CurveScore::new(&half_sine(1e3, 2e-3), &half_sine(800.0, 2e-3), 20.0).unwrap();
        // Squares of 0.8.
        assert!((score.size - 0.64).abs() < 2e-3 && score.progression > 0.999 && score.phase == 1.0, "{score:?}");
        // The 158 samples from 20 N on have the mean 0.6445 and the mean square 0.5063 of the peak, so R2 is
        // 1 - 0.2^2 0.5063 / (0.5063 - 0.6445^2) = 0.777.
        assert!((score.r_squared - 0.777).abs() < 2e-3, "{score:?}");
    }

    /// Known by construction: the later trace begins 3.02 ms after the other, not a whole number of samples.
    #[test]
    fn noise_before_the_contact_does_not_move_a_trace() {
        for deviation in [0.0, 0.02, 0.05] {
            for seed in 0..20 {
                let mut random = fcmaes_core::Rng::new(seed);
                let mut noisy = half_sine(4e3, 5.02e-3);
                noisy.force.iter_mut().for_each(|force| *force += random.normreal(0.0, 4e3 * deviation));
                let score = CurveScore::new(&noisy, &half_sine(4e3, 2e-3), 20.0).unwrap();
                // The error of the shift is that of the noise over the root of the sum of the squared slopes, 14 us at 5 %.
                assert!(
                    (score.alignment.lag + 3.02e-3).abs() < 4.0 * 14e-6 * deviation / 0.05 + 1e-6,
                    "{deviation} {seed}: {score:?}"
                );
                // The variance of a half sine is 0.095 of its peak's square, with half as many zeros beside it more, and that
                // of the noise scatters by four standard errors of 134 squares.
                assert!(score.r_squared > 1.0 - 15.0 * deviation * deviation - 1e-4, "{deviation} {seed}: {score:?}");
            }
        }
    }

    #[test]
    fn nothing_compares_with_no_contact() {
        assert!(CurveScore::new(&half_sine(1e3, 2e-3), &half_sine(1.0, 2e-3), 20.0).is_none());
    }
}
