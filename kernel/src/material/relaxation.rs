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

/// Most branches of one kind.
pub const MAX_BRANCHES: usize = 5;

/// The constants of the recurrences, for one step size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branches {
    n_term: usize,
    decay: [f64; MAX_BRANCHES],
    gain: [f64; MAX_BRANCHES],
    /// 1 / (G tau), 1/(Pa s).
    fluidity: [f64; MAX_BRANCHES],
}

/// Overstress of a block before and after a step, Pa, and the power that its dashpots dissipate after it, W/m3.
pub struct Overstress {
    /// Sum over the branches before the step.
    pub before: Deviator,
    /// Sum over the branches after it.
    pub after: Deviator,
    /// Power dissipated after it.
    pub power: Lane,
}

impl Overstress {
    /// No branch.
    pub const NONE: Self = Self { before: Deviator::ZERO, after: Deviator::ZERO, power: ZERO };
}

impl Branches {
    /// No branch.
    pub const NONE: Self =
        Self { n_term: 0, decay: [0.0; MAX_BRANCHES], gain: [0.0; MAX_BRANCHES], fluidity: [0.0; MAX_BRANCHES] };

    /// Adds a branch: `ratio` of what drives it, Pa per its unit, `steps` = dt / tau, fluidity 1 / (G tau).
    pub(crate) fn push(&mut self, ratio: f64, steps: f64, fluidity: f64) {
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
        for (stress, ((decay, gain), fluidity)) in history.iter_mut().zip(constants) {
            overstress.before.add(stress);
            for l in 0..LANES {
                stress.xx[l] = decay * stress.xx[l] + gain * increment.xx[l];
                stress.yy[l] = decay * stress.yy[l] + gain * increment.yy[l];
                stress.xy[l] = decay * stress.xy[l] + gain * increment.xy[l];
                // Half of H : H, with zz = -(xx + yy).
                let (xx, yy, xy) = (stress.xx[l], stress.yy[l], stress.xy[l]);
                overstress.power[l] += fluidity * (xx * (xx + yy) + yy * yy + xy * xy);
            }
            overstress.after.add(stress);
        }
    }
}
