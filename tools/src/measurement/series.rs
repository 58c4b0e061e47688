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

impl Series {
    /// The force samples of `run`; each is the mean over its interval, so its time is the middle of it.
    pub fn of_run(run: &Run, sensor: Sensor) -> Self {
        let force = run.samples()[1..].iter().map(|sample| match sensor {
            Sensor::Contact => sample.sampler.last.contact_force,
            Sensor::Core => sample.sampler.last.core_reaction,
        });
        Self { start: 0.5 * SAMPLING_INTERVAL, interval: SAMPLING_INTERVAL, force: force.collect() }
    }

    /// A measured trace, `forces` in N over `times` in s, which rise, at 20 kHz by linear interpolation.
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
        let mut segment = 0;
        let force = (0..count as usize).map(|i| {
            let time = first + i as f64 * SAMPLING_INTERVAL;
            while segment + 2 < times.len() && times[segment + 1] <= time {
                segment += 1;
            }
            let after = (segment + 1).min(times.len() - 1);
            let (a, b) = (forces[segment], forces[after]);
            a + (b - a) * (time - times[segment]) / (times[after] - times[segment])
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
        if below < 0.0 || below + 1.0 > (self.force.len() - 1) as f64 {
            return 0.0;
        }
        let (a, b) = (self.force[below as usize], self.force[below as usize + 1]);
        a + (b - a) * (place - below)
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
        assert!((series.impulse(15.0) - 110.0 * 50e-6).abs() < 1e-12);
    }

    #[test]
    fn a_trace_of_no_length_is_refused() {
        let error = Series::resampled(&[0.0, 1e-5], &[1.0, 1.0]).unwrap_err().to_string();
        assert!(error.contains("expected 50 us to 50 s"), "{error}");
    }
}
