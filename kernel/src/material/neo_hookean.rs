//! Neo-Hooke, isochoric (Treloar 1943): W = C10 (I1-3), I1 = tr C-bar, so that the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 C10 C-bar).

use crate::material::Material;
use crate::material::shear_tangent::invariant_shear_tangent;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// Long-term coefficient, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeoHookean {
    /// Of (I1-3).
    pub c10: Real,
}

impl NeoHookean {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        Self { c10: material.long_term_scale() * material.c10 }
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        self.c10 * (stretch.invariants().0 - 3.0)
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of neighbouring triangles.
    #[inline(always)]
    pub fn stress<V: Vector>(&self, kinematics: &Kinematics<V>) -> (Deviator<V>, V) {
        let c = kinematics.isochoric_cauchy_green();
        let factor = 2.0 * self.c10;
        let tau = Deviator {
            mean: (c.mean - c.out).mul_scalar(factor * SQRT_THIRD),
            difference: c.difference.mul_scalar(factor),
            shear: c.shear.mul_scalar(factor),
        };
        (tau, (c.mean + c.mean + c.out.add_scalar(-3.0)).mul_scalar(self.c10))
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    /// A majorant of the shear tangent, Pa; see `invariant_shear_tangent`.
    #[inline(always)]
    pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        invariant_shear_tangent(simd, stretch, [simd.splat(self.c10), zero], [zero; 3])
    }
}
