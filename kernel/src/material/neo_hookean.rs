//! Neo-Hooke, isochoric (Treloar 1943): W = C10 (I1-3), I1 = tr C-bar, so that the Kirchhoff stress in the unrotated
//! frame is tau = dev(2 C10 C-bar).

use crate::element::Kinematics;
use crate::lanes::{Deviator, LANES, Lane};
use crate::material::plane_shear_tangent;
use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::IsochoricStretch;

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

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of a block of triangles.
    #[inline(always)]
    pub fn stress(&self, kinematics: &Kinematics) -> (Deviator, Lane) {
        let mut tau = Deviator::ZERO;
        let mut energy = [0.0; LANES];
        let factor = 2.0 * self.c10;
        for l in 0..LANES {
            let [c11, c22, c12, c33] = kinematics.isochoric_cauchy_green(l);
            let i1 = c11 + c22 + c33;
            let mean = i1 * (1.0 / 3.0);
            tau.xx[l] = factor * (c11 - mean);
            tau.yy[l] = factor * (c22 - mean);
            tau.xy[l] = factor * c12;
            energy[l] = self.c10 * (i1 - 3.0);
        }
        (tau, energy)
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        2.0 * self.c10
    }

    /// An upper bound of the shear tangent, Pa.
    pub fn shear_tangent(&self, stretch: &IsochoricStretch) -> Real {
        plane_shear_tangent(stretch.invariants(), self.c10, 0.0)
    }
}
