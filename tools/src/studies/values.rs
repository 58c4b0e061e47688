//! The values of a study as the command line gives them.

use softanvil_kernel::Scenario;
use softanvil_kernel::parameter::Values;

use crate::failure::Failure;
use crate::scenario_file::names;

/// `values` as numbers.
///
/// # Errors
/// The first that is no finite number.
pub fn numbers(study: &str, values: &[String]) -> Result<Vec<f64>, Failure> {
    let number = |text: &String| {
        text.trim().parse::<f64>().ok().filter(|value| value.is_finite()).ok_or_else(|| {
            Failure::Input(format!("study {study}: {text} is refused: expected a list of numbers, such as 1,2.5"))
        })
    };
    values.iter().map(number).collect()
}

/// `values` in rising order, with `own` among them, each once.
pub fn with_own(mut values: Vec<f64>, own: f64) -> Vec<f64> {
    values.push(own);
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * b.abs());
    values
}

/// Sets a parameter of `scenario`.
///
/// # Errors
/// A value that is refused, with its unit and legal range.
pub(crate) fn set(scenario: &mut Scenario, name: &str, value: f64) -> Result<(), Failure> {
    let parameter = names::find(&Values::of(scenario), name).map_err(Failure::Failed)?;
    parameter.set(scenario, value).map_err(|error| Failure::Input(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_sorted_and_stand_once() {
        assert_eq!(with_own(vec![0.6, 0.2, 0.3], 0.3 + 1e-16), [0.2, 0.3, 0.6]);
        assert!(numbers("poisson", &["0.4".into(), "x".into()]).unwrap_err().to_string().contains("x is refused"));
    }
}
