//! Statistics that a few outliers do not move.

/// Standard deviations of a normal distribution in its median absolute deviation.
pub const NORMAL: f64 = 1.482_602_218_505_602;

/// The median, of an even number the larger of the two in the middle; 0 of nothing.
pub fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// Median of `values`, and the standard deviation of normal errors that have their median absolute deviation.
pub fn median_and_deviation(values: &[f64]) -> (f64, f64) {
    let center = median(values.to_vec());
    (center, NORMAL * median(values.iter().map(|value| (value - center).abs()).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_outlier_moves_neither() {
        assert_eq!((median(vec![]), median(vec![3.0, 1.0]), median(vec![2.0, 9e9, 1.0])), (0.0, 3.0, 2.0));
        let (center, deviation) = median_and_deviation(&[1.0, 2.0, 3.0, 4.0, 1e9]);
        assert_eq!((center, deviation), (3.0, NORMAL));
        assert_eq!(median_and_deviation(&[]), (0.0, 0.0));
    }
}
