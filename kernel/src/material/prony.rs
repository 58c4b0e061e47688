//! Quasi-linear viscoelasticity on the isochoric stress (Fung's form of the Prony series; the recurrence is that of
//! Taylor, Pister and Goudreau 1970):
//!
//! H_k' = -H_k / tau_k + (g_k / g_inf) tau_iso', overstress = sum H_k,
//!
//! where tau_iso is the long-term Kirchhoff stress in the unrotated frame and g_inf + sum g_k = 1. Over a step in which
//! tau_iso changes linearly the solution is exact:
//! H <- e^(-dt/tau) H + (g/g_inf) (1 - e^(-dt/tau)) / (dt/tau) delta tau_iso.

use crate::lanes::{Deviator, LANES};
use crate::math;
use crate::scenario::Material;

/// Most terms of a Prony series.
pub const MAX_PRONY_TERMS: usize = 5;

/// The constants of the recurrence, for one step size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prony {
    n_term: usize,
    decay: [f64; MAX_PRONY_TERMS],
    gain: [f64; MAX_PRONY_TERMS],
    overstress: f64,
}

impl Prony {
    /// The terms of `material` with g > 0, for steps of `dt` s.
    pub fn new(material: &Material, dt: f64) -> Self {
        let mut prony =
            Self { n_term: 0, decay: [0.0; MAX_PRONY_TERMS], gain: [0.0; MAX_PRONY_TERMS], overstress: 0.0 };
        let g_inf = material.prony_g_inf();
        for (g, tau) in material.prony_g.iter().zip(material.prony_tau) {
            if *g > 0.0 {
                prony.push(g / g_inf, dt / tau);
            }
        }
        prony
    }

    fn push(&mut self, ratio: f64, steps: f64) {
        let decay = math::exp(-steps);
        if let (Some(d), Some(g)) = (self.decay.get_mut(self.n_term), self.gain.get_mut(self.n_term)) {
            *d = decay;
            *g = ratio * (1.0 - decay) / steps;
            self.n_term += 1;
            self.overstress += ratio;
        }
    }

    /// Number of active terms.
    pub fn n_term(&self) -> usize {
        self.n_term
    }

    /// Ratio of instantaneous overstress to long-term stress, sum g_k / g_inf.
    pub fn overstress(&self) -> f64 {
        self.overstress
    }

    /// Advances the `history` of a block (one entry per active term) by the change of the elastic stress.
    ///
    /// Returns the overstress before and after, Pa.
    #[inline(always)]
    pub fn update(&self, elastic: &Deviator, elastic_prev: &Deviator, history: &mut [Deviator]) -> [Deviator; 2] {
        let mut before = Deviator::ZERO;
        let mut after = Deviator::ZERO;
        for (stress, (decay, gain)) in history.iter_mut().zip(self.decay.iter().zip(&self.gain)) {
            before.add(stress);
            for l in 0..LANES {
                stress.xx[l] = decay * stress.xx[l] + gain * (elastic.xx[l] - elastic_prev.xx[l]);
                stress.yy[l] = decay * stress.yy[l] + gain * (elastic.yy[l] - elastic_prev.yy[l]);
                stress.xy[l] = decay * stress.xy[l] + gain * (elastic.xy[l] - elastic_prev.xy[l]);
            }
            after.add(stress);
        }
        [before, after]
    }
}
