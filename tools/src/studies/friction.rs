//! Friction under the face and at the core, and what hides it.

use softanvil_identify::study::{DAMPING_MODULUS, LIMIT_STRESSES};
use softanvil_kernel::Scenario;
use softanvil_kernel::scenario::Interface;

use super::case::{Case, Outcome};
use super::evaluation::{Evaluation, Finding, Picture, Sheet};
use super::results::{Results, Study, percent};
use super::values::{numbers, set, with_own};
use super::variants::{DEPTH, SPEED, press, ratio_of, set_ratio, undamped};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::paper::{self, FRICTION};
use crate::plot::StudyLine;
use crate::text::number::short;

/// The study.
pub static STUDY: Study = Study {
    name: "friction",
    title: "Friction",
    about: "Coulomb friction, under the face and, where the layer is not bonded to the core, there as well. The paper saw \
            almost nothing of it, but friction keeps a nearly incompressible layer from escaping sideways, so that a slow \
            press on an elastic layer feels it clearly. Which mechanism hides it: a core that is not bonded, the damping, \
            the impact's inertia, or a layer that can be compressed? All combinations of the four are simulated; \
            damping is off, the scenario's, or the paper's spring of 47 MPa with a slider at the upper end of its rule of \
            thumb, 188 kPa, alone.",
    values: "friction coefficients of the impact",
    default_values: &["0", "0.1", "0.2", "0.3", "0.4", "0.6"],
    settings: &["loading", "core", "damping", "Poisson's ratio", "friction"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

/// Friction coefficients of the combinations.
const COEFFICIENTS: [f64; 4] = [0.0, 0.2, 0.3, 0.6];

/// The impact that is swept with the values of the command line.
const SWEPT: [&str; 4] = ["impact", "as it is", "on", "as it is"];

const LOADINGS: [&str; 2] = ["press", "impact"];
const CORES: [&str; 2] = ["bonded", "contact"];
const DAMPINGS: [&str; 3] = ["off", "on", "slider"];

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let mut cases = Vec::new();
    for friction in with_own(numbers("friction", values)?, scenario.face.friction_coefficient) {
        let settings = SWEPT.map(String::from).into_iter().chain([short(friction)]);
        cases.push(Case { settings: settings.collect(), scenario: Ok(rubbing(scenario.clone(), friction)?) });
    }
    for combination in combinations(scenario) {
        let [loading, core, damping, ratio] = &combination;
        let mut varied = scenario.clone();
        varied.core.interface = if core == CORES[0] { Interface::Bonded } else { Interface::Frictional };
        if *ratio != own_ratio(scenario) {
            set_ratio(&mut varied, FRICTION_RATIO)?;
        }
        if damping != DAMPINGS[1] {
            varied = undamped(varied);
        }
        if damping == DAMPINGS[2] {
            set(&mut varied, "layers[0].slider_stiffness", DAMPING_MODULUS)?;
            set(&mut varied, "layers[0].slider_yield_stress", LIMIT_STRESSES.1)?;
        }
        if loading == LOADINGS[0] {
            varied = press(varied);
        } else {
            // Without damping or glue the contact lasts longer.
            varied.time.duration *= 2.0;
        }
        for friction in COEFFICIENTS {
            let settings = combination.iter().cloned().chain([short(friction)]).collect();
            cases.push(Case { settings, scenario: Ok(rubbing(varied.clone(), friction)?) });
        }
    }
    Ok(cases)
}

/// Poisson's ratio of the paper's model.
const FRICTION_RATIO: f64 = paper::POISSON.range[0];

/// Friction of both interfaces.
fn rubbing(mut scenario: Scenario, friction: f64) -> Result<Scenario, Failure> {
    set(&mut scenario, "face.friction_coefficient", friction)?;
    set(&mut scenario, "core.friction_coefficient", friction)?;
    Ok(scenario)
}

fn own_ratio(scenario: &Scenario) -> String {
    short((ratio_of(scenario) * 1e4).round() / 1e4)
}

/// Settings of the combinations, without the friction.
fn combinations(scenario: &Scenario) -> Vec<[String; 4]> {
    let mut ratios = vec![short(FRICTION_RATIO), own_ratio(scenario)];
    ratios.dedup();
    let mut combinations = Vec::new();
    for ratio in ratios {
        for core in CORES {
            for damping in DAMPINGS {
                combinations.extend(LOADINGS.map(|loading| [loading, core, damping, &ratio].map(String::from)));
            }
        }
    }
    combinations
}

/// Outcome of a combination with a friction coefficient.
fn outcome<'a>(results: &'a Results, combination: &[String; 4], friction: f64) -> Option<&'a Outcome> {
    let friction = short(friction);
    let settings: Vec<&str> = combination.iter().map(String::as_str).chain([friction.as_str()]).collect();
    results.find(&settings)
}

/// Change of the force of a combination between two friction coefficients, %.
fn effect(results: &Results, combination: &[String; 4], range: [f64; 2]) -> Option<f64> {
    let [low, high] = range.map(|friction| outcome(results, combination, friction).map(Outcome::force));
    Some(error_percent(high?, low?))
}

fn evaluate(results: &Results) -> Evaluation {
    let swept = |case: &Case| case.settings[..4] == SWEPT;
    let friction = short(results.scenario.face.friction_coefficient);
    let own = [&SWEPT[..], &[friction.as_str()]].concat();
    Evaluation {
        sheets: vec![
            results.sheet("The drop as it is", &[4], swept, results.find(&own)),
            combination_sheet(results),
            mechanism_sheet(results),
        ],
        findings: findings(results),
        notes: notes(results),
        picture: picture(results),
    }
}

/// Range of the paper's sweep, and from nothing to its default coefficient.
const RANGES: [[f64; 2]; 2] = [FRICTION.range, [0.0, 0.3]];

fn findings(results: &Results) -> Vec<Finding> {
    let swept = SWEPT.map(String::from);
    let ends = FRICTION.range.map(|friction| outcome(results, &swept, friction));
    let mut findings = Vec::new();
    let [low, high] = FRICTION.range;
    if let [Some(a), Some(b)] = ends {
        let difference = a.largest_difference(b);
        let (peaks, peak) = ((b.force() - a.force()).abs(), a.force());
        let paper = format!("below {} N ({} %)", paper::FRICTION_FORCE, FRICTION.below_percent);
        findings.push(Finding {
            key: "trace_difference",
            what: format!("friction {low} to {high}: largest change of the force at any time"),
            paper: paper.clone(),
            here: format!("{difference:.0} N ({:.1} %)", 100.0 * difference / peak),
            value: difference,
        });
        findings.push(Finding {
            key: "peak_difference",
            what: format!("friction {low} to {high}: change of the peak force"),
            paper,
            here: format!("{peaks:.0} N ({:.1} %)", 100.0 * peaks / peak),
            value: peaks,
        });
    }
    for (key, combination) in named_combinations(results) {
        if let Some(change) = effect(results, &combination, FRICTION.range) {
            let [loading, core, damping, ratio] = &combination;
            findings.push(Finding {
                key,
                what: format!("the same: {loading}, core {core}, damping {damping}, Poisson's ratio {ratio}"),
                paper: "-".into(),
                here: percent(change),
                value: change,
            });
        }
    }
    findings
}

/// The combination that feels friction as an elastic layer does, and those that differ from it in one thing, for
/// programs by name.
fn named_combinations(results: &Results) -> Vec<(&'static str, [String; 4])> {
    let plain = [LOADINGS[0], CORES[0], DAMPINGS[0], &short(FRICTION_RATIO)].map(String::from);
    let with = |index: usize, text: &str| {
        let mut combination = plain.clone();
        combination[index] = text.into();
        combination
    };
    let impact = |core: usize, damping: usize| {
        [LOADINGS[1], CORES[core], DAMPINGS[damping], &short(FRICTION_RATIO)].map(String::from)
    };
    vec![
        ("elastic_press", plain.clone()),
        ("contact_core", with(1, CORES[1])),
        ("impact", with(0, LOADINGS[1])),
        ("damped_press", with(2, DAMPINGS[1])),
        ("own_poissons_ratio", with(3, &own_ratio(&results.scenario))),
        ("damped_impact", impact(0, 1)),
        ("slider_impact", impact(0, 2)),
        ("contact_damped_impact", impact(1, 1)),
        ("contact_slider_impact", impact(1, 2)),
    ]
}

fn combination_sheet(results: &Results) -> Sheet {
    let changes = RANGES.map(|[low, high]| format!("{low} to {high}"));
    let header = ["loading", "core", "damping", "Poisson's ratio"]
        .map(String::from)
        .into_iter()
        .chain(COEFFICIENTS.map(|friction| format!("N at {friction}")))
        .chain(changes);
    let rows = combinations(&results.scenario).into_iter().map(|combination| {
        let forces = COEFFICIENTS.map(|friction| {
            outcome(results, &combination, friction).map_or("-".into(), |outcome| format!("{:.0}", outcome.force()))
        });
        let changes = RANGES.map(|range| effect(results, &combination, range).map_or("-".into(), percent));
        combination.iter().cloned().chain(forces).chain(changes).collect()
    });
    let depth = 1e3 * DEPTH * results.scenario.thickness();
    Sheet {
        title: format!(
            "Force by friction: held force of a press to {} mm at {SPEED} m/s, peak force of an impact",
            short(depth)
        ),
        header: header.collect(),
        rows: rows.collect(),
        n_text: 4,
    }
}

/// What one change does to the effect of friction.
fn mechanism_sheet(results: &Results) -> Sheet {
    let label = |key: &str| match key {
        "elastic_press" => "slow press, bonded, undamped, nearly incompressible",
        "contact_core" => "the same with a core in contact",
        "impact" => "the same as an impact",
        "damped_press" => "the same with damping",
        "own_poissons_ratio" => "the same with the scenario's Poisson's ratio",
        "damped_impact" => "the same as an impact with damping",
        "slider_impact" => "the same as an impact with the slider",
        "contact_damped_impact" => "the same as an impact with damping and a core in contact",
        _ => "the same as an impact with the slider and a core in contact (the paper's set-up)",
    };
    let rows = named_combinations(results).into_iter().map(|(key, combination)| {
        let changes = RANGES.map(|range| effect(results, &combination, range).map_or("-".into(), percent));
        [label(key).to_string()].into_iter().chain(changes).collect()
    });
    Sheet {
        title: "What hides friction".into(),
        header: ["".into()].into_iter().chain(RANGES.map(|[low, high]| format!("{low} to {high}"))).collect(),
        rows: rows.collect(),
        n_text: 1,
    }
}

/// A mechanism that leaves less than this part of the effect of friction hides it.
const HIDES: f64 = 0.25;

fn notes(results: &Results) -> Vec<String> {
    let effects: Vec<(&str, f64)> = named_combinations(results)
        .into_iter()
        .filter_map(|(key, combination)| Some((key, effect(results, &combination, FRICTION.range)?.abs())))
        .collect();
    let of = |wanted: &str| effects.iter().find(|(key, _)| *key == wanted).map(|(_, effect)| *effect);
    let Some(plain) = of("elastic_press") else { return Vec::new() };
    let [low, high] = FRICTION.range;
    let mut notes = vec![format!(
        "Between friction {low} and {high} an elastic, nearly incompressible layer on a bonded core changes its force by \
         {plain:.1} % in a slow press."
    )];
    for (key, name) in [
        ("contact_core", "a core in contact instead of a bonded one"),
        ("impact", "an impact instead of the press"),
        ("damped_press", "the damping on"),
        ("own_poissons_ratio", "the scenario's Poisson's ratio"),
        ("damped_impact", "an impact and the damping on"),
        ("slider_impact", "an impact and the slider"),
        ("contact_damped_impact", "an impact, the damping on and a core in contact"),
        ("contact_slider_impact", "an impact, the slider and a core in contact"),
    ] {
        if let Some(effect) = of(key) {
            let verdict = match effect / plain {
                ratio if ratio < HIDES => "this hides friction",
                ratio if ratio < 1.0 => "this makes friction matter less",
                _ => "this does not hide friction",
            };
            notes.push(format!("With {name} it is {effect:.1} %: {verdict}."));
        }
    }
    notes.push(stiff_in_shear(&results.scenario));
    notes
}

/// Why damping hides friction: what is stiff in shear does not flow sideways.
fn stiff_in_shear(scenario: &Scenario) -> String {
    let silicone = &scenario.layers[0].material;
    let relaxed = silicone.shear_modulus_inf();
    let unrelaxed = relaxed / silicone.prony_g_inf() + silicone.maxwell_g.iter().sum::<f64>();
    let bulk = silicone.effective_bulk_modulus();
    let ratio = |shear: f64| (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear));
    let meaning = match unrelaxed > bulk {
        true => "an impact meets a layer that resists shear more than compression and hardly flows",
        false => "an impact meets a layer that resists shear less than compression and flows",
    };
    format!(
        "Friction acts on what flows sideways. The layer's bulk modulus is {:.2} MPa. Relaxed, its shear modulus is {:.2} \
         MPa and its Poisson's ratio {:.2}; before any relaxation they are {:.1} MPa and {:.2}: {meaning}.",
        1e-6 * bulk,
        1e-6 * relaxed,
        ratio(relaxed),
        1e-6 * unrelaxed,
        ratio(unrelaxed)
    )
}

/// Combinations in the picture.
const PICTURED: usize = 6;

fn picture(results: &Results) -> Picture {
    let shown = named_combinations(results).into_iter().take(PICTURED);
    let lines = shown.map(|(_, combination)| {
        let zero = outcome(results, &combination, 0.0).map(Outcome::force);
        let point =
            |friction: f64| Some((friction, error_percent(outcome(results, &combination, friction)?.force(), zero?)));
        let [loading, core, damping, ratio] = &combination;
        let damping = match damping.as_str() {
            "off" => String::new(),
            damping => format!(", damping {damping}"),
        };
        StudyLine {
            label: format!("{loading}, {core}{damping}, {ratio}"),
            dashed: loading == LOADINGS[0],
            points: COEFFICIENTS.into_iter().filter_map(point).collect(),
        }
    });
    Picture::Lines {
        title: "Change of the force by friction (loading, core, Poisson's ratio)",
        x: ("friction coefficient", false),
        y: "change from no friction (%)",
        lines: lines.collect(),
    }
}
