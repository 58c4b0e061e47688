//! Mooney-Rivlin with two, three or five parameters, isochoric (Mooney 1940, Rivlin 1948; the polynomial form of degree
//! two). With C20 = C02 = 0 it is the law of three parameters, with C11 = 0 as well that of two:
//!
//! W = C10 (I1-3) + C01 (I2-3) + C11 (I1-3)(I2-3) + C20 (I1-3)^2 + C02 (I2-3)^2
//!
//! with the invariants of C-bar = J^(-2/3) C. With W1 = dW/dI1 and W2 = dW/dI2 the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 W1 C-bar - 2 W2 C-bar^-1), because I2 = tr C-bar^-1 when det C-bar = 1.

use crate::material::coefficient::Coefficient;
use crate::material::invariants::{C10, C20, invariant_principal_stress, invariant_shear_tangent};
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::{IsochoricSymmetric, SolidKinematics};
use crate::tensor::stretch::IsochoricState;

/// Coefficients, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MooneyRivlin {
    /// Of (I1-3).
    pub c10: Real,
    /// Of (I2-3).
    pub c01: Real,
    /// Of (I1-3)(I2-3).
    pub c11: Real,
    /// Of (I1-3)^2.
    pub c20: Real,
    /// Of (I2-3)^2.
    pub c02: Real,
}

impl MooneyRivlin {
    /// No stress.
    pub const ZERO: Self = Self { c10: 0.0, c01: 0.0, c11: 0.0, c20: 0.0, c02: 0.0 };

    /// Twice the derivatives of W, Pa, at I1 - 3 and I2 - 3.
    #[inline(always)]
    fn double_slopes<V: Vector>(&self, a: V, b: V) -> [V; 2] {
        [
            (a.mul_scalar(4.0 * self.c20) + b.mul_scalar(2.0 * self.c11)).add_scalar(2.0 * self.c10),
            (b.mul_scalar(4.0 * self.c02) + a.mul_scalar(2.0 * self.c11)).add_scalar(2.0 * self.c01),
        ]
    }

    /// W, J/m3, of degree two without a constant: half the invariants times the mean of the slope and that at rest.
    #[inline(always)]
    fn energy<V: Vector>(&self, a: V, b: V, [w1, w2]: [V; 2]) -> V {
        (a * w1.add_scalar(2.0 * self.c10) + b * w2.add_scalar(2.0 * self.c01)).mul_scalar(0.25)
    }
}

impl HyperelasticLaw for MooneyRivlin {
    const NAME: &'static str = "mooney_rivlin";
    const LABEL: &'static str = "Mooney-Rivlin";
    const DESCRIPTION: &'static str =
        "W = C10 (I1 - 3) + C01 (I2 - 3) + C11 (I1 - 3)(I2 - 3) + C20 (I1 - 3)^2 + C02 (I2 - 3)^2";
    const COEFFICIENTS: &'static [Coefficient] = &[
        C10,
        Coefficient::modulus("c01", (0.0, 1.0), "mooney_rivlin coefficient of (I2 - 3)"),
        Coefficient::modulus("c11", (0.0, 0.4), "mooney_rivlin coefficient of (I1 - 3)(I2 - 3)"),
        C20,
        Coefficient::modulus("c02", (0.0, 0.2), "mooney_rivlin coefficient of (I2 - 3)^2"),
    ];
    const VARIANTS: &'static [Variant] = &[
        Variant { name: "mooney_rivlin_2", label: "Mooney-Rivlin 2", n_coefficient: 2 },
        Variant { name: "mooney_rivlin_3", label: "Mooney-Rivlin 3", n_coefficient: 3 },
        Variant { name: "mooney_rivlin_5", label: "Mooney-Rivlin 5", n_coefficient: 5 },
    ];
    const MODULUS_AT_REST: &'static str = "c10 and c01 give";
    const EXAMPLE: &'static [Real] = &[0.1e6, 0.05e6, 0.02e6, 0.004e6, 0.003e6];

    type Values = [Real; 5];

    fn from_values([c10, c01, c11, c20, c02]: [Real; 5]) -> Self {
        Self { c10, c01, c11, c20, c02 }
    }

    fn values(&self) -> [Real; 5] {
        [self.c10, self.c01, self.c11, self.c20, self.c02]
    }

    fn shear_modulus(&self) -> Real {
        2.0 * (self.c10 + self.c01)
    }

    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        invariant_principal_stress(stretches, |i1, i2| {
            let (a, b) = (i1 - 3.0, i2 - 3.0);
            (self.c10 + 2.0 * self.c20 * a + self.c11 * b, self.c01 + 2.0 * self.c02 * b + self.c11 * a)
        })
    }
}

impl IsochoricLaw for MooneyRivlin {
    /// In the section, C-bar^-1 is the adjugate of C-bar times C33, and out of it the determinant of the section.
    #[inline(always)]
    fn response<S: Simd>(
        &self,
        _: S,
        kinematics: &Kinematics<S::Vector>,
        axisymmetric: bool,
    ) -> (Deviator<S::Vector>, S::Vector) {
        let Kinematics { mean, difference, shear, .. } = *kinematics;
        let scale = kinematics.inverse_cbrt_j * kinematics.inverse_cbrt_j;
        let squares = [mean * mean, difference * difference + shear * shear];
        let c_mean = scale * (squares[0] + squares[1]);
        let c_out = if axisymmetric { scale * (kinematics.hoop * kinematics.hoop) } else { scale };
        let section = scale * if axisymmetric { squares[0] - squares[1] } else { kinematics.jacobian };
        let (inverse_mean, inverse_out) = (c_mean * c_out, section * section);
        // I1 - 3 and I2 - 3.
        let a = c_mean + c_mean + c_out.add_scalar(-3.0);
        let b = inverse_mean + inverse_mean + inverse_out.add_scalar(-3.0);
        let [w1, w2] = self.double_slopes(a, b);
        let turned = (w1 + w2 * c_out) * (scale * (mean + mean));
        let tau = Deviator {
            mean: (w1 * (c_mean - c_out) - w2 * (inverse_mean - inverse_out)).mul_scalar(SQRT_THIRD),
            difference: turned * difference,
            shear: turned * shear,
        };
        (tau, self.energy(a, b, [w1, w2]))
    }

    /// C-bar^-1 is the adjugate of C-bar, whose determinant is one.
    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        _: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        let IsochoricSymmetric(c) = kinematics.isochoric_cauchy_green();
        let inverse = c.adjugate();
        let (a, b) = (c.trace().add_scalar(-3.0), inverse.trace().add_scalar(-3.0));
        let [w1, w2] = self.double_slopes(a, b);
        let tau = SolidDeviator::of(&c.scaled(w1).minus(&inverse.scaled(w2)));
        (tau, self.energy(a, b, [w1, w2]))
    }

    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let (i1, i2) = stretch.invariants();
        let (a, b) = (i1.add_scalar(-3.0), i2.add_scalar(-3.0));
        let w1 = a.mul_scalar(2.0 * self.c20).add_scalar(self.c10) + b.mul_scalar(self.c11);
        let w2 = b.mul_scalar(2.0 * self.c02).add_scalar(self.c01) + a.mul_scalar(self.c11);
        let second = [2.0 * self.c20, self.c11, 2.0 * self.c02].map(|c| simd.splat(c));
        invariant_shear_tangent(simd, stretch, [w1, w2], second)
    }
}
