//! Frequency-independent damping: the modulus of the spring and the limit stress of the slider.

use softanvil_identify::study::{DAMPING_MODULUS, LIMIT_STRESSES};
use softanvil_kernel::{Parameter, Scenario};

use super::case::{Case, Outcome};
use super::evaluation::{Evaluation, Finding, Picture};
use super::results::{Results, Study, percent};
use super::values::{numbers, set, with_own};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::PEAK_FORCE;
use crate::paper::{LOW_DAMPING_MODULUS, LOW_DAMPING_PERCENT};
use crate::plot::StudyLine;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "damping",
    title: "Damping modulus and limit stress",
    about: "The paper damps by a spring of shear modulus G in series with a slider, tuned G on the peak at 14.7 J, and \
            found that a higher G gives a higher peak and less vibration. It does not print the limit stress of the \
            slider; the rule of thumb in the manual of its solver gives 0.047 to 0.188 MPa for its G. Both are changed here; without limit the \
            slider never slips, and the spring is one more elastic law. Vibration is how much the force rises and falls \
            beyond one rise to the peak and one fall from it.",
    values: "moduli G of the damping spring, MPa",
    default_values: &["0.06", "1", "5", "20", "47", "100"],
    settings: &["limit stress [kPa]", "G [MPa]"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

/// Name of the limit that is never reached.
const NO_LIMIT: &str = "none";

/// Limit stresses, Pa, with their names.
fn limits(scenario: &Scenario) -> Vec<(String, f64)> {
    let own = scenario.layers[0].material.slider_yield_stress;
    let stresses = with_own(vec![LIMIT_STRESSES.0, LIMIT_STRESSES.1], own).into_iter().filter(|stress| *stress > 0.0);
    let unlimited =
        Parameter::find("layers[0].slider_yield_stress").map(|parameter| (NO_LIMIT.into(), parameter.range().1));
    stresses.map(|stress| (short(1e-3 * stress), stress)).chain(unlimited).collect()
}

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let mut moduli = numbers("damping", values)?;
    moduli.extend([1e-6 * LOW_DAMPING_MODULUS, 1e-6 * DAMPING_MODULUS]);
    let moduli = with_own(moduli, 1e-6 * scenario.layers[0].material.slider_stiffness);
    let mut cases = Vec::new();
    for (name, stress) in limits(scenario) {
        for modulus in &moduli {
            let mut scenario = scenario.clone();
            set(&mut scenario, "layers[0].slider_stiffness", 1e6 * modulus)?;
            set(&mut scenario, "layers[0].slider_yield_stress", stress)?;
            cases.push(Case { settings: vec![name.clone(), short(*modulus)], scenario: Ok(scenario) });
        }
    }
    Ok(cases)
}

fn evaluate(results: &Results) -> Evaluation {
    let limits = limits(&results.scenario);
    let own = short(1e-3 * results.scenario.layers[0].material.slider_yield_stress);
    let mut evaluation =
        Evaluation { sheets: Vec::new(), findings: Vec::new(), notes: Vec::new(), picture: picture(results, &limits) };
    for (name, _) in &limits {
        let find = |modulus: f64| results.find(&[name, &short(1e-6 * modulus)]);
        let high = find(DAMPING_MODULUS);
        let title = match name.as_str() {
            NO_LIMIT => "Impacts without limit stress".to_string(),
            _ => format!("Impacts with a limit stress of {name} kPa"),
        };
        let mut sheet = results.sheet(&title, &[1], |case| case.settings[0] == *name, high);
        sheet.header.push("vibration (% of the peak)".into());
        let cases = results.cases.iter().zip(&results.outcomes).filter(|(case, _)| case.settings[0] == *name);
        for (row, (_, outcome)) in sheet.rows.iter_mut().zip(cases) {
            let outcome = outcome.as_ref().and_then(|outcome| outcome.as_ref().ok());
            row.push(outcome.map_or("-".into(), |outcome| format!("{:.1}", outcome.vibration())));
        }
        evaluation.sheets.push(sheet);
        if let (Some(low), Some(high)) = (find(LOW_DAMPING_MODULUS), high) {
            evaluation.findings.extend(compare(name, *name == own, low, high));
        }
    }
    evaluation
}

/// What the paper says of a low and a high modulus, for one limit stress.
fn compare(limit: &str, own: bool, low: &Outcome, high: &Outcome) -> [Finding; 2] {
    let [low_g, high_g] = [LOW_DAMPING_MODULUS, DAMPING_MODULUS].map(|modulus| short(1e-6 * modulus));
    let limit = match limit {
        NO_LIMIT => "no limit stress".to_string(),
        _ if own => format!("limit stress {limit} kPa, as it is"),
        _ => format!("limit stress {limit} kPa"),
    };
    let change = error_percent(low.values[PEAK_FORCE], high.values[PEAK_FORCE]);
    let vibration = [low, high].map(Outcome::vibration);
    [
        Finding {
            key: "low_modulus_peak",
            what: format!("{limit}: peak force at G = {low_g} MPa against {high_g} MPa"),
            paper: format!("more than {LOW_DAMPING_PERCENT} % too low"),
            here: percent(change),
            value: change,
        },
        Finding {
            key: "vibration",
            what: format!("{limit}: vibration at G = {low_g} and {high_g} MPa"),
            paper: "less with the higher G".into(),
            here: format!("{:.1} and {:.1} % of the peak", vibration[0], vibration[1]),
            value: vibration[1] - vibration[0],
        },
    ]
}

fn picture(results: &Results, limits: &[(String, f64)]) -> Picture {
    let line = |(name, _): &(String, f64)| StudyLine {
        label: if name == NO_LIMIT { "no limit stress".into() } else { format!("limit stress {name} kPa") },
        dashed: false,
        points: results
            .done()
            .filter(|(case, _)| case.settings[0] == *name)
            .filter_map(|(case, outcome)| Some((case.settings[1].parse().ok()?, outcome.values[PEAK_FORCE])))
            .filter(|(modulus, _)| *modulus > 0.0)
            .collect(),
    };
    Picture::Lines {
        title: "Peak force by the modulus of the damping spring",
        x: ("modulus G (MPa)", true),
        y: "peak force (N)",
        lines: limits.iter().map(line).collect(),
    }
}
