//! Yeoh with three terms, isochoric (Yeoh 1993): W = sum_k Ck0 (I1-3)^k, k = 1, 2, 3, with I1 = tr C-bar, so that the
//! Kirchhoff stress in the unrotated frame is tau = dev(2 dW/dI1 C-bar). Zero coefficients give one or two terms.

use crate::material::coefficient::Coefficient;
use crate::material::invariants::{C10, C20, invariant_principal_stress, invariant_shear_tangent};
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricState, IsochoricTensor};

/// Coefficients, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yeoh {
    /// Of (I1-3).
    pub c10: Real,
    /// Of (I1-3)^2.
    pub c20: Real,
    /// Of (I1-3)^3.
    pub c30: Real,
}

/// All of the modulus at rest.
const C10_OF_YEOH: Coefficient = Coefficient { plausible: (1.0, 1.0), ..C10 };
/// It softens many rubbers, before C30 stiffens them.
const C20_OF_YEOH: Coefficient = Coefficient { plausible: (-0.02, 0.3), ..C20 };

impl Yeoh {
    /// No stress.
    pub const ZERO: Self = Self { c10: 0.0, c20: 0.0, c30: 0.0 };
}

impl Yeoh {
    /// Stress, Pa, and W, J/m3, at a C-bar.
    #[inline(always)]
    fn of_strain<V: Vector, C: IsochoricTensor<V>>(&self, c: &C) -> (C::Deviator, V) {
        let a = c.first_invariant();
        let slope = a * (a.mul_scalar(3.0 * self.c30)).add_scalar(2.0 * self.c20);
        let factor = slope.add_scalar(self.c10).mul_scalar(2.0);
        let energy = a * (a * a.mul_scalar(self.c30).add_scalar(self.c20)).add_scalar(self.c10);
        (c.scaled_deviator(factor), energy)
    }
}

impl HyperelasticLaw for Yeoh {
    const NAME: &'static str = "yeoh";
    const LABEL: &'static str = "Yeoh";
    const DESCRIPTION: &'static str = "W = C10 (I1 - 3) + C20 (I1 - 3)^2 + C30 (I1 - 3)^3";
    const COEFFICIENTS: &'static [Coefficient] =
        &[C10_OF_YEOH, C20_OF_YEOH, Coefficient::modulus("c30", (0.001, 0.1), "yeoh coefficient of (I1 - 3)^3")];
    const VARIANTS: &'static [Variant] = &[
        Variant { name: "yeoh_1", label: "Yeoh 1", n_coefficient: 1 },
        Variant { name: "yeoh_2", label: "Yeoh 2", n_coefficient: 2 },
        Variant { name: "yeoh_3", label: "Yeoh 3", n_coefficient: 3 },
    ];
    const MODULUS_AT_REST: &'static str = "c10 gives";
    const EXAMPLE: &'static [Real] = &[0.1e6, -0.002e6, 0.0004e6];

    type Values = [Real; 3];

    fn from_values([c10, c20, c30]: [Real; 3]) -> Self {
        Self { c10, c20, c30 }
    }

    fn values(&self) -> [Real; 3] {
        [self.c10, self.c20, self.c30]
    }

    fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        invariant_principal_stress(stretches, |i1, _| {
            let a = i1 - 3.0;
            (self.c10 + 2.0 * self.c20 * a + 3.0 * self.c30 * a * a, 0.0)
        })
    }
}

impl IsochoricLaw for Yeoh {
    #[inline(always)]
    fn response<S: Simd>(&self, _: S, kinematics: &Kinematics<S::Vector>, _: bool) -> (Deviator<S::Vector>, S::Vector) {
        self.of_strain(&kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        _: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        self.of_strain(&kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        let a = stretch.invariants().0.add_scalar(-3.0);
        let first = (a * a.mul_scalar(3.0 * self.c30).add_scalar(2.0 * self.c20)).add_scalar(self.c10);
        let second = a.mul_scalar(6.0 * self.c30).add_scalar(2.0 * self.c20);
        invariant_shear_tangent(simd, stretch, [first, zero], [second, zero, zero])
    }
}
