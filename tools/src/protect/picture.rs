//! Pictures of pads: transmitted forces over time, sections at the largest compression, and forces over thickness.

use itertools::Itertools;

use super::trial::{Outcome, Trial};
use crate::measurement::series::{Sensor, Series};
use crate::plot::{self, Line, PlotError};
use crate::section::picture::{self, Shot};

/// Most curves and sections in a picture: as many as there are colours.
const SHOWN: usize = 6;

/// Name and SVG of each picture.
///
/// # Errors
/// What the drawing library refuses.
pub fn pictures(trial: &Trial) -> Result<Vec<(&'static str, String)>, PlotError> {
    let mut pictures = vec![("forces", forces(trial)?), ("sections", sections(trial))];
    if let Some(over_thickness) = over_thickness(trial) {
        pictures.push(("thickness", over_thickness?));
    }
    Ok(pictures)
}

/// The bare anvil and the first pads, each with what it is called.
fn shown(trial: &Trial) -> impl Iterator<Item = (String, &Outcome)> {
    let bare = trial.bare.iter().map(|bare| ("bare".to_string(), bare));
    bare.chain(trial.done().map(|(case, outcome)| (trial.label(case), outcome))).take(SHOWN)
}

/// Transmitted forces over time.
fn forces(trial: &Trial) -> Result<String, PlotError> {
    let curve = |(label, outcome): (String, &Outcome)| {
        let cut = crate::run::suffix(&outcome.run);
        (format!("{label}{cut}"), Series::of_run_since_onset(&outcome.run, Sensor::Core))
    };
    plot::forces("Transmitted force over time", Sensor::Core.axis(), shown(trial).map(curve).collect())
}

/// Sections at the largest compression.
fn sections(trial: &Trial) -> String {
    let shots: Vec<Shot> = shown(trial)
        .filter_map(|(label, outcome)| Some(Shot { label, animation: outcome.animation.as_ref()? }))
        .collect();
    picture::maximum_compression(&shots)
}

/// Peak transmitted force over the pad's thickness, a line for each pad; none of one thickness.
fn over_thickness(trial: &Trial) -> Option<Result<String, PlotError>> {
    let points = trial.done().map(|(case, outcome)| {
        let numbers = &outcome.numbers;
        (case.name.clone(), (1e3 * numbers.pad_thickness, 1e-3 * numbers.transmitted))
    });
    let mut lines: Vec<Line> = Vec::new();
    for (label, group) in &points.chunk_by(|(name, _)| name.clone()) {
        let mut points: Vec<(f64, f64)> = group.map(|(_, point)| point).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        lines.push(Line { label, points });
    }
    lines.truncate(SHOWN);
    let several = lines.iter().any(|line| line.points.len() > 1);
    several.then(|| plot::lines("Peak transmitted force", ("pad thickness (mm)", false), "force (kN)", &lines))
}
