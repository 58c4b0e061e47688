//! Where the coefficients are that the stress is not linear in.

use softanvil_kernel::material::Coefficient;

use crate::least_squares::Bounded;

/// The values of a shape between its bounds, evenly by logarithm where both are positive.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    bounded: Bounded,
    logarithmic: bool,
}

impl Interval {
    /// Of the legal values of `coefficient`.
    pub fn of(coefficient: &Coefficient) -> Self {
        let logarithmic = coefficient.min > 0.0;
        let [low, high] = [coefficient.min, coefficient.max].map(|end| if logarithmic { end.ln() } else { end });
        Self { bounded: Bounded { middle: 0.5 * (low + high), half: 0.5 * (high - low) }, logarithmic }
    }

    /// Where `value` is between the bounds, from 0 to 1.
    pub fn part(self, value: f64) -> f64 {
        let at = if self.logarithmic { value.ln() } else { value };
        0.5 + 0.5 * (at - self.bounded.middle) / self.bounded.half
    }

    /// The value at a part of the way, from 0 to 1.
    pub fn at(self, part: f64) -> f64 {
        self.of_linear(self.bounded.middle + (2.0 * part - 1.0) * self.bounded.half)
    }

    fn of_linear(self, at: f64) -> f64 {
        if self.logarithmic { at.exp() } else { at }
    }

    /// The value at an unbounded t.
    pub fn value(self, t: f64) -> f64 {
        self.of_linear(self.bounded.value(t))
    }

    /// The t of a value.
    pub fn parameter(self, value: f64) -> f64 {
        self.bounded.parameter(if self.logarithmic { value.ln() } else { value })
    }
}
