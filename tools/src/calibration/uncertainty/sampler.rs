//! The affine-invariant ensemble sampler of Goodman and Weare (2010), by the crate `hammer-and-sample`, and what tells
//! whether its chains have converged.
//!
//! Independent ensembles run side by side, each with a generator of random numbers for each walker, so that the number of
//! threads changes nothing. The first half of each is left out. Their agreement is told by the split R-hat of Gelman and Rubin
//! over the halves of what is left, the length of all
//! ensembles together by the integrated autocorrelation time of the mean of the walkers.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use hammer_and_sample::{Model, Schedule, Serial, Stretch, auto_corr_time, sample};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;
use rayon::prelude::*;
use serde::Serialize;

/// Ensembles that run side by side.
const ENSEMBLES: usize = 4;
/// Largest R-hat of chains that agree.
const AGREE: f64 = 1.02;
/// Autocorrelation times that the moves of all ensembles together have to last.
const TIMES: f64 = 50.0;
/// Acceptance of a chain that moves.
const ACCEPTANCE: std::ops::RangeInclusive<f64> = 0.1..=0.9;

/// How chains are run.
#[derive(Clone, Copy, Debug)]
pub struct Chains<'a> {
    /// Seed of the random numbers.
    pub seed: u64,
    /// Moves of every walker, the first half of which is left out.
    pub moves: usize,
    /// Set to end early.
    pub stop: &'a AtomicBool,
}

/// What the chains gave.
pub struct Sampled {
    /// The samples after the first half, ensemble by ensemble.
    pub samples: Vec<Vec<f64>>,
    /// Whether they are to be trusted.
    pub diagnostics: Diagnostics,
}

/// What tells whether chains have converged.
#[derive(Clone, Debug, Serialize)]
pub struct Diagnostics {
    /// Part of the moves that were accepted.
    pub acceptance: f64,
    /// Largest split R-hat of all coordinates.
    pub r_hat: f64,
    /// Largest integrated autocorrelation time of all coordinates, moves.
    pub autocorrelation_time: f64,
    /// Moves of every walker that count.
    pub moves: usize,
    /// Walkers of all ensembles.
    pub walkers: usize,
    /// Samples over the autocorrelation time.
    pub effective_samples: f64,
}

impl Diagnostics {
    /// What speaks against the chains; nothing if they have converged.
    pub fn refusal(&self) -> Option<String> {
        // The ensembles are independent, so that their moves add up.
        let needed = TIMES * self.autocorrelation_time;
        if !ACCEPTANCE.contains(&self.acceptance) {
            let legal = format!("{} to {}", ACCEPTANCE.start(), ACCEPTANCE.end());
            return Some(format!("the acceptance is {:.3}, expected {legal}", self.acceptance));
        }
        // NaN agrees with nothing.
        if self.r_hat.is_nan() || self.r_hat > AGREE {
            return Some(format!("the chains differ: R-hat is {:.3}, expected {AGREE} at most", self.r_hat));
        }
        let long = (ENSEMBLES * self.moves) as f64;
        (needed.is_nan() || long < needed).then(|| {
            format!(
                "the chains are too short: {long} moves of all ensembles together, expected {TIMES} times the autocorrelation time of {:.0}",
                self.autocorrelation_time
            )
        })
    }
}

/// A number of moves, or less.
struct Moves<'a> {
    left: usize,
    stop: &'a AtomicBool,
}

impl<P: hammer_and_sample::Params> Schedule<P> for Moves<'_> {
    fn next_step(&mut self, _chain: &[P]) -> ControlFlow<()> {
        if self.left == 0 || self.stop.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        self.left -= 1;
        ControlFlow::Continue(())
    }

    fn iterations(&self, _walkers: usize) -> Option<usize> {
        Some(self.left)
    }
}

/// Runs chains on `model`; `start` gives where each walker begins, by its number, all of them within the support.
pub fn run<M: Model<Params = Vec<f64>>>(model: &M, start: &[Vec<f64>], chains: Chains) -> Sampled {
    let dimension = start.first().map_or(1, Vec::len);
    let walkers = (4 * dimension).max(24);
    let ensembles: Vec<Ensemble> = (0..ENSEMBLES)
        .into_par_iter()
        .map(|ensemble| {
            let numbers = ensemble * walkers..(ensemble + 1) * walkers;
            let random = |number| Pcg64::seed_from_u64(chains.seed.wrapping_mul(1 << 20).wrapping_add(number as u64));
            let mut ensemble = Ensemble {
                samples: numbers.clone().map(|number| start[number % start.len()].clone()).collect(),
                random: numbers.map(random).collect(),
                accepted: 0,
                made: 0,
            };
            for moves in [chains.moves / 2, chains.moves - chains.moves / 2] {
                ensemble.advance(model, Moves { left: moves, stop: chains.stop });
            }
            ensemble
        })
        .collect();
    let accepted: usize = ensembles.iter().map(|ensemble| ensemble.accepted).sum();
    let made: usize = ensembles.iter().map(|ensemble| ensemble.made).sum();
    let kept: Vec<&[Vec<f64>]> = ensembles.iter().map(|ensemble| &ensemble.samples[..]).collect();
    let diagnostics = diagnose(&kept, walkers, accepted as f64 / made.max(1) as f64);
    Sampled { samples: ensembles.into_iter().flat_map(|ensemble| ensemble.samples).collect(), diagnostics }
}

/// One ensemble of walkers.
struct Ensemble {
    /// Samples since the last call of [`Ensemble::advance`], move by move.
    samples: Vec<Vec<f64>>,
    /// Of each walker.
    random: Vec<Pcg64>,
    /// Moves of single walkers that were accepted, and all of them.
    accepted: usize,
    made: usize,
}

impl Ensemble {
    /// Goes on from the last samples. Those before are given up, so that no more than half of a chain is held.
    fn advance<M: Model<Params = Vec<f64>>>(&mut self, model: &M, moves: Moves) {
        if moves.left == 0 || moves.stop.load(Ordering::Relaxed) {
            return;
        }
        let last = self.samples.split_off(self.samples.len() - self.random.len());
        let walkers = last.into_iter().zip(&mut self.random);
        let (samples, accepted) = sample(model, &Stretch::default(), walkers, moves, Serial);
        self.made += samples.len();
        self.accepted += accepted;
        self.samples = samples;
    }
}

/// Judges chains of `walkers` walkers, whose samples follow each other move by move.
fn diagnose(chains: &[&[Vec<f64>]], walkers: usize, acceptance: f64) -> Diagnostics {
    let dimension = chains.first().and_then(|chain| chain.first()).map_or(0, Vec::len);
    let (mut r_hat, mut time) = (1.0, 1.0);
    for coordinate in 0..dimension {
        let values: Vec<Vec<f64>> =
            chains.iter().map(|chain| chain.iter().map(|sample| sample[coordinate]).collect()).collect();
        r_hat = larger(r_hat, split_r_hat(&values));
        for chain in &values {
            let means: Vec<f64> =
                chain.chunks(walkers).map(|move_| move_.iter().sum::<f64>() / move_.len() as f64).collect();
            time = larger(time, auto_corr_time(means.iter().copied(), None, Some(0)).unwrap_or(f64::NAN));
        }
    }
    let moves = chains.iter().map(|chain| chain.len() / walkers).min().unwrap_or(0);
    let samples = chains.iter().map(|chain| chain.len()).sum::<usize>() as f64;
    Diagnostics {
        acceptance,
        r_hat,
        autocorrelation_time: time,
        moves,
        walkers: walkers * chains.len(),
        effective_samples: samples / time,
    }
}

/// The larger number; NaN if either is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// Root of the variance of all halves of the chains together over that within them.
fn split_r_hat(chains: &[Vec<f64>]) -> f64 {
    let halves: Vec<&[f64]> = chains.iter().flat_map(|chain| chain.chunks(chain.len().div_ceil(2).max(1))).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let means: Vec<f64> = halves.iter().map(|half| mean(half)).collect();
    let variance = |values: &[f64], about: f64| {
        values.iter().map(|value| (value - about).powi(2)).sum::<f64>() / (values.len() as f64 - 1.0)
    };
    let within = halves.iter().zip(&means).map(|(half, mean)| variance(half, *mean)).sum::<f64>() / halves.len() as f64;
    let between = variance(&means, mean(&means));
    ((within + between) / within).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two normal numbers of correlation 0.9, the second with ten times the deviation.
    struct Correlated;

    impl Model for Correlated {
        type Params = Vec<f64>;

        fn log_prob(&self, at: &Vec<f64>) -> f64 {
            let (x, y) = (at[0] - 3.0, at[1] / 10.0);
            -0.5 * (x * x - 1.8 * x * y + y * y) / (1.0 - 0.81)
        }
    }

    fn start() -> Vec<Vec<f64>> {
        (0..96).map(|i| vec![f64::from(i % 7), f64::from(i % 11)]).collect()
    }

    fn sampled(moves: usize, seed: u64, threads: usize) -> Sampled {
        let stop = AtomicBool::new(false);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| run(&Correlated, &start(), Chains { seed, moves, stop: &stop }))
    }

    /// Source: the distribution itself.
    #[test]
    fn a_correlated_normal_distribution_comes_back() {
        let sampled = sampled(4000, 1, 2);
        assert!(sampled.diagnostics.refusal().is_none(), "{:?}", sampled.diagnostics);
        let n = sampled.samples.len() as f64;
        let mean = |of: &dyn Fn(&Vec<f64>) -> f64| sampled.samples.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(&|at| at[0]), mean(&|at| at[1]));
        let (xx, yy) = (mean(&|at| (at[0] - x).powi(2)), mean(&|at| (at[1] - y).powi(2)));
        let xy = mean(&|at| (at[0] - x) * (at[1] - y)) / (xx * yy).sqrt();
        assert!((x - 3.0).abs() < 0.05 && y.abs() < 0.5, "{x} {y}");
        assert!(
            (xx - 1.0).abs() < 0.08 && (yy / 100.0 - 1.0).abs() < 0.08 && (xy - 0.9).abs() < 0.02,
            "{xx} {yy} {xy}"
        );
    }

    #[test]
    fn the_seed_decides_everything_and_the_threads_nothing() {
        let reference = sampled(40, 1, 1).samples;
        assert_eq!(sampled(40, 1, 3).samples, reference);
        assert_ne!(sampled(40, 2, 1).samples, reference);
    }

    #[test]
    fn chains_that_are_too_short_or_apart_are_refused() {
        assert!(sampled(40, 1, 2).diagnostics.refusal().is_some());
        let good = sampled(4000, 1, 2).diagnostics;
        let apart = Diagnostics { r_hat: 1.1, ..good.clone() }.refusal().unwrap();
        assert!(apart.contains("R-hat is 1.100"), "{apart}");
        let stuck = Diagnostics { acceptance: 0.01, ..good.clone() }.refusal().unwrap();
        assert!(stuck.contains("acceptance is 0.010"), "{stuck}");
        let short = Diagnostics { autocorrelation_time: 1e6, ..good.clone() }.refusal().unwrap();
        assert!(short.contains("too short: 8000 moves of all ensembles together, expected 50 times"), "{short}");
        // The moves of four ensembles, of which the first half is left out, are what counts.
        let just = |time: f64| Diagnostics { autocorrelation_time: time, ..good.clone() }.refusal();
        assert_eq!((good.moves, just(160.0)), (2000, None));
        assert!(just(160.1).is_some());
        assert!(Diagnostics { r_hat: f64::NAN, ..good }.refusal().is_some());
    }
}
