//! Branches of one spring and one dashpot each: the recurrence that [`crate::material::prony`] and
//! [`crate::material::maxwell`] share.
//!
//! A branch holds the overstress H' = -H / tau + q', where q is what drives it. Over a step in which q changes linearly
//! the solution is exact (Taylor, Pister and Goudreau 1970):
//! H <- e^(-dt/tau) H + (1 - e^(-dt/tau)) / (dt/tau) delta q.

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
}

/// Stress of neighbouring triangles with their overstress.
pub struct Overstress<V> {
    /// Stress after the step with the sum over the branches, Pa.
    pub total: Deviator<V>,
    /// Sum over the branches before the step, Pa.
    pub before: Deviator<V>,
}

impl<V: Vector> Overstress<V> {
    /// No branch yet, beside the stress `rest`.
    #[inline(always)]
    pub fn beside<S: Instructions<Vector = V>>(set: S, rest: Deviator<V>) -> Self {
        let zero = set.splat(0.0);
        Self { total: rest, before: Deviator { mean: zero, difference: zero, shear: zero } }
    }

    /// Sum over the branches before and after the step, Pa, beside the stress `rest`.
    #[inline(always)]
    pub fn double_mean(&self, rest: &Deviator<V>) -> Deviator<V> {
        self.before + (self.total - *rest)
    }
}

impl Branches {
    /// No branch.
    pub const NONE: Self = Self { n_term: 0, decay: [0.0; MAX_BRANCHES], gain: [0.0; MAX_BRANCHES] };

    /// Adds a branch: `ratio` of what drives it, Pa per its unit, `steps` = dt / tau.
    pub(crate) fn push(&mut self, ratio: Real, steps: Real) {
        let decay = math::exp(-steps);
        if let (Some(d), Some(g)) = (self.decay.get_mut(self.n_term), self.gain.get_mut(self.n_term)) {
            *d = decay;
            *g = ratio * (1.0 - decay) / steps;
            self.n_term += 1;
        }
    }

    /// Number of branches.
    pub fn n_term(&self) -> usize {
        self.n_term
    }

    /// Advances the histories of the two triangles of each cell of a block (one entry per branch) by the increments of
    /// what drives them, and adds them up.
    #[inline(always)]
    pub fn update<S: Instructions>(
        &self,
        set: S,
        chunk: usize,
        increment: &[Deviator<S::Vector>; 2],
        [first, second]: [&mut [Deviator]; 2],
        overstress: &mut [Overstress<S::Vector>; 2],
    ) {
        let constants = self.decay.iter().zip(&self.gain);
        for ((first, second), (decay, gain)) in first.iter_mut().zip(second).zip(constants) {
            for (t, history) in [first, second].into_iter().enumerate() {
                let (sum, before) = (&mut overstress[t], set.load_deviator(history, chunk));
                let stress = before.scaled(set.splat(*decay)) + increment[t].scaled(set.splat(*gain));
                set.store_deviator(&stress, history, chunk);
                sum.before = sum.before + before;
                sum.total = sum.total + stress;
            }
        }
    }
}
