//! What the pictures show, in display units.

use serde::{Deserialize, Serialize};
use softanvil_kernel::state::Scalars;

use super::shown::Shown;
use crate::measurement::quantity::{MAX_DEFORMATION, PEAK_FORCE};
use crate::run::Run;

/// Milliseconds in a second, millimetres in a metre.
const MILLI: f64 = 1e3;

/// One run in one picture.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Curve {
    /// What the legend calls it.
    pub label: String,
    /// The curve.
    pub points: Vec<(f64, f64)>,
    /// What the experiment says about it.
    pub measured: Option<Measured>,
}

/// A measured value in a picture.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Measured {
    /// A force whose time is not known, drawn as a line over this range.
    Level {
        /// Range along the horizontal axis.
        over: [f64; 2],
        /// Force, N.
        force: f64,
    },
    /// A force and a deformation.
    Point(f64, f64),
}

impl Measured {
    /// The corner of its bounding box that is farthest from the origin.
    pub fn corner(&self) -> (f64, f64) {
        match *self {
            Self::Level { over, force } => (over[1], force),
            Self::Point(x, y) => (x, y),
        }
    }
}

/// Half the length of the line of a measured peak force, in durations of the contact.
const LEVEL_REACH: f64 = 0.12;

/// Contact force, N, over time since contact, ms.
pub fn force_time(shown: &[Shown]) -> Vec<Curve> {
    shown
        .iter()
        .map(|shown| {
            let points = sampled(shown.run, |run, [from, to]| MILLI * 0.5 * (run.time(from) + run.time(to)));
            let start = points.first().map_or(0.0, |first| first.0);
            let points: Vec<_> = points.into_iter().map(|(time, force)| (time - start, force)).collect();
            let measured = shown.experiment.map(|values| {
                let peak = time_of_peak(&points);
                let reach = LEVEL_REACH * points.last().map_or(0.0, |last| last.0);
                let over = [(peak - reach).max(0.0), peak + reach];
                Measured::Level { over, force: values[PEAK_FORCE] }
            });
            Curve { label: shown.label.clone(), points, measured }
        })
        .collect()
}

/// Contact force, N, over deformation, mm.
pub fn force_deformation(shown: &[Shown]) -> Vec<Curve> {
    shown
        .iter()
        .map(|shown| {
            let depth = |sample: &Scalars| sample.impactor.deformation();
            let points = sampled(shown.run, |_, [from, to]| MILLI * 0.5 * (depth(from) + depth(to)));
            let measured =
                shown.experiment.map(|values| Measured::Point(MILLI * values[MAX_DEFORMATION], values[PEAK_FORCE]));
            Curve { label: shown.label.clone(), points, measured }
        })
        .collect()
}

/// Contact force over `abscissa`, from the last sample before contact to the first after it. A sample is the mean over
/// its interval, so it is drawn at the middle of it.
fn sampled(run: &Run, abscissa: impl Fn(&Run, [&Scalars; 2]) -> f64) -> Vec<(f64, f64)> {
    let points: Vec<_> = run
        .samples()
        .windows(2)
        .map(|pair| (abscissa(run, [&pair[0], &pair[1]]), pair[1].sampler.last.contact_force))
        .collect();
    let loaded = |point: &(f64, f64)| point.1 > 0.0;
    let Some(first) = points.iter().position(loaded) else { return Vec::new() };
    let last = points.iter().rposition(loaded).unwrap_or(first);
    points[first.saturating_sub(1)..points.len().min(last + 2)].to_vec()
}

fn time_of_peak(points: &[(f64, f64)]) -> f64 {
    points.iter().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0.0, |peak| peak.0)
}
