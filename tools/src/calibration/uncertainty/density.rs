//! The density that is sampled: prior times likelihood, by the emulator.
//!
//! A point is the parts of the ranges (0 to 1, uniform: the prior is flat on the scale of the file), then the logarithms of
//! the inferred discrepancies.

use hammer_and_sample::Model;

use super::emulator::Emulator;
use super::error_model::ErrorModel;
use crate::calibration::material_test::distances;
use crate::calibration::objective::scenario;
use crate::calibration::problem::Problem;

/// The density.
pub struct Density<'a> {
    /// The emulator of the numbers that count.
    pub emulator: &'a Emulator,
    /// The measured numbers.
    pub errors: &'a ErrorModel,
    /// The problem, whose tests of the material may count; without any the ranges alone are the prior.
    pub problem: Option<&'a Problem>,
    /// How many parameters there are.
    pub parameters: usize,
}

impl Model for Density<'_> {
    type Params = Vec<f64>;

    fn log_prob(&self, point: &Vec<f64>) -> f64 {
        let (parts, ln_discrepancies) = point.split_at(self.parameters);
        if parts.iter().any(|part| !(0.0..=1.0).contains(part)) {
            return f64::NEG_INFINITY;
        }
        let Some(logarithms) = self.emulator.predict(parts) else { return f64::NEG_INFINITY };
        let discrepancies: Vec<f64> = ln_discrepancies.iter().map(|ln| ln.exp()).collect();
        let likelihood = self.errors.ln_likelihood(&logarithms, &self.emulator.variances, &discrepancies);
        let tests = self.problem.map_or(0.0, |problem| ln_material_tests(problem, parts));
        let density = likelihood + self.errors.ln_prior(ln_discrepancies) + tests;
        if density.is_nan() { f64::NEG_INFINITY } else { density }
    }
}

/// The values at `parts` of the ranges.
pub fn values_at(problem: &Problem, parts: &[f64]) -> Vec<f64> {
    problem.variables.iter().zip(parts).map(|(variable, part)| variable.value(*part)).collect()
}

/// Logarithm of the density of the tests of the material, of `[prior]` and of every `[[material_test]]` that counts: model over
/// measurement, log-normal.
pub fn ln_material_tests(problem: &Problem, parts: &[f64]) -> f64 {
    if problem.prior.is_none() && problem.material_tests.is_empty() {
        return 0.0;
    }
    let Ok(scenario) = scenario(problem, &values_at(problem, parts)) else { return f64::NEG_INFINITY };
    let demands = problem.prior.map(|prior| prior.demands(&scenario.layers[0].material));
    let of_prior = demands
        .iter()
        .flatten()
        .map(|demand| (demand.model / demand.measured).ln() / problem.uncertainty.prior_deviation);
    of_prior.chain(distances(&problem.material_tests, &scenario)).map(|distance| -0.5 * distance * distance).sum()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// Neo-Hookean, whose relaxed nominal stress in tension to a stretch of 1.5 is 2 c10 (1.5 - 1.5^-2): as measured at 1e5 Pa.
    fn problem(predict: bool) -> Problem {
        let stress = 2.0 * 1e5 * (1.5 - 1.5f64.powi(-2));
        let text = format!(
            r#"
preset = "study"
[fixed]
"silicone.c01" = 0.0
"silicone.c11" = 0.0
"silicone.c20" = 0.0
"silicone.c02" = 0.0
[search]
evaluations = 1
[parameters]
"silicone.c10" = {{ min = 1e4, max = 1e6, scale = "log" }}
[[impact]]
energy = 14.7
table_1 = true
[[material_test]]
name = "tension"
load = "tension"
quantity = "stress"
strain = 0.5
value = {stress}
standard_deviation = {}
predict = {predict}
"#,
            0.2 * stress
        );
        Problem::parse(&text, Path::new(".")).unwrap()
    }

    /// Source: the closed form above, and the density of a log-normal number with a deviation of 0.2.
    #[test]
    fn a_material_test_that_counts_is_log_normal() {
        let problem_that_counts = problem(false);
        assert!(ln_material_tests(&problem_that_counts, &[0.5]).abs() < 1e-6);
        let twice = 0.5 + 2f64.ln() / 100f64.ln();
        let expected = -0.5 * (2f64.ln() / 0.2).powi(2);
        assert!((ln_material_tests(&problem_that_counts, &[twice]) - expected).abs() < 1e-4);
        assert_eq!(ln_material_tests(&problem(true), &[twice]), 0.0);
    }
}
