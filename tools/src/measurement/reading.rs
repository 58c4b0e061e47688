//! What a laboratory reads from a drop: its load cells, filter, camera and rule for the duration, applied to a run.
//!
//! A model and a test compare only if both are read alike. The load cells under the core see more than the impactor does,
//! by the inertia of the layer between; a channel filter takes off some of a peak; the duration hangs on the threshold.

use std::fmt;
use std::str::FromStr;

use fcmaes_core::Rng;
use softanvil_kernel::SAMPLING_INTERVAL;

use crate::measurement::quantity::{self, COUNT};
use crate::measurement::series::{Sensor, Series, SeriesError};
use crate::run::Run;

/// Samples of force in a frame of the camera: 20 kHz over the 10 kHz of the paper's.
const SAMPLES_PER_FRAME: usize = 2;

/// From which force on the impact lasts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Threshold {
    /// A force, N.
    Force(f64),
    /// A part of the peak force.
    PartOfPeak(f64),
}

impl Threshold {
    /// The force, N, for a peak of `peak` N.
    pub fn force(self, peak: f64) -> f64 {
        match self {
            Self::Force(force) => force,
            Self::PartOfPeak(part) => part * peak,
        }
    }
}

impl FromStr for Threshold {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let refused = "expected a force of 0 N or more, as in 20, or a part of the peak below 100 %, as in 5%";
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|value| *value >= 0.0 && value.is_finite());
        match text.strip_suffix('%') {
            Some(percent) => {
                number(percent).filter(|value| *value < 100.0).map(|value| Self::PartOfPeak(value / 100.0))
            }
            None => number(text).map(Self::Force),
        }
        .ok_or_else(|| refused.into())
    }
}

impl fmt::Display for Threshold {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Force(force) => write!(f, "{force} N"),
            Self::PartOfPeak(part) => write!(f, "{} % of the peak", 100.0 * part),
        }
    }
}

/// Errors of a load cell and its amplifier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Standard deviation of the error of a sample, N.
    pub force: f64,
    /// Standard deviation of the error of the calibration, as a part of the force: one for the whole record.
    pub calibration: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Noise {
    /// None.
    pub const NONE: Self = Self { force: 0.0, calibration: 0.0, seed: 1 };

    fn apply(&self, series: &mut Series) {
        let mut random = Rng::new(self.seed);
        let gain = random.normreal(1.0, self.calibration);
        for force in &mut series.force {
            *force = gain * *force + random.normreal(0.0, self.force);
        }
    }
}

/// How a run is read.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::measurement::quantity::PEAK_FORCE;
/// use softanvil_tools::measurement::reading::Reading;
/// use softanvil_tools::run::Drop;
/// use softanvil_tools::measurement::series::Sensor;
///
/// let run = Drop::new(&preset::study())?.run(|_| {})?;
/// let on_impactor = Reading::PLAIN.take(&run)?;
/// let under_core = Reading { sensor: Sensor::Core, threshold: Some("5%".parse()?), ..Reading::PLAIN }.take(&run)?;
/// // The load cells see the inertia of the layer as well.
/// assert!(under_core.values[PEAK_FORCE] > on_impactor.values[PEAK_FORCE]);
/// assert_eq!(under_core.threshold, 0.05 * under_core.series.peak());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Which force.
    pub sensor: Sensor,
    /// Channel frequency class of the filter on it, Hz; none unfiltered.
    pub channel_class: Option<f64>,
    /// From which force on the impact lasts; none for the scenario's.
    pub threshold: Option<Threshold>,
    /// Errors of the force.
    pub noise: Noise,
    /// Whether the deformation is that in the frames of a 10 kHz camera, instead of that in every step.
    pub camera: bool,
}

impl Reading {
    /// Contact force, unfiltered, the scenario's threshold, no error: what the kernel itself gives as its results.
    pub const PLAIN: Self =
        Self { sensor: Sensor::Contact, channel_class: None, threshold: None, noise: Noise::NONE, camera: false };

    /// Reads `run`.
    ///
    /// # Errors
    /// A channel frequency class that 20 kHz do not carry.
    pub fn take(&self, run: &Run) -> Result<Record, SeriesError> {
        let mut series = Series::of_run(run, self.sensor);
        if self.noise != Noise::NONE {
            self.noise.apply(&mut series);
        }
        if let Some(class) = self.channel_class {
            series = series.filtered(class)?;
        }
        let rule = self.threshold.unwrap_or(Threshold::Force(run.constants.scenario.measurement.force_threshold));
        let peak = series.peak();
        let threshold = rule.force(peak);
        let deformation = if self.camera { filmed_deformation(run) } else { run.end().metrics.max_deformation };
        if *self == Self::PLAIN {
            return Ok(Record { values: quantity::measure(run), series, threshold });
        }
        // Noise makes an impulse of the time without contact as well; without it, all force counts.
        let impulse = series.impulse(if self.noise == Noise::NONE { 0.0 } else { threshold });
        Ok(Record { values: [peak, deformation, series.duration(threshold), impulse], series, threshold })
    }
}

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.channel_class {
            Some(class) => write!(f, "{}, CFC {class}", self.sensor.label()),
            None => write!(f, "{}, unfiltered", self.sensor.label()),
        }
    }
}

/// What was read.
#[derive(Clone, Debug)]
pub struct Record {
    /// The force.
    pub series: Series,
    /// The four numbers, in SI and in the order of [`crate::measurement::quantity::QUANTITIES`].
    pub values: [f64; COUNT],
    /// Force from which on the impact lasts, N.
    pub threshold: f64,
}

/// Largest deformation in the frames of a camera, m.
fn filmed_deformation(run: &Run) -> f64 {
    run.samples().iter().step_by(SAMPLES_PER_FRAME).map(|sample| sample.impactor.deformation()).fold(0.0, f64::max)
}

/// Frames of the camera per second.
pub fn frame_rate() -> f64 {
    1.0 / (SAMPLES_PER_FRAME as f64 * SAMPLING_INTERVAL)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::quantity::MAX_DEFORMATION;
    use crate::run::Drop;
    use softanvil_kernel::preset;

    #[test]
    fn a_threshold_is_a_force_or_a_part_of_the_peak() {
        assert_eq!("20".parse(), Ok(Threshold::Force(20.0)));
        assert_eq!("5%".parse(), Ok(Threshold::PartOfPeak(0.05)));
        assert_eq!("0.5 %".parse(), Ok(Threshold::PartOfPeak(0.005)));
        assert_eq!(Threshold::PartOfPeak(0.05).force(2e3), 100.0);
        for text in ["", "-1", "100%", "nan", "inf", "x%"] {
            assert!(text.parse::<Threshold>().unwrap_err().contains("expected a force"), "{text}");
        }
    }

    #[test]
    fn a_plain_reading_gives_the_results_of_the_kernel() {
        let run = Drop::new(&preset::study()).unwrap().run(|_| {}).unwrap();
        let threshold = Some(Threshold::Force(run.constants.scenario.measurement.force_threshold));
        let from_samples = Reading { threshold, ..Reading::PLAIN }.take(&run).unwrap().values;
        let from_kernel = Reading::PLAIN.take(&run).unwrap().values;
        for (a, b) in from_samples.into_iter().zip(from_kernel) {
            assert!((a - b).abs() < 1e-12 * b, "{a} {b}");
        }
        // A camera misses the maximum by what the impactor moves in half a frame at its turning point: next to nothing.
        let filmed = Reading { camera: true, ..Reading::PLAIN }.take(&run).unwrap().values[MAX_DEFORMATION];
        let exact = from_kernel[MAX_DEFORMATION];
        assert!(filmed <= exact && filmed > 0.999 * exact, "{filmed} {exact}");
    }

    #[test]
    fn noise_has_the_spread_that_it_says() {
        let mut series = Series { start: 0.0, interval: SAMPLING_INTERVAL, force: vec![1000.0; 20_000] };
        Noise { force: 5.0, calibration: 0.0, seed: 3 }.apply(&mut series);
        let mean = series.force.iter().sum::<f64>() / 2e4;
        let spread = (series.force.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / 2e4).sqrt();
        // Four standard errors of 20,000 samples.
        assert!((mean - 1000.0).abs() < 0.15 && (spread - 5.0).abs() < 0.1, "{mean} {spread}");
    }

    #[test]
    fn a_calibration_error_is_one_for_the_record() {
        let gains: Vec<f64> = (0..2000)
            .map(|seed| {
                let mut series = Series { start: 0.0, interval: SAMPLING_INTERVAL, force: vec![1.0, 2.0] };
                Noise { force: 0.0, calibration: 0.01, seed }.apply(&mut series);
                assert_eq!(series.force[1], 2.0 * series.force[0]);
                series.force[0] - 1.0
            })
            .collect();
        let spread = (gains.iter().map(|gain| gain * gain).sum::<f64>() / 2e3).sqrt();
        assert!((spread - 0.01).abs() < 1e-3, "{spread}");
    }
}
