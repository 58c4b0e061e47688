//! Yeoh with three terms, isochoric (Yeoh 1993): W = sum_k Ck0 (I1-3)^k, k = 1, 2, 3, with I1 = tr C-bar, so that the
//! Kirchhoff stress in the unrotated frame is tau = dev(2 dW/dI1 C-bar). Zero coefficients give one or two terms.

use crate::element::Kinematics;
use crate::lanes::{Deviator, LANES, Lane};
use crate::material::plane_shear_tangent;
use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::IsochoricStretch;

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
    fn slope(&self, a: Real) -> Real {
        self.c10 + a * (2.0 * self.c20 + a * (3.0 * self.c30))
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        self.energy(stretch.invariants().0 - 3.0)
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of a block of triangles.
    #[inline(always)]
    pub fn stress(&self, kinematics: &Kinematics) -> (Deviator, Lane) {
        let mut tau = Deviator::ZERO;
        let mut energy = [0.0; LANES];
        for l in 0..LANES {
            let [c11, c22, c12, c33] = kinematics.isochoric_cauchy_green(l);
            let i1 = c11 + c22 + c33;
            let mean = i1 * (1.0 / 3.0);
            let factor = 2.0 * self.slope(i1 - 3.0);
            tau.xx[l] = factor * (c11 - mean);
            tau.yy[l] = factor * (c22 - mean);
            tau.xy[l] = factor * c12;
            energy[l] = self.energy(i1 - 3.0);
        }
        (tau, energy)
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    /// An upper bound of the shear tangent, Pa.
    pub fn shear_tangent(&self, stretch: &IsochoricStretch) -> Real {
        let (i1, i2) = stretch.invariants();
        let a = i1 - 3.0;
        plane_shear_tangent((i1, i2), self.slope(a), 2.0 * self.c20 + 6.0 * self.c30 * a)
    }
}
