//! Ogden's law, by Levenberg-Marquardt from several starts.
//!
//! The exponents are bounded by the kernel's range through alpha = A t / sqrt(1 + t^2). Starts are combinations of exponents
//! of a fixed grid, the best and some of the others, and the law of one term less with another one; they are refined on a
//! part of the points, the best of those on all. The coefficients follow from the exponents, as a linear problem, except where
//! stability is demanded. Nothing is random, so a fit can be repeated to the bit.
//!
//! [`super::separable`] would do, but not as well: three exponents have many minima, for which the starts here are made, a further
//! term is not to fit worse, and stability, as mu alpha > 0, is a condition on moduli and exponents together.

use nalgebra::{DMatrix, DVector};

use super::stress::{divisor, stretches};
use super::{DataSet, Mode, linear};
use crate::least_squares::{self, Bounded, Effort, Held, Model};

/// Largest exponent, as in the kernel's table of parameters.
pub const LARGEST_ALPHA: f64 = 30.0;
/// An exponent nearer to zero makes a coefficient of more than the kernel takes.
const SMALLEST_ALPHA: f64 = 1e-3;

/// Exponents of the starts, denser where rubbers are.
const GRID: [f64; 14] = [-20.0, -12.0, -8.0, -5.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0];
/// Exponents of a term that is added to the law of one term less.
const ADDED: [f64; 2] = [-4.0, 4.0];
/// Starts that are refined.
const REFINED: usize = 32;
/// Refined starts that are finished on all points.
const FINISHED: usize = 5;
/// Points of which starts are judged, at most.
const START_POINTS: usize = 150;

/// A point with its weight.
#[derive(Clone, Copy)]
struct Target {
    /// What the difference of Kirchhoff stresses is divided by.
    divisor: f64,
    /// Logarithms of the stretches of the loaded and of the free direction.
    loaded: f64,
    free: f64,
    stress: f64,
    weight: f64,
}

impl Target {
    fn new(mode: Mode, stretch: f64, stress: f64, weight: f64) -> Self {
        let [loaded, free, _] = stretches(mode, stretch);
        Self { divisor: divisor(mode, stretch), loaded: loaded.ln(), free: free.ln(), stress, weight }
    }
}

/// Nominal stress of a term of exponent alpha per mu, and its derivative by alpha.
fn basis(alpha: f64, target: &Target) -> (f64, f64) {
    let (loaded, free) = ((alpha * target.loaded).exp(), (alpha * target.free).exp());
    ((loaded - free) / target.divisor, (loaded * target.loaded - free * target.free) / target.divisor)
}

/// Parameters mu_1, alpha_1, mu_2, ... of the law with `n_term` terms nearest to `data`, exponents in falling order.
///
/// With `stable`, every mu alpha is positive, which makes the law stable at all stretches.
pub fn fit(n_term: usize, data: &[DataSet], weights: &[f64], stable: bool) -> Vec<f64> {
    let all = targets(data, weights);
    let few = thinned(&all);
    let smaller = if n_term > 1 { fit(n_term - 1, data, weights, stable) } else { Vec::new() };
    let larger = ADDED.iter().filter(|_| n_term > 1).map(|alpha| [smaller.as_slice(), &[0.0, *alpha]].concat());
    let mut starts = starts(n_term, &few, stable);
    starts.extend(larger.clone());
    let mut refined: Vec<(f64, Vec<f64>)> =
        starts.iter().map(|start| minimise(&few, start, stable, &Effort::ROUGH)).collect();
    refined.sort_by(|a, b| a.0.total_cmp(&b.0));
    refined.dedup_by(|a, b| (a.0 - b.0).abs() <= 1e-6 * b.0);
    let finished = refined.iter().take(FINISHED).map(|(_, start)| minimise(&all, start, stable, &Effort::FULL));
    // The smaller law itself with a term of nothing, so that a further term never fits worse.
    let smaller = larger.take(1).map(|values| (cost(&values, &all), values));
    let best = finished.chain(smaller).min_by(|a, b| a.0.total_cmp(&b.0)).map_or_else(Vec::new, |(_, values)| values);
    let mut terms: Vec<&[f64]> = best.chunks(2).collect();
    terms.sort_by(|a, b| b[1].total_cmp(&a[1]));
    terms.concat()
}

/// Derivative of the nominal stress by each parameter at each point, n_point x n_parameter.
pub fn jacobian(values: &[f64], data: &[DataSet]) -> DMatrix<f64> {
    let count = data.iter().map(|set| set.points.len()).sum();
    let targets = targets(data, &vec![1.0; count]);
    let mut jacobian = DMatrix::zeros(count, values.len());
    for (i, target) in targets.iter().enumerate() {
        for (k, term) in values.chunks(2).enumerate() {
            let (value, slope) = basis(term[1], target);
            jacobian[(i, 2 * k)] = value;
            jacobian[(i, 2 * k + 1)] = term[0] * slope;
        }
    }
    jacobian
}

/// Least sum of squares with `parameter` held at its value in `start`, from there and from `optimum`.
pub fn minimum_at(parameter: usize, start: &[f64], optimum: &[f64], data: &[DataSet], weights: &[f64]) -> f64 {
    let targets = targets(data, weights);
    let problem = Problem::new(&targets, false);
    let held = problem.inner(start)[parameter];
    let from = |values: &[f64]| {
        let mut inner = problem.inner(values);
        inner.remove(parameter);
        least_squares::minimise(&Held { model: &problem, parameter, value: held }, inner, &Effort::ROUGH).0
    };
    // Beyond its bound an exponent cannot be.
    if parameter % 2 == 1 && start[parameter].abs() > LARGEST_ALPHA {
        f64::INFINITY
    } else {
        from(start).min(from(optimum))
    }
}

fn targets(data: &[DataSet], weights: &[f64]) -> Vec<Target> {
    let points = data.iter().flat_map(|set| set.points.iter().map(|point| (set.mode, *point)));
    let target =
        |((mode, (stretch, stress)), weight): ((Mode, (f64, f64)), &f64)| Target::new(mode, stretch, stress, *weight);
    points.zip(weights).map(target).collect()
}

/// Evenly chosen points, at most [`START_POINTS`].
fn thinned(targets: &[Target]) -> Vec<Target> {
    let count = targets.len().min(START_POINTS);
    (0..count).map(|k| targets[k * (targets.len() - 1) / (count - 1).max(1)]).collect()
}

/// The best combinations of the grid, as parameters.
fn starts(n_term: usize, targets: &[Target], stable: bool) -> Vec<Vec<f64>> {
    let columns: Vec<DVector<f64>> = GRID
        .iter()
        .map(|&alpha| DVector::from_iterator(targets.len(), targets.iter().map(|t| t.weight * basis(alpha, t).0)))
        .collect();
    let stresses = DVector::from_iterator(targets.len(), targets.iter().map(|t| t.weight * t.stress));
    let mut found: Vec<(f64, Vec<f64>)> = combinations(n_term)
        .into_iter()
        .map(|choice| {
            let signs: Vec<f64> = choice.iter().map(|&k| if stable { GRID[k].signum() } else { 1.0 }).collect();
            let chosen: Vec<DVector<f64>> = choice.iter().zip(&signs).map(|(&k, sign)| &columns[k] * *sign).collect();
            let a = DMatrix::from_columns(&chosen);
            let mu = if stable { linear::non_negative(&a, &stresses) } else { linear::solve(&a, &stresses) };
            let cost = (&a * &mu - &stresses).norm();
            let values = choice.iter().enumerate().flat_map(|(i, &k)| [signs[i] * mu[i], GRID[k]]).collect();
            (cost, values)
        })
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The best, which are neighbours of each other, and as many evenly from the others.
    let others = found.split_off(found.len().min(REFINED / 2));
    let step = others.len().div_ceil(REFINED / 2).max(1);
    found.into_iter().chain(others.into_iter().step_by(step)).map(|(_, values)| values).collect()
}

/// Every choice of `n_term` different indices of [`GRID`], in order.
fn combinations(n_term: usize) -> Vec<Vec<usize>> {
    let mut choices = vec![Vec::new()];
    for _ in 0..n_term {
        let longer = choices.iter().flat_map(|choice: &Vec<usize>| {
            let next = choice.last().map_or(0, |last| last + 1);
            (next..GRID.len()).map(move |k| [choice.as_slice(), &[k]].concat())
        });
        choices = longer.collect();
    }
    choices
}

/// The parameters that Levenberg-Marquardt reaches from `start`, and their sum of squares.
fn minimise(targets: &[Target], start: &[f64], stable: bool, effort: &Effort) -> (f64, Vec<f64>) {
    if !stable {
        let problem = Projected { targets };
        let exponents = start.iter().skip(1).step_by(2).map(|alpha| EXPONENT.parameter(*alpha)).collect();
        let (cost, inner) = least_squares::minimise(&problem, exponents, effort);
        return (cost, problem.values(&inner));
    }
    let problem = Problem::new(targets, stable);
    let (cost, inner) = least_squares::minimise(&problem, problem.inner(start), effort);
    (cost, problem.values(&inner))
}

/// Sum of the squared residuals of the parameters mu_1, alpha_1, mu_2, ...
fn cost(values: &[f64], targets: &[Target]) -> f64 {
    targets.iter().map(|target| residual(values, target).powi(2)).sum()
}

fn residual(values: &[f64], target: &Target) -> f64 {
    let stress: f64 = values.chunks(2).map(|term| term[0] * basis(term[1], target).0).sum();
    target.weight * (stress - target.stress)
}

const EXPONENT: Bounded = Bounded { middle: 0.0, half: LARGEST_ALPHA };

fn exponent(t: f64) -> f64 {
    let alpha = EXPONENT.value(t);
    if alpha.abs() < SMALLEST_ALPHA { SMALLEST_ALPHA.copysign(alpha) } else { alpha }
}

/// The problem in the exponents' t alone, each with the coefficients that are best for them: the valleys in which a
/// coefficient and its exponent trade against each other are gone. Golub and Pereyra (1973), with the derivative of Kaufman
/// (1975), which leaves out the part within the column space.
struct Projected<'a> {
    targets: &'a [Target],
}

impl Projected<'_> {
    /// Weighted stresses of each term per mu and their derivatives by t, the weighted stresses, and the coefficients.
    fn solve(&self, inner: &[f64]) -> (DMatrix<f64>, DMatrix<f64>, DVector<f64>, DVector<f64>) {
        let (n, k) = (self.targets.len(), inner.len());
        let (mut columns, mut slopes) = (DMatrix::zeros(n, k), DMatrix::zeros(n, k));
        for (j, t) in inner.iter().enumerate() {
            let alpha = exponent(*t);
            for (i, target) in self.targets.iter().enumerate() {
                let (value, slope) = basis(alpha, target);
                columns[(i, j)] = target.weight * value;
                slopes[(i, j)] = target.weight * slope * EXPONENT.slope(*t);
            }
        }
        let stresses = DVector::from_iterator(n, self.targets.iter().map(|target| target.weight * target.stress));
        let mu = linear::solve(&columns, &stresses);
        (columns, slopes, stresses, mu)
    }

    /// mu_1, alpha_1, mu_2, ...
    fn values(&self, inner: &[f64]) -> Vec<f64> {
        let (.., mu) = self.solve(inner);
        mu.iter().zip(inner).flat_map(|(mu, t)| [*mu, exponent(*t)]).collect()
    }
}

impl Model for Projected<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        let (columns, _, stresses, mu) = self.solve(inner);
        columns * mu - stresses
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        let (columns, mut slopes, _, mu) = self.solve(inner);
        for (j, mu) in mu.iter().enumerate() {
            slopes.column_mut(j).scale_mut(*mu);
        }
        let q = columns.qr().q();
        let within = &q * (q.transpose() * &slopes);
        slopes - within
    }
}

/// The problem in unbounded parameters: for each term mu / scale (or sqrt(mu alpha / scale) where it must be positive),
/// and t of the exponent.
struct Problem<'a> {
    targets: &'a [Target],
    scale: f64,
    stable: bool,
}

impl<'a> Problem<'a> {
    fn new(targets: &'a [Target], stable: bool) -> Self {
        let scale = targets.iter().fold(0.0, |largest, t| f64::max(largest, t.stress.abs()));
        Self { targets, scale, stable }
    }

    fn inner(&self, values: &[f64]) -> Vec<f64> {
        let term = |term: &[f64]| {
            // A coefficient of exactly zero would never move.
            let product = (term[0] * term[1] / self.scale).max(1e-6);
            [if self.stable { product.sqrt() } else { term[0] / self.scale }, EXPONENT.parameter(term[1])]
        };
        values.chunks(2).flat_map(term).collect()
    }

    /// mu_1, alpha_1, mu_2, ...
    fn values(&self, inner: &[f64]) -> Vec<f64> {
        let term = |term: &[f64]| {
            let (a, alpha) = (term[0], exponent(term[1]));
            [if self.stable { a * a * self.scale / alpha } else { a * self.scale }, alpha]
        };
        inner.chunks(2).flat_map(term).collect()
    }
}

impl Model for Problem<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        let values = self.values(inner);
        DVector::from_iterator(self.targets.len(), self.targets.iter().map(|target| residual(&values, target)))
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        let values = self.values(inner);
        let mut jacobian = DMatrix::zeros(self.targets.len(), inner.len());
        for (i, target) in self.targets.iter().enumerate() {
            for k in (0..inner.len()).step_by(2) {
                let (mu, alpha) = (values[k], values[k + 1]);
                let (value, slope) = basis(alpha, target);
                let by_inner = if self.stable { 2.0 * inner[k] * self.scale / alpha } else { self.scale };
                jacobian[(i, k)] = target.weight * by_inner * value;
                // With mu = a^2 / alpha the coefficient moves with the exponent.
                let through_mu = if self.stable { -mu / alpha * value } else { 0.0 };
                jacobian[(i, k + 1)] = target.weight * EXPONENT.slope(inner[k + 1]) * (mu * slope + through_mu);
            }
        }
        jacobian
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::MODES;

    fn data(values: &[f64]) -> Vec<DataSet> {
        let set = |mode: Mode| {
            let point = |l: f64| {
                let target = Target::new(mode, l, 0.0, 1.0);
                (l, values.chunks(2).map(|term| term[0] * basis(term[1], &target).0).sum::<f64>())
            };
            DataSet { mode, points: (1..25).map(|k| point(0.8 + 0.1 * f64::from(k))).collect() }
        };
        MODES.iter().map(|mode| set(*mode)).collect()
    }

    #[test]
    fn exact_data_give_their_coefficients_back() {
        for (values, tolerance) in [
            (&[0.4e6, 2.7][..], 1e-9),
            (&[0.02e6, 6.0, 0.5e6, 1.4], 1e-6),
            (&[0.0012e6, 5.0, 0.63e6, 1.3, -0.01e6, -2.0], 1e-3),
        ] {
            let data = data(values);
            let found = fit(values.len() / 2, &data, &[1.0; 72], false);
            for (a, b) in found.iter().zip(values) {
                assert!((a / b - 1.0).abs() < tolerance, "{found:?}");
            }
        }
    }

    /// Data of one term: what is added has nothing to do, and must not make the fit worse.
    #[test]
    fn a_further_term_never_fits_worse() {
        for (modes, noise) in [(1, 0.0), (1, 0.03), (3, 0.0), (3, 0.03)] {
            let mut data = data(&[0.4e6, 2.7]);
            data.truncate(modes);
            for (k, point) in data.iter_mut().flat_map(|set| &mut set.points).enumerate() {
                point.1 *= 1.0 + noise * ((k * 7919 % 101) as f64 / 50.0 - 1.0);
            }
            let weights = vec![1.0; 24 * modes];
            let all = targets(&data, &weights);
            let costs: Vec<f64> = (1..=3).map(|n| cost(&fit(n, &data, &weights, false), &all)).collect();
            assert!(costs[1] <= costs[0] && costs[2] <= costs[1], "{modes} {noise}: {costs:?}");
        }
    }

    #[test]
    fn demanded_products_are_positive() {
        let mut data = data(&[0.4e6, 1.5, 0.2e6, -3.0]);
        data.truncate(1);
        for n_term in 1..=3 {
            let found = fit(n_term, &data, &[1.0; 24], true);
            assert!(found.chunks(2).all(|term| term[0] * term[1] >= 0.0), "{found:?}");
        }
    }

    #[test]
    fn the_inner_jacobian_is_that_of_the_residuals() {
        let data = data(&[0.4e6, 1.5, 0.2e6, -3.0]);
        let targets = targets(&data, &[1.0; 72]);
        for stable in [false, true] {
            let problem = Problem { targets: &targets, scale: 1e6, stable };
            let inner = problem.inner(&[0.3e6, 2.0, -0.1e6, -4.0]);
            let jacobian = problem.jacobian(&inner);
            for j in 0..inner.len() {
                let at = |by: f64| {
                    let mut moved = inner.clone();
                    moved[j] += by;
                    problem.residuals(&moved)
                };
                let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
                let error = (difference - jacobian.column(j)).norm() / jacobian.column(j).norm();
                assert!(error < 1e-7, "{stable} {j}: {error:e}");
            }
        }
    }
}
