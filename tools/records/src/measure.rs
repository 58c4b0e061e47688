//! Stretches and nominal stresses of strains and stresses of any measure.

use super::ReadError;
use super::column::Measure;

/// Stretches that are read: beyond them powers of the stretch leave the range of numbers.
const LEGAL: std::ops::RangeInclusive<f64> = 0.01..=100.0;

impl Measure {
    /// The stretch at a `strain` of this measure in `line`.
    ///
    /// # Errors
    /// A strain that no specimen can have.
    pub fn stretch(self, strain: f64, line: usize) -> Result<f64, ReadError> {
        let stretch = match self {
            Self::Engineering => 1.0 + strain,
            Self::True => strain.exp(),
            Self::Lagrange => (1.0 + 2.0 * strain).max(0.0).sqrt(),
        };
        if LEGAL.contains(&stretch) {
            return Ok(stretch);
        }
        let reason = format!(
            "strain {strain} is refused: expected a stretch of {} to {}, an engineering strain above -1 (is it in percent, or \
             a stretch?)",
            LEGAL.start(),
            LEGAL.end()
        );
        Err(ReadError::line(line, reason))
    }

    /// The nominal stress that is `stress` of this measure at `stretch`: P = sigma / l = S l in all three tests, because
    /// the volume stays.
    pub fn nominal(self, stress: f64, stretch: f64) -> f64 {
        match self {
            Self::Engineering => stress,
            Self::True => stress / stretch,
            Self::Lagrange => stress * stretch,
        }
    }

    /// Words for a strain and a stress of it.
    pub fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Engineering => ("engineering", "engineering"),
            Self::True => ("true", "true"),
            Self::Lagrange => ("Green", "second Piola-Kirchhoff"),
        }
    }
}
