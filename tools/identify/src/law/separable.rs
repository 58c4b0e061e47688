//! Laws of moduli, in which the stress is linear, and of shapes, in which it is not.
//!
//! The moduli follow from the shapes as a linear problem, so that the search runs over the shapes alone (variable projection,
//! Golub and Pereyra 1973), between the bounds that the law states: Levenberg-Marquardt from the best points of a grid. It
//! needs nothing but the law's stresses, and so serves every law whose coefficients say what they are. Nothing is random.

use nalgebra::{DMatrix, DVector};
use softanvil_kernel::material::Coefficient;

use super::interval::Interval;
use super::stability::Stability;
use super::stress::predict;
use super::{DataSet, Law, linear};
use crate::least_squares::{self, Effort, Held, Model};

/// Points of the grid over all shapes together, about.
const GRID: f64 = 60.0;
/// Points of the grid that are refined.
const REFINED: usize = 4;
/// Differences that take derivatives: relative ones by a parameter, and by the t of a bounded one.
const DIFFERENCE: f64 = 1e-6;

/// The values of the parameters of `law` nearest to `data`; none that is stable over the stretches `stable`, where that is
/// demanded.
///
/// Stability is demanded of the moduli, at the shapes that are nearest without it.
pub fn fit(law: &Law, data: &[DataSet], weights: &[f64], stable: Option<(f64, f64)>) -> Option<Vec<f64>> {
    let problem = Projected { law, data, weights };
    let mut starts: Vec<(f64, Vec<f64>)> = grid(&law.intervals())
        .into_iter()
        .map(|start| (problem.residuals(&start).norm_squared(), start))
        .filter(|(cost, _)| cost.is_finite())
        .collect();
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let refined = starts.into_iter().take(REFINED);
    let refined = refined.map(|(_, start)| least_squares::minimise(&problem, start, &Effort::FULL));
    let (_, inner) = refined.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let shapes = problem.shapes(&inner);
    let (a, b) = problem.linear(&shapes);
    let Some(range) = stable else {
        return Some(law.values(linear::solve(&a, &b).as_slice(), &shapes));
    };
    let moduli = linear::solve_stable(&linear::unit_laws(law, &shapes), &a, &b, range)?;
    let values = law.values(moduli.as_slice(), &shapes);
    Stability::new(&law.elastic(&values)).covers(range).then_some(values)
}

/// Derivative of the nominal stress by each parameter at each point, n_point x n_parameter: exact by the moduli, central
/// differences by the shapes.
pub fn jacobian(law: &Law, values: &[f64], data: &[DataSet]) -> DMatrix<f64> {
    let (_, shapes) = law.parted(values);
    let mut by_modulus = linear::design(&linear::unit_laws(law, &shapes), data)
        .column_iter()
        .map(DVector::from)
        .collect::<Vec<_>>()
        .into_iter();
    let column = |(index, parameter): (usize, &Coefficient)| match parameter.is_modulus() {
        true => by_modulus.next().unwrap_or_else(|| DVector::zeros(0)),
        false => {
            let step = DIFFERENCE * values[index].abs();
            let at = |offset: f64| {
                let mut moved = values.to_vec();
                moved[index] += offset;
                DVector::from_vec(predict(law, &moved, data))
            };
            (at(step) - at(-step)) / (2.0 * step)
        }
    };
    DMatrix::from_columns(&law.parameters.iter().enumerate().map(column).collect::<Vec<_>>())
}

/// Least sum of squares with `parameter` held at its value in `start`, from there and from `optimum`; infinite beyond its
/// bounds.
pub fn minimum_at(
    law: &Law,
    parameter: usize,
    start: &[f64],
    optimum: &[f64],
    data: &[DataSet],
    weights: &[f64],
) -> f64 {
    let coefficient = &law.parameters[parameter];
    if !(coefficient.min..=coefficient.max).contains(&start[parameter]) {
        return f64::INFINITY;
    }
    let problem = Whole { law, data, weights, units: optimum };
    let held = problem.inner(start)[parameter];
    let from = |values: &[f64]| {
        let mut inner = problem.inner(values);
        inner.remove(parameter);
        least_squares::minimise(&Held { model: &problem, parameter, value: held }, inner, &Effort::ROUGH).0
    };
    from(start).min(from(optimum))
}

/// The t of the points of a grid over all shapes.
fn grid(intervals: &[Interval]) -> Vec<Vec<f64>> {
    let n = GRID.powf(1.0 / intervals.len().max(1) as f64).round().max(2.0) as usize;
    let mut points = vec![Vec::new()];
    for interval in intervals {
        let places = (0..n).map(|k| interval.parameter(interval.at((k as f64 + 0.5) / n as f64)));
        let places: Vec<f64> = places.collect();
        points = points.iter().flat_map(|point| places.iter().map(|t| [point.as_slice(), &[*t]].concat())).collect();
    }
    points
}

fn weighted(weights: &[f64], stresses: impl IntoIterator<Item = f64>) -> DVector<f64> {
    DVector::from_iterator(weights.len(), stresses.into_iter().zip(weights).map(|(stress, weight)| weight * stress))
}

fn measured(data: &[DataSet]) -> impl Iterator<Item = f64> {
    data.iter().flat_map(|set| set.points.iter().map(|point| point.1))
}

/// Derivatives of residuals over unbounded parameters, by central differences.
fn differences(inner: &[f64], residuals: impl Fn(&[f64]) -> DVector<f64>) -> DMatrix<f64> {
    let column = |index: usize| {
        let step = DIFFERENCE * (1.0 + inner[index].abs());
        let at = |offset: f64| {
            let mut moved = inner.to_vec();
            moved[index] += offset;
            residuals(&moved)
        };
        (at(step) - at(-step)) / (2.0 * step)
    };
    DMatrix::from_columns(&(0..inner.len()).map(column).collect::<Vec<_>>())
}

/// The problem in the shapes' t alone, each with the moduli that are best for it.
struct Projected<'a> {
    law: &'a Law,
    data: &'a [DataSet],
    weights: &'a [f64],
}

impl Projected<'_> {
    fn shapes(&self, inner: &[f64]) -> Vec<f64> {
        self.law.intervals().iter().zip(inner).map(|(interval, t)| interval.value(*t)).collect()
    }

    /// Weighted stresses of unit moduli, and those measured.
    fn linear(&self, shapes: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let mut design = linear::design(&linear::unit_laws(self.law, shapes), self.data);
        for (mut row, weight) in design.row_iter_mut().zip(self.weights) {
            row *= *weight;
        }
        (design, weighted(self.weights, measured(self.data)))
    }
}

impl Model for Projected<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        let (a, b) = self.linear(&self.shapes(inner));
        let moduli = linear::solve(&a, &b);
        a * moduli - b
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        differences(inner, |inner| self.residuals(inner))
    }
}

/// The problem in all parameters: moduli in `units`, and t of the shapes.
struct Whole<'a> {
    law: &'a Law,
    data: &'a [DataSet],
    weights: &'a [f64],
    units: &'a [f64],
}

impl Whole<'_> {
    fn inner(&self, values: &[f64]) -> Vec<f64> {
        let of = |((parameter, value), unit): ((&Coefficient, &f64), &f64)| match parameter.is_modulus() {
            true => value / unit,
            false => Interval::of(parameter).parameter(*value),
        };
        self.law.parameters.iter().zip(values).zip(self.units).map(of).collect()
    }

    fn values(&self, inner: &[f64]) -> Vec<f64> {
        let of = |((parameter, inner), unit): ((&Coefficient, &f64), &f64)| match parameter.is_modulus() {
            true => inner * unit,
            false => Interval::of(parameter).value(*inner),
        };
        self.law.parameters.iter().zip(inner).zip(self.units).map(of).collect()
    }
}

impl Model for Whole<'_> {
    fn residuals(&self, inner: &[f64]) -> DVector<f64> {
        let found = weighted(self.weights, predict(self.law, &self.values(inner), self.data));
        found - weighted(self.weights, measured(self.data))
    }

    fn jacobian(&self, inner: &[f64]) -> DMatrix<f64> {
        differences(inner, |inner| self.residuals(inner))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{LAWS, MODES, ogden};

    /// The stresses of `law` with `values` in the three tests.
    fn data(law: &Law, values: &[f64]) -> Vec<DataSet> {
        let stretches = (1..25).map(|k| (0.6 + 0.08 * f64::from(k), 0.0));
        let set = |mode: &_| DataSet { mode: *mode, points: stretches.clone().collect() };
        let mut data: Vec<DataSet> = MODES.iter().map(set).collect();
        let stresses = predict(law, values, &data);
        data.iter_mut().flat_map(|set| &mut set.points).zip(stresses).for_each(|(point, stress)| point.1 = stress);
        data
    }

    /// Every law with shapes, and Ogden's of one term, which has a fit of its own.
    #[test]
    fn exact_data_give_their_coefficients_back() {
        let separable = |law: &&Law| !law.is_linear() && law.parameters.len() == 2;
        let mut tried = 0;
        for law in LAWS.iter().filter(separable) {
            let truth = law.example();
            let data = data(law, truth);
            for stable in [None, Some((0.5, 2.0))] {
                let found = fit(law, &data, &[1.0; 72], stable).unwrap();
                for (found, truth) in found.iter().zip(truth) {
                    assert!((found / truth - 1.0).abs() < 1e-6, "{}: {found} {truth}", law.name);
                }
            }
            tried += 1;
        }
        assert!(tried > 0);
    }

    /// Against the fit of Ogden's law that is made for it.
    #[test]
    fn ogden_with_one_term_is_fitted_as_well() {
        let law = Law::find("ogden_1").unwrap();
        let data = data(Law::find("yeoh_3").unwrap(), &[1e5, -3e3, 500.0]);
        let special = ogden::fit(1, &data, &[1.0; 72], false);
        let general = fit(law, &data, &[1.0; 72], None).unwrap();
        for (a, b) in special.iter().zip(&general) {
            assert!((a / b - 1.0).abs() < 1e-5, "{special:?} {general:?}");
        }
        let (a, b) = (ogden::jacobian(&general, &data), jacobian(law, &general, &data));
        assert!((&a - &b).norm() < 1e-7 * a.norm());
    }
}
