//! The search: CMA-ES (Hansen and Ostermeier 2001, with active updates) over the unit cube of the ranges, with restarts.
//!
//! A restart ends when CMA-ES stops or a number of evaluations has brought nothing. The first begins at the scenario's
//! values; then the odd ones begin anywhere, with twice the population, and the even ones at the best values so far, with
//! half the step. Generations are evaluated on all cores, and nothing depends on their number.

use std::sync::atomic::{AtomicBool, Ordering};

use fcmaes_core::{Cmaes, CmaesParams, Fitness, Rng};
use rayon::prelude::*;

use super::convergence::{Descent, IMPROVEMENT, PATIENCE};
use super::log::{Entry, Log};
use super::objective::{Evaluation, evaluate};
use super::problem::Problem;
use crate::failure::Failure;

/// Hears of the search: evaluations that are done, and the best so far.
pub type Progress<'a> = &'a dyn Fn(usize, &Entry);

/// Searches until the evaluations are spent, not one more or less, or `stop` is set; everything goes to `log`, which also
/// answers what it holds. Returns the descents.
///
/// # Errors
/// A log that is not of this search, or cannot be written.
pub fn search(
    problem: &Problem,
    log: &mut Log,
    stop: &AtomicBool,
    progress: Progress,
) -> Result<Vec<Descent>, Failure> {
    let mut done = 0;
    let mut descents = Vec::new();
    let mut rng = Rng::new(problem.search.seed);
    while done < problem.search.evaluations && !stop.load(Ordering::Relaxed) {
        let restart = descents.len();
        let begin = Beginning::new(problem, restart, &log.entries[..done.min(log.entries.len())], &mut rng);
        let descent = descend(problem, restart, &begin, done, log, stop, progress)?;
        done += descent.evaluations;
        descents.push(descent);
    }
    Ok(descents)
}

/// Where and how wide a restart begins.
struct Beginning {
    mean: Vec<f64>,
    step: f64,
    population: usize,
}

impl Beginning {
    fn new(problem: &Problem, restart: usize, done: &[Entry], rng: &mut Rng) -> Self {
        let variables = &problem.variables;
        let n = variables.len();
        let options = &problem.search;
        let population = match options.population {
            0 => (4.0 + 3.0 * (n as f64).ln()).floor() as usize,
            given => given,
        };
        let parts = |values: &[f64]| variables.iter().zip(values).map(|(v, value)| v.part(*value)).collect();
        match (restart, best(done)) {
            (0, _) | (_, None) => {
                let start: Vec<f64> = variables.iter().map(|variable| variable.start(&problem.scenario)).collect();
                Self { mean: parts(&start), step: options.step, population }
            }
            (restart, _) if restart % 2 == 1 => {
                Self { mean: rng.uniform_vec(n), step: options.step.max(0.3), population: 2 * population }
            }
            (_, Some(best)) => Self { mean: parts(&best.values), step: 0.5 * options.step, population },
        }
    }
}

/// The entry with the lowest score.
pub fn best(entries: &[Entry]) -> Option<&Entry> {
    entries.iter().min_by(|a, b| a.score.total_cmp(&b.score))
}

/// One restart, which begins after `start` evaluations.
fn descend(
    problem: &Problem,
    restart: usize,
    begin: &Beginning,
    start: usize,
    log: &mut Log,
    stop: &AtomicBool,
    progress: Progress,
) -> Result<Descent, Failure> {
    let n = problem.variables.len();
    let fitness = Fitness::bounded(n, 1, &vec![0.0; n], &vec![1.0; n]);
    let parameters = CmaesParams {
        popsize: begin.population as i32,
        // Damps the step by the length of a run: that of a restart, not of the whole search, so that a longer search
        // begins with the same evaluations.
        max_evaluations: (PATIENCE * n * 4) as u64,
        seed: problem.search.seed.wrapping_add(restart as u64),
        ..CmaesParams::default()
    };
    let mut optimiser = Cmaes::new(fitness, &begin.mean, &[begin.step], &parameters);
    let (mut done, mut lowest, mut improved_at) = (start, f64::INFINITY, start);
    let mut ended = false;
    let mut best_score = f64::INFINITY;
    while !ended && done < problem.search.evaluations && !stop.load(Ordering::Relaxed) {
        let mut parts = optimiser.ask();
        let whole = parts.len();
        parts.truncate(problem.search.evaluations - done);
        let scores = generation(problem, restart, &parts, done, log)?;
        done += scores.len();
        if let Some(best) = best(&log.entries[..done]) {
            progress(done, best);
        }
        let low = scores.iter().copied().fold(f64::INFINITY, f64::min);
        best_score = best_score.min(low);
        if scores.len() < whole {
            // The evaluations are spent; with more of them the generation is completed first.
            break;
        }
        if low < lowest - IMPROVEMENT {
            (lowest, improved_at) = (low, done);
        }
        ended = optimiser.tell(&scores) != 0 || done - improved_at > PATIENCE * n;
    }
    Ok(Descent { best: best_score, evaluations: done - start, ended })
}

/// Scores of a generation that begins at evaluation `done`: from the log, as far as it goes, then by evaluating.
fn generation(
    problem: &Problem,
    restart: usize,
    parts: &[Vec<f64>],
    done: usize,
    log: &mut Log,
) -> Result<Vec<f64>, Failure> {
    let values: Vec<Vec<f64>> = parts
        .iter()
        .map(|parts| problem.variables.iter().zip(parts).map(|(variable, part)| variable.value(*part)).collect())
        .collect();
    let known = log.entries.len().saturating_sub(done).min(values.len());
    for (values, entry) in values[..known].iter().zip(&log.entries[done..]) {
        if *values != entry.values {
            let reason = "the log in this folder is of a search with other ranges, start, seed or population; \
                          choose another folder by --out, or remove it";
            return Err(Failure::Input(reason.into()));
        }
    }
    let results: Vec<Evaluation> = values[known..].par_iter().map(|values| evaluate(problem, values)).collect();
    log.append(problem, restart, &values[known..], &results)?;
    Ok(log.entries[done..done + values.len()].iter().map(|entry| entry.score).collect())
}
