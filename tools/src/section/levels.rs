//! Bands of colour between round values.

use colorous::{Color, Gradient, VIRIDIS};

use crate::text::number::{decimals, round_numbers};

/// About how many bands there are.
const BANDS: f64 = 10.0;
/// From dark for low to bright for high values, evenly to any eye.
const COLOURS: Gradient = VIRIDIS;
/// A stress from this many Pa on is shown in MPa, below in kPa.
const MEGA: f64 = 1e6;

/// Values between which a colour lasts.
#[derive(Clone, Debug, PartialEq)]
pub struct Levels {
    /// Bounds of the bands, Pa, rising.
    pub bounds: Vec<f64>,
    /// Display units in a Pa.
    pub scale: f64,
    /// Display unit.
    pub unit: &'static str,
    decimals: usize,
}

impl Levels {
    /// Bands over stresses from `low` to `high`, Pa.
    pub fn new([low, high]: [f64; 2]) -> Self {
        let (scale, unit) = if high >= MEGA { (1e-6, "MPa") } else { (1e-3, "kPa") };
        // Where there is one value, any band around it.
        let high = if high > low { high } else { low + 1.0 };
        let interval = round_near((high - low) / BANDS);
        let (first, last) = ((low / interval + 1e-6).floor(), (high / interval - 1e-6).ceil());
        let count = (last - first).max(1.0) as usize;
        let decimals = decimals(interval * scale);
        let bounds = (0..=count).map(|band| (first + band as f64) * interval).collect();
        Self { bounds, scale, unit, decimals }
    }

    /// Number of bands.
    pub fn bands(&self) -> usize {
        self.bounds.len() - 1
    }

    /// Number of the bound at zero, or of the one nearest to it.
    pub fn zero(&self) -> usize {
        self.bounds.iter().take_while(|bound| **bound < -1e-6 * self.reach()).count()
    }

    fn reach(&self) -> f64 {
        self.bounds[self.bands()] - self.bounds[0]
    }

    /// Colour of a band.
    pub fn colour(&self, band: usize) -> String {
        let Color { r, g, b } = COLOURS.eval_rational(band, self.bands().max(2));
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// A bound in the display unit.
    pub fn text(&self, bound: f64) -> String {
        let shown = bound * self.scale;
        // No minus before a zero.
        format!("{:.*}", self.decimals, if shown.abs() < 1e-9 { 0.0 } else { shown })
    }
}

/// The round number that is nearest to `value` by ratio.
fn round_near(value: f64) -> f64 {
    let distance = |round: &f64| (round / value).ln().abs();
    round_numbers(value).into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_are_round_and_cover_the_values() {
        for (range, first, last, bands, texts) in [
            ([0.0, 2.31e6], 0.0, 2.4e6, 12, ["0.0", "0.2"]),
            ([-0.13e6, 0.88e6], -0.2e6, 0.9e6, 11, ["-200", "-100"]),
            ([0.0, 0.0], 0.0, 1.0, 10, ["0.0000", "0.0001"]),
        ] {
            let levels = Levels::new(range);
            assert_eq!(levels.bands(), bands, "{levels:?}");
            assert!((levels.bounds[0] - first).abs() < 1e-6 && (levels.bounds[bands] - last).abs() < 1e-3);
            assert_eq!([0, 1].map(|bound| levels.text(levels.bounds[bound])), texts);
        }
    }

    #[test]
    fn no_two_bands_look_alike() {
        let levels = Levels::new([0.0, 1e6]);
        let colours: std::collections::BTreeSet<_> = (0..levels.bands()).map(|band| levels.colour(band)).collect();
        assert_eq!(colours.len(), levels.bands());
    }
}
