//! Yeoh with three terms, isochoric (Yeoh 1993): W = sum_k Ck0 (I1-3)^k, k = 1, 2, 3, with I1 = tr C-bar, so that the
//! Kirchhoff stress in the unrotated frame is tau = dev(2 dW/dI1 C-bar). Zero coefficients give one or two terms.

use crate::material::Material;
use crate::material::shear_tangent::invariant_shear_tangent;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// Long-term coefficients, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yeoh {
    /// Of (I1-3).
    pub c10: Real,
    /// Of (I1-3)^2.
    pub c20: Real,
    /// Of (I1-3)^3.
    pub c30: Real,
}

impl Yeoh {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        let scale = material.long_term_scale();
        Self { c10: scale * material.c10, c20: scale * material.c20, c30: scale * material.c30 }
    }

    /// W at a = I1 - 3.
    #[inline(always)]
    fn energy(&self, a: Real) -> Real {
        a * (self.c10 + a * (self.c20 + a * self.c30))
    }

    /// dW/dI1 at a = I1 - 3.
    #[inline(always)]
    fn slope<V: Vector>(&self, a: V) -> V {
        (a * a.mul_scalar(3.0 * self.c30).add_scalar(2.0 * self.c20)).add_scalar(self.c10)
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        self.energy(stretch.invariants().0 - 3.0)
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of neighbouring triangles.
    #[inline(always)]
    pub fn stress<V: Vector>(&self, kinematics: &Kinematics<V>) -> (Deviator<V>, V) {
        let c = kinematics.isochoric_cauchy_green();
        let a = c.mean + c.mean + c.out.add_scalar(-3.0);
        let slope = a * (a.mul_scalar(3.0 * self.c30)).add_scalar(2.0 * self.c20);
        let factor = slope.add_scalar(self.c10).mul_scalar(2.0);
        let tau = Deviator {
            mean: factor * (c.mean - c.out).mul_scalar(SQRT_THIRD),
            difference: factor * c.difference,
            shear: factor * c.shear,
        };
        (tau, a * (a * a.mul_scalar(self.c30).add_scalar(self.c20)).add_scalar(self.c10))
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    /// A majorant of the shear tangent, Pa; see `invariant_shear_tangent`.
    #[inline(always)]
    pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        let a = stretch.invariants().0.add_scalar(-3.0);
        let second = a.mul_scalar(6.0 * self.c30).add_scalar(2.0 * self.c20);
        invariant_shear_tangent(simd, stretch, [self.slope(a), zero], [second, zero, zero])
    }
}
