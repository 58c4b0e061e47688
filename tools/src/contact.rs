//! Where in a record the impact is, whatever the noise: by what the force does before the contact, and by its whole rising
//! flank instead of one sample.

use crate::series::Series;

/// Samples before the contact from which its noise is read, at least.
const FEWEST_QUIET: usize = 10;
/// Part of the peak below which a force before the peak is none of the flank's upper part.
const LOWER_FLANK: f64 = 0.25;
/// Standard deviations of the noise that its samples stay below: one of ten million does not.
const CLEAR_OF_NOISE: f64 = 5.0;
/// Standard deviations of a normal distribution in its median absolute deviation.
const NORMAL: f64 = 1.482_602_218_505_602;
/// Parts of the peak between which the rising flank is taken as a straight line.
const FLANK: [f64; 2] = [0.1, 0.5];
/// The part of the peak whose time on that line is that of the rise.
pub const LEVEL: f64 = 0.3;

/// The force without contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Floor {
    /// Its median, N.
    pub level: f64,
    /// Its standard deviation, N, by the median absolute deviation.
    pub deviation: f64,
}

impl Floor {
    /// What stands before the rising flank of `series`; if that is too short, the part of the whole that changes from sample
    /// to sample.
    pub fn of(series: &Series) -> Self {
        let force = &series.force;
        let peak = series.peak();
        let top = force.iter().position(|f| *f >= peak).unwrap_or_default();
        let foot = force[..top].iter().rposition(|f| *f < LOWER_FLANK * peak).unwrap_or_default();
        // The lower part of a flank takes no longer than the upper part.
        let quiet = &force[..foot.saturating_sub(top - foot)];
        if quiet.len() >= FEWEST_QUIET {
            let level = median(quiet.to_vec());
            let distances = quiet.iter().map(|f| (f - level).abs()).collect();
            return Self { level, deviation: NORMAL * median(distances) };
        }
        // Second differences of independent errors have six times their variance, those of a smooth force vanish.
        let differences = force.windows(3).map(|f| (f[0] - 2.0 * f[1] + f[2]).abs()).collect();
        Self { level: 0.0, deviation: NORMAL * median(differences) / 6.0_f64.sqrt() }
    }

    /// The least force, N, that is no noise.
    pub fn clear(self) -> f64 {
        if self.deviation > 0.0 { self.level + CLEAR_OF_NOISE * self.deviation } else { 0.0 }
    }
}

/// When the force rises, s: where the straight line through the samples of the rising flank has [`LEVEL`] of the peak, in the
/// middle of them, so that nothing is extrapolated.
pub fn rise(series: &Series) -> Option<f64> {
    let peak = series.peak();
    let end = series.force.iter().position(|f| *f > 0.0 && *f >= FLANK[1] * peak)?;
    let start = series.force[..end].iter().rposition(|f| *f < FLANK[0] * peak).map_or(0, |below| below + 1);
    Some(crossing(series, start.saturating_sub(1), end, LEVEL * peak))
}

/// Where the straight line through the samples `start..=end`, which rise, has the force `level`, N.
fn crossing(series: &Series, start: usize, end: usize, level: f64) -> f64 {
    let n = (end + 1 - start) as f64;
    let middle = 0.5 * (n - 1.0);
    let mean = series.force[start..=end].iter().sum::<f64>() / n;
    let (mut moment, mut square) = (0.0, 0.0);
    for (k, force) in series.force[start..=end].iter().enumerate() {
        let distance = k as f64 - middle;
        moment += distance * (force - mean);
        square += distance * distance;
    }
    let beyond = if moment > 0.0 { (level - mean) * square / moment } else { 0.0 };
    series.time(start) + series.interval * (middle + beyond.clamp(-middle, middle))
}

fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use fcmaes_core::Rng;
    use softanvil_kernel::SAMPLING_INTERVAL;
    use std::f64::consts::PI;

    /// A half sine of 8 ms and 4 kN that begins after `quiet` samples, with a normal error of `deviation` N.
    fn half_sine(quiet: usize, deviation: f64, seed: u64) -> Series {
        let mut random = Rng::new(seed);
        let force = (0..quiet + 200).map(|i| {
            let time = (i as f64 - quiet as f64) * SAMPLING_INTERVAL;
            let sine = if (0.0..8e-3).contains(&time) { 4e3 * (PI * time / 8e-3).sin() } else { 0.0 };
            sine + random.normreal(0.0, deviation)
        });
        Series { start: 0.0, interval: SAMPLING_INTERVAL, force: force.collect() }
    }

    #[test]
    fn the_noise_is_that_before_the_contact() {
        for deviation in [0.0, 10.0, 80.0, 200.0] {
            let deviations: Vec<f64> =
                (0..20).map(|seed| Floor::of(&half_sine(200, deviation, seed)).deviation).collect();
            let mean = deviations.iter().sum::<f64>() / 20.0;
            // Four standard errors of 20 median deviations of some 150 samples.
            assert!((mean - deviation).abs() <= 0.09 * deviation, "{deviation}: {deviations:?}");
            let unloaded = Floor::of(&half_sine(0, deviation, 1)).deviation;
            assert!((unloaded - deviation).abs() <= 0.4 * deviation + 1.0, "{deviation}: {unloaded}");
        }
    }

    /// The first sample above 20 N stands somewhere before the contact as soon as there is noise.
    #[test]
    fn the_rise_is_that_of_the_flank() {
        // 0.3 of the peak.
        let exact = 200.0 * SAMPLING_INTERVAL + 8e-3 / PI * 0.3_f64.asin();
        assert!((rise(&half_sine(200, 0.0, 1)).unwrap() - exact).abs() < 20e-6);
        for seed in 0..20 {
            let noisy = half_sine(200, 200.0, seed);
            assert!(noisy.onset(20.0).unwrap() < 195.0 * SAMPLING_INTERVAL);
            // A standard error is 29 us, 200 N over the slope of 1.5 N/us and the root of 21 samples; the largest error of the
            // samples around the peak, 440 N, moves the level by 88 us.
            assert!((rise(&noisy).unwrap() - exact).abs() < 88e-6 + 4.0 * 29e-6, "{seed}: {:?}", rise(&noisy));
        }
    }
}
