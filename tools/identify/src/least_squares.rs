//! Nonlinear least squares by Levenberg-Marquardt, in parameters without bounds.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, Owned};

/// What is minimised: residuals over unbounded parameters.
pub trait Model {
    /// The weighted residuals.
    fn residuals(&self, parameters: &[f64]) -> DVector<f64>;
    /// Their derivatives, n_residual x n_parameter.
    fn jacobian(&self, parameters: &[f64]) -> DMatrix<f64>;
}

/// A model of which one parameter is held.
pub struct Held<'a> {
    /// The model.
    pub model: &'a dyn Model,
    /// Index of the parameter.
    pub parameter: usize,
    /// Its value.
    pub value: f64,
}

impl Held<'_> {
    fn all(&self, others: &[f64]) -> Vec<f64> {
        let mut all = others.to_vec();
        all.insert(self.parameter, self.value);
        all
    }
}

impl Model for Held<'_> {
    fn residuals(&self, others: &[f64]) -> DVector<f64> {
        self.model.residuals(&self.all(others))
    }

    fn jacobian(&self, others: &[f64]) -> DMatrix<f64> {
        self.model.jacobian(&self.all(others)).remove_column(self.parameter)
    }
}

/// When a minimisation ends.
pub struct Effort {
    /// Relative change of the sum of squares and of the parameters.
    tolerance: f64,
    /// Evaluations per parameter, and one.
    patience: usize,
}

impl Effort {
    /// To the end.
    pub const FULL: Self = Self { tolerance: 1e-13, patience: 200 };
    /// To tell good starts from bad ones.
    pub const ROUGH: Self = Self { tolerance: 1e-6, patience: 20 };
}

/// The parameters reached from `start`, and their sum of squares (infinite where it is no number).
pub fn minimise(model: &dyn Model, start: Vec<f64>, effort: &Effort) -> (f64, Vec<f64>) {
    let problem = Problem { model, parameters: DVector::from_vec(start) };
    let search = LevenbergMarquardt::new().with_tol(effort.tolerance).with_patience(effort.patience);
    let (problem, _) = search.minimize(problem);
    let cost = problem.residuals().map_or(f64::INFINITY, |r| r.norm_squared());
    (if cost.is_finite() { cost } else { f64::INFINITY }, problem.parameters.as_slice().to_vec())
}

// One type for all models, so that the search is compiled once.
struct Problem<'a> {
    model: &'a dyn Model,
    parameters: DVector<f64>,
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Problem<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters.copy_from(parameters);
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.model.residuals(self.parameters.as_slice()))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.model.jacobian(self.parameters.as_slice()))
    }
}

/// A value between bounds as a function of a parameter t without: middle + half t / sqrt(1 + t^2).
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    /// Middle between the bounds.
    pub middle: f64,
    /// Half their distance.
    pub half: f64,
}

impl Bounded {
    /// The value at t.
    pub fn value(self, t: f64) -> f64 {
        self.middle + self.half * t / (1.0 + t * t).sqrt()
    }

    /// Its derivative by t.
    pub fn slope(self, t: f64) -> f64 {
        self.half * (1.0 + t * t).powf(-1.5)
    }

    /// The t of a value; of one at a bound or beyond, that of a value just within.
    pub fn parameter(self, value: f64) -> f64 {
        let ratio = ((value - self.middle) / self.half).clamp(-0.999, 0.999);
        ratio / (1.0 - ratio * ratio).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y = a e^(b x) through exact points, and the derivative of a bounded value by a central difference.
    #[test]
    fn an_exponential_and_the_slope_of_a_bound() {
        struct Exponential;
        impl Model for Exponential {
            fn residuals(&self, p: &[f64]) -> DVector<f64> {
                DVector::from_fn(20, |k, _| p[0] * (p[1] * 0.1 * k as f64).exp() - 2.0 * (-0.1 * k as f64).exp())
            }
            fn jacobian(&self, p: &[f64]) -> DMatrix<f64> {
                DMatrix::from_fn(20, 2, |k, j| {
                    let power = (p[1] * 0.1 * k as f64).exp();
                    if j == 0 { power } else { p[0] * 0.1 * k as f64 * power }
                })
            }
        }
        let (cost, found) = minimise(&Exponential, vec![1.0, 0.5], &Effort::FULL);
        assert!(cost < 1e-20 && (found[0] - 2.0).abs() < 1e-9 && (found[1] + 1.0).abs() < 1e-9, "{found:?}");
        let bounded = Bounded { middle: 1.0, half: 30.0 };
        for t in [-2.0, 0.0, 0.7] {
            let slope = (bounded.value(t + 1e-5) - bounded.value(t - 1e-5)) / 2e-5;
            assert!((slope / bounded.slope(t) - 1.0).abs() < 1e-8);
            assert!((bounded.parameter(bounded.value(t)) - t).abs() < 1e-12);
        }
        assert!(bounded.parameter(99.0).is_finite());
    }
}
