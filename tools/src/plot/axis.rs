//! Axes that begin at zero and end at a round number.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Range and ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// End of the axis, a whole number of tick intervals.
    pub end: f64,
    /// Number of tick intervals.
    pub intervals: usize,
    /// Digits after the point that tell the ticks apart.
    pub decimals: usize,
}

/// About how many tick intervals an axis has.
const INTERVALS: f64 = 7.0;

impl Axis {
    /// An axis that reaches a little past `largest`.
    pub fn new(largest: f64) -> Self {
        let reach = if largest > 0.0 { largest * 1.04 } else { 1.0 };
        let interval = round_up(reach / INTERVALS);
        let intervals = (reach / interval).ceil();
        let decimals = (0..9).find(|decimals| is_whole(interval * 10f64.powi(*decimals))).unwrap_or_default();
        Self { end: interval * intervals, intervals: intervals as usize, decimals: decimals as usize }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        limit.0 + (value / self.end * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        (0..=self.intervals).map(|tick| self.end * tick as f64 / self.intervals as f64).collect()
    }

    fn range(&self) -> Range<f64> {
        0.0..self.end
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        format!("{value:.*}", self.decimals)
    }
}

/// The smallest of 1, 2 and 5 times a power of ten that is at least `value`.
fn round_up(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0].into_iter().map(|digit| digit * power).find(|round| *round >= value).unwrap_or(10.0 * power)
}

fn is_whole(value: f64) -> bool {
    (value - value.round()).abs() < 1e-6 * value.abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_covers_the_data_with_round_ticks() {
        for (largest, end, intervals, decimals) in
            [(5499.0, 6000.0, 6, 0), (10.5, 12.0, 6, 0), (0.051, 0.06, 6, 2), (1.3, 1.4, 7, 1), (0.0, 1.0, 5, 1)]
        {
            let axis = Axis::new(largest);
            assert!((axis.end - end).abs() < 1e-9 && axis.intervals == intervals, "{largest}: {axis:?}");
            assert_eq!(axis.decimals, decimals, "{largest}");
        }
    }
}
