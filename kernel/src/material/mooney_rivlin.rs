//! Mooney-Rivlin with two, three or five parameters, isochoric (Mooney 1940, Rivlin 1948; the polynomial form of degree
//! two). With C20 = C02 = 0 it is the law of three parameters, with C11 = 0 as well that of two:
//!
//! W = C10 (I1-3) + C01 (I2-3) + C11 (I1-3)(I2-3) + C20 (I1-3)^2 + C02 (I2-3)^2
//!
//! with the invariants of C-bar = J^(-2/3) C. With W1 = dW/dI1 and W2 = dW/dI2 the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 W1 C-bar - 2 W2 C-bar^-1), because I2 = tr C-bar^-1 when det C-bar = 1.

use crate::element::Kinematics;
use crate::lanes::{Deviator, LANES, Lane};
use crate::material::plane_shear_tangent;
use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::IsochoricStretch;

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
    fn derivatives(&self, i1: Real, i2: Real) -> (Real, Real) {
        let (a, b) = (i1 - 3.0, i2 - 3.0);
        (self.c10 + 2.0 * self.c20 * a + self.c11 * b, self.c01 + 2.0 * self.c02 * b + self.c11 * a)
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

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of a block of triangles.
    #[inline(always)]
    pub fn stress(&self, kinematics: &Kinematics) -> (Deviator, Lane) {
        let mut tau = Deviator::ZERO;
        let mut energy = [0.0; LANES];
        for l in 0..LANES {
            let (u11, u22, u12, u33) = (kinematics.u11[l], kinematics.u22[l], kinematics.u12[l], kinematics.u33[l]);
            let shear = u12 * u12;
            let (c11, c22, c12, c33) = (u11 * u11 + shear, u22 * u22 + shear, u12 * (u11 + u22), u33 * u33);
            let det = u11 * u22 - shear;
            // J^(-2/3) scales C, J^(-4/3) its cofactors, which are C^-1 when det C-bar = 1.
            let scale = kinematics.inverse_cbrt_j[l] * kinematics.inverse_cbrt_j[l];
            let cofactor_scale = scale * scale;
            let section = c11 + c22;
            let i1 = scale * (section + c33);
            let i2 = cofactor_scale * (section * c33 + det * det);
            let (w1, w2) = self.derivatives(i1, i2);
            let (a, b) = (2.0 * w1 * scale, 2.0 * w2 * cofactor_scale * c33);
            let mean = (2.0 / 3.0) * (w1 * i1 - w2 * i2);
            tau.xx[l] = a * c11 - b * c22 - mean;
            tau.yy[l] = a * c22 - b * c11 - mean;
            tau.xy[l] = (a + b) * c12;
            energy[l] = self.energy(i1, i2);
        }
        (tau, energy)
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * (self.c10 + self.c01)
    }

    /// An upper bound of the shear tangent, Pa.
    pub fn shear_tangent(&self, stretch: &IsochoricStretch) -> Real {
        let (i1, i2) = stretch.invariants();
        let (w1, w2) = self.derivatives(i1, i2);
        plane_shear_tangent((i1, i2), w1 + w2, 2.0 * (self.c20 + self.c02 + self.c11))
    }
}
