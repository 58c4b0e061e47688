//! Poisson's ratio, that is, the bulk modulus of the layer.

use softanvil_kernel::Scenario;
use softanvil_kernel::material::VolumetricBy;
use softanvil_kernel::scenario::Interface;

use super::case::Case;
use super::evaluation::{Evaluation, Finding, Picture};
use super::results::{Results, Study, percent};
use super::values::{numbers, set, with_own};
use super::variants::{ratio_of, set_ratio};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{PEAK_FORCE, QUANTITIES};
use crate::paper::{DAMPING_YOUNGS_MODULUS, POISSON};
use crate::plot::StudyLine;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "poisson",
    title: "Poisson's ratio",
    about: "Poisson's ratio sets the bulk modulus, K = 2 G (1 + nu) / (3 (1 - 2 nu)) with the shear modulus G of the \
            long-term law at rest. The paper took 0.48 and saw nothing change at 0.49, although K doubles on the way. \
            A thin layer that is wide and held on both sides can give way only by changing its volume, so that it should \
            feel K. Tried are a core to which it is bonded, and which it only touches without any friction, and a bulk \
            modulus from the 140 MPa of which the paper computed its damping modulus.",
    values: "Poisson's ratios",
    default_values: &["0.38", "0.42", "0.45", "0.47", "0.48", "0.49"],
    settings: &["variant", "Poisson's ratio"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

/// A variant of the drop.
struct Variant {
    key: &'static str,
    name: &'static str,
    /// Makes the variant for a ratio.
    make: fn(Scenario, f64) -> Result<Scenario, Failure>,
}

static VARIANTS: [Variant; 5] = [
    Variant { key: "as_it_is", name: "as it is", make: |scenario, ratio| with_ratio(scenario, ratio) },
    Variant {
        key: "bonded",
        name: "core bonded",
        make: |mut scenario, ratio| {
            scenario.core.interface = Interface::Bonded;
            with_ratio(scenario, ratio)
        },
    },
    Variant {
        key: "frictionless",
        name: "core in contact, no friction",
        make: |mut scenario, ratio| {
            scenario.core.interface = Interface::Frictional;
            set(&mut scenario, "core.friction_coefficient", 0.0)?;
            set(&mut scenario, "face.friction_coefficient", 0.0)?;
            with_ratio(scenario, ratio)
        },
    },
    Variant { key: "stiff_bulk", name: "bulk modulus of E = 140 MPa", make: with_stiff_bulk },
    Variant {
        key: "stiff_bulk_bonded",
        name: "the same, core bonded",
        make: |mut scenario, ratio| {
            scenario.core.interface = Interface::Bonded;
            with_stiff_bulk(scenario, ratio)
        },
    },
];

fn with_ratio(mut scenario: Scenario, ratio: f64) -> Result<Scenario, Failure> {
    set_ratio(&mut scenario, ratio)?;
    Ok(scenario)
}

/// The bulk modulus that belongs to the paper's 140 MPa.
fn with_stiff_bulk(mut scenario: Scenario, ratio: f64) -> Result<Scenario, Failure> {
    scenario.layers[0].material.volumetric_by = VolumetricBy::BulkModulus;
    set(&mut scenario, "layers[0].bulk_modulus", DAMPING_YOUNGS_MODULUS / (3.0 * (1.0 - 2.0 * ratio)))?;
    Ok(scenario)
}

fn is_stiff(variant: &Variant) -> bool {
    variant.key.starts_with("stiff_bulk")
}

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let mut cases = Vec::new();
    let own = (ratio_of(scenario) * 1e4).round() / 1e4;
    let values = with_own(numbers("poisson", values)?, own);
    for variant in &VARIANTS {
        // The paper's range is what these are for, and their steps are short.
        let ratios = if is_stiff(variant) { &POISSON.range[..] } else { &values };
        for ratio in ratios {
            let scenario = (variant.make)(scenario.clone(), *ratio)?;
            cases.push(Case { settings: vec![variant.name.into(), short(*ratio)], scenario: Ok(scenario) });
        }
    }
    Ok(cases)
}

/// Changes of the four numbers of a variant over the paper's range, %.
fn changes(results: &Results, variant: &Variant) -> Option<[f64; QUANTITIES.len()]> {
    let [low, high] = POISSON.range.map(|ratio| results.find(&[variant.name, &short(ratio)]));
    let (low, high) = (low?, high?);
    Some(std::array::from_fn(|i| error_percent(high.values[i], low.values[i])))
}

fn evaluate(results: &Results) -> Evaluation {
    let own = short((ratio_of(&results.scenario) * 1e4).round() / 1e4);
    let mut evaluation =
        Evaluation { sheets: Vec::new(), findings: Vec::new(), notes: Vec::new(), picture: picture(results) };
    let [low, high] = POISSON.range;
    for variant in &VARIANTS {
        let title = format!("Impacts, {}", variant.name);
        let reference = results.find(&[variant.name, &own]).or_else(|| results.find(&[variant.name, &short(low)]));
        evaluation.sheets.push(results.sheet(&title, &[1], |case| case.settings[0] == variant.name, reference));
        let Some(changes) = changes(results, variant) else { continue };
        let largest = changes.into_iter().fold(0.0, |a, b| if b.abs() > f64::abs(a) { b } else { a });
        evaluation.findings.push(Finding {
            key: variant.key,
            what: format!("{low} to {high}, {}: change of force, deformation, duration, impulse", variant.name),
            paper: if variant.key == "as_it_is" { format!("below {} %", POISSON.below_percent) } else { "-".into() },
            here: changes.map(percent).join(", "),
            value: largest,
        });
    }
    evaluation
}

fn picture(results: &Results) -> Picture {
    let line = |variant: &Variant| StudyLine {
        label: variant.name.into(),
        dashed: false,
        points: results
            .done()
            .filter(|(case, _)| case.settings[0] == variant.name)
            .filter_map(|(case, outcome)| Some((case.settings[1].parse().ok()?, outcome.values[PEAK_FORCE])))
            .collect(),
    };
    // Another bulk modulus at the same ratio has no place on this axis.
    let shown = VARIANTS.iter().filter(|variant| !is_stiff(variant));
    Picture::Lines {
        title: "Peak force by Poisson's ratio",
        x: ("Poisson's ratio", false),
        y: "peak force (N)",
        lines: shown.map(line).collect(),
    }
}
