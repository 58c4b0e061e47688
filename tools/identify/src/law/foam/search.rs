//! The coefficients of the hyperfoam law that are nearest to several tests, among those of positive moduli.
//!
//! A positive modulus of every term makes the law stable at all stretches; without that demand two terms of the same exponent
//! cancel, and the law that is nearest to the data is none that a simulation can use.
//!
//! Where all terms have one Poisson's ratio, the stress is linear in the moduli: a grid of exponents and ratios is searched that
//! way. Its best points, and the law of one term less, are then refined by Levenberg-Marquardt in all coefficients at once, each
//! term with a ratio of its own, the free stretch of every state found anew. Nothing is random.

use nalgebra::{DMatrix, DVector};

use super::stress::{PER_TERM, State, Term};
use crate::law::{DataSet, linear};
use crate::least_squares::{self, Bounded, Effort, Held, Model};

/// Legal exponents and Poisson's ratios of the kernel, for an exponent never nearer to zero than `SMALLEST_ALPHA`.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Of the exponents.
    pub alpha: (f64, f64),
    /// Of Poisson's ratios.
    pub nu: (f64, f64),
}

/// What is asked of the coefficients.
#[derive(Clone, Copy, Debug)]
pub struct Demand {
    /// What the kernel takes.
    pub bounds: Bounds,
    /// Poisson's ratio of every term, where it is known.
    pub nu: Option<f64>,
}

/// An exponent nearer to zero has no numbers for the stress of its term.
const SMALLEST_ALPHA: f64 = 1e-3;
/// Exponents of the starts: positive ones soften in compression, negative ones stiffen.
const ALPHAS: [f64; 14] = [-18.0, -11.0, -7.0, -4.0, -2.0, -1.0, 1.0, 2.0, 4.0, 7.0, 11.0, 16.0, 22.0, 28.0];
/// Poisson's ratios of the starts, as parts of the way between the bounds.
const NUS: [f64; 4] = [0.02, 0.25, 0.5, 0.8];
/// Exponents of a term that is added to the law of one term less.
const ADDED: [f64; 3] = [-4.0, 4.0, 16.0];
/// Starts that are refined.
const REFINED: usize = 16;
/// Refined starts that are finished on all points.
const FINISHED: usize = 3;
/// Points of which starts are judged, at most.
const START_POINTS: usize = 100;
/// A state without a free stretch counts as a residual of so many times the largest stress.
const LOST: f64 = 10.0;

/// A point with its weight.
#[derive(Clone, Copy)]
struct Target {
    state: State,
    stress: f64,
    weight: f64,
}

/// The values mu_1, alpha_1, nu_1, mu_2, ... of the law with `n_term` terms nearest to `data`, exponents in falling order.
pub fn fit(n_term: usize, data: &[DataSet], weights: &[f64], demand: &Demand) -> Vec<f64> {
    let all = targets(data, weights);
    let few = thinned(&all);
    let smaller = if n_term > 1 { fit(n_term - 1, data, weights, demand) } else { Vec::new() };
    let nu = demand.nu.unwrap_or_else(|| part_of(demand.bounds.nu, NUS[1]));
    let larger = ADDED.iter().filter(|_| n_term > 1).map(|alpha| [smaller.as_slice(), &[0.0, *alpha, nu]].concat());
    let mut starts = starts(n_term, &few, demand);
    starts.extend(larger.clone());
    let refine = |targets: &[Target], start: &[f64], effort: &Effort| {
        let problem = Problem::new(targets, *demand);
        let (cost, inner) = least_squares::minimise(&problem, problem.inner(start), effort);
        (cost, problem.values(&inner))
    };
    let mut refined: Vec<_> = starts.iter().map(|start| refine(&few, start, &Effort::ROUGH)).collect();
    refined.sort_by(|a, b| a.0.total_cmp(&b.0));
    refined.dedup_by(|a, b| (a.0 - b.0).abs() <= 1e-6 * b.0);
    let finished = refined.iter().take(FINISHED).map(|(_, start)| refine(&all, start, &Effort::FULL));
    // The smaller law itself with a term of nothing, so that a further term never fits worse.
    let smaller = larger.take(1).map(|values| (cost(&values, &all), values));
    let best = finished.chain(smaller).min_by(|a, b| a.0.total_cmp(&b.0)).map_or_else(Vec::new, |(_, values)| values);
    let mut terms: Vec<&[f64]> = best.chunks(PER_TERM).collect();
    terms.sort_by(|a, b| b[1].total_cmp(&a[1]));
    terms.concat()
}

/// Nominal stress of the law at every point of `data`, Pa; NaN where no free stretch is found.
pub fn predict(values: &[f64], data: &[DataSet]) -> Vec<f64> {
    let terms = Term::list(values);
    states(data).map(|state| state.stress(&terms).map_or(f64::NAN, |(stress, _)| stress)).collect()
}

/// Derivative of the nominal stress by each value at each point, n_point x n_value; zeros where no free stretch is found.
pub fn jacobian(values: &[f64], data: &[DataSet]) -> DMatrix<f64> {
    let terms = Term::list(values);
    let row = |state: State| state.stress(&terms).map_or_else(|| vec![0.0; values.len()], |(_, slopes)| slopes);
    let rows: Vec<f64> = states(data).flat_map(row).collect();
    DMatrix::from_row_slice(rows.len() / values.len().max(1), values.len(), &rows)
}

/// Least sum of squares with `parameter` held at its value in `start`, from there and from `optimum`; infinite beyond its bounds.
pub fn minimum_at(
    parameter: usize,
    start: &[f64],
    optimum: &[f64],
    data: &[DataSet],
    weights: &[f64],
    demand: &Demand,
) -> f64 {
    let bounds = [(0.0, f64::MAX), demand.bounds.alpha, demand.bounds.nu][parameter % PER_TERM];
    if !(bounds.0..=bounds.1).contains(&start[parameter]) {
        return f64::INFINITY;
    }
    let targets = targets(data, weights);
    let problem = Problem::new(&targets, *demand);
    let Some(place) = problem.places(start.len()).position(|place| place == parameter) else { return f64::INFINITY };
    let held = problem.inner(start)[place];
    let from = |values: &[f64]| {
        let mut inner = problem.inner(values);
        inner.remove(place);
        let model = Held { model: &problem, parameter: place, value: held };
        least_squares::minimise(&model, inner, &Effort::ROUGH).0
    };
    from(start).min(from(optimum))
}

fn states(data: &[DataSet]) -> impl Iterator<Item = State> {
    data.iter().flat_map(|set| set.points.iter().map(|(x, _)| State::new(set.mode, *x)))
}

fn targets(data: &[DataSet], weights: &[f64]) -> Vec<Target> {
    let stresses = data.iter().flat_map(|set| set.points.iter().map(|point| point.1));
    let targets = states(data).zip(stresses).zip(weights);
    targets.map(|((state, stress), weight)| Target { state, stress, weight: *weight }).collect()
}

/// Evenly chosen points, at most [`START_POINTS`].
fn thinned(targets: &[Target]) -> Vec<Target> {
    let count = targets.len().min(START_POINTS);
    (0..count).map(|k| targets[k * (targets.len() - 1) / (count - 1).max(1)]).collect()
}

fn part_of((low, high): (f64, f64), part: f64) -> f64 {
    low + part * (high - low)
}

/// The best combinations of the grid, as values.
fn starts(n_term: usize, targets: &[Target], demand: &Demand) -> Vec<Vec<f64>> {
    let stresses = DVector::from_iterator(targets.len(), targets.iter().map(|t| t.weight * t.stress));
    let nus = demand.nu.map_or_else(|| NUS.map(|part| part_of(demand.bounds.nu, part)).to_vec(), |nu| vec![nu]);
    let alphas: Vec<f64> =
        ALPHAS.into_iter().filter(|alpha| (demand.bounds.alpha.0..=demand.bounds.alpha.1).contains(alpha)).collect();
    let choices = combinations(alphas.len(), n_term);
    let mut found: Vec<(f64, Vec<f64>)> = Vec::new();
    for nu in nus {
        let column = |alpha: &f64| {
            DVector::from_iterator(targets.len(), targets.iter().map(|t| t.weight * t.state.unit(*alpha, nu)))
        };
        let columns: Vec<DVector<f64>> = alphas.iter().map(column).collect();
        found.extend(choices.iter().map(|choice| {
            let a = DMatrix::from_columns(&choice.iter().map(|k| columns[*k].clone()).collect::<Vec<_>>());
            let mu = linear::non_negative(&a, &stresses);
            let values = choice.iter().enumerate().flat_map(|(i, k)| [mu[i], alphas[*k], nu]).collect();
            ((&a * &mu - &stresses).norm(), values)
        }));
    }
    found.retain(|(cost, _)| cost.is_finite());
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    // The best, which are neighbours of each other, and as many evenly from the others.
    let others = found.split_off(found.len().min(REFINED / 2));
    let step = others.len().div_ceil(REFINED / 2).max(1);
    found.into_iter().chain(others.into_iter().step_by(step)).map(|(_, values)| values).collect()
}

/// Every choice of `n` different indices below `count`, in order.
fn combinations(count: usize, n: usize) -> Vec<Vec<usize>> {
    let mut choices = vec![Vec::new()];
    for _ in 0..n {
        let longer = choices.iter().flat_map(|choice: &Vec<usize>| {
            let next = choice.last().map_or(0, |last| last + 1);
            (next..count).map(move |k| [choice.as_slice(), &[k]].concat())
        });
        choices = longer.collect();
    }
    choices
}

/// Sum of the squared residuals of the values mu_1, alpha_1, nu_1, mu_2, ...
fn cost(values: &[f64], targets: &[Target]) -> f64 {
    let terms = Term::list(values);
    let residual = |target: &Target| Some(target.weight * (target.state.stress(&terms)?.0 - target.stress));
    targets.iter().map(|target| residual(target).map_or(f64::INFINITY, |r| r * r)).sum()
}

/// The problem in unbounded parameters: for each term the root of mu / scale, t of the exponent, and t of Poisson's ratio unless it
/// is known.
struct Problem<'a> {
    targets: &'a [Target],
    demand: Demand,
    scale: f64,
}

impl<'a> Problem<'a> {
    fn new(targets: &'a [Target], demand: Demand) -> Self {
        let scale = targets.iter().fold(0.0, |largest, t| f64::max(largest, t.stress.abs()));
        Self { targets, demand, scale }
    }

    /// Indices of the free ones among `n` values.
    fn places(&self, n: usize) -> impl Iterator<Item = usize> {
        let known = self.demand.nu.is_some();
        (0..n).filter(move |k| !(known && k % PER_TERM == PER_TERM - 1))
    }

    fn bounded(&self, place: usize) -> Bounded {
        let (low, high) = if place % PER_TERM == 1 { self.demand.bounds.alpha } else { self.demand.bounds.nu };
        Bounded { middle: 0.5 * (low + high), half: 0.5 * (high - low) }
    }

    fn inner(&self, values: &[f64]) -> Vec<f64> {
        let of = |place: usize| {
            let value = values[place];
            match place % PER_TERM {
                // A root of exactly zero would never move.
                0 => (value / self.scale).max(1e-6).sqrt(),
                _ => self.bounded(place).parameter(value),
            }
        };
        self.places(values.len()).map(of).collect()
    }

    /// Each free value with its derivative by its parameter.
    fn free(&self, inner: &[f64]) -> Vec<(f64, f64)> {
        let n = PER_TERM * inner.len() / self.per_term();
        let of = |(place, t): (usize, &f64)| match place % PER_TERM {
            0 => (self.scale * t * t, 2.0 * self.scale * t),
            1 => {
                let alpha = self.bounded(place).value(*t);
                let alpha = if alpha.abs() < SMALLEST_ALPHA { SMALLEST_ALPHA.copysign(alpha) } else { alpha };
                (alpha, self.bounded(place).slope(*t))
            }
            _ => (self.bounded(place).value(*t), self.bounded(place).slope(*t)),
        };
        self.places(n).zip(inner).map(of).collect()
    }

    fn per_term(&self) -> usize {
        PER_TERM - usize::from(self.demand.nu.is_some())
    }

    /// mu_1, alpha_1, nu_1, mu_2, ...
    fn values(&self, inner: &[f64]) -> Vec<f64> {
        let free: Vec<f64> = self.free(inner).into_iter().map(|(value, _)| value).collect();
        free.chunks(self.per_term())
            .flat_map(|term| [term[0], term[1], self.demand.nu.unwrap_or(term[term.len() - 1])])
            .collect()
    }
}

impl Model for Problem<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        let terms = Term::list(&self.values(inner));
        let residual = |target: &Target| match target.state.stress(&terms) {
            Some((stress, _)) => target.weight * (stress - target.stress),
            None => target.weight * LOST * self.scale,
        };
        DVector::from_iterator(self.targets.len(), self.targets.iter().map(residual))
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        let free = self.free(inner);
        let values = self.values(inner);
        let (terms, places) = (Term::list(&values), self.places(values.len()).collect::<Vec<_>>());
        let mut jacobian = DMatrix::zeros(self.targets.len(), free.len());
        for (i, target) in self.targets.iter().enumerate() {
            let Some((_, slopes)) = target.state.stress(&terms) else { continue };
            for (j, (place, (_, slope))) in places.iter().zip(&free).enumerate() {
                jacobian[(i, j)] = target.weight * slopes[*place] * slope;
            }
        }
        jacobian
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Mode;

    const DEMAND: Demand = Demand { bounds: Bounds { alpha: (-30.0, 30.0), nu: (0.0, 0.45) }, nu: None };

    fn data(values: &[f64]) -> Vec<DataSet> {
        let set = |(mode, low, high): (Mode, f64, f64)| DataSet {
            mode,
            points: (0..30).map(|k| (low + (high - low) * (f64::from(k) + 0.5) / 30.0, 0.0)).collect(),
        };
        let ranges = [(Mode::Uniaxial, 0.3, 1.4), (Mode::SimpleShear, -0.4, 0.4), (Mode::Equibiaxial, 0.8, 1.2)];
        let mut data: Vec<DataSet> = ranges.into_iter().map(set).collect();
        let stresses = predict(values, &data);
        data.iter_mut().flat_map(|set| &mut set.points).zip(stresses).for_each(|(point, stress)| point.1 = stress);
        data
    }

    #[test]
    fn exact_data_give_their_coefficients_back() {
        for truth in [&[4e4, 8.0, 0.15][..], &[3e4, 12.0, 0.1, 1e4, -2.5, 0.3]] {
            let (data, n_term) = (data(truth), truth.len() / PER_TERM);
            let found = fit(n_term, &data, &[1.0; 90], &DEMAND);
            for (found, truth) in found.iter().zip(truth) {
                assert!((found / truth - 1.0).abs() < 1e-5, "{found} {truth}");
            }
        }
    }

    #[test]
    fn a_known_ratio_is_kept() {
        let found = fit(1, &data(&[4e4, 8.0, 0.0]), &[1.0; 90], &Demand { nu: Some(0.0), ..DEMAND });
        assert!((found[0] / 4e4 - 1.0).abs() < 1e-8 && (found[1] / 8.0 - 1.0).abs() < 1e-8, "{found:?}");
        assert_eq!(found[2], 0.0);
    }

    #[test]
    fn a_further_term_is_not_worse() {
        let data = data(&[3e4, 12.0, 0.1, 1e4, -2.5, 0.3, 2e3, 25.0, 0.0]);
        let sum = |n_term: usize| cost(&fit(n_term, &data, &[1.0; 90], &DEMAND), &targets(&data, &[1.0; 90]));
        let sums = [1, 2, 3].map(sum);
        assert!(sums[1] <= sums[0] && sums[2] <= sums[1], "{sums:?}");
    }
}
