//! Frequency-independent damping: a spring of shear modulus G in series with a slider that slips at the von Mises
//! stress SIGF (LS-DYNA's MAT_077 calls them G and SIGF):
//!
//! tau <- tau + 2 G dev(delta e), scaled back radially to von Mises stress SIGF.
//!
//! The stress is a Kirchhoff stress in the unrotated frame and delta e the increment of the unrotated rate of
//! deformation, sym(U' U^-1) = R^T D R. This is the rate of Green and Naghdi: a rotation changes neither U nor the
//! stress, whatever its speed, and nothing drifts. The rate of Jaumann would oscillate in large simple shear and needs
//! the rotation integrated.

use crate::lanes::{Deviator, SQRT_THIRD};
use crate::math;
use crate::real::Real;
use crate::vector::{Instructions, Vector};

/// Constants of the spring-slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Shear modulus G of the spring, Pa.
    pub stiffness: Real,
    /// Von Mises stress SIGF at which the slider slips, Pa.
    pub yield_stress: Real,
}

/// Springs and sliders of neighbouring triangles after a step.
pub struct SliderStep<V> {
    /// Stress of the springs, Pa.
    pub stress: Deviator<V>,
    /// Energy dissipated in the step, J/m3, from the mean of the stresses before and after.
    pub dissipation: V,
    /// Energy stored in the springs, J/m3.
    pub stored: V,
}

impl Slider {
    /// Whether the material has one.
    #[inline(always)]
    pub fn active(&self) -> bool {
        self.stiffness > 0.0
    }

    /// Advances the stress `before` of neighbouring triangles by the deviatoric strain increment.
    #[inline(always)]
    pub fn update<S: Instructions>(
        &self,
        set: S,
        strain_increment: &Deviator<S::Vector>,
        before: &Deviator<S::Vector>,
    ) -> SliderStep<S::Vector> {
        let one = set.splat(1.0);
        let double_stiffness = 2.0 * self.stiffness;
        let trial = *before + strain_increment.scaled(set.splat(double_stiffness));
        // The von Mises stress is the root of 3/2 trial : trial.
        let squared = trial.half_contract(&trial);
        let returned = math::inverse_sqrt(squared).times(self.yield_stress * SQRT_THIRD);
        let limit = set.splat(self.yield_stress * self.yield_stress * (1.0 / 3.0));
        let scale = squared.if_greater(limit, returned, one);
        let scaled = scale * squared;
        let compliance = 1.0 / double_stiffness;
        SliderStep {
            stress: trial.scaled(scale),
            // The slip increment is (trial - after) / 2G = (1 - scale) / 2G trial, and after = scale trial.
            dissipation: ((one - scale) * (before.half_contract(&trial) + scaled)).times(compliance),
            stored: (scale * scaled).times(compliance),
        }
    }
}
