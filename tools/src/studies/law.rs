//! Hyperelastic laws fitted to the same material data.

use rayon::prelude::*;
use softanvil_identify::law::fit::{Fit, Settings, Weighting};
use softanvil_identify::law::{DataSet, LAWS, Law, Mode, stress};
use softanvil_kernel::Scenario;
use softanvil_kernel::material::{Elastic, Material, Moduli, VolumetricBy};

use super::case::{Case, Outcome};
use super::diameter::is_energy;
use super::evaluation::{Evaluation, Finding, Picture};
use super::results::{Results, Study, percent};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::PEAK_FORCE;
use crate::measurement::series::{Sensor, Series};
use crate::paper::{ALTERNATIVES, RESIDUALS, TABLE_1, TUNED_ENERGY};

/// The study.
pub static STUDY: Study = Study {
    name: "law",
    title: "Hyperelastic laws",
    about: "The paper fitted its laws to slow uniaxial compression, gave all the same Prony series and damping, and found \
            that Ogden 3 and Yeoh 3 under-predict the peak. Its data are not published, so the data here are the \
            scenario's own long-term law in uniaxial compression, over the strains of the paper's tests (to 50 and to \
            70 %), without noise: every law is fitted to the same curve by least squares of the nominal stress and put in \
            the place of the scenario's, with its Prony series, damping and bulk modulus; once more to 50 % with stable \
            coefficients only. The residual is the root mean square in parts of the largest stress.",
    values: "laws, by the names of `softanvil fit --law`",
    default_values: &[
        "neo_hookean",
        "mooney_rivlin_2",
        "mooney_rivlin_3",
        "mooney_rivlin_5",
        "yeoh_2",
        "yeoh_3",
        "ogden_1",
        "ogden_2",
        "ogden_3",
    ],
    settings: &["law", "fit to [%]", "stable", "residual [%]"],
    plan: |_, scenario, values| plan(scenario, values),
    evaluate,
};

/// The fits: the largest strain, and whether only stable coefficients are taken.
const FITS: [(f64, bool); 3] = [(0.5, false), (0.7, false), (0.5, true)];
/// How the latter are marked.
const DEMANDED: &str = "demanded";
/// Points of the curve that is fitted.
const POINTS: usize = 100;
/// Name of the scenario's law.
const OWN: &str = "as it is";

fn plan(scenario: &Scenario, values: &[String]) -> Result<Vec<Case>, Failure> {
    let laws = values.iter().map(|name| {
        Law::find(name.trim()).ok_or_else(|| {
            let names: Vec<_> = LAWS.iter().map(|law| law.name).collect();
            Failure::Input(format!("study law: {name} is refused: expected {}", names.join(", ")))
        })
    });
    let laws = laws.collect::<Result<Vec<_>, _>>()?;
    let fits: Vec<(&'static Law, (f64, bool))> =
        FITS.iter().flat_map(|fit| laws.iter().map(|law| (*law, *fit))).collect();
    let own = Case { settings: [OWN, "", "", ""].map(String::from).to_vec(), scenario: Ok(scenario.clone()) };
    let fitted: Vec<Case> = fits.into_par_iter().map(|(law, fit)| fitted(scenario, law, fit)).collect();
    Ok([own].into_iter().chain(fitted).collect())
}

/// Nominal stress of the long-term law of `material` in uniaxial compression to `strain`.
fn curve(material: &Material, strain: f64) -> DataSet {
    let stretches: Vec<f64> = (1..=POINTS).map(|i| 1.0 - strain * i as f64 / POINTS as f64).collect();
    let stresses = stress::nominal(&Elastic::new(material), Mode::Uniaxial, &stretches);
    DataSet { mode: Mode::Uniaxial, points: stretches.into_iter().zip(stresses).collect() }
}

/// The drop with `law` in place of its own, fitted to it up to a strain, perhaps with stable coefficients only.
fn fitted(scenario: &Scenario, law: &'static Law, (strain, demanded): (f64, bool)) -> Case {
    let data = curve(&scenario.layers[0].material, strain);
    let settings = Settings {
        weighting: Weighting::Absolute,
        stability_range: (1.0 - strain, 1.0 / (1.0 - strain)),
        demand_stability: demanded,
    };
    let fit = Fit::new(law, std::slice::from_ref(&data), &settings);
    let largest = data.points.iter().fold(0.0, |largest, point| f64::max(largest, point.1.abs()));
    let residual = fit.as_ref().map_or("-".into(), |fit| format!("{:.2}", 100.0 * fit.statistics.rms / largest));
    let stable = match &fit {
        _ if demanded => DEMANDED,
        Some(fit) if fit.is_stable => "yes",
        _ => "no",
    };
    let scenario = match fit {
        Some(fit) => {
            let mut scenario = scenario.clone();
            scenario.layers[0].material = with_law(&scenario.layers[0].material, law.material(&fit.values));
            scenario.validate().map(|()| scenario).map_err(|error| error.to_string())
        }
        None => Err("no such coefficients were found".into()),
    };
    Case { settings: vec![law.name.into(), in_percent(strain), stable.into(), residual], scenario }
}

fn in_percent(strain: f64) -> String {
    format!("{:.0}", 100.0 * strain)
}

/// `own` with the elastic law of `other`.
fn with_law(own: &Material, other: Material) -> Material {
    Material {
        law: other.law,
        moduli: Moduli::LongTerm,
        c10: other.c10,
        c01: other.c01,
        c11: other.c11,
        c20: other.c20,
        c02: other.c02,
        c30: other.c30,
        ogden_mu: other.ogden_mu,
        ogden_alpha: other.ogden_alpha,
        // A law that is softer at rest is not to be more compressible.
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus: own.effective_bulk_modulus(),
        ..*own
    }
}

/// The drop with a law of one of [`FITS`].
fn outcome<'a>(results: &'a Results, law: &str, (strain, demanded): (f64, bool)) -> Option<&'a Outcome> {
    let strain = in_percent(strain);
    let is_it =
        |settings: &[String]| settings[0] == law && settings[1] == strain && (settings[2] == DEMANDED) == demanded;
    results.done().find(|(case, _)| is_it(&case.settings)).map(|(_, outcome)| outcome)
}

fn evaluate(results: &Results) -> Evaluation {
    let own = results.find(&[OWN, "", "", ""]);
    Evaluation {
        sheets: vec![results.sheet("Impacts", &[0, 1, 2, 3], |_| true, own)],
        findings: own.map_or_else(Vec::new, |own| findings(results, own)),
        notes: own.and_then(|own| note(results, own)).into_iter().chain(against_experiment(results)).collect(),
        picture: picture(results, own),
    }
}

fn findings(results: &Results, own: &Outcome) -> Vec<Finding> {
    let experiment = TABLE_1.iter().find(|case| is_energy(&results.scenario, case.energy));
    let mut findings = Vec::new();
    for alternative in &ALTERNATIVES {
        for fit in FITS {
            let Some(outcome) = outcome(results, alternative.law, fit) else { continue };
            let label = Law::find(alternative.law).map_or(alternative.law, |law| law.label);
            let peak = outcome.values[PEAK_FORCE];
            let change = error_percent(peak, own.values[PEAK_FORCE]);
            let against = |case: &crate::paper::Case| {
                format!(" ({} against the experiment)", percent(error_percent(peak, case.experiment[PEAK_FORCE])))
            };
            let paper = match is_energy(&results.scenario, TUNED_ENERGY) {
                true => format!("{:+.0} % against the experiment", alternative.peak_error_percent),
                false => "-".into(),
            };
            let stable = if fit.1 { "stable, " } else { "" };
            findings.push(Finding {
                key: alternative.law,
                what: format!(
                    "{label}, {stable}fitted to {} %: peak force against the law as it is",
                    in_percent(fit.0)
                ),
                paper,
                here: percent(change) + &experiment.map_or_else(String::new, against),
                value: change,
            });
        }
    }
    findings
}

/// What the errors against the experiment are worth.
fn against_experiment(results: &Results) -> Option<String> {
    let compared = TABLE_1.iter().any(|case| is_energy(&results.scenario, case.energy));
    results.fitted().filter(|_| compared)
}

/// What the laws that under-predict in the paper do here.
fn note(results: &Results, own: &Outcome) -> Option<String> {
    let fits = ALTERNATIVES.iter().flat_map(|alternative| FITS.map(|fit| outcome(results, alternative.law, fit)));
    let changes = fits.flatten().map(|outcome| error_percent(outcome.values[PEAK_FORCE], own.values[PEAK_FORCE]));
    let lowest = changes.reduce(f64::min)?;
    let [chosen, ogden, yeoh] = RESIDUALS.map(|(_, residual)| residual);
    let verdict = match lowest < -UNDER_PREDICTION {
        true => "The form of the law does under-predict",
        false => "The form of the law alone does not under-predict",
    };
    Some(format!(
        "{verdict}: fitted to the same curve, the lowest peak of the two is {} from that of the law as it is. In the \
         paper their fits are worse than that of its chosen law: residuals {ogden} and {yeoh} against {chosen}.",
        percent(lowest)
    ))
}

/// A peak lower than this, %, counts as an under-prediction: the paper's model is within a few percent itself.
const UNDER_PREDICTION: f64 = 5.0;

fn picture(results: &Results, own: Option<&Outcome>) -> Picture {
    let tried = ["neo_hookean", "mooney_rivlin_5"].into_iter();
    let tried = tried.chain(ALTERNATIVES.iter().map(|alternative| alternative.law));
    let fitted = tried.filter_map(|law| {
        let label = Law::find(law).map_or(law, |law| law.label);
        Some((format!("{label}, fitted to {} %", in_percent(FITS[0].0)), outcome(results, law, FITS[0])?))
    });
    let shown = own.map(|own| (format!("law {OWN}"), own)).into_iter().chain(fitted);
    let curves = shown.map(|(label, outcome)| {
        let threshold = outcome.run.constants.scenario.measurement.force_threshold;
        (label, Series::of_run(&outcome.run, Sensor::Contact).since_onset(threshold))
    });
    Picture::Forces { title: "Force over time with laws fitted to the same curve", curves: curves.collect() }
}
