//! Branches of one spring and one dashpot each: the recurrence that [`crate::material::prony`] and
//! [`crate::material::maxwell`] share, and the energy that it dissipates.
//!
//! A branch holds the overstress H' = -H / tau + q', where q is what drives it. Over a step in which q changes linearly
//! the solution is exact (Taylor, Pister and Goudreau 1970):
//! H <- e^(-dt/tau) H + (1 - e^(-dt/tau)) / (dt/tau) delta q.
//!
//! Its dashpot has the viscosity G tau and dissipates the power H : H / (2 G tau), which no history makes negative.

use crate::lanes::{Deviator, LANES, Lane, ZERO};
use crate::math;
use crate::real::Real;

/// Most branches of one kind.
pub const MAX_BRANCHES: usize = 5;

/// The constants of the recurrences, for one step size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branches {
    n_term: usize,
    decay: [Real; MAX_BRANCHES],
    gain: [Real; MAX_BRANCHES],
    /// 1 / (G tau), 1/(Pa s).
    fluidity: [Real; MAX_BRANCHES],
}

/// Stress of a block with its overstress, and what the overstress does in a step.
pub struct Overstress {
    /// Stress after the step with the sum over the branches, Pa.
    pub total: Deviator,
    /// Sum over the branches before the step and after it, Pa.
    pub double_mean: Deviator,
    /// Power that the dashpots dissipate after the step, W/m3.
    pub power: Lane,
}

impl Overstress {
    /// No branch yet, beside the stress `rest`.
    #[inline(always)]
    pub fn beside(rest: &Deviator) -> Self {
        Self { total: *rest, double_mean: Deviator::ZERO, power: ZERO }
    }
}

impl Branches {
    /// No branch.
    pub const NONE: Self =
        Self { n_term: 0, decay: [0.0; MAX_BRANCHES], gain: [0.0; MAX_BRANCHES], fluidity: [0.0; MAX_BRANCHES] };

    /// Adds a branch: `ratio` of what drives it, Pa per its unit, `steps` = dt / tau, fluidity 1 / (G tau).
    pub(crate) fn push(&mut self, ratio: Real, steps: Real, fluidity: Real) {
        let decay = math::exp(-steps);
        if let (Some(d), Some(g), Some(f)) =
            (self.decay.get_mut(self.n_term), self.gain.get_mut(self.n_term), self.fluidity.get_mut(self.n_term))
        {
            *d = decay;
            *g = ratio * (1.0 - decay) / steps;
            *f = fluidity;
            self.n_term += 1;
        }
    }

    /// Number of branches.
    pub fn n_term(&self) -> usize {
        self.n_term
    }

    /// Advances the `history` of a block (one entry per branch) by the `increment` of what drives it, and adds it up.
    #[inline(always)]
    pub fn update(&self, increment: &Deviator, history: &mut [Deviator], overstress: &mut Overstress) {
        let constants = self.decay.iter().zip(&self.gain).zip(&self.fluidity);
        let Overstress { total, double_mean, power } = overstress;
        for (stress, ((decay, gain), fluidity)) in history.iter_mut().zip(constants) {
            for l in 0..LANES {
                let before = [stress.xx[l], stress.yy[l], stress.xy[l]];
                let xx = decay * before[0] + gain * increment.xx[l];
                let yy = decay * before[1] + gain * increment.yy[l];
                let xy = decay * before[2] + gain * increment.xy[l];
                stress.xx[l] = xx;
                stress.yy[l] = yy;
                stress.xy[l] = xy;
                total.xx[l] += xx;
                total.yy[l] += yy;
                total.xy[l] += xy;
                double_mean.xx[l] += before[0] + xx;
                double_mean.yy[l] += before[1] + yy;
                double_mean.xy[l] += before[2] + xy;
                // Half of H : H, with zz = -(xx + yy).
                power[l] += fluidity * (xx * (xx + yy) + yy * yy + xy * xy);
            }
        }
    }
}
