//! The picture of the comparison.

use super::{Comparison, Reduction};
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::measurement::series::{CONTACT_FORCE, Sensor, Series};
use crate::plot::{self, Line, PlotError};
use crate::sweep::case::Outcome;

/// Most scenarios whose forces are drawn: two curves each.
const SCENARIOS: usize = 3;

/// Draws a comparison as SVG: differences of the section from the solid over a parameter that is a number, the only one
/// that changes; else the forces of the first scenarios over time.
///
/// # Errors
/// What the drawing library refuses.
pub fn draw(reduction: &Reduction) -> Result<String, PlotError> {
    let at = |comparison: &Comparison| comparison.settings.first()?.parse::<f64>().ok();
    let places: Option<Vec<f64>> = reduction.comparisons.iter().map(at).collect();
    match (&reduction.headings[..], places) {
        ([heading], Some(places)) if places.len() > 1 => differences(reduction, heading, &places),
        _ => forces(reduction),
    }
}

/// Differences of the four numbers of the section from those of the solid, %, over the parameter's values.
fn differences(reduction: &Reduction, heading: &str, places: &[f64]) -> Result<String, PlotError> {
    let mut order: Vec<(f64, &Comparison)> = places.iter().copied().zip(&reduction.comparisons).collect();
    order.sort_by(|one, other| one.0.total_cmp(&other.0));
    let line = |(number, label): (usize, &str)| {
        let difference = |comparison: &Comparison| {
            let [section, solid] = [&comparison.section, &comparison.solid].map(|outcome| outcome.values[number]);
            error_percent(section, solid)
        };
        let points =
            order.iter().map(|(at, comparison)| (*at, difference(comparison))).filter(|point| point.1.is_finite());
        Line { label: label.into(), points: points.collect() }
    };
    let lines: Vec<Line> = QUANTITIES.iter().map(|quantity| quantity.label).enumerate().map(line).collect();
    let x = heading.replace('[', "(").replace(']', ")");
    plot::lines("The section against the solid", (&x, false), "difference from the solid (%)", &lines)
}

/// Forces over time, of the solid and of the section.
fn forces(reduction: &Reduction) -> Result<String, PlotError> {
    let curve = |name: &str, comparison: &Comparison, outcome: &Outcome| {
        let label = [&comparison.settings[..], &[name.into()]].concat().join(", ");
        (label, Series::of_run_since_onset(&outcome.run, Sensor::Contact))
    };
    let of = |comparison: &Comparison| {
        [("solid", &comparison.solid), ("section", &comparison.section)]
            .map(|(name, outcome)| curve(name, comparison, outcome))
    };
    let curves = reduction.comparisons.iter().take(SCENARIOS).flat_map(of).collect();
    plot::forces("The section against the solid", CONTACT_FORCE, curves)
}
