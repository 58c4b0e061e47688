//! What a laboratory reads from the drop: force samples at 20 kHz, and the numbers of the test.
//!
//! A sample is the mean contact force over its sampling interval, that is, its impulse over its length, as a load cell
//! behind an anti-aliasing filter gives it. Peak force and impact duration are read from the samples: the force of a
//! single step is not a converged number, because catching a node of finite mass on a rigid face takes an impulse.

use crate::cfc::Filter;
use crate::digest::Digest;
use crate::model::Constants;
use crate::real::Real;
use crate::sampling::SAMPLING_INTERVAL;
use crate::state::Forces;

/// One sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Samples taken up to and including this one; it ends at this many [`SAMPLING_INTERVAL`]s.
    pub number: u64,
    /// Mean contact force on the impactor over the interval, N.
    pub contact_force: Real,
    /// Mean force of the layer on the core over the interval, N.
    pub core_reaction: Real,
}

/// Averages the forces of the steps over the sampling intervals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampler {
    /// The last complete sample.
    pub last: Sample,
    /// Digest of all samples so far (FNV-1a): the bits of contact force, core reaction, and impactor position at the
    /// end of the interval.
    pub trace_hash: u64,
    /// Forward pass of the channel filter over the samples of the contact force.
    pub filter: Filter,
    /// Steps in the running interval.
    pub(crate) steps: u32,
    /// Sums over the running interval, N.
    pub(crate) sum: Forces,
}

impl Sampler {
    /// Nothing sampled.
    pub(crate) const START: Self = Self {
        last: Sample { number: 0, contact_force: 0.0, core_reaction: 0.0 },
        trace_hash: Digest::new().value(),
        filter: Filter::settled(0.0),
        steps: 0,
        sum: Forces { contact: 0.0, core_reaction: 0.0 },
    };

    /// Takes in one step; returns the sample that it completes.
    pub(crate) fn take(&mut self, constants: &Constants, force: &Forces, position: Real) -> Option<Sample> {
        self.steps += 1;
        self.sum.contact += force.contact;
        self.sum.core_reaction += force.core_reaction;
        if self.steps < constants.steps_per_sample {
            return None;
        }
        let count = constants.steps_per_sample as Real;
        self.last = Sample {
            number: self.last.number + 1,
            contact_force: self.sum.contact / count,
            core_reaction: self.sum.core_reaction / count,
        };
        self.filter.take(&constants.channel, self.last.contact_force);
        self.steps = 0;
        self.sum = Self::START.sum;
        let mut digest = Digest::resume(self.trace_hash);
        digest.number(self.last.contact_force);
        digest.number(self.last.core_reaction);
        digest.number(position);
        self.trace_hash = digest.value();
        Some(self.last)
    }
}

/// The numbers of the test, up to the current time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metrics {
    /// Largest sample of the contact force, N.
    pub peak_force: Real,
    /// Largest depth of the face below the undeformed anvil, m.
    pub max_deformation: Real,
    /// Impulse of the contact force, N s.
    pub impulse: Real,
    /// Speed of the impactor before the first contact, m/s, downwards.
    pub impact_speed: Real,
    /// Speed of the impactor after the last step with contact, m/s, upwards.
    pub rebound_speed: Real,
    /// Time from the first to the last step with contact, s.
    pub contact_time: Real,
    /// Number of the first sample at or above the force threshold; 0 before it.
    pub(crate) first_sample: u64,
    /// Number of the last sample at or above the force threshold; 0 before it.
    pub(crate) last_sample: u64,
    /// One more than the index of the first step with contact; 0 before it.
    pub(crate) first_step: u64,
}

impl Metrics {
    /// Before any contact.
    pub(crate) const START: Self = Self {
        peak_force: 0.0,
        max_deformation: 0.0,
        impulse: 0.0,
        impact_speed: 0.0,
        rebound_speed: 0.0,
        contact_time: 0.0,
        first_sample: 0,
        last_sample: 0,
        first_step: 0,
    };

    /// Time covered by the samples from the first to the last one at or above the force threshold, s.
    pub fn impact_duration(&self) -> Real {
        match self.first_sample {
            0 => 0.0,
            first => (self.last_sample - first + 1) as Real * SAMPLING_INTERVAL,
        }
    }

    /// Whether the face has touched the layer.
    pub fn has_touched(&self) -> bool {
        self.first_step > 0
    }

    /// Rebound speed over impact speed; 0 before contact.
    pub fn restitution(&self) -> Real {
        if self.impact_speed > 0.0 { self.rebound_speed / self.impact_speed } else { 0.0 }
    }

    /// Takes in one step: its contact force, N, the impactor's velocity before and after, m/s, and depth at its end, m.
    pub(crate) fn take_step(
        &mut self,
        constants: &Constants,
        step_index: u64,
        force: Real,
        velocity: [Real; 2],
        depth: Real,
    ) {
        self.max_deformation = crate::math::larger(self.max_deformation, depth);
        if force <= 0.0 {
            return;
        }
        if self.first_step == 0 {
            self.first_step = step_index + 1;
            self.impact_speed = -velocity[0];
        }
        self.impulse += force * constants.dt;
        self.rebound_speed = velocity[1];
        self.contact_time = constants.time(step_index + 2 - self.first_step);
    }

    /// Takes in one sample.
    pub(crate) fn take_sample(&mut self, sample: &Sample, threshold: Real) {
        self.peak_force = crate::math::larger(self.peak_force, sample.contact_force);
        if sample.contact_force >= threshold && sample.contact_force > 0.0 {
            if self.first_sample == 0 {
                self.first_sample = sample.number;
            }
            self.last_sample = sample.number;
        }
    }
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    use super::*;

    /// The metrics after samples of these forces, N, with a threshold of 10 N.
    fn after(forces: &[f64]) -> Metrics {
        let mut metrics = Metrics::START;
        for (number, force) in (1..).zip(forces) {
            metrics.take_sample(&Sample { number, contact_force: *force, core_reaction: 0.0 }, 10.0);
        }
        metrics
    }

    /// Samples of 50 us, counted by hand: from the first at the threshold to the last, what lies between included.
    #[test]
    fn the_duration_is_that_of_the_samples_at_the_threshold() {
        for (forces, samples) in [
            (&[0.0, 9.9, 9.9] as &[f64], 0),
            (&[0.0, 10.0], 1),
            (&[0.0, 9.0, 11.0, 30.0, 12.0, 9.0, 0.0], 3),
            (&[20.0, 0.0, 0.0, 20.0, 0.0], 4),
        ] {
            let expected = f64::from(samples) * 50e-6;
            assert!((after(forces).impact_duration() - expected).abs() < 1e-12, "{forces:?}: {expected} s");
        }
        assert_eq!(after(&[0.0, 9.0, 31.0, 12.0]).peak_force, 31.0);
    }

    /// A ball that comes with 2 m/s and leaves with 1.
    #[test]
    fn the_restitution_is_the_ratio_of_the_speeds() {
        assert_eq!(Metrics::START.restitution(), 0.0);
        assert_eq!(Metrics { impact_speed: 2.0, rebound_speed: 1.0, ..Metrics::START }.restitution(), 0.5);
    }
}
