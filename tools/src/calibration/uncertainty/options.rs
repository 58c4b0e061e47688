//! `[uncertainty]` of a problem file: what is known of the errors of the measured numbers.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::measurement::quantity::{COUNT, QUANTITIES};

/// What is known of the errors, and how many samples are kept.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, default)]
pub struct UncertaintyOptions {
    /// Samples that the posterior file keeps.
    pub samples: usize,
    /// Relative standard deviation of the measurement, by key of the number; [`NOISE`] if left out.
    pub noise: BTreeMap<String, f64>,
    /// Scale of the half-normal prior of what the model misses, a relative standard deviation, by key of the number;
    /// [`DISCREPANCY`] if left out, and 0 for a model that is taken to miss nothing.
    pub discrepancy: BTreeMap<String, f64>,
    /// Steps to which numbers of one's own are rounded, in SI, by key; 0 if left out. Those of the study's table have its digits.
    pub rounding: BTreeMap<String, f64>,
    /// Standard deviation of the logarithm of a modulus of `[prior]`, model over measurement.
    pub prior_deviation: f64,
}

/// Relative standard deviation of a measured number of which nothing is stated.
pub const NOISE: f64 = 0.01;
/// Scale of what a model misses of which nothing is stated.
pub const DISCREPANCY: f64 = 0.1;
/// Samples that can be kept.
const SAMPLES: std::ops::RangeInclusive<usize> = 50..=2000;

impl Default for UncertaintyOptions {
    fn default() -> Self {
        Self {
            samples: 200,
            noise: BTreeMap::new(),
            discrepancy: BTreeMap::new(),
            rounding: BTreeMap::new(),
            prior_deviation: 0.3,
        }
    }
}

impl UncertaintyOptions {
    /// Whether the values make sense.
    ///
    /// # Errors
    /// The first that is refused, with what is legal.
    pub fn check(&self) -> Result<(), String> {
        let refuse = |key: String, value: f64, unit: &str, legal: &str| {
            Err(format!("uncertainty.{key} = {value} {unit} is refused: expected {legal} {unit}"))
        };
        if !SAMPLES.contains(&self.samples) {
            let legal = format!("{} to {}", SAMPLES.start(), SAMPLES.end());
            return refuse("samples".into(), self.samples as f64, "samples", &legal);
        }
        let tables = [
            ("noise", &self.noise, 1e-6..=1.0),
            ("discrepancy", &self.discrepancy, 0.0..=1.0),
            ("rounding", &self.rounding, 0.0..=1e4),
        ];
        for (table, values, legal) in tables {
            for (key, value) in values {
                let Some(quantity) = QUANTITIES.iter().find(|quantity| quantity.key == key) else {
                    let keys = QUANTITIES.each_ref().map(|quantity| quantity.key).join(", ");
                    return Err(format!("uncertainty.{table}: {key} is unknown; expected {keys}"));
                };
                if !legal.contains(value) {
                    let unit = if table == "rounding" { quantity.unit() } else { "1" };
                    return refuse(
                        format!("{table}.{key}"),
                        *value,
                        unit,
                        &format!("{} to {}", legal.start(), legal.end()),
                    );
                }
            }
        }
        match self.prior_deviation > 0.0 && self.prior_deviation <= 3.0 {
            true => Ok(()),
            false => refuse("prior_deviation".into(), self.prior_deviation, "1", "above 0 to 3"),
        }
    }

    /// Relative standard deviations of the measurement, in the order of [`QUANTITIES`].
    pub fn noise(&self) -> [f64; COUNT] {
        QUANTITIES.each_ref().map(|quantity| self.noise.get(quantity.key).copied().unwrap_or(NOISE))
    }

    /// Scales of what the model misses, in the order of [`QUANTITIES`].
    pub fn discrepancy(&self) -> [f64; COUNT] {
        QUANTITIES.each_ref().map(|quantity| self.discrepancy.get(quantity.key).copied().unwrap_or(DISCREPANCY))
    }

    /// Steps to which a number is rounded, in the order of [`QUANTITIES`].
    pub fn rounding(&self) -> [f64; COUNT] {
        QUANTITIES.each_ref().map(|quantity| self.rounding.get(quantity.key).copied().unwrap_or(0.0))
    }
}
