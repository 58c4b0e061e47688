//! Frequency-independent damping: a spring of shear modulus G in series with a slider that slips at the von Mises
//! stress SIGF (LS-DYNA's MAT_077 calls them G and SIGF):
//!
//! tau <- tau + 2 G dev(delta e), scaled back radially to von Mises stress SIGF.
//!
//! The stress is a Kirchhoff stress in the unrotated frame and delta e the increment of the unrotated rate of
//! deformation, sym(U' U^-1) = R^T D R. This is the rate of Green and Naghdi: a rotation changes neither U nor the
//! stress, whatever its speed, and nothing drifts. The rate of Jaumann would oscillate in large simple shear and needs
//! the rotation integrated.

use crate::lanes::{Deviator, LANES, Lane, ZERO, contract};
use crate::math;
use crate::real::Real;

/// Constants of the spring-slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Shear modulus G of the spring, Pa.
    pub stiffness: Real,
    /// Von Mises stress SIGF at which the slider slips, Pa.
    pub yield_stress: Real,
}

/// Energies of a block's springs and sliders, J/m3.
pub struct SliderEnergy {
    /// Dissipated in the step, from the mean of the stresses before and after.
    pub dissipation: Lane,
    /// Stored in the spring after the step.
    pub stored: Lane,
}

impl Slider {
    /// Whether the material has one.
    #[inline(always)]
    pub fn active(&self) -> bool {
        self.stiffness > 0.0
    }

    /// Advances the `stress` of a block by the deviatoric strain increment.
    #[inline(always)]
    pub fn update(&self, strain_increment: &Deviator, stress: &mut Deviator) -> SliderEnergy {
        let mut energy = SliderEnergy { dissipation: ZERO, stored: ZERO };
        let double_stiffness = 2.0 * self.stiffness;
        let (half_compliance, quarter_compliance) = (0.5 / double_stiffness, 0.25 / self.stiffness);
        let squared_limit = self.yield_stress * self.yield_stress * (2.0 / 3.0);
        let limit = self.yield_stress * SQRT_TWO_THIRDS;
        for l in 0..LANES {
            let before = [stress.xx[l], stress.yy[l], stress.xy[l]];
            let trial = [
                before[0] + double_stiffness * strain_increment.xx[l],
                before[1] + double_stiffness * strain_increment.yy[l],
                before[2] + double_stiffness * strain_increment.xy[l],
            ];
            // The von Mises stress is the root of 3/2 trial : trial.
            let squared = contract(trial, trial);
            let returned = limit * math::inverse_sqrt(squared);
            let scale = if squared > squared_limit { returned } else { 1.0 };
            // The slip increment is (trial - after) / 2G = (1 - scale) / 2G trial, and after = scale trial.
            let double_mean = contract(before, trial) + scale * squared;
            energy.dissipation[l] = (1.0 - scale) * half_compliance * double_mean;
            energy.stored[l] = quarter_compliance * (scale * scale * squared);
            stress.xx[l] = scale * trial[0];
            stress.yy[l] = scale * trial[1];
            stress.xy[l] = scale * trial[2];
        }
        energy
    }
}

/// The square root of 2/3, rounded once.
const SQRT_TWO_THIRDS: Real = 0.816_496_580_927_726;
