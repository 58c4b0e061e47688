//! Deviations of values from references.

use crate::measurement::quantity::COUNT;

/// Deviation of `value` from `reference`, %.
pub fn error_percent(value: f64, reference: f64) -> f64 {
    100.0 * (value - reference) / reference
}

/// Deviation of each of the four numbers, %.
pub fn errors_percent(values: &[f64; COUNT], references: &[f64; COUNT]) -> [f64; COUNT] {
    std::array::from_fn(|i| error_percent(values[i], references[i]))
}

/// Mean of the absolute values; 0 of none.
pub fn mean_absolute(errors: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = errors.fold((0.0, 0.0), |(sum, count), error| (sum + error.abs(), count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}
