//! Whether 90 % bands hold 90 % of what they should: data made with known parameters, errors and rounding by the model
//! itself, and inferred from again.
//!
//! The truth is drawn from the prior, parameters and discrepancies, so that the bands of a right inference hold it in 90 % of
//! the trials, whatever the data say. The numbers of a third impact, which the inference has not seen, are compared with
//! their bands likewise.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use fcmaes_core::Rng;
use hammer_and_sample::Model;
use rayon::prelude::*;
use softanvil_tools::calibration::objective::evaluate;
use softanvil_tools::calibration::problem::Problem;
use softanvil_tools::calibration::uncertainty::density::{Density, values_at};
use softanvil_tools::calibration::uncertainty::emulator::Emulator;
use softanvil_tools::calibration::uncertainty::error_model::{ErrorModel, Number};
use softanvil_tools::calibration::uncertainty::normal::{mixture_quantile, quantile};
use softanvil_tools::calibration::uncertainty::sampler::{self, Chains};
use softanvil_tools::measurement::quantity::{COUNT, QUANTITIES};

/// Two parameters, and with [`THREE`] a third one, over ranges that the emulator covers whole. The numbers are placeholders.
const PROBLEM: &str = r#"
[search]
evaluations = 1
[fixed]
"mesh.element_size" = 7.5e-3
[uncertainty]
discrepancy = { peak_force = 0.03, max_deformation = 0.05, impact_duration = 0.05, impulse = 0.03 }
[[impact]]
energy = 14.7
table_1 = true
[[impact]]
energy = 4.9
table_1 = true
[[impact]]
energy = 9.8
table_1 = true
[parameters]
"silicone.c10" = { min = 1e5, max = 2.5e5, scale = "log" }
"silicone.overstress_1" = { min = 12.0, max = 30.0, scale = "log" }
"#;
const THREE: &str = "\"silicone.c20\" = { min = 2e4, max = 2e5 }\n";

/// Steps to which the numbers are rounded, as the study's table.
const STEPS: [f64; COUNT] = [1.0, 1e-4, 1e-4, 1.0];
/// Impacts that the inference knows; the last one is predicted.
const KNOWN: usize = 2;
/// Logarithms of the numbers of all impacts.
type Logarithms = Vec<f64>;

struct Trials {
    problem: Problem,
    emulator: Emulator,
    /// Moves of a walker.
    moves: usize,
}

/// What one trial found: for each of what is inferred or predicted, the part of the samples below the truth; and whether
/// the chains have converged.
struct Found {
    ranks: Vec<f64>,
    converged: bool,
}

impl Trials {
    fn new(text: &str, moves: usize) -> Self {
        let problem = Problem::parse(text, Path::new(".")).unwrap();
        let n = problem.variables.len();
        let mut random = Rng::new(1);
        // Corners too, where the fit would have to extrapolate.
        let mut points: Vec<Vec<f64>> =
            (0..1 << n).map(|corner| (0..n).map(|i| f64::from((corner >> i) & 1)).collect()).collect();
        points.extend((0..60 * n).map(|_| random.uniform_vec(n)));
        let outputs: Vec<Logarithms> = points.par_iter().map(|parts| simulated(&problem, parts)).collect();
        let emulator = Emulator::fit(&points, &outputs).unwrap();
        Self { problem, emulator, moves }
    }

    fn trial(&self, number: u64) -> Found {
        let n = self.problem.variables.len();
        let mut random = Rng::new(1000 + number);
        let parts = random.uniform_vec(n);
        let options = &self.problem.uncertainty;
        let (noise, scales) = (options.noise(), options.discrepancy());
        let discrepancies: Vec<f64> = scales.iter().map(|scale| random.normreal(0.0, *scale).abs()).collect();
        // By the kernel, so that the emulator's error is part of what is tried.
        let truth = simulated(&self.problem, &parts);
        let measured: Vec<f64> = truth
            .iter()
            .enumerate()
            .map(|(i, ln)| {
                let (noise, missed) = (noise[i % COUNT], discrepancies[i % COUNT]);
                (ln + random.normreal(0.0, (noise * noise + missed * missed).sqrt())).exp()
            })
            .collect();
        let known = measured[..KNOWN * COUNT].iter().enumerate().map(|(i, value)| {
            let (quantity, step) = (i % COUNT, STEPS[i % COUNT]);
            let printed = (value / step).round() * step;
            let interval = [(printed - 0.5 * step).ln(), (printed + 0.5 * step).ln()];
            Number { target: i / COUNT, quantity, interval }
        });
        let errors = ErrorModel::of(known.collect(), options);
        let density = Density { emulator: &self.emulator, errors: &errors, problem: None, parameters: n };
        let start = start(&density, n, &mut random);
        let stop = AtomicBool::new(false);
        let sampled = sampler::run(&density, &start, Chains { seed: number, moves: self.moves, stop: &stop });
        let samples: Vec<&Vec<f64>> = sampled.samples.iter().step_by(7).collect();
        let mut ranks: Vec<f64> = (0..n).map(|i| below(&samples, i, parts[i])).collect();
        ranks.extend((0..COUNT).map(|q| below(&samples, n + q, discrepancies[q].ln())));
        ranks.extend((0..COUNT).map(|q| {
            let number = KNOWN * COUNT + q;
            self.predicted(&errors, &samples, number).iter().filter(|value| **value < measured[number].ln()).count()
                as f64
                / 99.0
        }));
        Found { ranks, converged: sampled.diagnostics.refusal().is_none() }
    }

    /// The percentiles of the logarithm of a number that is predicted.
    fn predicted(&self, errors: &ErrorModel, samples: &[&Vec<f64>], number: usize) -> Vec<f64> {
        let n = self.problem.variables.len();
        let components = samples.iter().step_by(samples.len() / 200 + 1).map(|sample| {
            let discrepancies: Vec<f64> = sample[n..].iter().map(|ln| ln.exp()).collect();
            let deviation = errors.deviation(number % COUNT, &discrepancies);
            let variance = self.emulator.variances[number];
            (self.emulator.predict(&sample[..n]).unwrap()[number], (deviation * deviation + variance).sqrt())
        });
        let components: Vec<(f64, f64)> = components.collect();
        (1..100).map(|percent| mixture_quantile(&components, f64::from(percent) / 100.0)).collect()
    }
}

fn simulated(problem: &Problem, parts: &[f64]) -> Logarithms {
    let impacts = evaluate(problem, &values_at(problem, parts)).impacts;
    assert_eq!(impacts.len(), KNOWN + 1, "{parts:?}");
    impacts.iter().flat_map(|impact| impact.values.map(f64::ln)).collect()
}

fn start(density: &Density, n: usize, random: &mut Rng) -> Vec<Vec<f64>> {
    let mut start = Vec::new();
    while start.len() < 120 {
        let mut point = random.uniform_vec(n);
        point.extend((0..COUNT).map(|_| random.normreal(0.03f64.ln(), 0.5)));
        if density.log_prob(&point).is_finite() {
            start.push(point);
        }
    }
    start
}

/// The part of the samples that lies below the truth.
fn below(samples: &[&Vec<f64>], column: usize, truth: f64) -> f64 {
    samples.iter().filter(|sample| sample[column] < truth).count() as f64 / samples.len() as f64
}

/// Coverage of central intervals of this probability, by column.
fn coverage(found: &[Found], probability: f64) -> Vec<f64> {
    let tail = 0.5 * (1.0 - probability);
    let holds = |rank: f64| (tail..=1.0 - tail).contains(&rank);
    let columns = found[0].ranks.len();
    let of = |column: usize| found.iter().filter(|one| holds(one.ranks[column])).count() as f64 / found.len() as f64;
    (0..columns).map(of).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Few trials, whose bounds are three standard errors of as many independent ones: bands that are half or twice as wide
/// as they should be are outside of them.
#[test]
fn bands_hold_the_truth_about_as_often_as_they_say() {
    let trials = Trials::new(PROBLEM, 200);
    let found: Vec<Found> = (0..24).into_par_iter().map(|number| trials.trial(number)).collect();
    let (wide, half) = (coverage(&found, 0.9), coverage(&found, 0.5));
    assert!((0.82..0.97).contains(&mean(&wide)), "{wide:?}");
    assert!((0.38..0.62).contains(&mean(&half)), "{half:?}");
}

/// All of it, minutes, therefore by
/// `cargo test --release -p softanvil --test suite -- --ignored --nocapture coverage`.
#[test]
#[ignore = "200 inferences take minutes"]
fn coverage_of_200_trials() {
    let trials = Trials::new(&format!("{PROBLEM}{THREE}"), 3000);
    let found: Vec<Found> = (0..200).into_par_iter().map(|number| trials.trial(number)).collect();
    let converged = found.iter().filter(|one| one.converged).count();
    let error = trials.emulator.variances.iter().copied().fold(0.0, f64::max).sqrt();
    // Not asked for here: chains of that length would take hours.
    println!(
        "{converged} of {} chains as long as the program asks for; emulator of degree {}, relative error up to {error:.4}",
        found.len(),
        trials.emulator.degree()
    );
    let names = trials.problem.variables.iter().map(|variable| variable.name.clone());
    let discrepancies = QUANTITIES.iter().map(|quantity| format!("discrepancy of {}", quantity.label));
    let predicted = QUANTITIES.iter().map(|quantity| format!("{} of 9.8 J, predicted", quantity.label));
    let (wide, half) = (coverage(&found, 0.9), coverage(&found, 0.5));
    for ((name, wide), half) in names.chain(discrepancies).chain(predicted).zip(&wide).zip(&half) {
        println!("| {name} | {:.1} % | {:.1} % |", 100.0 * wide, 100.0 * half);
    }
    println!("| all | {:.1} % | {:.1} % |", 100.0 * mean(&wide), 100.0 * mean(&half));
    assert!((0.85..0.95).contains(&mean(&wide)), "{wide:?}");
    assert!(wide.iter().all(|part| (0.83..0.97).contains(part)), "{wide:?}");
    // The quantile itself, so that the ranks are not all of the same samples.
    let ranks: Vec<f64> = found.iter().map(|one| one.ranks[0]).collect();
    assert!((quantile(&ranks, 0.5) - 0.5).abs() < 0.15, "{ranks:?}");
}
