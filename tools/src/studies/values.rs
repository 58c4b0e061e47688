//! The values of a study as the command line gives them.

use crate::failure::Failure;

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

/// A number as short as it goes, without the noise of a change of units.
pub fn short(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    if rounded == 0.0 { "0".into() } else { format!("{rounded}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_sorted_and_stand_once() {
        assert_eq!(with_own(vec![0.6, 0.2, 0.3], 0.3 + 1e-16), [0.2, 0.3, 0.6]);
        assert_eq!((short(0.1 + 0.2), short(-1e-9), short(1e3 * 0.0147)), ("0.3".into(), "0".into(), "14.7".into()));
        assert!(numbers("poisson", &["0.4".into(), "x".into()]).unwrap_err().to_string().contains("x is refused"));
    }
}
