//! The interval that the fixed step divides.

use crate::number::real::Real;

/// Samples of the force per second: those of the study's load cells.
pub const SAMPLING_RATE: Real = 20e3;
/// Interval between samples of the force, s.
pub const SAMPLING_INTERVAL: Real = 1.0 / SAMPLING_RATE;

/// Most steps in a sampling interval.
pub const MAX_STEPS_PER_SAMPLE: u32 = 500_000;
/// The smallest step that is offered, s.
pub const SMALLEST_STEP: Real = SAMPLING_INTERVAL / MAX_STEPS_PER_SAMPLE as Real;
