//! Mathematics with a fixed sequence of operations, from `libm` or by comparisons alone.

use crate::number::real::Real;

pub use crate::number::real::{asin, ceil, cos, exp, exp_m1, ln, round, sin, sqrt};

/// Absolute value.
#[inline(always)]
pub fn abs(x: Real) -> Real {
    if x < 0.0 { -x } else { x }
}

/// The larger of two numbers by comparison alone (no IEEE `max`, whose signed-zero case differs between targets).
#[inline(always)]
pub fn max(a: Real, b: Real) -> Real {
    if a > b { a } else { b }
}

/// 1/3, rounded once.
pub const THIRD: Real = 1.0 / 3.0;
