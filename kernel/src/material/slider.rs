//! Frequency-independent damping: a spring of shear modulus G in series with a slider that slips at the von Mises
//! stress SIGF (LS-DYNA's MAT_077 calls them G and SIGF):
//!
//! tau <- tau + 2 G dev(delta e), scaled back radially to von Mises stress SIGF.
//!
//! The stress is a Kirchhoff stress in the unrotated frame and delta e the increment of the unrotated rate of
//! deformation, sym(U' U^-1) = R^T D R. This is the rate of Green and Naghdi: a rotation changes neither U nor the
//! stress, whatever its speed, and nothing drifts. The rate of Jaumann would oscillate in large simple shear and needs
//! the rotation integrated.

use crate::number::math;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, Deviatoric};

/// Constants of the spring-slider.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Shear modulus G of the spring, Pa.
    stiffness: Real,
    /// 1 / 2G, 1/Pa.
    compliance: Real,
    /// Half of tau : tau at which the slider slips, SIGF^2 / 3, Pa2; more than nothing.
    limit: Real,
}

/// Springs and sliders of neighbouring elements after a step.
#[derive(Clone, Copy)]
pub struct SliderStep<V, D = Deviator<V>> {
    /// Stress of the springs, Pa.
    pub stress: D,
    /// Energy dissipated in the step, J/m3, from the mean of the stresses before and after.
    pub dissipation: V,
    /// Energy stored in the springs, J/m3.
    pub stored: V,
}

impl<V: Vector, D: Deviatoric<V>> SliderStep<V, D> {
    /// Of a material without springs.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        let zero = simd.splat(0.0);
        Self { stress: D::uniform(zero), dissipation: zero, stored: zero }
    }
}

impl Slider {
    /// A spring of shear modulus `stiffness`, Pa, 0 for none, and a slider that slips at the von Mises stress
    /// `yield_stress`, Pa.
    pub fn new(stiffness: Real, yield_stress: Real) -> Self {
        Self {
            stiffness,
            compliance: if stiffness > 0.0 { 0.5 / stiffness } else { 0.0 },
            limit: math::max(yield_stress * yield_stress * (1.0 / 3.0), Real::MIN_POSITIVE),
        }
    }

    /// Shear modulus G of the spring, Pa.
    pub fn stiffness(&self) -> Real {
        self.stiffness
    }

    /// Whether the material has one.
    #[inline(always)]
    pub fn active(&self) -> bool {
        self.stiffness > 0.0
    }

    /// Advances the stress `before` of neighbouring elements by the deviatoric strain increment.
    #[inline(always)]
    pub fn update<S: Simd, D: Deviatoric<S::Vector>>(
        &self,
        simd: S,
        strain_increment: &D,
        before: &D,
    ) -> SliderStep<S::Vector, D> {
        let one = simd.splat(1.0);
        let trial = *before + strain_increment.scaled(simd.splat(2.0 * self.stiffness));
        // The von Mises stress is the root of 3/2 trial : trial.
        let squared = trial.half_contract(&trial);
        let limit = simd.splat(self.limit);
        // 1 where it does not slip: a quotient of equal numbers.
        let scale = (limit / squared.max(limit)).square_root();
        let scaled = scale * squared;
        SliderStep {
            stress: trial.scaled(scale),
            // The slip increment is (trial - after) / 2G = (1 - scale) / 2G trial, and after = scale trial.
            dissipation: ((one - scale) * (before.half_contract(&trial) + scaled)).mul_scalar(self.compliance),
            stored: (scale * scaled).mul_scalar(self.compliance),
        }
    }
}
