//! Branches of one spring and one dashpot each: the recurrence that [`crate::material::prony`] and
//! [`crate::material::maxwell`] share, and the energy that it dissipates.
//!
//! A branch holds the overstress H' = -H / tau + q', where q is what drives it. Over a step in which q changes linearly
//! the solution is exact (Taylor, Pister and Goudreau 1970):
//! H <- e^(-dt/tau) H + (1 - e^(-dt/tau)) / (dt/tau) delta q.
//!
//! Its dashpot has the viscosity G tau and dissipates the power H : H / (2 G tau), which no history makes negative.

use crate::lanes::Deviator;
use crate::math;
use crate::real::Real;
use crate::vector::{Instructions, Vector};

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

/// Stress of neighbouring triangles with their overstress, and what the overstress does in a step.
pub struct Overstress<V> {
    /// Stress after the step with the sum over the branches, Pa.
    pub total: Deviator<V>,
    /// Sum over the branches before the step, Pa.
    pub before: Deviator<V>,
    /// Power that the dashpots dissipate after the step, W/m3.
    pub power: V,
}

impl<V: Vector> Overstress<V> {
    /// No branch yet, beside the stress `rest`.
    #[inline(always)]
    pub fn beside<S: Instructions<Vector = V>>(set: S, rest: Deviator<V>) -> Self {
        let zero = set.splat(0.0);
        Self { total: rest, before: Deviator { mean: zero, difference: zero, shear: zero }, power: zero }
    }

    /// Sum over the branches before and after the step, Pa, beside the stress `rest`.
    #[inline(always)]
    pub fn double_mean(&self, rest: &Deviator<V>) -> Deviator<V> {
        self.before + (self.total - *rest)
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
    pub fn update<S: Instructions>(
        &self,
        set: S,
        chunk: usize,
        increment: &Deviator<S::Vector>,
        history: &mut [Deviator],
        overstress: &mut Overstress<S::Vector>,
    ) {
        let constants = self.decay.iter().zip(&self.gain).zip(&self.fluidity);
        for (history, ((decay, gain), fluidity)) in history.iter_mut().zip(constants) {
            let before = set.load_deviator(history, chunk);
            let stress = before.scaled(set.splat(*decay)) + increment.scaled(set.splat(*gain));
            set.store_deviator(&stress, history, chunk);
            overstress.before = overstress.before + before;
            overstress.total = overstress.total + stress;
            // Half of H : H.
            overstress.power = overstress.power + stress.half_contract(&stress).times(*fluidity);
        }
    }
}
