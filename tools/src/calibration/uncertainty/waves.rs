//! From a converged search to samples of the posterior, in waves.
//!
//! Each wave fits the emulator to the simulated points that are not out of the question, samples the density by it, and
//! simulates some of the samples: they tell the emulator's error where it matters, before it has seen them. What it does
//! not know widens the density (its variance is part of the likelihood), so that the first waves look everywhere. When the
//! simulated samples have about the weights that the emulator gave them, the last and longest chains are run; their samples
//! are simulated, too, and drawn anew by the ratio of the two likelihoods, so that no error of the emulator is left but in how
//! many of them count.

use std::sync::atomic::AtomicBool;

use fcmaes_core::Rng;
use hammer_and_sample::Model;
use serde::Serialize;

use super::density::{Density, ln_material_tests, values_at};
use super::emulator::Emulator;
use super::error_model::ErrorModel;
use super::runs::Runs;
use super::sampler::{self, Chains, Diagnostics};
use crate::calibration::problem::Problem;
use crate::failure::Failure;
use crate::measurement::quantity::COUNT;

/// Points of the first design, for each parameter: all over the ranges, and about the best values.
const DESIGN: [usize; 2] = [40, 10];
/// Standard deviation of those about the best, as a part of the ranges.
const ABOUT_BEST: f64 = 0.06;
/// How far below the best logarithm of the likelihood a point is out of the question.
const OUT_OF_THE_QUESTION: f64 = 12.0;
/// Points that are kept in any case, for each parameter.
const FEWEST: usize = 14;
/// Samples that a wave simulates, for each parameter.
const LOOK: usize = 24;
/// Waves, at most.
const WAVES: usize = 10;
/// Part of the simulated samples that has to count for the emulator to be trusted.
const TRUSTED: f64 = 0.25;
/// Moves of the chains of a wave, and of the last ones at first and at most.
const MOVES: (usize, usize, usize) = (800, 4_000, 128_000);
/// Simulated samples for each one that is kept, at most.
const SURPLUS: usize = 10;
/// Samples that count for each one that is kept: wanted, and needed.
const COUNTING: (f64, f64) = (1.0, 0.5);

/// Everything that is needed.
pub struct Inference<'a> {
    /// The problem.
    pub problem: &'a Problem,
    /// The measured numbers.
    pub errors: &'a ErrorModel,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Set to end early.
    pub stop: &'a AtomicBool,
    /// Hears of simulated points, and what they are for.
    pub progress: &'a dyn Fn(usize, &str),
}

/// A sample of the posterior.
#[derive(Clone, Debug)]
pub struct Sample {
    /// Values of the parameters.
    pub values: Vec<f64>,
    /// The inferred discrepancies.
    pub discrepancies: Vec<f64>,
}

/// How the emulator did at samples that it had not seen.
#[derive(Clone, Debug, Serialize)]
pub struct Emulation {
    /// Degree of its polynomials.
    pub degree: usize,
    /// Root mean square of the relative error, by number that counts.
    pub held_out_error: Vec<f64>,
    /// Samples simulated for it.
    pub held_out: usize,
    /// Part of these that count when they are weighted by the likelihood of their simulations.
    pub counting: f64,
    /// Points simulated in all.
    pub simulated: usize,
    /// Waves.
    pub waves: usize,
}

/// What came out.
pub struct Inferred {
    /// Samples of the posterior, each of the same weight.
    pub samples: Vec<Sample>,
    /// Of the chains.
    pub diagnostics: Diagnostics,
    /// Of the emulator.
    pub emulation: Emulation,
}

/// How an inference ended.
pub enum Ended {
    /// With samples.
    Inferred(Box<Inferred>),
    /// Without, and why.
    Refused(String),
    /// By the user.
    Interrupted,
}

/// A simulated point.
struct Point {
    parts: Vec<f64>,
    /// Logarithms of the numbers that count.
    logarithms: Vec<f64>,
    /// Logarithm of the likelihood, by the best discrepancies.
    merit: f64,
}

/// Samples drawn by the emulator, and simulated.
#[derive(Default)]
struct Look {
    /// The samples.
    drawn: Vec<Vec<f64>>,
    /// Logarithms of the likelihood of their simulations over that of the emulator; minus infinity of what cannot be simulated.
    ratios: Vec<f64>,
    /// Squares of the emulator's errors.
    squares: Vec<Vec<f64>>,
}

impl Look {
    /// Weights of the samples, up to a factor.
    fn weights(&self) -> Vec<f64> {
        let largest = self.ratios.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        self.ratios.iter().map(|ratio| if ratio.is_finite() { (ratio - largest).exp() } else { 0.0 }).collect()
    }

    /// The part of the samples that counts: (sum w)^2 over n sum w^2.
    fn counting(&self) -> f64 {
        let (sum, squares) = self.weights().iter().fold((0.0, 0.0), |(s, q), w| (s + w, q + w * w));
        if squares > 0.0 { sum * sum / (squares * self.ratios.len() as f64) } else { 0.0 }
    }

    /// Root mean square of the emulator's error, by number.
    fn error(&self) -> Vec<f64> {
        let count = self.squares.len() as f64;
        let of = |i: usize| (self.squares.iter().map(|squares| squares[i]).sum::<f64>() / count).sqrt();
        (0..self.squares.first().map_or(0, Vec::len)).map(of).collect()
    }

    fn append(&mut self, mut more: Self) {
        self.drawn.append(&mut more.drawn);
        self.ratios.append(&mut more.ratios);
        self.squares.append(&mut more.squares);
    }
}

impl Inference<'_> {
    /// Infers the posterior, from the `best` values of a search on.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn run(&self, best: &[f64], runs: &mut Runs) -> Result<Ended, Failure> {
        let mut points = Vec::new();
        let Some(()) = self.add(&self.design(best), &mut points, runs, "first design")? else {
            return Ok(Ended::Interrupted);
        };
        let mut wave = 0;
        loop {
            wave += 1;
            let Some(emulator) = self.emulator(&points) else { return Ok(refused("too few points can be simulated")) };
            let density = self.density(&emulator);
            let chains = Chains { seed: self.seed.wrapping_add(wave as u64), moves: MOVES.0, stop: self.stop };
            let start = self.start(&points, &density, wave as u64);
            if start.is_empty() {
                return Ok(refused("the emulator speaks nowhere"));
            }
            let sampled = sampler::run(&density, &start, chains);
            let count = LOOK * self.problem.variables.len();
            let label = format!("wave {wave}");
            let Some(look) = self.look(&density, &thinned(&sampled.samples, count), &mut points, runs, &label)? else {
                return Ok(Ended::Interrupted);
            };
            if wave > 1 && look.counting() >= TRUSTED {
                break;
            }
            // The last samples tell whether it serves all the same.
            if wave == WAVES {
                break;
            }
        }
        self.finish(points, runs, wave)
    }

    /// The last chains.
    fn finish(&self, mut points: Vec<Point>, runs: &mut Runs, waves: usize) -> Result<Ended, Failure> {
        let Some(emulator) = self.emulator(&points) else { return Ok(refused("too few points can be simulated")) };
        let density = self.density(&emulator);
        let start = self.start(&points, &density, 0);
        if start.is_empty() {
            return Ok(refused("the emulator speaks nowhere"));
        }
        let mut moves = MOVES.1;
        let sampled = loop {
            (self.progress)(0, "chains");
            let sampled = sampler::run(&density, &start, Chains { seed: self.seed, moves, stop: self.stop });
            if self.stop.load(std::sync::atomic::Ordering::Relaxed) {
                return Ok(Ended::Interrupted);
            }
            match sampled.diagnostics.refusal() {
                None => break sampled,
                Some(why) if moves >= MOVES.2 => return Ok(Ended::Refused(why)),
                Some(_) => moves *= 2,
            }
        };
        let wanted = self.problem.uncertainty.samples;
        let drawn = shuffled(thinned(&sampled.samples, SURPLUS * wanted), self.seed);
        let mut look = Look::default();
        let effective = |look: &Look| look.counting() * look.drawn.len() as f64;
        for some in drawn.chunks(wanted) {
            let Some(more) = self.look(&density, some, &mut points, runs, "samples")? else {
                return Ok(Ended::Interrupted);
            };
            look.append(more);
            if effective(&look) >= COUNTING.0 * wanted as f64 {
                break;
            }
        }
        let counting = effective(&look);
        if counting < COUNTING.1 * wanted as f64 {
            return Ok(refused(&format!(
                "of {} simulated samples {counting:.0} count, expected {:.0} at least: the emulator does not follow the model",
                look.drawn.len(),
                COUNTING.1 * wanted as f64
            )));
        }
        let samples = resampled(&look, wanted, self.seed);
        let emulation = Emulation {
            degree: emulator.degree(),
            held_out_error: look.error(),
            held_out: look.drawn.len(),
            counting: look.counting(),
            simulated: runs.count(),
            waves,
        };
        let samples = samples.iter().map(|point| self.sample(point)).collect();
        Ok(Ended::Inferred(Box::new(Inferred { samples, diagnostics: sampled.diagnostics, emulation })))
    }

    fn sample(&self, point: &[f64]) -> Sample {
        let (parts, ln_discrepancies) = point.split_at(self.problem.variables.len());
        let discrepancies = ln_discrepancies.iter().map(|ln| ln.exp()).collect();
        Sample { values: values_at(self.problem, parts), discrepancies }
    }

    fn density<'a>(&'a self, emulator: &'a Emulator) -> Density<'a> {
        let problem = self.problem.prior.is_some().then_some(self.problem);
        Density { emulator, errors: self.errors, problem, parameters: self.problem.variables.len() }
    }

    /// Points all over the ranges, in each part of every range one (a Latin hypercube), and others about the best values.
    fn design(&self, best: &[f64]) -> Vec<Vec<f64>> {
        let n = self.problem.variables.len();
        let mut random = Rng::new(self.seed);
        let count = DESIGN[0] * n;
        let columns: Vec<Vec<f64>> = (0..n)
            .map(|_| {
                let mut places: Vec<usize> = (0..count).collect();
                for last in (1..count).rev() {
                    places.swap(last, random.int_below(last as i64 + 1) as usize);
                }
                places.iter().map(|place| (*place as f64 + random.uniform01()) / count as f64).collect()
            })
            .collect();
        let mut design: Vec<Vec<f64>> =
            (0..count).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
        let middle: Vec<f64> =
            self.problem.variables.iter().zip(best).map(|(variable, value)| variable.part(*value)).collect();
        for _ in 0..DESIGN[1] * n {
            let near = |part: &f64| (part + random.normreal(0.0, ABOUT_BEST)).clamp(0.0, 1.0);
            design.push(middle.iter().map(near).collect());
        }
        design
    }

    /// Simulates the points at `parts` and adds them; none if interrupted.
    fn add(
        &self,
        parts: &[Vec<f64>],
        points: &mut Vec<Point>,
        runs: &mut Runs,
        label: &str,
    ) -> Result<Option<()>, Failure> {
        let Some(all) = self.simulate(parts, runs, label)? else { return Ok(None) };
        for (parts, logarithms) in parts.iter().zip(all) {
            if let Some(logarithms) = logarithms {
                let merit = self.errors.best_ln_likelihood(&logarithms) + ln_material_tests(self.problem, parts);
                points.push(Point { parts: parts.clone(), logarithms, merit });
            }
        }
        Ok(Some(()))
    }

    /// Logarithms of the numbers that count at `parts`; none if interrupted.
    fn simulate(
        &self,
        parts: &[Vec<f64>],
        runs: &mut Runs,
        label: &str,
    ) -> Result<Option<Vec<Option<Vec<f64>>>>, Failure> {
        let values: Vec<Vec<f64>> = parts.iter().map(|parts| values_at(self.problem, parts)).collect();
        let hear = |count: usize| (self.progress)(count, label);
        let simulated = runs.simulate(self.problem, &values, self.stop, &hear)?;
        let of = |impacts: Vec<[f64; COUNT]>| -> Vec<f64> {
            self.errors.numbers.iter().map(|number| impacts[number.target][number.quantity].ln()).collect()
        };
        Ok(simulated.map(|all| all.into_iter().map(|numbers| numbers.map(of)).collect()))
    }

    /// The emulator of the points that are not out of the question.
    fn emulator(&self, points: &[Point]) -> Option<Emulator> {
        let kept = self.plausible(points);
        let parts: Vec<Vec<f64>> = kept.iter().map(|point| point.parts.clone()).collect();
        let outputs: Vec<Vec<f64>> = kept.iter().map(|point| point.logarithms.clone()).collect();
        Emulator::fit(&parts, &outputs)
    }

    /// The points that are not out of the question, the best first.
    fn plausible<'p>(&self, points: &'p [Point]) -> Vec<&'p Point> {
        let mut sorted: Vec<&Point> = points.iter().collect();
        sorted.sort_by(|a, b| b.merit.total_cmp(&a.merit));
        let best = sorted.first().map_or(0.0, |point| point.merit);
        let within = sorted.iter().filter(|point| point.merit >= best - OUT_OF_THE_QUESTION).count();
        sorted.truncate(within.max(FEWEST * self.problem.variables.len()));
        sorted
    }

    /// Where the walkers begin: near the best points.
    fn start(&self, points: &[Point], density: &Density, seed: u64) -> Vec<Vec<f64>> {
        let mut random = Rng::new(self.seed.wrapping_add(1000 + seed));
        let kept = self.plausible(points);
        let kept = &kept[..kept.len().min(FEWEST * self.problem.variables.len())];
        let mut start = Vec::new();
        // Some of those beside the points have no density.
        for round in 0..20 * kept.len() {
            let parts = &kept[round % kept.len()].parts;
            let near: Vec<f64> = parts.iter().map(|part| (part + random.normreal(0.0, 0.01)).clamp(0.0, 1.0)).collect();
            let discrepancies = (0..self.errors.inferred.len()).map(|_| random.normreal(0.05f64.ln(), 0.5));
            let point: Vec<f64> = near.into_iter().chain(discrepancies.collect::<Vec<_>>()).collect();
            if density.log_prob(&point).is_finite() {
                start.push(point);
            }
            if start.len() >= 2 * kept.len() {
                break;
            }
        }
        start
    }

    /// Simulates `drawn` samples of `density`, and adds them to the points; none if interrupted.
    fn look(
        &self,
        density: &Density,
        drawn: &[Vec<f64>],
        points: &mut Vec<Point>,
        runs: &mut Runs,
        label: &str,
    ) -> Result<Option<Look>, Failure> {
        let n = self.problem.variables.len();
        let parts: Vec<Vec<f64>> = drawn.iter().map(|point| point[..n].to_vec()).collect();
        let Some(simulated) = self.simulate(&parts, runs, label)? else { return Ok(None) };
        let emulator = density.emulator;
        let zeros = vec![0.0; self.errors.numbers.len()];
        let mut look = Look { drawn: drawn.to_vec(), ..Look::default() };
        for (point, truth) in drawn.iter().zip(&simulated) {
            let (Some(truth), Some(emulated)) = (truth, emulator.predict(&point[..n])) else {
                look.ratios.push(f64::NEG_INFINITY);
                continue;
            };
            let discrepancies: Vec<f64> = point[n..].iter().map(|ln| ln.exp()).collect();
            let by_model = self.errors.ln_likelihood(truth, &zeros, &discrepancies);
            let by_emulator = self.errors.ln_likelihood(&emulated, &emulator.variances, &discrepancies);
            look.ratios.push(by_model - by_emulator);
            look.squares
                .push(truth.iter().zip(&emulated).map(|(truth, emulated)| (truth - emulated).powi(2)).collect());
        }
        self.add(&parts, points, runs, label)?;
        Ok(Some(look))
    }
}

fn refused(why: &str) -> Ended {
    Ended::Refused(why.into())
}

/// `count` of the samples, evenly from all.
fn thinned(samples: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let count = count.min(samples.len());
    (0..count).map(|i| samples[i * samples.len() / count].clone()).collect()
}

/// The samples in another order, so that the first ones are of all chains and moves.
fn shuffled(mut samples: Vec<Vec<f64>>, seed: u64) -> Vec<Vec<f64>> {
    let mut random = Rng::new(seed);
    for last in (1..samples.len()).rev() {
        samples.swap(last, random.int_below(last as i64 + 1) as usize);
    }
    samples
}

/// `count` samples of the same weight, drawn by the weights at even steps from a random first one.
fn resampled(look: &Look, count: usize, seed: u64) -> Vec<Vec<f64>> {
    let weights = look.weights();
    let step = weights.iter().sum::<f64>() / count as f64;
    let mut next = step * Rng::new(seed).uniform01();
    let (mut sum, mut samples) = (0.0, Vec::new());
    for (point, weight) in look.drawn.iter().zip(&weights) {
        sum += weight;
        while samples.len() < count && next < sum {
            samples.push(point.clone());
            next += step;
        }
    }
    samples
}
