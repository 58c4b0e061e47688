//! Outer diameter of the anvil.

use softanvil_kernel::Scenario;

use super::case::{Case, Outcome};
use super::evaluation::{Evaluation, Finding, Picture};
use super::results::{Results, Study, percent};
use super::values::{numbers, set, with_own};
use crate::failure::Failure;
use crate::measurement::errors::{error_percent, errors_percent, mean_absolute};
use crate::measurement::quantity::{PEAK_FORCE, QUANTITIES};
use crate::measurement::series::{Sensor, Series};
use crate::paper;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "diameter",
    title: "Outer diameter of the anvil",
    about: "The paper calls its anvil as large as the 115 mm steel anvil of the test standard, but a core of 75 mm under a \
            layer of 15 mm makes 105 mm. What if it were 115 mm: by a thicker core under the same layer, or by a thicker \
            layer on the same core?",
    values: "outer diameters, mm",
    default_values: &["105", "110", "115"],
    settings: &["diameter [mm]", "made by"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

/// The part that makes up for another diameter.
const CORE: &str = "core";
/// See [`CORE`].
const LAYER: &str = "layer";

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let geometry = &scenario.geometry;
    let own = diameter(scenario);
    let mut cases = Vec::new();
    for outer in with_own(numbers("diameter", values)?, own) {
        let more = 0.5e-3 * (outer - own);
        if short(outer) == short(own) {
            cases.push(Case { settings: vec![short(own), "as it is".into()], scenario: Ok(scenario.clone()) });
            continue;
        }
        for (part, name, value) in [
            (CORE, "geometry.core_radius", geometry.core_radius + more),
            (LAYER, "layers[0].thickness", scenario.layers[0].thickness + more),
        ] {
            let mut scenario = scenario.clone();
            set(&mut scenario, name, value)?;
            cases.push(Case { settings: vec![short(outer), part.into()], scenario: Ok(scenario) });
        }
    }
    Ok(cases)
}

/// Outer diameter, mm.
fn diameter(scenario: &Scenario) -> f64 {
    2e3 * (scenario.geometry.core_radius + scenario.thickness())
}

fn evaluate(results: &Results) -> Evaluation {
    let own = results.find(&[&short(diameter(&results.scenario)), "as it is"]);
    let mut findings = Vec::new();
    let standard = short(1e3 * paper::STANDARD_DIAMETER);
    for (part, key) in [(CORE, "peak_force_115_core"), (LAYER, "peak_force_115_layer")] {
        if let (Some(own), Some(outcome)) = (own, results.find(&[&standard, part])) {
            let change = error_percent(outcome.values[PEAK_FORCE], own.values[PEAK_FORCE]);
            let what = format!("peak force of {standard} mm by the {part}, against the anvil as it is");
            findings.push(Finding { key, what, paper: "-".into(), here: percent(change), value: change });
        }
    }
    let curve = |(case, outcome): (&Case, &Outcome)| {
        let threshold = outcome.run.constants.scenario.measurement.force_threshold;
        let series = Series::of_run(&outcome.run, Sensor::Contact);
        (format!("{} mm, {}", case.settings[0], case.settings[1]), series.since_onset(threshold))
    };
    Evaluation {
        sheets: vec![results.sheet("Impacts", &[0, 1], |_| true, own)],
        findings,
        notes: own.and_then(|own| against_experiment(results, own, &standard)).into_iter().collect(),
        picture: Picture::Forces {
            title: "Force over time with the outer diameter of the anvil",
            curves: results.done().map(curve).collect(),
        },
    }
}

/// Mean error against the experiment of the anvil as it is and of the standard's diameter, where the energy is one of
/// the paper's.
fn against_experiment(results: &Results, own: &Outcome, standard: &str) -> Option<String> {
    let case = paper::TABLE_1.iter().find(|case| is_energy(&results.scenario, case.energy))?;
    let error = |outcome: &Outcome| mean_absolute(errors_percent(&outcome.values, &case.experiment).into_iter());
    let [core, layer] = [CORE, LAYER].map(|part| results.find(&[standard, part]).map(error));
    let fitted = results.fitted().map_or(String::new(), |fitted| format!(" {fitted}"));
    Some(format!(
        "Mean error of the {} numbers against the experiment: {:.1} % as it is, {:.1} % with {standard} mm by the core, \
         {:.1} % by the layer; the material was not identified anew.{fitted}",
        QUANTITIES.len(),
        error(own),
        core?,
        layer?
    ))
}

/// Whether this is the paper's drop with the impact energy `energy`, J.
pub fn is_energy(scenario: &Scenario, energy: f64) -> bool {
    if !paper::is_its_model(scenario) {
        return false;
    }
    let speed = scenario.impactor.start_speed();
    (0.5 * scenario.impactor.mass * speed * speed / energy - 1.0).abs() < 1e-6
}
