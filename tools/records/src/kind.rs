//! What a column holds.

use super::unit::Dimension;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Change of length over length.
    Strain,
    /// Length over original length.
    Stretch,
    /// Force over area.
    Stress,
    /// Force of the machine.
    Force,
    /// Change of length.
    Displacement,
    /// Strain or stretch of a free direction.
    Lateral,
    /// Change of the volume over that at rest, or their ratio.
    Volume,
    /// Time.
    Time,
    /// Stress over strain.
    Modulus,
    /// A load over its first or largest value.
    Normalised,
    /// Acceleration.
    Acceleration,
    /// Which specimen or repeat.
    Specimen,
    /// Which load cycle.
    Cycle,
}

impl Kind {
    /// What it measures; none for names and counts.
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Strain | Self::Stretch | Self::Normalised | Self::Lateral | Self::Volume => Some(Dimension::Ratio),
            Self::Stress | Self::Modulus => Some(Dimension::Stress),
            Self::Force => Some(Dimension::Force),
            Self::Displacement => Some(Dimension::Length),
            Self::Time => Some(Dimension::Time),
            Self::Acceleration => Some(Dimension::Acceleration),
            Self::Specimen | Self::Cycle => None,
        }
    }

    /// Name in messages, and a title that would be understood.
    pub fn example(self) -> (&'static str, &'static str) {
        match self {
            Self::Strain => ("strain", "strain [%]"),
            Self::Stretch => ("stretch", "stretch"),
            Self::Stress => ("stress", "stress [kPa]"),
            Self::Force => ("force", "force [N]"),
            Self::Displacement => ("displacement", "displacement [mm]"),
            Self::Lateral => ("lateral strain", "lateral strain [%]"),
            Self::Volume => ("volume change", "volume change [%]"),
            Self::Time => ("time", "time [s]"),
            Self::Modulus => ("modulus", "modulus [kPa]"),
            Self::Normalised => ("normalised load", "normalised load [-]"),
            Self::Acceleration => ("acceleration", "acceleration [g]"),
            Self::Specimen => ("specimen", "specimen"),
            Self::Cycle => ("cycle", "cycle"),
        }
    }
}
