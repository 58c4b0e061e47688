//! A force over time at equal intervals, from a run or a measurement, and the four numbers of the test read from it.

use softanvil_kernel::{SAMPLING_INTERVAL, cfc};

use crate::run::Run;

/// Which force is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, serde::Serialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Sensor {
    /// Force on the impactor, as the paper's LS-DYNA figures are.
    #[default]
    Contact,
    /// Force of the layer on the core, as the load cells of its experiment see it: larger by the inertia of the layer.
    Core,
}

impl Sensor {
    /// Name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Contact => "contact force",
            Self::Core => "core reaction (load cells)",
        }
    }

    /// Name and unit for an axis.
    pub fn axis(self) -> &'static str {
        match self {
            Self::Contact => CONTACT_FORCE,
            Self::Core => "core reaction (N)",
        }
    }
}

/// Name and unit of the force that the kernel's own pictures show.
pub const CONTACT_FORCE: &str = "contact force (N)";

/// Forces at equal intervals.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::run::Drop;
/// use softanvil_tools::measurement::series::{Sensor, Series};
///
/// let run = Drop::new(&preset::study())?.run(|_| {})?;
/// let series = Series::of_run(&run, Sensor::Contact);
/// assert_eq!(series.peak(), run.end().metrics.peak_force);
/// let filtered = series.clone().filtered(180.0)?;
/// assert!(filtered.peak() < series.peak());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Series {
    /// Time of the first force, s.
    pub start: f64,
    /// Interval, s.
    pub interval: f64,
    /// Forces, N.
    pub force: Vec<f64>,
}

/// What cannot be read as a force over time.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct SeriesError(String);

/// Checks that the sampling interval carries `channel_class`, Hz.
///
/// # Errors
/// It does not, with what is legal.
pub fn check_channel_class(channel_class: f64) -> Result<(), SeriesError> {
    match cfc::Coefficients::new(channel_class, SAMPLING_INTERVAL) {
        Ok(_) => Ok(()),
        Err(error) => Err(SeriesError(error.to_string())),
    }
}

/// Most samples that a measured trace is resampled to.
const MAX_SAMPLES: f64 = 1e6;

/// Part of the interval of 20 kHz below which the samples of a record are closer than that, jitter of its clock aside.
const FASTER: f64 = 0.9;

/// The straight lines between the samples of a record, and where on them one is.
struct Lines<'a> {
    times: &'a [f64],
    forces: &'a [f64],
    /// The line from this sample to the next.
    at: usize,
}

impl<'a> Lines<'a> {
    /// Begins at the first of two samples or more.
    fn new(times: &'a [f64], forces: &'a [f64]) -> Self {
        Self { times, forces, at: 0 }
    }

    /// Goes on to the line at `time`.
    fn go_to(&mut self, time: f64) {
        while self.at + 2 < self.times.len() && self.times[self.at + 1] <= time {
            self.at += 1;
        }
    }

    fn step(&self) -> f64 {
        self.times[self.at + 1] - self.times[self.at]
    }

    fn force(&self, time: f64) -> f64 {
        let (a, b) = (self.forces[self.at], self.forces[self.at + 1]);
        a + (b - a) * (time - self.times[self.at]) / self.step()
    }

    /// The mean from `start`, on this line, to `end`, on the line of `last`.
    fn mean(&self, last: &Self, start: f64, end: f64) -> f64 {
        let area = |a: (f64, f64), b: (f64, f64)| 0.5 * (b.0 - a.0) * (a.1 + b.1);
        let mut sum = 0.0;
        let mut from = (start, self.force(start));
        for corner in self.at + 1..=last.at {
            let to = (self.times[corner], self.forces[corner]);
            sum += area(from, to);
            from = to;
        }
        (sum + area(from, (end, last.force(end)))) / (end - start)
    }
}

impl Series {
    /// The force samples of `run`; each is the mean over its interval, so its time is the middle of it.
    pub fn of_run(run: &Run, sensor: Sensor) -> Self {
        let force = run.samples()[1..].iter().map(|sample| match sensor {
            Sensor::Contact => sample.sampler.last.contact_force,
            Sensor::Core => sample.sampler.last.core_reaction,
        });
        Self { start: 0.5 * SAMPLING_INTERVAL, interval: SAMPLING_INTERVAL, force: force.collect() }
    }

    /// A measured trace, `forces` in N over `times` in s, which rise, at 20 kHz by linear interpolation; where it is faster,
    /// by the mean over the interval around each sample, as the simulated force is.
    ///
    /// # Errors
    /// A trace that is too short or too long.
    pub fn resampled(times: &[f64], forces: &[f64]) -> Result<Self, SeriesError> {
        let (Some(first), Some(last)) = (times.first(), times.last()) else {
            return Err(SeriesError("the trace has no samples".into()));
        };
        // A length within a millionth of a sample of a whole number is that number.
        let count = ((last - first) / SAMPLING_INTERVAL + 1e-6).floor() + 1.0;
        if !(2.0..=MAX_SAMPLES).contains(&count) {
            return Err(SeriesError(format!("the trace lasts {} s; expected 50 us to 50 s", last - first)));
        }
        let mut lines = [Lines::new(times, forces), Lines::new(times, forces), Lines::new(times, forces)];
        let force = (0..count as usize).map(|i| {
            let time = first + i as f64 * SAMPLING_INTERVAL;
            let [before, at, after] = &mut lines;
            at.go_to(time);
            if at.step() >= FASTER * SAMPLING_INTERVAL {
                return at.force(time);
            }
            let (start, end) =
                ((time - 0.5 * SAMPLING_INTERVAL).max(*first), (time + 0.5 * SAMPLING_INTERVAL).min(*last));
            before.go_to(start);
            after.go_to(end);
            before.mean(after, start, end)
        });
        Ok(Self { start: *first, interval: SAMPLING_INTERVAL, force: force.collect() })
    }

    /// The same force through the filter of a channel frequency class, Hz, forwards and backwards.
    ///
    /// # Errors
    /// A class that the sampling cannot carry.
    pub fn filtered(mut self, channel_class: f64) -> Result<Self, SeriesError> {
        let coefficients =
            cfc::Coefficients::new(channel_class, self.interval).map_err(|error| SeriesError(error.to_string()))?;
        cfc::filter_both_ways(&coefficients, &mut self.force);
        Ok(self)
    }

    /// The force of `run` over time since it reached the threshold of its scenario: points of ms and N.
    pub fn of_run_since_onset(run: &Run, sensor: Sensor) -> Vec<(f64, f64)> {
        Self::of_run(run, sensor).since_onset(run.constants.scenario.measurement.force_threshold)
    }

    /// The force over time since it reached `threshold`, N: points of ms and N.
    pub fn since_onset(&self, threshold: f64) -> Vec<(f64, f64)> {
        self.since(self.onset(threshold).unwrap_or(self.start), threshold)
    }

    /// The force over time since the time `zero`, s, up to where it has left `threshold`, N: points of ms and N.
    pub fn since(&self, zero: f64, threshold: f64) -> Vec<(f64, f64)> {
        let last = self.contact(threshold).map_or(self.force.len(), |[_, last]| last + 2);
        let points = self.force.iter().take(last).enumerate();
        points.map(|(i, force)| (1e3 * (self.time(i) - zero), *force)).filter(|point| point.0 >= 0.0).collect()
    }

    /// Time of sample `index`, s.
    pub fn time(&self, index: usize) -> f64 {
        self.start + index as f64 * self.interval
    }

    /// Largest force, N.
    pub fn peak(&self) -> f64 {
        self.force.iter().copied().fold(0.0, f64::max)
    }

    /// First and last sample at or above `threshold`, N.
    pub fn contact(&self, threshold: f64) -> Option<[usize; 2]> {
        let above = |force: &f64| *force >= threshold && *force > 0.0;
        Some([self.force.iter().position(above)?, self.force.iter().rposition(above)?])
    }

    /// Time covered by the samples from the first to the last one at or above `threshold`, s.
    pub fn duration(&self, threshold: f64) -> f64 {
        self.contact(threshold).map_or(0.0, |[first, last]| (last - first + 1) as f64 * self.interval)
    }

    /// Impulse, N s, of all samples from the first to the last one at or above `threshold`, N.
    pub fn impulse(&self, threshold: f64) -> f64 {
        self.contact(threshold)
            .map_or(0.0, |[first, last]| self.force[first..=last].iter().sum::<f64>() * self.interval)
    }

    /// The force at `time`, N, between samples by linear interpolation, and 0 outside of the series.
    pub fn at(&self, time: f64) -> f64 {
        let place = (time - self.start) / self.interval;
        let below = place.floor();
        match self.force.get(below as usize..) {
            _ if below < 0.0 => 0.0,
            Some([only]) if place == below => *only,
            Some([a, b, ..]) => a + (b - a) * (place - below),
            _ => 0.0,
        }
    }

    /// When the force first reaches `threshold`, N, between samples by linear interpolation, s.
    pub fn onset(&self, threshold: f64) -> Option<f64> {
        let [first, _] = self.contact(threshold)?;
        if first == 0 {
            return Some(self.time(0));
        }
        let (a, b) = (self.force[first - 1], self.force[first]);
        Some(self.time(first - 1) + self.interval * (threshold - a) / (b - a))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trace_is_resampled_at_20_khz() {
        let series = Series::resampled(&[0.001, 0.0012, 0.0013], &[0.0, 40.0, 0.0]).unwrap();
        assert_eq!(series.force.len(), 7);
        for (force, expected) in series.force.iter().zip([0.0, 10.0, 20.0, 30.0, 40.0, 20.0, 0.0]) {
            assert!((force - expected).abs() < 1e-9, "{:?}", series.force);
        }
        assert_eq!((series.peak().round(), series.contact(15.0)), (40.0, Some([2, 5])));
        assert!((series.onset(15.0).unwrap() - 0.001075).abs() < 1e-12);
        assert!((series.at(0.001025) - 5.0).abs() < 1e-9 && series.at(0.0) == 0.0 && series.at(1.0) == 0.0);
        let end = Series { start: 0.0, interval: 0.5, force: vec![1.0, 3.0] };
        assert_eq!([-0.1, 0.0, 0.25, 0.5, 0.51].map(|time| end.at(time)), [0.0, 1.0, 2.0, 3.0, 0.0]);
        assert_eq!(Series { force: Vec::new(), ..end }.at(0.0), 0.0);
        assert!((series.impulse(15.0) - 110.0 * 50e-6).abs() < 1e-12);
    }

    #[test]
    fn of_a_faster_trace_the_means_are_taken() {
        let half_sine = |time: f64| 4e3 * (std::f64::consts::PI * time / 8e-3).sin();
        for (rate, deviation) in [(1e6, 0.0), (1e6, 60.0), (3e4, 0.0)] {
            let mut random = fcmaes_core::Rng::new(1);
            let times: Vec<f64> = (0..=(8e-3 * rate) as usize).map(|i| i as f64 / rate).collect();
            let forces: Vec<f64> =
                times.iter().map(|time| half_sine(*time) + random.normreal(0.0, deviation)).collect();
            let series = Series::resampled(&times, &forces).unwrap();
            // The mean of the sine over an interval around a sample, and four standard errors of 50 samples; the straight
            // lines between samples cut off 0.06 N at 30 kHz.
            let angle = 0.5 * std::f64::consts::PI * SAMPLING_INTERVAL / 8e-3;
            for (i, force) in series.force.iter().enumerate().skip(1).take(158) {
                let mean = half_sine(series.time(i)) * angle.sin() / angle;
                assert!((force - mean).abs() < 4.0 * deviation / 50.0_f64.sqrt() + 0.1, "{rate}: {i} {force} {mean}");
            }
            assert!((series.peak() - 4e3).abs() < 34.0, "{rate}: {}", series.peak());
        }
    }

    #[test]
    fn a_trace_of_no_length_is_refused() {
        let error = Series::resampled(&[0.0, 1e-5], &[1.0, 1.0]).unwrap_err().to_string();
        assert!(error.contains("expected 50 us to 50 s"), "{error}");
    }
}
