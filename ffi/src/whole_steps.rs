//! The rule by which a time becomes a number of kernel steps.

/// Two times closer than this, in kernel steps, are the same time: well above what rounding adds up to in the times of a
/// run, and far below anything that shows.
pub(crate) const SAME: f64 = 1e-9;

/// The whole number of steps nearest to `steps`, of two equally near the larger; 0 for what is below.
pub(crate) fn nearest(steps: f64) -> i64 {
    // Processors turn floats into signed integers at once. The cast cuts off what is behind the point, also of numbers
    // below 0, and holds what does not fit at the largest integer.
    let count = (steps + 0.5 + SAME) as i64;
    if count > 0 { count } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn ties_go_up_however_they_are_rounded() {
        for (steps, count) in [(0.0, 0), (0.49, 0), (0.5, 1), (1.49, 1), (1.5, 2), (2.5, 3), (1e6 + 0.5, 1_000_001)] {
            assert_eq!(nearest(steps), count, "{steps}");
        }
        let almost = [0.5_f64.next_down(), 0.1 + 0.2 + 0.2 - f64::EPSILON, (1e6_f64 + 0.5).next_down()];
        assert_eq!(almost.map(nearest), [1, 1, 1_000_001]);
        assert_eq!([-0.4, -0.6, -1.0, -1e9].map(nearest), [0; 4]);
    }
}
