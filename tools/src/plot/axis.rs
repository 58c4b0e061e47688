//! Axes that begin and end at round numbers, linear or logarithmic.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use crate::text::number::{decimals, round_numbers};

/// Range and ticks of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    start: f64,
    interval: f64,
    intervals: usize,
    decimals: usize,
    /// Positions are decimal logarithms of the values.
    logarithmic: bool,
}

/// About how many tick intervals an axis between two numbers has, and one from zero.
const INTERVALS: (f64, f64) = (6.0, 7.0);

impl Axis {
    /// An axis from zero to a little past `largest`.
    pub fn from_zero(largest: f64) -> Self {
        Self::with_intervals(0.0, 1.04 * largest, INTERVALS.1)
    }

    /// An axis over `low` to `high`.
    pub fn linear(low: f64, high: f64) -> Self {
        Self::with_intervals(low, high, INTERVALS.0)
    }

    fn with_intervals(low: f64, high: f64, intervals: f64) -> Self {
        let reach = if high > low { high - low } else { 1.0 };
        let interval = round_up(reach / intervals);
        let start = (low / interval + 1e-9).floor();
        let end = ((low + reach) / interval - 1e-9).ceil();
        let intervals = (end - start).max(1.0) as usize;
        Self { start: start * interval, interval, intervals, decimals: decimals(interval), logarithmic: false }
    }

    /// A logarithmic axis over `low` to `high`, both positive, with a tick a decade.
    pub fn logarithmic(low: f64, high: f64) -> Self {
        let (start, end) = ((low.log10() + 1e-9).floor(), (high.log10() - 1e-9).ceil());
        let intervals = (end - start).max(1.0) as usize;
        Self { start, interval: 1.0, intervals, decimals: 0, logarithmic: true }
    }

    fn end(&self) -> f64 {
        self.start + self.interval * self.intervals as f64
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let position = if self.logarithmic { value.log10() } else { *value };
        let part = (position - self.start) / (self.end() - self.start);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        let ticks = (0..=self.intervals).map(|tick| self.start + self.interval * tick as f64);
        ticks.map(|position| if self.logarithmic { 10f64.powf(position) } else { position }).collect()
    }

    fn range(&self) -> Range<f64> {
        if self.logarithmic { 10f64.powf(self.start)..10f64.powf(self.end()) } else { self.start..self.end() }
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        if self.logarithmic {
            return format!("{}", (value * 1e9).round() / 1e9);
        }
        // No minus before a zero.
        let value = if value.abs() < 1e-6 * self.interval { 0.0 } else { *value };
        format!("{value:.*}", self.decimals)
    }
}

/// The smallest round number that is at least `value`.
fn round_up(value: f64) -> f64 {
    let round = round_numbers(value);
    round.into_iter().find(|round| *round >= value).unwrap_or(round[3])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_from_zero_covers_the_data_with_round_ticks() {
        for (largest, end, intervals, decimals) in
            [(5499.0, 6000.0, 6, 0), (10.5, 12.0, 6, 0), (0.051, 0.06, 6, 2), (1.3, 1.4, 7, 1), (0.0, 1.0, 5, 1)]
        {
            let axis = Axis::from_zero(largest);
            assert!((axis.end() - end).abs() < 1e-9 && axis.intervals == intervals, "{largest}: {axis:?}");
            assert_eq!(axis.decimals, decimals, "{largest}");
        }
    }

    #[test]
    fn axes_cover_the_data_with_round_ticks() {
        for (low, high, start, end) in [(-0.5, 0.0, -0.5, 0.0), (0.0, 660.0, 0.0, 800.0), (-37.0, 4.0, -40.0, 10.0)] {
            let axis = Axis::linear(low, high);
            assert!((axis.start - start).abs() < 1e-9 && (axis.end() - end).abs() < 1e-9, "{axis:?}");
        }
        let axis = Axis::logarithmic(0.02, 300.0);
        assert_eq!((axis.start, axis.intervals), (-2.0, 5));
        assert_eq!(axis.format_ext(&0.01), "0.01");
    }
}
