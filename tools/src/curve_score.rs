//! How alike two force traces are: numbers, coefficient of determination, and the ratings of CORA's cross-correlation.
//!
//! Both traces are first shifted so that they reach the force threshold at the same time, because a laboratory's clock
//! knows nothing of ours. CORA ("CORrelation and Analysis", Gehre, Gades and Wernicke, ESV 2009, paper 09-0389) rates the
//! rest: the *phase* by the further shift that correlates best, the *size* by the ratio of the areas under the squares,
//! the *progression* by the correlation K at that shift, as ((1 + K)/2)^K_V; each from 0 (unlike) to 1 (the same). The
//! parameters are the program's defaults (as parameter files of CORAplus 4.0.5 list them).

use crate::series::Series;

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
}

/// Shift beyond which the phase rates 0, as a part of the duration: CORA's D_max.
const LARGEST_SHIFT: f64 = 0.12;
/// Shift within which the phase rates 1, as a part of the duration: CORA's D_min.
const SMALLEST_SHIFT: f64 = 0.01;
/// Exponent of the progression: CORA's K_V. Those of size and phase are 1.
const PROGRESSION_EXPONENT: i32 = 10;

impl CurveScore {
    /// Compares over the time in which either trace is at or above `threshold`, N; none if one never is.
    pub fn new(measured: &Series, simulated: &Series, threshold: f64) -> Option<Self> {
        let (zero, ours) = (measured.onset(threshold)?, simulated.onset(threshold)?);
        let duration = measured.duration(threshold).max(simulated.duration(threshold));
        let count = (duration / measured.interval).round().max(2.0) as usize;
        let sample = |series: &Series, start: f64, shift: isize| -> Vec<f64> {
            let time = |i: usize| start + (i as f64 + shift as f64) * measured.interval;
            (0..=count).map(|i| series.at(time(i))).collect()
        };
        let reference = sample(measured, zero, 0);
        let aligned = sample(simulated, ours, 0);
        let squares = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let mean = reference.iter().sum::<f64>() / reference.len() as f64;
        let spread = squares(&reference, &vec![mean; reference.len()]);
        let reach = (LARGEST_SHIFT * count as f64).ceil() as isize;
        let (shift, correlation) = (-reach..=reach)
            .map(|shift| (shift, correlation(&reference, &sample(simulated, ours, shift))))
            // The smaller of two shifts that correlate as well.
            .fold((0_isize, f64::NEG_INFINITY), |best, next| {
                let better = next.1 > best.1 || (next.1 == best.1 && next.0.abs() < best.0.abs());
                if better { next } else { best }
            });
        let [a, b] = [&reference, &sample(simulated, ours, shift)].map(|s| s.iter().map(|f| f * f).sum::<f64>());
        let late = shift.unsigned_abs() as f64 / count as f64;
        Some(Self {
            r_squared: 1.0 - squares(&reference, &aligned) / spread,
            difference: (squares(&reference, &aligned) / reference.len() as f64).sqrt() / measured.peak(),
            phase: ((LARGEST_SHIFT - late) / (LARGEST_SHIFT - SMALLEST_SHIFT)).clamp(0.0, 1.0),
            size: (a / b).min(b / a),
            progression: (0.5 * (1.0 + correlation)).powi(PROGRESSION_EXPONENT),
        })
    }

    /// CORA's rating: half progression, a quarter each size and phase.
    pub fn rating(&self) -> f64 {
        0.5 * self.progression + 0.25 * (self.size + self.phase)
    }
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
        // Squares of 0.8; aligning at 20 N moves the smaller one by 13 us.
        assert!((score.size - 0.64).abs() < 2e-3 && score.progression > 0.999 && score.phase == 1.0, "{score:?}");
        // The 158 samples from 20 N on have the mean 0.6445 and the mean square 0.5063 of the peak, so R2 is
        // 1 - 0.2^2 0.5063 / (0.5063 - 0.6445^2) = 0.777.
        assert!((score.r_squared - 0.777).abs() < 2e-3, "{score:?}");
    }

    #[test]
    fn nothing_compares_with_no_contact() {
        assert!(CurveScore::new(&half_sine(1e3, 2e-3), &half_sine(1.0, 2e-3), 20.0).is_none());
    }
}
