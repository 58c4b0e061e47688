//! Any parameter of the scenario.

use softanvil_kernel::parameter::{Kind, Values};
use softanvil_kernel::{Changes, Parameter, Scenario};

use super::case::{Case, Outcome};
use super::evaluation::{Evaluation, Picture};
use super::results::{Results, Study};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::measurement::series::{Sensor, Series};
use crate::plot::StudyLine;
use crate::scenario_file::{assign, names};

/// A study of `parameter`, which the user calls `name`.
pub fn study(name: &str, parameter: Parameter) -> &'static Study {
    let unit = parameter.unit();
    // One study, which lives as long as the program: tables and pages hold on to it.
    let name: &'static str = name.to_string().leak();
    let setting: &'static str = match parameter.kind() {
        Kind::Choice { .. } => name,
        Kind::Quantity | Kind::Count => format!("{name} [{unit}]").leak(),
    };
    Box::leak(Box::new(Study {
        name,
        title: name,
        about: parameter.description(),
        values: format!("{name} ({unit})").leak(),
        default_values: &[],
        settings: Box::leak(Box::new([setting])),
        plan: |study, scenario, values| plan(parameter_of(study, scenario)?, scenario, values),
        evaluate,
    }))
}

fn parameter_of(study: &Study, scenario: &Scenario) -> Result<Parameter, Failure> {
    names::find(&Values::of(scenario), study.name).map_err(Failure::Failed)
}

fn plan(parameter: Parameter, scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let mut cases = vec![(parameter.get(scenario), scenario.clone())];
    for text in values {
        let mut changes = Changes::of(scenario);
        let scenario = assign::set_bare(&mut changes, parameter, text)
            .and_then(|()| changes.apply().map_err(|error| error.to_string()))
            .map_err(|error| Failure::Input(format!("study {}: {error}", parameter.name())))?;
        cases.push((parameter.get(&scenario), scenario));
    }
    cases.sort_by(|a, b| a.0.total_cmp(&b.0));
    cases.dedup_by(|a, b| a.0 == b.0);
    let case = |(value, scenario)| Case { settings: vec![text(&parameter, value)], scenario: Ok(scenario) };
    Ok(cases.into_iter().map(case).collect())
}

/// A value as it is written in a scenario file.
fn text(parameter: &Parameter, value: f64) -> String {
    match parameter.kind() {
        Kind::Choice { labels } => labels.get(value as usize).copied().unwrap_or_default().into(),
        Kind::Quantity | Kind::Count => value.to_string(),
    }
}

fn evaluate(results: &Results) -> Evaluation {
    let parameter = parameter_of(results.study, &results.scenario).ok();
    let own = parameter.map(|parameter| text(&parameter, parameter.get(&results.scenario))).unwrap_or_default();
    let reference = results.find(&[&own]);
    let mut notes = vec![format!("Changes are from {} = {own}, the scenario's own value.", results.study.name)];
    let mut hashes: Vec<String> = results.done().map(|(_, outcome)| outcome.run.trace_hash()).collect();
    let count = hashes.len();
    hashes.dedup();
    if count > 1 && hashes.len() == 1 {
        notes.push(format!("{} changes nothing in this scenario, to the last bit.", results.study.name));
    }
    Evaluation {
        sheets: vec![results.sheet("Impacts", &[0], |_| true, reference)],
        findings: Vec::new(),
        notes,
        picture: match parameter.map(|parameter| parameter.kind()) {
            Some(Kind::Quantity | Kind::Count) => lines(results, reference),
            _ => forces(results),
        },
    }
}

/// A range of more than this factor is shown on a logarithmic axis.
const WIDE: f64 = 20.0;

fn lines(results: &Results, reference: Option<&Outcome>) -> Picture {
    let points = |i: usize| {
        let change = |outcome: &Outcome| Some(error_percent(outcome.values[i], reference?.values[i]));
        let point = |(case, outcome): (&Case, &Outcome)| {
            Some((case.settings[0].parse().ok()?, change(outcome).filter(|change| change.is_finite())?))
        };
        results.done().filter_map(point).collect::<Vec<(f64, f64)>>()
    };
    let lines: Vec<StudyLine> = QUANTITIES
        .iter()
        .enumerate()
        .map(|(i, quantity)| StudyLine { label: quantity.label.into(), dashed: false, points: points(i) })
        .collect();
    let values: Vec<f64> = lines.iter().flat_map(|line| &line.points).map(|point| point.0).collect();
    let [low, high] = [values.iter().copied().reduce(f64::min), values.iter().copied().reduce(f64::max)];
    let wide = low.zip(high).is_some_and(|(low, high)| low > 0.0 && high > WIDE * low);
    Picture::Lines {
        title: "Change of the four numbers with the parameter",
        x: (results.study.values, wide),
        y: "change (%)",
        lines,
    }
}

fn forces(results: &Results) -> Picture {
    let curve = |(case, outcome): (&Case, &Outcome)| {
        let threshold = outcome.run.constants.scenario.measurement.force_threshold;
        let series = Series::of_run(&outcome.run, Sensor::Contact);
        (case.settings[0].clone(), series.since_onset(threshold))
    };
    Picture::Forces { title: "Force over time", curves: results.done().map(curve).collect() }
}
