//! The score of values: how far simulated impacts are from the measured ones.
//!
//! Every number that counts gives a relative error, %; a trace gives the root mean square of its difference over the
//! measured peak, %. The score is (1 - s) mean |e| + s sqrt(mean e^2), weighted means with the share s of the root mean
//! square, plus the mean excess over the limits, plus the mean square distance from the material tests times its weight, plus
//! the penalty of the prior. Lower is better; values that cannot be simulated score more than any that are worth anything.
//!
//! With `objective.rounding` an error in the score is what is left of it beyond the rounding of the printed number. Errors that
//! are reported are always those from the printed number itself.

use rayon::prelude::*;
use softanvil_kernel::Scenario;

use super::material_test;
use super::problem::Problem;
use super::variable;
use crate::measurement::curve_score::CurveScore;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::COUNT;
use crate::measurement::reading::Reading;
use crate::measurement::series::SeriesError;
use crate::run::{Drop, Ending, Run, RunError};

/// Score of values that cannot be simulated.
pub const REFUSED: f64 = 1e3;

/// One impact, simulated.
#[derive(Clone, Debug)]
pub struct Simulated {
    /// The four numbers, in SI.
    pub values: [f64; COUNT],
    /// How the simulation ended: whether the numbers are those of the whole impact.
    pub ending: Ending,
    /// Comparison with the measured trace, if there is one.
    pub curve: Option<CurveScore>,
}

/// What an evaluation gives.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The score.
    pub score: f64,
    /// Mean of the absolute errors of all measured numbers, %, whether they count or not; NaN if not simulated, or if traces alone
    /// were measured.
    pub mean_error: f64,
    /// The impacts in the order of the targets; none if they could not be simulated.
    pub impacts: Vec<Simulated>,
    /// Why not.
    pub refusal: Option<String>,
}

/// Evaluates one set of values.
pub fn evaluate(problem: &Problem, values: &[f64]) -> Evaluation {
    match attempt(problem, values) {
        Ok(evaluation) => evaluation,
        Err((score, reason)) => Evaluation { score, mean_error: f64::NAN, impacts: Vec::new(), refusal: Some(reason) },
    }
}

/// The scenario of `values`.
///
/// # Errors
/// A value that the kernel refuses.
pub fn scenario(problem: &Problem, values: &[f64]) -> Result<Scenario, String> {
    let mut scenario = problem.scenario.clone();
    variable::apply(&problem.variables, values, &mut scenario)?;
    Ok(scenario)
}

fn attempt(problem: &Problem, values: &[f64]) -> Result<Evaluation, (f64, String)> {
    let refuse = |reason: String| (REFUSED, reason);
    let scenario = scenario(problem, values).map_err(refuse)?;
    check_poissons_ratio(problem, &scenario)?;
    let drops = prepare(problem, &scenario)?;
    let runs: Vec<Run> = drops
        .into_par_iter()
        .map(|drop| drop.run(|_| {}))
        .collect::<Result<_, RunError>>()
        .map_err(|error| refuse(error.to_string()))?;
    let impacts: Vec<Simulated> = runs
        .iter()
        .zip(0..)
        .map(|(run, i)| measure(problem, i, run))
        .collect::<Result<_, _>>()
        .map_err(|error| refuse(error.to_string()))?;
    let penalty = problem.prior.map_or(0.0, |prior| prior.penalty(&scenario.layers[0].material));
    let material = problem.objective.material_weight * material_test::mean_square(&problem.material_tests, &scenario);
    let score = score(problem, &impacts) + material + penalty;
    Ok(Evaluation { score, mean_error: mean_error(problem, &impacts), impacts, refusal: None })
}

/// Refuses a layer that gives way more at once than the problem allows.
fn check_poissons_ratio(problem: &Problem, scenario: &Scenario) -> Result<(), (f64, String)> {
    let Some(least) = problem.objective.poissons_ratio_at_once else { return Ok(()) };
    let ratios = scenario.layers.iter().map(|layer| layer.material.poissons_ratio_0());
    match ratios.fold(f64::INFINITY, f64::min) {
        // A slope that leads back.
        ratio if ratio < least => Err((
            REFUSED * 0.5 + 100.0 * (least - ratio),
            format!("Poisson's ratio is {ratio} at once; at least {least} is allowed"),
        )),
        _ => Ok(()),
    }
}

/// The drops of all targets.
fn prepare(problem: &Problem, scenario: &Scenario) -> Result<Vec<Drop>, (f64, String)> {
    let mut drops = Vec::new();
    for target in &problem.targets {
        let mut scenario = scenario.clone();
        scenario.impactor = scenario.impactor.with_energy(target.energy);
        let drop = Drop::until(&scenario, problem.until).map_err(|error| (REFUSED, error.to_string()))?;
        let (steps, most) = (drop.steps_per_sample(), problem.objective.steps_per_sample);
        if most > 0 && steps > most {
            // A slope that leads back to where steps are large enough.
            let score = REFUSED * 0.5 + f64::from(steps - most);
            return Err((score, format!("{steps} steps in 50 us; at most {most} are allowed")));
        }
        drops.push(drop);
    }
    Ok(drops)
}

/// The numbers of `run`, an impact of target `index`, read as the problem says.
///
/// # Errors
/// A channel frequency class that the sampling does not carry, which [`Problem`] has refused.
fn measure(problem: &Problem, index: usize, run: &Run) -> Result<Simulated, SeriesError> {
    let options = &problem.objective;
    let reading = Reading { sensor: options.force, channel_class: options.cfc, ..Reading::PLAIN };
    let record = reading.take(run)?;
    let trace = problem.targets[index].trace.as_ref();
    let curve = trace.and_then(|trace| CurveScore::new(trace, &record.series, record.threshold));
    Ok(Simulated { values: record.values, ending: run.ending(), curve })
}

/// Errors of all impacts, %.
fn errors<'a>(problem: &'a Problem, impacts: &'a [Simulated]) -> impl Iterator<Item = f64> + 'a {
    problem.targets.iter().zip(impacts).flat_map(|(target, simulated)| {
        (0..COUNT).filter_map(|i| Some(error_percent(simulated.values[i], target.measured[i]?)))
    })
}

/// Errors that count in the score, %.
fn scored_errors<'a>(problem: &'a Problem, impacts: &'a [Simulated]) -> impl Iterator<Item = (usize, f64)> + 'a {
    let rounding = problem.objective.rounding;
    problem.targets.iter().zip(impacts).flat_map(move |(target, simulated)| {
        (0..COUNT).filter(|i| target.counts[*i]).filter_map(move |i| {
            let measured = target.measured[i]?;
            let error = error_percent(simulated.values[i], measured);
            let within = if rounding { 100.0 * target.half_unit[i] / measured } else { 0.0 };
            Some((i, error.signum() * (error.abs() - within).max(0.0)))
        })
    })
}

fn mean_error(problem: &Problem, impacts: &[Simulated]) -> f64 {
    if !problem.has_numbers() {
        return f64::NAN;
    }
    crate::measurement::errors::mean_absolute(errors(problem, impacts))
}

fn score(problem: &Problem, impacts: &[Simulated]) -> f64 {
    let options = &problem.objective;
    let (weights, limits) = (options.weights(), options.limits());
    let mut sums = Sums::default();
    for (i, error) in scored_errors(problem, impacts) {
        sums.add(error, weights[i]);
        sums.excess += (error.abs() - limits[i]).max(0.0);
    }
    for (target, simulated) in problem.targets.iter().zip(impacts).filter(|(target, _)| !target.predict) {
        if target.trace.is_some() {
            // No contact at all differs by about the peak.
            let difference = simulated.curve.map_or(1.0, |curve| curve.difference);
            sums.add(100.0 * difference, options.trace_weight());
        }
    }
    sums.score(options.root_mean_square)
}

/// Weighted sums of errors.
#[derive(Default)]
struct Sums {
    weight: f64,
    absolute: f64,
    square: f64,
    excess: f64,
    count: f64,
}

impl Sums {
    fn add(&mut self, error: f64, weight: f64) {
        self.weight += weight;
        self.absolute += weight * error.abs();
        self.square += weight * error * error;
        self.count += 1.0;
    }

    fn score(&self, root_mean_square: f64) -> f64 {
        if self.weight <= 0.0 {
            return 0.0;
        }
        (1.0 - root_mean_square) * self.absolute / self.weight
            + root_mean_square * (self.square / self.weight).sqrt()
            + self.excess / self.count
    }
}
