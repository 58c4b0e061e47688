//! Channel filters of impact tests: SAE J211/1 and ISO 6487, by channel frequency class (CFC).
//!
//! A class names the frequency in Hz up to which a channel is flat; the amplitude is down by 3 dB at 5/3 of it after two
//! passes. One pass is a Butterworth low-pass filter of second order, made digital by the bilinear transformation:
//!
//! w_d = 2 pi CFC 2.0775, w_a = tan(w_d T / 2), D = 1 + sqrt(2) w_a + w_a^2, a_0 = a_2 = w_a^2 / D, a_1 = 2 a_0,
//! b_1 = -2 (w_a^2 - 1) / D, b_2 = (-1 + sqrt(2) w_a - w_a^2) / D (SAE J211/1, appendix C), and
//! y_n = a_0 x_n + a_1 x_{n-1} + a_2 x_{n-2} + b_1 y_{n-1} + b_2 y_{n-2}.
//!
//! The standards filter a whole record forwards and backwards ([`filter_both_ways`]), which shifts no phase. A running
//! simulation has only the past: [`Filter`] makes the forward pass alone, which lags.

use crate::number::real::consts::{PI, SQRT_2};
use crate::number::real::{self, Real};

use crate::error::ParameterError;
use crate::number::math;

/// Design frequency of one pass over the channel frequency class.
const DESIGN_RATIO: Real = 2.0775;

/// Samples per second over the channel frequency class that the standards ask for at least.
const MIN_SAMPLES: Real = 10.0;

/// Coefficients of one pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients {
    /// a_0, a_1 and a_2: weights of this sample and the two before it.
    pub a: [Real; 3],
    /// b_1 and b_2: weights of the two results before.
    pub b: [Real; 2],
}

impl Coefficients {
    /// The filter of `channel_class`, Hz, for samples `interval` s apart.
    ///
    /// # Errors
    /// A class that is not above zero, or with fewer than the ten samples a period that the standards ask for; an interval
    /// that is not a positive number leaves no legal class.
    pub fn new(channel_class: Real, interval: Real) -> Result<Self, ParameterError> {
        let largest = 1.0 / (MIN_SAMPLES * interval);
        // Also false for what is no number. The margin is for the rounding of the two quotients.
        let legal = channel_class > 0.0 && channel_class <= largest * (1.0 + real::SAME) && interval > 0.0;
        if !legal {
            let (value, max) = (channel_class, largest);
            return Err(ParameterError { name: "channel frequency class".into(), value, unit: "Hz", min: 0.0, max });
        }
        let half_angle = PI * channel_class * DESIGN_RATIO * interval;
        let w = math::sin(half_angle) / math::cos(half_angle);
        let d = 1.0 + SQRT_2 * w + w * w;
        let a_0 = w * w / d;
        Ok(Self { a: [a_0, 2.0 * a_0, a_0], b: [-2.0 * (w * w - 1.0) / d, (-1.0 + SQRT_2 * w - w * w) / d] })
    }
}

/// The forward pass, sample by sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    /// The last two samples, newest first.
    pub(crate) x: [Real; 2],
    /// The last two results, newest first.
    pub(crate) y: [Real; 2],
}

impl Filter {
    /// A filter that has seen nothing but `value` for ever.
    pub const fn settled(value: Real) -> Self {
        Self { x: [value; 2], y: [value; 2] }
    }

    /// Takes in the next sample; returns its filtered value.
    pub fn take(&mut self, coefficients: &Coefficients, sample: Real) -> Real {
        let Coefficients { a, b } = coefficients;
        let result = a[0] * sample + a[1] * self.x[0] + a[2] * self.x[1] + b[0] * self.y[0] + b[1] * self.y[1];
        self.x = [sample, self.x[0]];
        self.y = [result, self.y[0]];
        result
    }

    /// The last result.
    pub fn value(&self) -> Real {
        self.y[0]
    }
}

/// Filters a whole record in place, forwards and then backwards: the filter of four poles without shift of phase that the
/// standards prescribe. Each pass begins settled at its first sample, so a record that begins and ends at rest has no
/// transients at its ends.
pub fn filter_both_ways(coefficients: &Coefficients, record: &mut [Real]) {
    pass(coefficients, record.iter_mut());
    pass(coefficients, record.iter_mut().rev());
}

fn pass<'a>(coefficients: &Coefficients, record: impl Iterator<Item = &'a mut Real>) {
    let mut filter = None;
    for sample in record {
        *sample = filter.get_or_insert(Filter::settled(*sample)).take(coefficients, *sample);
    }
}

#[cfg(test)]
#[allow(clippy::excessive_precision, reason = "numbers of double precision")]
mod tests;
