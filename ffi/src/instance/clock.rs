//! [`Clock`]: the master's time beside the kernel's, which knows whole steps alone.
//!
//! The master is at a communication point; the kernel is at the whole step nearest to the time that has been asked for
//! since the start of the experiment, which is the sum of the communication steps. Of both the clock keeps what the other
//! does not tell: the point, in the master's own numbers, and by how much it is ahead of the kernel. So a start at 1e9 s
//! takes no digits from the sum, and what a master rounds off when it adds up its times is not taken for time: its next
//! point is expected where its last step ended.

use super::Error;
use crate::whole_steps::{SAME, nearest};

/// Rounding of a time that comes of a few additions, relative to the largest of them.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The master's clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Clock {
    /// Communication point at which the master is, s.
    pub point: f64,
    /// By how much it is ahead of the kernel's time, s; negative if the kernel is ahead.
    pub ahead: f64,
}

impl Clock {
    /// At the start of an experiment, s.
    pub fn at(start: f64) -> Self {
        Self { point: start, ahead: 0.0 }
    }

    /// The kernel's time by this clock, s; `kernel` is the same by the start of the experiment, and what it is unless the
    /// master counts otherwise.
    pub fn kernel_time(&self, dt: f64, kernel: f64) -> f64 {
        let own = self.point - self.ahead;
        if (own - kernel).abs() <= SAME * dt { kernel } else { own }
    }

    /// How far `other` and the point can be apart by rounding alone, s.
    pub fn rounding(&self, other: f64) -> f64 {
        let (a, b) = (self.point.abs(), other.abs());
        ROUNDING * if a > b { a } else { b }
    }

    /// The clock of a master who says that it is at `point`, in an experiment since `start`, s, with kernel steps of `dt`.
    /// Rounding moves no clock; a point within half a kernel step of the expected one moves it there.
    ///
    /// # Errors
    /// Another point, or one that is before the kernel's time by more than a step.
    pub fn follow(&self, point: f64, start: f64, dt: f64) -> Result<Self, Error> {
        let (moved, rounding) = (point - self.point, self.rounding(start));
        if moved.abs() <= rounding + SAME * dt {
            return Ok(Self { point, ..*self });
        }
        let ahead = self.ahead + moved;
        if moved.abs() <= 0.5 * dt + rounding && ahead >= -dt {
            return Ok(Self { point, ahead });
        }
        Err(Error::CommunicationPoint { given: point, expected: self.point, half: 0.5 * dt })
    }

    /// Kernel steps that a communication step of `step` s makes: to the one nearest to its end.
    pub fn steps_in(&self, step: f64, dt: f64) -> i64 {
        nearest((self.ahead + step) / dt)
    }

    /// Kernel steps from the kernel's time to the end of a communication step of `step` s; whole where it is, but for
    /// rounding, at the end of the `count` steps made.
    pub fn steps_until_end(&self, step: f64, count: i64, dt: f64) -> f64 {
        let (steps, whole) = ((self.ahead + step) / dt, count as f64);
        if (steps - whole).abs() <= SAME { whole } else { steps }
    }

    /// From the point to the kernel's time after `count` steps, s.
    pub fn until(&self, count: i64, dt: f64) -> f64 {
        let whole = count as f64 * dt;
        // Next to a whole step nothing but rounding is left.
        if self.ahead.abs() <= SAME * dt { whole } else { whole - self.ahead }
    }

    /// At the end of a communication step of `step` s, for which the kernel has made `count` steps and is at `kernel` s.
    pub fn complete(&self, step: f64, count: i64, dt: f64, kernel: f64) -> Self {
        let ahead = self.ahead + step - count as f64 * dt;
        let shorter = if step < dt { step } else { dt };
        // Nothing but rounding; relative to the step, so that the shortest ones add up.
        let ahead = if ahead.abs() <= SAME * shorter { 0.0 } else { ahead };
        Self { point: self.point + step, ahead }.at_step(dt, kernel)
    }

    /// On a kernel step within a communication step, of which `count` are made, where the kernel is at `kernel` s.
    pub fn interrupted(&self, count: i64, dt: f64, kernel: f64) -> Self {
        if count == 0 {
            return *self;
        }
        Self { point: self.point + self.until(count, dt), ahead: 0.0 }.at_step(dt, kernel)
    }

    /// On a kernel step the master's time is the kernel's.
    fn at_step(self, dt: f64, kernel: f64) -> Self {
        if self.ahead == 0.0 { Self::at(self.kernel_time(dt, kernel)) } else { self }
    }
}

#[cfg(test)]
mod tests;
