//! 90 % bands: where a number, or a force over time, is to be expected.

use serde::{Deserialize, Serialize};

use crate::measurement::quantity::COUNT;

/// The part of cases below the lower end of a band, and above the upper one.
pub const TAIL: f64 = 0.05;

/// Lower end, median, upper end of a number, in SI.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Serialize)]
pub struct Band {
    /// 5 % lie below.
    pub low: f64,
    /// Half lie below.
    pub median: f64,
    /// 5 % lie above.
    pub high: f64,
}

impl Band {
    /// Whether `value`, known within `half` a step of rounding, lies in it.
    pub fn holds(&self, value: f64, half: f64) -> bool {
        value + half >= self.low && value - half <= self.high
    }
}

/// A force over time since contact, with its band.
#[derive(Clone, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct ForceBand {
    /// Time between two forces, s.
    pub interval: f64,
    /// 5 % lie below, N.
    pub low: Vec<f64>,
    /// 5 % lie above, N.
    pub high: Vec<f64>,
}

/// What is to be expected of one impact.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Expected {
    /// Impact energy, J.
    pub energy: f64,
    /// Samples of the posterior that were simulated.
    pub samples: usize,
    /// What the parameters leave open, by quantity.
    pub parameters: [Band; COUNT],
    /// The same with what the model misses and the noise of a measurement: where a measured number lies.
    pub measured: [Band; COUNT],
    /// Force over time, with all of that.
    pub force: ForceBand,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_number_lies_in_a_band_that_its_interval_meets() {
        let band = Band { low: 1.0, median: 1.2, high: 1.5 };
        assert!(band.holds(1.0, 0.0) && band.holds(1.6, 0.1) && band.holds(0.9, 0.1));
        assert!(!band.holds(1.6, 0.05) && !band.holds(0.9, 0.05));
    }
}
