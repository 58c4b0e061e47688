//! Mooney-Rivlin with two, three or five parameters, isochoric (Mooney 1940, Rivlin 1948; the polynomial form of degree
//! two). With C20 = C02 = 0 it is the law of three parameters, with C11 = 0 as well that of two:
//!
//! W = C10 (I1-3) + C01 (I2-3) + C11 (I1-3)(I2-3) + C20 (I1-3)^2 + C02 (I2-3)^2
//!
//! with the invariants of C-bar = J^(-2/3) C. With W1 = dW/dI1 and W2 = dW/dI2 the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 W1 C-bar - 2 W2 C-bar^-1), because I2 = tr C-bar^-1 when det C-bar = 1.

use crate::material::Material;
use crate::material::shear_tangent::invariant_shear_tangent;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// Long-term coefficients, Pa.
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
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        let scale = material.long_term_scale();
        Self {
            c10: scale * material.c10,
            c01: scale * material.c01,
            c11: scale * material.c11,
            c20: scale * material.c20,
            c02: scale * material.c02,
        }
    }

    /// (dW/dI1, dW/dI2), Pa.
    #[inline(always)]
    fn derivatives<V: Vector>(&self, i1: V, i2: V) -> (V, V) {
        let (a, b) = (i1.add_scalar(-3.0), i2.add_scalar(-3.0));
        let first = a.mul_scalar(2.0 * self.c20).add_scalar(self.c10) + b.mul_scalar(self.c11);
        (first, b.mul_scalar(2.0 * self.c02).add_scalar(self.c01) + a.mul_scalar(self.c11))
    }

    /// W at the invariants.
    #[inline(always)]
    fn energy(&self, i1: Real, i2: Real) -> Real {
        let (a, b) = (i1 - 3.0, i2 - 3.0);
        a * (self.c10 + self.c20 * a + self.c11 * b) + b * (self.c01 + self.c02 * b)
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        let (i1, i2) = stretch.invariants();
        self.energy(i1, i2)
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of neighbouring triangles; without `axisymmetric`, U33 = 1.
    ///
    /// In the section, C-bar^-1 is the adjugate of C-bar times C33, and out of it the determinant of the section.
    #[inline(always)]
    pub fn stress<V: Vector>(&self, kinematics: &Kinematics<V>, axisymmetric: bool) -> (Deviator<V>, V) {
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
        // Twice the derivatives of W.
        let w1 = (a.mul_scalar(4.0 * self.c20) + b.mul_scalar(2.0 * self.c11)).add_scalar(2.0 * self.c10);
        let w2 = (b.mul_scalar(4.0 * self.c02) + a.mul_scalar(2.0 * self.c11)).add_scalar(2.0 * self.c01);
        let turned = (w1 + w2 * c_out) * (scale * (mean + mean));
        let tau = Deviator {
            mean: (w1 * (c_mean - c_out) - w2 * (inverse_mean - inverse_out)).mul_scalar(SQRT_THIRD),
            difference: turned * difference,
            shear: turned * shear,
        };
        // W is of degree two without a constant: half the invariants times the mean of the slope and that at rest.
        let energy = (a * w1.add_scalar(2.0 * self.c10) + b * w2.add_scalar(2.0 * self.c01)).mul_scalar(0.25);
        (tau, energy)
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * (self.c10 + self.c01)
    }

    /// A majorant of the shear tangent, Pa; see `invariant_shear_tangent`.
    #[inline(always)]
    pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let (i1, i2) = stretch.invariants();
        let (w1, w2) = self.derivatives(i1, i2);
        let second = [2.0 * self.c20, self.c11, 2.0 * self.c02].map(|c| simd.splat(c));
        invariant_shear_tangent(simd, stretch, [w1, w2], second)
    }
}
