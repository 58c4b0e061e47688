//! A Prony series of a number of terms, by non-negative least squares on a grid of times and Levenberg-Marquardt.
//!
//! The load is Y_inf e(t) + sum Y_i q(t; tau_i), with the elastic response e and the response q of a term from
//! [`History`], and no negative Y. Normalised on the instantaneous modulus, g_i = Y_i / (Y_inf + sum Y_i), which is the
//! kernel's convention.

use nalgebra::{DMatrix, DVector};
use ndarray::{Array1, Array2};

use super::history::History;
use crate::law::statistics::Statistics;
use crate::least_squares::{self, Bounded, Effort, Model};

/// Load over time, in the order of time.
///
/// ```
/// use softanvil_identify::relaxation::history::History;
/// use softanvil_identify::relaxation::prony::{Relaxation, fit};
///
/// // From 100 to 60 kPa after a step, in half a second.
/// let times: Vec<f64> = (0..60).map(|i| 1e-2 * 1.1_f64.powi(i)).collect();
/// let loads = times.iter().map(|t| 60e3 + 40e3 * (-t / 0.5).exp()).collect();
/// let counts = vec![1; times.len()];
/// let prony = fit(1, &Relaxation { times, loads, counts, loaded: 0.0, history: History::step(0.0) });
/// let (g, tau) = prony.normalised()[0];
/// assert!((g - 0.4).abs() < 1e-6 && (tau - 0.5).abs() < 1e-6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Relaxation {
    /// Times, s.
    pub times: Vec<f64>,
    /// Loads: stress, modulus or force.
    pub loads: Vec<f64>,
    /// How many samples each load is the mean of: their variances go as its inverse.
    pub counts: Vec<usize>,
    /// When the strain was reached, s; earlier loads are those of the ramp.
    pub loaded: f64,
    /// What they relax from.
    pub history: History,
}

impl Relaxation {
    /// `loads` at `times`, one sample each, after `history`, whose loading ended at `loaded` s.
    pub fn of_samples(times: Vec<f64>, loads: Vec<f64>, loaded: f64, history: History) -> Self {
        let counts = vec![1; times.len()];
        Self { times, loads, counts, loaded, history }
    }

    /// The part from the end of the loading on.
    pub fn hold(&self) -> Self {
        let from = self.n_ramp();
        Self {
            times: self.times[from..].to_vec(),
            loads: self.loads[from..].to_vec(),
            counts: self.counts[from..].to_vec(),
            loaded: self.loaded,
            history: self.history.clone(),
        }
    }

    /// Points before the end of the loading.
    pub fn n_ramp(&self) -> usize {
        self.times.partition_point(|time| *time < self.loaded)
    }

    /// Weight of the residual of each point.
    fn weights(&self) -> Vec<f64> {
        self.counts.iter().map(|count| (*count as f64).sqrt()).collect()
    }
}

/// A fitted series.
///
/// ```
/// use softanvil_identify::relaxation::history::History;
/// use softanvil_identify::relaxation::prony::{Relaxation, fit};
///
/// let times: Vec<f64> = (0..60).map(|i| 1e-2 * 1.1_f64.powi(i)).collect();
/// let loads = times.iter().map(|t| 60e3 + 40e3 * (-t / 0.5).exp()).collect();
/// let counts = vec![1; times.len()];
/// let prony = fit(1, &Relaxation { times, loads, counts, loaded: 0.0, history: History::step(0.0) });
/// assert!((prony.equilibrium - 60e3).abs() < 1.0 && (prony.instantaneous() - 100e3).abs() < 1.0);
/// // What the same material does where it is strained within a second instead of at once.
/// let after_a_ramp = prony.predict(&History::ramp(0.0, 1.0, |part| part), &[1.0])[0];
/// assert!(60e3 < after_a_ramp && after_a_ramp < 100e3);
/// ```
#[derive(Clone, Debug)]
pub struct Prony {
    /// Y_inf, in the unit of the load.
    pub equilibrium: f64,
    /// (Y_i in the unit of the load, tau_i in s), in order of tau.
    pub terms: Vec<(f64, f64)>,
    /// Its statistics; parameters in the order Y_inf, Y_1, tau_1, Y_2, tau_2...
    pub statistics: Statistics,
    /// What the data do not determine; empty if all terms are identified.
    pub doubts: Vec<String>,
}

impl Prony {
    /// Y_inf + sum Y_i, in the unit of the load.
    pub fn instantaneous(&self) -> f64 {
        self.equilibrium + self.terms.iter().map(|term| term.0).sum::<f64>()
    }

    /// (g_i, tau_i in s), normalised on the instantaneous load.
    pub fn normalised(&self) -> Vec<(f64, f64)> {
        let whole = self.instantaneous();
        self.terms.iter().map(|(y, tau)| (y / whole, *tau)).collect()
    }

    /// Root mean square of the residuals in the ramp, none without points there, and in the hold, in the unit of the load.
    pub fn residuals(&self, data: &Relaxation) -> (Option<f64>, f64) {
        let fitted = self.predict(&data.history, &data.times);
        let squares: Vec<f64> = fitted.iter().zip(&data.loads).map(|(fit, load)| (fit - load).powi(2)).collect();
        let rms = |squares: &[f64]| (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt();
        let (ramp, hold) = squares.split_at(data.n_ramp());
        ((!ramp.is_empty()).then(|| rms(ramp)), rms(hold))
    }

    /// The load at `times` after `history`.
    pub fn predict(&self, history: &History, times: &[f64]) -> Vec<f64> {
        let mut loads: Vec<f64> = history.elastic(times).iter().map(|e| self.equilibrium * e).collect();
        for (y, tau) in &self.terms {
            for (load, q) in loads.iter_mut().zip(history.response(times, *tau)) {
                *load += y * q;
            }
        }
        loads
    }
}

/// Times of the grid in a decade.
const PER_DECADE: usize = 8;

/// Part of the loading time below which no relaxation time is looked for. What relaxes so much faster than the strain rises
/// is seen in the ramp alone, by tau / (loading time) of its modulus, where the curvature of the elastic law looks the same.
pub const FASTEST: f64 = 0.1;

/// The series of `n_term` terms nearest to `data`.
pub fn fit(n_term: usize, data: &Relaxation) -> Prony {
    let mut range = tau_range(&data.times);
    range.0 = range.0.max(FASTEST * data.loaded).min(0.1 * range.1);
    let starts = [spectrum(n_term, data, range), spread(n_term, range)];
    let best = starts
        .iter()
        .map(|taus| minimise(data, taus, range))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .map_or_else(|| vec![0.0; 1 + 2 * n_term], |(_, values)| values);
    describe(best, data, range)
}

/// Shortest and longest time that the data may tell of: a third of the first interval, three times the whole.
fn tau_range(times: &[f64]) -> (f64, f64) {
    let first = times.first().copied().unwrap_or_default();
    let interval = times.iter().map(|time| time - first).find(|interval| *interval > 0.0).unwrap_or(1.0);
    let whole = times.last().map_or(1.0, |last| last - first);
    (interval / 3.0, 3.0 * whole)
}

/// `n_term` times spread evenly over the decades within `range`.
fn spread(n_term: usize, range: (f64, f64)) -> Vec<f64> {
    let part = |k: usize| (k as f64 + 0.5) / n_term as f64;
    (0..n_term).map(|k| range.0 * (range.1 / range.0).powf(part(k))).collect()
}

/// The heaviest times of the non-negative spectrum on a grid, neighbours merged; filled up from [`spread`].
fn spectrum(n_term: usize, data: &Relaxation, range: (f64, f64)) -> Vec<f64> {
    let count = ((range.1 / range.0).log10() * PER_DECADE as f64).ceil() as usize + 1;
    let grid: Vec<f64> =
        (0..count).map(|k| range.0 * (range.1 / range.0).powf(k as f64 / (count - 1) as f64)).collect();
    let weights = amplitudes(data, &grid);
    // A peak between two times of the grid takes weight on both.
    let mut peaks: Vec<(f64, f64)> = Vec::new();
    let mut previous = None;
    for (k, weight) in weights.iter().skip(1).enumerate().filter(|(_, weight)| **weight > 0.0) {
        match peaks.last_mut().filter(|_| previous == Some(k.wrapping_sub(1))) {
            Some((sum, log)) => {
                *log = (*log * *sum + grid[k].ln() * weight) / (*sum + weight);
                *sum += weight;
            }
            None => peaks.push((*weight, grid[k].ln())),
        }
        previous = Some(k);
    }
    peaks.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut taus: Vec<f64> = peaks.iter().take(n_term).map(|peak| peak.1.exp()).collect();
    taus.extend(spread(n_term, range).into_iter().skip(taus.len()));
    taus
}

/// Y_inf and the Y of each of `taus` that are best, none negative.
fn amplitudes(data: &Relaxation, taus: &[f64]) -> Vec<f64> {
    let mut columns = vec![data.history.elastic(&data.times)];
    columns.extend(taus.iter().map(|tau| data.history.response(&data.times, *tau)));
    let weights = data.weights();
    let matrix = Array2::from_shape_fn((data.times.len(), columns.len()), |(i, j)| weights[i] * columns[j][i]);
    let loads: Array1<f64> = data.loads.iter().zip(&weights).map(|(load, weight)| weight * load).collect();
    let (amplitudes, _) = nnls::nnls(matrix.view(), loads.view());
    amplitudes.to_vec()
}

/// The parameters Y_inf, Y_1, tau_1, ... that Levenberg-Marquardt reaches from `taus`, and their sum of squares.
fn minimise(data: &Relaxation, taus: &[f64], range: (f64, f64)) -> (f64, Vec<f64>) {
    let amplitudes = amplitudes(data, taus);
    let scale = data.loads.iter().fold(0.0, |largest, load| f64::max(largest, load.abs()));
    // A root of exactly zero would never move.
    let root = |y: f64| (y / scale).max(1e-4).sqrt();
    let weights = DVector::from_vec(data.weights()) / scale;
    let problem = Problem { data, scale, weights, log_tau: log_tau(range) };
    let mut inner = vec![root(amplitudes[0])];
    for (y, tau) in amplitudes[1..].iter().zip(taus) {
        inner.extend([root(*y), problem.log_tau.parameter(tau.ln())]);
    }
    let (cost, inner) = least_squares::minimise(&problem, inner, &Effort::FULL);
    (cost, problem.values(&inner))
}

/// The logarithm of a time within `range`.
fn log_tau(range: (f64, f64)) -> Bounded {
    Bounded { middle: 0.5 * (range.1 * range.0).ln(), half: 0.5 * (range.1 / range.0).ln() }
}

/// The problem in unbounded parameters: roots of Y over the largest load, and t of the times.
struct Problem<'a> {
    data: &'a Relaxation,
    scale: f64,
    /// Weight of each residual over the scale.
    weights: DVector<f64>,
    log_tau: Bounded,
}

/// Whether the parameter with this index of Y_inf, Y_1, tau_1, ... is a time.
fn is_time(index: usize) -> bool {
    index > 0 && index.is_multiple_of(2)
}

impl Problem<'_> {
    fn values(&self, inner: &[f64]) -> Vec<f64> {
        let value = |(index, x): (usize, &f64)| match is_time(index) {
            true => self.log_tau.value(*x).exp(),
            false => x * x * self.scale,
        };
        inner.iter().enumerate().map(value).collect()
    }
}

impl Model for Problem<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        DVector::from_vec(residuals(&self.values(inner), self.data)).component_mul(&self.weights)
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        let values = self.values(inner);
        let mut jacobian = jacobian(&values, self.data);
        for (j, x) in inner.iter().enumerate() {
            let slope = if is_time(j) { values[j] * self.log_tau.slope(*x) } else { 2.0 * x * self.scale };
            let mut column = jacobian.column_mut(j);
            column.component_mul_assign(&self.weights);
            column.scale_mut(slope);
        }
        jacobian
    }
}

/// Fit less data for the parameters Y_inf, Y_1, tau_1, ...
fn residuals(values: &[f64], data: &Relaxation) -> Vec<f64> {
    let mut residuals: Vec<f64> =
        data.history.elastic(&data.times).iter().zip(&data.loads).map(|(e, load)| values[0] * e - load).collect();
    for term in values[1..].chunks(2) {
        for (residual, q) in residuals.iter_mut().zip(data.history.response(&data.times, term[1])) {
            *residual += term[0] * q;
        }
    }
    residuals
}

/// Derivatives of the load by Y_inf, Y_1, tau_1, ...
fn jacobian(values: &[f64], data: &Relaxation) -> DMatrix<f64> {
    /// Relative difference of a time: the response is smooth over decades of it.
    const STEP: f64 = 1e-5;
    let mut columns = vec![DVector::from_vec(data.history.elastic(&data.times))];
    for term in values[1..].chunks(2) {
        let at = |tau: f64| DVector::from_vec(data.history.response(&data.times, tau));
        columns.push(at(term[1]));
        columns.push((at(term[1] * (1.0 + STEP)) - at(term[1] * (1.0 - STEP))) * (term[0] / (2.0 * STEP * term[1])));
    }
    DMatrix::from_columns(&columns)
}

/// The series in order of its times, with its statistics and doubts.
fn describe(values: Vec<f64>, data: &Relaxation, range: (f64, f64)) -> Prony {
    let mut terms: Vec<(f64, f64)> = values[1..].chunks(2).map(|term| (term[0], term[1])).collect();
    terms.sort_by(|a, b| a.1.total_cmp(&b.1));
    let sorted: Vec<f64> = [values[0]].into_iter().chain(terms.iter().flat_map(|term| [term.0, term.1])).collect();
    let jacobian = jacobian(&sorted, data);
    let statistics = Statistics::new(&data.loads, &residuals(&sorted, data), &data.weights(), &jacobian);
    let mut prony = Prony { equilibrium: sorted[0], terms, statistics, doubts: Vec::new() };
    prony.doubts = doubts(&prony, range);
    prony
}

/// A standard error above this part of its value says nothing but the order of magnitude.
const UNCERTAIN: f64 = 0.5;
/// A term of less than this part of the instantaneous modulus is noise.
const NEGLIGIBLE: f64 = 1e-3;
/// Times within this factor are one.
const SAME_TIME: f64 = 1.5;

fn doubts(prony: &Prony, range: (f64, f64)) -> Vec<String> {
    let errors = &prony.statistics.standard_errors;
    let mut doubts = Vec::new();
    for (k, ((g, tau), (y, _))) in prony.normalised().into_iter().zip(&prony.terms).enumerate() {
        let (error_y, error_tau) = (errors[1 + 2 * k], errors[2 + 2 * k]);
        let term = format!("term {} (tau {tau:.3e} s)", k + 1);
        if g < NEGLIGIBLE {
            doubts.push(format!("{term} has nothing to do: g = {g:.1e}"));
        } else if tau < 1.05 * range.0 || tau > 0.95 * range.1 {
            doubts.push(format!("{term} lies outside the times of the data"));
        } else if error_y.is_nan() || error_tau.is_nan() {
            doubts.push(format!("{term} is not identified: the data cannot tell the terms apart"));
        } else if !(error_y / y < UNCERTAIN && error_tau / tau < UNCERTAIN) {
            doubts.push(format!(
                "{term} is not identified: standard errors {:.0} % of g and {:.0} % of tau",
                100.0 * error_y / y,
                100.0 * error_tau / tau
            ));
        }
    }
    for (k, pair) in prony.terms.windows(2).enumerate().filter(|(_, pair)| pair[1].1 < SAME_TIME * pair[0].1) {
        let (a, b) = (pair[0].1, pair[1].1);
        doubts.push(format!("terms {} and {} are one: tau {a:.3e} and {b:.3e} s", k + 1, k + 2));
    }
    doubts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times() -> Vec<f64> {
        (0..=150).map(|k| 1e-2 * 10f64.powf(4.0 * f64::from(k) / 150.0)).collect()
    }

    fn data(terms: &[(f64, f64)], equilibrium: f64, history: History) -> Relaxation {
        let times = times();
        let mut loads: Vec<f64> = history.elastic(&times).iter().map(|e| equilibrium * e).collect();
        for (y, tau) in terms {
            for (load, q) in loads.iter_mut().zip(history.response(&times, *tau)) {
                *load += y * q;
            }
        }
        Relaxation::of_samples(times, loads, 0.0, history)
    }

    #[test]
    fn exact_data_give_their_terms_back_after_a_step_and_after_a_ramp() {
        let terms = [(2e5, 0.05), (1e5, 1.5), (0.5e5, 20.0)];
        for history in [History::step(0.0), History::ramp(0.0, 0.3, |part| part), History::ramp(0.0, 0.3, |p| p * p)] {
            let found = fit(3, &data(&terms, 3e5, history));
            assert!((found.equilibrium / 3e5 - 1.0).abs() < 1e-6, "{found:?}");
            for (a, b) in found.terms.iter().zip(terms) {
                assert!((a.0 / b.0 - 1.0).abs() < 1e-5 && (a.1 / b.1 - 1.0).abs() < 1e-5, "{found:?}");
            }
            assert!(found.doubts.is_empty(), "{:?}", found.doubts);
        }
    }

    /// A ramp that is taken for a step loses the fast term.
    #[test]
    fn the_ramp_matters() {
        let truth = data(&[(2e5, 0.1)], 1e5, History::ramp(0.0, 0.5, |part| part));
        let after = truth.times.iter().position(|t| *t > 0.5).unwrap();
        let (times, loads) = (truth.times[after..].to_vec(), truth.loads[after..].to_vec());
        let step = Relaxation::of_samples(times, loads, 0.0, History::step(0.0));
        let (right, wrong) = (fit(1, &truth), fit(1, &step));
        let g = |prony: &Prony| prony.normalised()[0].0;
        assert!((g(&right) - 2.0 / 3.0).abs() < 1e-6);
        assert!((g(&wrong) - 2.0 / 3.0).abs() > 0.05, "{}", g(&wrong));
    }

    #[test]
    fn terms_that_are_not_there_are_doubted() {
        let mut one = data(&[(2e5, 0.5)], 1e5, History::step(0.0));
        for (index, load) in one.loads.iter_mut().enumerate() {
            *load += 500.0 * ((index * 7919 % 101) as f64 / 50.0 - 1.0);
        }
        assert!(fit(1, &one).doubts.is_empty());
        for n_term in 2..=5 {
            assert!(!fit(n_term, &one).doubts.is_empty(), "{n_term}");
        }
    }

    #[test]
    fn no_amplitude_is_negative() {
        // A load that rises: no relaxation describes it.
        let mut rising = data(&[], 1e5, History::step(0.0));
        for (load, time) in rising.loads.iter_mut().zip(&rising.times) {
            *load *= 1.0 + 0.01 * time.ln();
        }
        let found = fit(2, &rising);
        assert!(found.equilibrium >= 0.0 && found.terms.iter().all(|term| term.0 >= 0.0), "{found:?}");
    }
}
