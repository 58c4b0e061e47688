//! The numbers of the test, from the samples and the steps of the contact.

use crate::model::Constants;
use crate::number::math;
use crate::number::real::Real;
use crate::sampling::SAMPLING_INTERVAL;
use crate::state::Sample;

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
        self.max_deformation = math::max(self.max_deformation, depth);
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
        self.peak_force = math::max(self.peak_force, sample.contact_force);
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
