//! The picture of a sweep.

use itertools::Itertools;

use super::case::{Case, Outcome};
use super::convergence::judged;
use super::results::Results;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::measurement::series::{CONTACT_FORCE, Sensor, Series};
use crate::plot::{self, Line, PlotError};

/// Most curves in a picture: as many as there are colours.
const CURVES: usize = 6;

/// A range of more than this factor is shown on a logarithmic axis.
const WIDE: f64 = 20.0;

/// A group of cases, and the point of a case in a picture.
type Group<'a> = [(&'a Case, &'a Outcome)];

/// Draws `results` as SVG: over numbers the changes of a group, or the forces of several; else forces over time.
///
/// # Errors
/// What the drawing library refuses.
pub fn draw(results: &Results) -> Result<String, PlotError> {
    let (sweep, groups) = (&results.sweep, results.groups());
    let last = sweep.axes.last().filter(|_| !sweep.refines());
    if last.is_some_and(|axis| !axis.is_of_numbers()) {
        return forces(results);
    }
    let x = last.map_or("element size (mm)".into(), |axis| axis.name.replace('[', "(").replace(']', ")"));
    let at = |case: &Case| match last {
        Some(_) => case.settings.last().and_then(|text| text.parse().ok()),
        None => Some(1e3 * case.scenario.mesh.element_size),
    };
    let groups = || groups.iter().filter(|(_, cases)| cases.len() > 1);
    let (title, y, mut lines) = match groups().collect::<Vec<_>>()[..] {
        [(_, group)] => ("Changes of the numbers", "change (%)", changes(results, group, &at)),
        _ => {
            let point = |(case, outcome): &(&Case, &Outcome)| Some((at(case)?, outcome.force()));
            let line = |(name, group): &(String, Vec<_>)| line(name, group.iter().filter_map(point));
            ("Force: peak of an impact, held force of a press", "force (N)", groups().take(CURVES).map(line).collect())
        }
    };
    let values = lines.iter().flat_map(|line: &Line| &line.points).map(|point| point.0).filter(|x| *x > 0.0);
    let is_wide = values.minmax().into_option().is_some_and(|(low, high)| high > WIDE * low);
    if is_wide {
        // Zero has no place on a logarithmic axis.
        lines.iter_mut().for_each(|line| line.points.retain(|point| point.0 > 0.0));
    }
    plot::lines(title, (&x, is_wide), y, &lines)
}

/// Changes of the numbers from the reference of `group`.
fn changes(results: &Results, group: &Group, at: &impl Fn(&Case) -> Option<f64>) -> Vec<Line> {
    let mut judged = judged();
    judged.retain(|judged| results.sweep.refines() || QUANTITIES.iter().any(|quantity| quantity.label == judged.label));
    let of = |read: &dyn Fn(&Outcome) -> f64| {
        let point = |(case, outcome): &(&Case, &Outcome)| {
            let change = error_percent(read(outcome), read(results.outcome(case.reference)?));
            Some((at(case)?, change)).filter(|_| change.is_finite())
        };
        group.iter().filter_map(point).collect::<Vec<_>>()
    };
    judged.iter().map(|judged| line(&judged.label, of(&judged.read))).collect()
}

fn line(label: &str, points: impl IntoIterator<Item = (f64, f64)>) -> Line {
    Line { label: label.into(), points: points.into_iter().collect() }
}

/// Forces over time of the first cases.
fn forces(results: &Results) -> Result<String, PlotError> {
    let curve = |(case, outcome): (&Case, &Outcome)| {
        (case.settings.join(", "), Series::of_run_since_onset(&outcome.run, Sensor::Contact))
    };
    plot::forces("Force over time", CONTACT_FORCE, results.done().take(CURVES).map(curve).collect())
}
