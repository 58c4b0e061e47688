//! Neo-Hooke, isochoric (Treloar 1943): W = C10 (I1-3), I1 = tr C-bar, so that the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 C10 C-bar).

use crate::material::coefficient::Coefficient;
use crate::material::invariants::{C10, invariant_principal_stress, invariant_shear_tangent};
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricState, IsochoricTensor};

/// Coefficient, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeoHookean {
    /// Of (I1-3).
    pub c10: Real,
}

impl HyperelasticLaw for NeoHookean {
    const NAME: &'static str = "neo_hookean";
    const LABEL: &'static str = "neo-Hookean";
    const DESCRIPTION: &'static str = "W = C10 (I1 - 3)";
    const COEFFICIENTS: &'static [Coefficient] = &[C10];
    const VARIANTS: &'static [Variant] = &[Variant { name: "neo_hookean", label: "neo-Hookean", n_coefficient: 1 }];
    const MODULUS_AT_REST: &'static str = "c10 gives";
    const EXAMPLE: &'static [Real] = &[0.1e6];

    type Values = [Real; 1];

    fn from_values([c10]: [Real; 1]) -> Self {
        Self { c10 }
    }

    fn values(&self) -> [Real; 1] {
        [self.c10]
    }

    fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        invariant_principal_stress(stretches, |_, _| (self.c10, 0.0))
    }
}

impl IsochoricLaw for NeoHookean {
    #[inline(always)]
    fn response<S: Simd>(&self, _: S, kinematics: &Kinematics<S::Vector>, _: bool) -> (Deviator<S::Vector>, S::Vector) {
        let c = kinematics.isochoric_cauchy_green();
        let factor = 2.0 * self.c10;
        let tau = Deviator {
            mean: (c.mean - c.out).mul_scalar(factor * SQRT_THIRD),
            difference: c.difference.mul_scalar(factor),
            shear: c.shear.mul_scalar(factor),
        };
        (tau, c.first_invariant().mul_scalar(self.c10))
    }

    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        let c = kinematics.isochoric_cauchy_green();
        (c.scaled_deviator(simd.splat(2.0 * self.c10)), c.first_invariant().mul_scalar(self.c10))
    }

    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        invariant_shear_tangent(simd, stretch, [simd.splat(self.c10), zero], [zero; 3])
    }
}
