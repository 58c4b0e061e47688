//! Frequency-independent damping: a spring of shear modulus G in series with a slider that slips at the von Mises
//! stress SIGF (LS-DYNA's MAT_077 calls them G and SIGF):
//!
//! tau <- tau + 2 G dev(delta e), scaled back radially to von Mises stress SIGF.
//!
//! The stress is a Kirchhoff stress in the unrotated frame and delta e the increment of the unrotated rate of
//! deformation, sym(U' U^-1) = R^T D R. This is the rate of Green and Naghdi: a rotation changes neither U nor the
//! stress, whatever its speed, and nothing drifts. The rate of Jaumann would oscillate in large simple shear and needs
//! the rotation integrated.

use crate::lanes::{Deviator, LANES, Lane, contract};
use crate::math;

/// Constants of the spring-slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Shear modulus G of the spring, Pa.
    pub stiffness: f64,
    /// Von Mises stress SIGF at which the slider slips, Pa.
    pub yield_stress: f64,
}

impl Slider {
    /// Advances the `stress` of a block by the deviatoric strain increment; returns the energy dissipated in the step,
    /// J/m3, from the mean of the stresses before and after.
    #[inline(always)]
    pub fn update(&self, strain_increment: &Deviator, stress: &mut Deviator) -> Lane {
        let mut dissipation = [0.0; LANES];
        if self.stiffness <= 0.0 {
            return dissipation;
        }
        let double_stiffness = 2.0 * self.stiffness;
        let compliance = 1.0 / double_stiffness;
        let yield_squared = self.yield_stress * self.yield_stress;
        for l in 0..LANES {
            let before = [stress.xx[l], stress.yy[l], stress.xy[l]];
            let trial = [
                before[0] + double_stiffness * strain_increment.xx[l],
                before[1] + double_stiffness * strain_increment.yy[l],
                before[2] + double_stiffness * strain_increment.xy[l],
            ];
            let mises_squared = 1.5 * contract(trial, trial);
            let returned = self.yield_stress * math::inverse_sqrt(mises_squared);
            let scale = if mises_squared > yield_squared { returned } else { 1.0 };
            let after = [scale * trial[0], scale * trial[1], scale * trial[2]];
            let mean = [0.5 * (before[0] + after[0]), 0.5 * (before[1] + after[1]), 0.5 * (before[2] + after[2])];
            // The slip increment is (trial - after) / 2G = (1 - scale) / 2G trial.
            dissipation[l] = (1.0 - scale) * compliance * contract(mean, trial);
            stress.xx[l] = after[0];
            stress.yy[l] = after[1];
            stress.xy[l] = after[2];
        }
        dissipation
    }

    /// Energy stored in the spring, J/m3.
    #[inline(always)]
    pub fn stored_energy(&self, stress: &Deviator) -> Lane {
        let mut energy = [0.0; LANES];
        if self.stiffness > 0.0 {
            let factor = 0.25 / self.stiffness;
            for l in 0..LANES {
                energy[l] = factor * stress.contract(stress, l);
            }
        }
        energy
    }
}
