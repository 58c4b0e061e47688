//! Where in a record the impact is, whatever the noise: by what the force does without contact, and by its whole
//! rising flank instead of one sample.

use softanvil_records::robust::median_and_deviation;

use crate::measurement::series::Series;

/// Samples without contact from which noise is read, at least.
const FEWEST_QUIET: usize = 20;
/// Part of the noise of a whole that a part of it has only if something else is in the rest.
const QUIETER: f64 = 0.5;
/// Part of the peak below which a force before the peak is none of the flank's upper part.
const LOWER_FLANK: f64 = 0.25;
/// Standard deviations of the noise that its samples stay below: one of ten million does not.
pub const CLEAR_OF_NOISE: f64 = 5.0;
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
    /// What stands before the rising flank of `series`, or behind the falling one if the record begins with the contact; nothing
    /// if it ends with it too.
    pub fn of(series: &Series) -> Self {
        let force = &series.force;
        let upper = LOWER_FLANK * series.peak();
        let top = force.iter().position(|f| *f >= series.peak()).unwrap_or_default();
        // The lower part of a flank hardly takes longer than the upper part.
        let foot = force[..top].iter().rposition(|f| *f < upper).unwrap_or_default();
        let before = &force[..foot.saturating_sub(top - foot)];
        if before.len() >= FEWEST_QUIET {
            return Self::of_quietest(before);
        }
        let foot = force[top..].iter().position(|f| *f < upper).map_or(force.len(), |below| top + below);
        let behind: Vec<f64> = force[(2 * foot - top).min(force.len())..].iter().rev().copied().collect();
        if behind.len() >= FEWEST_QUIET { Self::of_quietest(&behind) } else { Self::default() }
    }

    /// Of `force`, or of its first half or quarter, if that is much quieter: what is farther from the contact then does not
    /// belong to it.
    fn of_quietest(force: &[f64]) -> Self {
        let parts = [force.len() / 2, force.len() / 4].into_iter().filter(|length| *length >= FEWEST_QUIET);
        let floors = parts.map(|length| Self::of_quiet(&force[..length]));
        floors.fold(Self::of_quiet(force), |best, next| if next.clear() < QUIETER * best.clear() { next } else { best })
    }

    fn of_quiet(force: &[f64]) -> Self {
        let (level, deviation) = median_and_deviation(force);
        Self { level, deviation }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::series::Sensor;
    use fcmaes_core::Rng;
    use softanvil_kernel::SAMPLING_INTERVAL;
    use std::f64::consts::PI;

    /// A half sine of 8 ms and 4 kN that begins after `quiet` samples, with a normal error of `deviation` N.
    fn half_sine(quiet: usize, deviation: f64, seed: u64) -> Series {
        let mut random = Rng::new(seed);
        let force = (0..quiet + 400).map(|i| {
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
            // Of a record that begins with the contact, the noise behind it.
            let behind = Floor::of(&half_sine(0, deviation, 1)).deviation;
            assert!((behind - deviation).abs() <= 0.4 * deviation, "{deviation}: {behind}");
        }
    }

    /// A force that rises slowly at first, and one that begins with the record and rings, have no noise.
    #[test]
    fn what_a_layer_does_is_no_noise() {
        let force = (0..300).map(|i| if i < 200 { 4e3 * (f64::from(i) / 200.0).powi(3) } else { 0.0 }).collect();
        assert!(Floor::of(&Series { start: 0.0, interval: SAMPLING_INTERVAL, force }).clear() < 20.0);
        // Presets without damping go on ringing behind the contact.
        for preset in softanvil_kernel::preset::PRESETS.iter().filter(|preset| preset.name.starts_with("study")) {
            let run = crate::run::Drop::new(&(preset.scenario)()).unwrap().run(|_| {}).unwrap();
            for sensor in [Sensor::Contact, Sensor::Core] {
                let clear = Floor::of(&Series::of_run(&run, sensor)).clear();
                assert!(clear < 20.0, "{} {sensor:?}: {clear} N", preset.name);
            }
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
