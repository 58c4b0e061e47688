//! What standards ask of pads, and how much is known of it.
//!
//! A limit is "second-hand" if it was read on a page of a laboratory or of a maker and not in the standard; what no source was
//! found for is said to be assumed.

use serde::Serialize;

/// What a limit is set on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Largest force under the anvil, N.
    TransmittedForce,
    /// Largest acceleration of the impactor, in g.
    PeakAcceleration,
}

impl Quantity {
    /// Name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::TransmittedForce => "peak transmitted force",
            Self::PeakAcceleration => "peak acceleration",
        }
    }

    /// `value` with its unit, as people read it.
    pub fn text(self, value: f64) -> String {
        match self {
            Self::TransmittedForce => format!("{:.2} kN", 1e-3 * value),
            Self::PeakAcceleration => format!("{value:.0} g"),
        }
    }
}

/// A limit that a mean of several impacts has to stay below.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limit {
    /// Level of performance, such as "level 1".
    pub level: &'static str,
    /// The mean has to be below this, in N or g.
    pub below: f64,
    /// No single impact may be above this; none where no such limit was found.
    pub single: Option<f64>,
}

/// What a standard's test asks for.
#[derive(Debug, Serialize)]
pub struct Standard {
    /// Preset that has its set-up.
    pub preset: &'static str,
    /// Name for people.
    pub name: &'static str,
    /// What is judged.
    pub quantity: Quantity,
    /// Limits, the strictest last; empty where none is known.
    pub limits: &'static [Limit],
    /// Where the limits were found, or why there is none.
    pub source: &'static str,
    /// What of the set-up is assumed or left out.
    pub assumed: &'static [&'static str],
}

/// The standards.
pub static STANDARDS: &[Standard] = &[];

/// The standard whose set-up is the preset called `preset`.
pub fn find(preset: &str) -> Option<&'static Standard> {
    STANDARDS.iter().find(|standard| standard.preset == preset)
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset::PRESETS;

    #[test]
    fn every_standard_has_a_preset_and_limits_from_the_loosest_to_the_strictest() {
        for standard in STANDARDS {
            assert!(PRESETS.iter().any(|preset| preset.name == standard.preset), "{}", standard.preset);
            assert!(standard.limits.is_sorted_by(|a, b| a.below > b.below), "{}", standard.name);
            assert!(standard.limits.iter().all(|limit| limit.single.is_none_or(|single| single >= limit.below)));
        }
    }
}
