//! Branches of one spring and one dashpot each: the recurrence that [`crate::material::prony`] and
//! [`crate::material::maxwell`] share.
//!
//! A branch holds the overstress H' = -H / tau + q', where q is what drives it. Over a step in which q changes linearly
//! the solution is exact (Taylor, Pister and Goudreau 1970):
//! H <- e^(-dt/tau) H + (1 - e^(-dt/tau)) / (dt/tau) delta q.
//!
//! The difference is taken as such: of a tau far above dt the exponential is 1 but for its last digits. Where dt/tau is
//! below half a last digit (6e-8 in single precision) it is 1, and the branch holds what it has.

use heapless::Vec;

use crate::number::math;
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, Deviatoric};
use crate::tensor::solid_deviator::{DEVIATOR_PACKS, SolidDeviator};

/// Most branches of one kind.
pub const MAX_BRANCHES: usize = 5;

/// Packs of an entry of the history.
pub const PACKS_OF_ENTRY: usize = 3;

/// The constants of the recurrences, for one step size.
#[derive(Clone, Debug, PartialEq)]
pub struct Branches(Vec<Branch, MAX_BRANCHES>);

/// e^(-dt/tau), and what the increment of the drive is multiplied by.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Branch {
    decay: Real,
    gain: Real,
}

/// Stress of neighbouring elements with their overstress.
pub struct Overstress<D> {
    /// Stress after the step with the sum over the branches, Pa.
    pub total: D,
    /// Sum over the branches before the step, Pa.
    pub before: D,
}

impl<D> Overstress<D> {
    /// No branch yet, beside the stress `rest`.
    #[inline(always)]
    pub fn with_equilibrium<S: Simd>(simd: S, rest: D) -> Self
    where
        D: Deviatoric<S::Vector>,
    {
        Self { total: rest, before: D::uniform(simd.splat(0.0)) }
    }

    /// Sum over the branches before and after the step, Pa, beside the stress `rest`.
    #[inline(always)]
    pub fn twice_mean<V>(&self, rest: &D) -> D
    where
        D: Deviatoric<V>,
    {
        self.before + (self.total - *rest)
    }
}

impl Branch {
    /// The overstress after a step from that before it, Pa, and the increment of what drives the branch.
    #[inline(always)]
    fn advance<S: Simd, D: Deviatoric<S::Vector>>(&self, simd: S, before: &D, increment: &D) -> D {
        before.scaled(simd.splat(self.decay)) + increment.scaled(simd.splat(self.gain))
    }
}

impl Branches {
    /// No branch.
    pub const NONE: Self = Self(Vec::new());

    /// Adds a branch: `ratio` of what drives it, Pa per its unit, `steps` = dt / tau.
    pub(crate) fn push(&mut self, ratio: Real, steps: Real) {
        let branch = Branch { decay: math::exp(-steps), gain: ratio * (-math::exp_m1(-steps) / steps) };
        // A material has no more terms than there is room for.
        let _ = self.0.push(branch);
    }

    /// Number of branches.
    pub fn n_term(&self) -> usize {
        self.0.len()
    }

    /// Advances the histories of the two triangles of each cell of a block (one entry per branch) by the increments of
    /// what drives them, and adds them up.
    #[inline(always)]
    pub fn update<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: &[Deviator<S::Vector>; 2],
        [first, second]: [&mut [Deviator]; 2],
        overstress: &mut [Overstress<Deviator<S::Vector>>; 2],
    ) {
        for ((first, second), branch) in first.iter_mut().zip(second).zip(&self.0) {
            for (t, history) in [first, second].into_iter().enumerate() {
                let (sum, before) = (&mut overstress[t], Deviator::load(simd, history, chunk));
                let stress = branch.advance(simd, &before, &increment[t]);
                stress.store(simd, history, chunk);
                sum.before = sum.before + before;
                sum.total = sum.total + stress;
            }
        }
    }

    /// The same for tetrahedra.
    #[inline(always)]
    pub fn update_solid<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: &SolidDeviator<S::Vector>,
        history: &mut [[Pack; DEVIATOR_PACKS]],
        overstress: &mut Overstress<SolidDeviator<S::Vector>>,
    ) {
        for (history, branch) in history.iter_mut().zip(&self.0) {
            let before = SolidDeviator::load(simd, history, chunk);
            let stress = branch.advance(simd, &before, increment);
            stress.store(simd, history, chunk);
            overstress.before = overstress.before + before;
            overstress.total = overstress.total + stress;
        }
    }

    /// The same for a mean stress, whose histories are packs of the entries of `history`, one entry for three branches. Returns
    /// the sums over the branches before and after the step, Pa.
    #[inline(always)]
    pub fn update_mean<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: S::Vector,
        history: &mut [Deviator],
    ) -> [S::Vector; 2] {
        let mut sums = [simd.splat(0.0); 2];
        for (entry, branches) in history.iter_mut().zip(self.0.chunks(PACKS_OF_ENTRY)) {
            for (pack, branch) in entry.packs_mut().into_iter().zip(branches) {
                branch.advance_mean(simd, chunk, increment, pack, &mut sums);
            }
        }
        sums
    }

    /// The same for tetrahedra, a pack of `history` for each branch.
    #[inline(always)]
    pub fn update_solid_mean<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: S::Vector,
        history: &mut [Pack],
    ) -> [S::Vector; 2] {
        let mut sums = [simd.splat(0.0); 2];
        for (pack, branch) in history.iter_mut().zip(&self.0) {
            branch.advance_mean(simd, chunk, increment, pack, &mut sums);
        }
        sums
    }
}

impl Branch {
    /// Advances a mean overstress, Pa, and adds it before and after to `sums`.
    #[inline(always)]
    fn advance_mean<S: Simd>(
        &self,
        simd: S,
        chunk: usize,
        increment: S::Vector,
        pack: &mut Pack,
        sums: &mut [S::Vector; 2],
    ) {
        let before = simd.load(pack, chunk);
        let stress = before.mul_scalar(self.decay) + increment.mul_scalar(self.gain);
        simd.store(stress, pack, chunk);
        *sums = [sums[0] + before, sums[1] + stress];
    }
}

#[cfg(test)]
#[allow(clippy::useless_conversion, clippy::excessive_precision, reason = "only in one of the precisions")]
mod tests {
    use super::*;

    /// tau, s, with e^(-s) and (1 - e^(-s)) / s for s = 5 us / tau, to sixty digits and then rounded to those of double
    /// precision.
    const CLOSED_FORM: [(f64, f64, f64); 14] = [
        (1e-7, 1.9287498479639178e-22, 0.02),
        (1e-6, 0.006737946999085467, 0.1986524106001829),
        (1e-5, 0.6065306597126334, 0.7869386805747332),
        (1e-4, 0.951229424500714, 0.9754115099857198),
        (1e-3, 0.9950124791926823, 0.9975041614635374),
        (1e-2, 0.9995001249791693, 0.9997500416614589),
        (1e-1, 0.9999500012499791, 0.9999750004166614),
        (1e0, 0.9999950000125, 0.9999975000041667),
        (1e1, 0.999999500000125, 0.9999997500000417),
        (1e2, 0.9999999500000013, 0.9999999750000004),
        (1e3, 0.999999995, 0.9999999975),
        (1e4, 0.9999999995, 0.99999999975),
        (1e5, 0.99999999995, 0.999999999975),
        (1e6, 0.999999999995, 0.9999999999975),
    ];

    /// From relaxed within a step to not at all: the digits of the precision, and those of s, which count s times in e^(-s).
    #[test]
    fn a_branch_follows_the_closed_form_whatever_its_time() {
        let bound = 2.0 * f64::from(Real::EPSILON);
        for (tau, decay, gain) in CLOSED_FORM {
            let mut branches = Branches::NONE;
            branches.push(2.5, (5e-6 / tau) as Real);
            let [found_decay, found_gain] = [branches.0[0].decay, branches.0[0].gain].map(f64::from);
            let counts = 1.0 + 5e-6 / tau;
            assert!((found_decay / decay - 1.0).abs() <= bound * counts, "tau = {tau} s: {found_decay}, not {decay}");
            assert!((found_gain / (2.5 * gain) - 1.0).abs() <= bound, "tau = {tau} s: {found_gain}, not 2.5 {gain}");
        }
    }
}
