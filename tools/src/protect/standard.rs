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
pub static STANDARDS: &[Standard] = &[
    Standard {
        preset: "rugby-soft-anvil",
        name: "World Rugby Regulation 12 (body padding), on the study's soft anvil",
        quantity: Quantity::PeakAcceleration,
        limits: &[],
        source: RUGBY,
        assumed: &[SOFT_ANVIL, LEAP],
    },
    Standard {
        preset: "rugby-steel-anvil",
        name: "World Rugby Regulation 12 (body padding)",
        quantity: Quantity::PeakAcceleration,
        limits: &[],
        source: RUGBY,
        assumed: &["Assumed: the length of the anvil, 150 mm, and friction of 0.3 on both sides of the pad.", LEAP],
    },
    Standard {
        preset: "en1621-1",
        name: "EN 1621-1 (motorcyclists' limb protectors)",
        quantity: Quantity::TransmittedForce,
        limits: &[
            Limit { level: "level 1", below: 35e3, single: Some(50e3) },
            Limit { level: "level 2", below: 20e3, single: None },
        ],
        source: "The limits are second-hand: level 1 from sweetprotection.com and satra.com, level 2 from a maker's catalogue \
                 (REV'IT)",
        assumed: &[
            "Assumed: a round face of the area of 40 mm x 30 mm, as the section turns about its axis; friction of 0.3 on both \
             sides of the protector.",
            STIFF,
        ],
    },
    Standard {
        preset: "en1621-2",
        name: "EN 1621-2 (motorcyclists' back protectors)",
        quantity: Quantity::TransmittedForce,
        limits: &[
            Limit { level: "level 1", below: 18e3, single: Some(24e3) },
            Limit { level: "level 2", below: 9e3, single: None },
        ],
        source: "The limits are second-hand: satra.com, and for level 2 sweetprotection.com and 4camping.at",
        assumed: &[
            "Assumed: anvil and striker, which are not those of EN 1621-1 but were not found: a bar of 25 mm along a round anvil \
             with a radius of 150 mm, over 100 mm; friction of 0.3 on both sides of the protector.",
            STIFF,
        ],
    },
    Standard {
        preset: "en13061",
        name: "EN 13061 (football shin guards), blunt impact",
        quantity: Quantity::TransmittedForce,
        limits: &[Limit { level: "blunt impact", below: 2e3, single: Some(2e3) }],
        source: "The limit is second-hand: satra.com",
        assumed: &[
            "Assumed: the energy of 2 J, a leg of a steel cylinder of 80 mm, 100 mm of it under a flat face of 50 mm, and \
             friction of 0.3 on both sides of the guard.",
            STIFF,
        ],
    },
];

const RUGBY: &str = "The regulation records the peak acceleration and wants pads that protect against cuts and abrasions alone, so \
                     its limit is a least peak, not a greatest; it was not found";
const SOFT_ANVIL: &str =
    "The soft anvil is the study's, not the regulation's steel cylinder: it stands for a shoulder.";
const LEAP: &str =
    "The preset's pad, where no other is given, is the foam \"leap\" of data/foam, elastic, with an assumed density.";
const STIFF: &str =
    "The preset's pad, where no other is given, is an assumed stiff foam of no particular maker, elastic.";

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
