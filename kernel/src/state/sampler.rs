//! Force samples at 20 kHz, as a laboratory takes them.
//!
//! A sample is the mean contact force over its sampling interval, that is, its impulse over its length, as a load cell
//! behind an anti-aliasing filter gives it. Peak force and impact duration are read from the samples: the force of a
//! single step is not a converged number, because catching a node of finite mass on a rigid face takes an impulse.

use crate::cfc::Filter;
use crate::model::Constants;
use crate::number::digest::Digest;
use crate::number::real::Real;

/// One sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Samples taken up to and including this one; it ends at this many [`crate::SAMPLING_INTERVAL`]s.
    pub number: u64,
    /// Mean contact force on the impactor over the interval, N.
    pub contact_force: Real,
    /// Mean force of the layer on the core over the interval, N.
    pub core_reaction: Real,
}

/// Forces of a step on the whole anvil, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// Contact force on the impactor, upwards.
    pub contact: Real,
    /// Force of the layer on the core, downwards.
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
