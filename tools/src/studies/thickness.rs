//! Thickness of the silicone.

use softanvil_kernel::Scenario;

use super::case::Case;
use super::evaluation::{Evaluation, Finding, Picture};
use super::results::{Results, Study, percent};
use super::values::{numbers, set, with_own};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{MAX_DEFORMATION, PEAK_FORCE, QUANTITIES};
use crate::plot::StudyLine;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "thickness",
    title: "Thickness of the layer",
    about: "The layer is made thinner and thicker on the same core, with everything else as it is. The paper has one \
            thickness, 14 mm of silicone and a skin of 1 mm; a layer is never cast to the last tenth of a millimetre.",
    values: "thicknesses of the layer (of the silicone, under a skin of its own), mm",
    default_values: &["11", "13", "14", "15", "16", "17", "19"],
    settings: &["thickness [mm]"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let own = 1e3 * scenario.layers[0].thickness;
    let case = |thickness: f64| {
        let mut scenario = scenario.clone();
        set(&mut scenario, "layers[0].thickness", 1e-3 * thickness)?;
        Ok(Case { settings: vec![short(thickness)], scenario: Ok(scenario) })
    };
    with_own(numbers("thickness", values)?, own).into_iter().map(case).collect()
}

fn evaluate(results: &Results) -> Evaluation {
    let own = 1e3 * results.scenario.layers[0].thickness;
    let reference = results.find(&[&short(own)]);
    let points = |i: usize| {
        let change = |outcome: &super::case::Outcome| Some(error_percent(outcome.values[i], reference?.values[i]));
        results.done().filter_map(|(case, outcome)| Some((case.settings[0].parse().ok()?, change(outcome)?))).collect()
    };
    let lines: Vec<StudyLine> = QUANTITIES
        .iter()
        .enumerate()
        .map(|(i, quantity)| StudyLine { label: quantity.label.into(), dashed: false, points: points(i) })
        .collect();
    let mut findings = Vec::new();
    for (i, key, what) in [
        (PEAK_FORCE, "peak_force_per_mm", "peak force, per mm of thickness"),
        (MAX_DEFORMATION, "max_deformation_per_mm", "largest deformation, per mm of thickness"),
    ] {
        if let Some(slope) = slope(&lines[i].points, own) {
            findings.push(Finding { key, what: what.into(), paper: "-".into(), here: percent(slope), value: slope });
        }
    }
    Evaluation {
        sheets: vec![results.sheet("Impacts", &[0], |_| true, reference)],
        findings,
        notes: Vec::new(),
        picture: Picture::Lines {
            title: "Change of the four numbers with the thickness of the layer",
            x: ("thickness of the layer (mm)", false),
            y: "change (%)",
            lines,
        },
    }
}

/// Slope between the neighbours of `at` among `points`.
fn slope(points: &[(f64, f64)], at: f64) -> Option<f64> {
    let below = points.iter().rev().find(|point| point.0 < at - 1e-9)?;
    let above = points.iter().find(|point| point.0 > at + 1e-9)?;
    Some((above.1 - below.1) / (above.0 - below.0))
}
