//! Volumetric laws U(J) with the bulk modulus K at rest, and their pressure-like stress p = dU/dJ, positive in tension:
//!
//! * quadratic: U = K/2 (J - 1)^2, p = K (J - 1): finite at J = 0, so nothing but the mesh keeps J positive;
//! * Simo (Simo, Taylor and Pister 1985; Simo and Miehe 1992): U = K/4 (J^2 - 1 - 2 ln J), p = K/2 (J - 1/J), which
//!   grows without bound as J goes to 0 and so keeps J positive.

use crate::material::{Material, VolumetricLaw};
use crate::number::power;
use crate::number::real::Real;
use crate::number::real::consts::LN_2;
use crate::number::vector::{Simd, Vector};

/// The chosen law and its modulus.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumetric {
    /// Which U(J).
    pub law: VolumetricLaw,
    /// Bulk modulus K at rest, Pa.
    pub bulk_modulus: Real,
}

impl Volumetric {
    /// The law of `material`.
    pub fn new(material: &Material) -> Self {
        Self { law: material.volumetric_law, bulk_modulus: material.effective_bulk_modulus() }
    }

    /// dU/dJ at the mean `jacobian` of neighbouring cells, Pa.
    #[inline(always)]
    pub fn stress<V: Vector>(&self, jacobian: V) -> V {
        let dilatation = jacobian.add_scalar(-1.0);
        match self.law {
            VolumetricLaw::Quadratic => dilatation.mul_scalar(self.bulk_modulus),
            // (J - 1)(J + 1) / J, which is exact near rest.
            VolumetricLaw::Simo => {
                (dilatation * jacobian.add_scalar(1.0)).mul_scalar(0.5 * self.bulk_modulus) / jacobian
            }
        }
    }

    /// U at the mean `jacobian` of neighbouring cells, J/m3 of reference volume. Error of Simo's: below 10^-15 K, from the
    /// logarithm.
    #[inline(always)]
    pub fn strain_energy_density<S: Simd>(&self, simd: S, jacobian: S::Vector) -> S::Vector {
        let dilatation = jacobian.add_scalar(-1.0);
        let square = dilatation * dilatation;
        match self.law {
            VolumetricLaw::Quadratic => square.mul_scalar(0.5 * self.bulk_modulus),
            VolumetricLaw::Simo => {
                // J^2 - 1 - 2 ln J with d = J - 1.
                let first_order = dilatation - power::log2(simd, jacobian).mul_scalar(LN_2);
                (square + first_order.mul_scalar(2.0)).mul_scalar(0.25 * self.bulk_modulus)
            }
        }
    }

    /// An upper bound of the modulus of volume strain at `jacobian`, Pa: J^2 d2U/dJ2, the modulus against spatial
    /// gradients, and not less than that at rest.
    #[inline(always)]
    pub fn tangent<S: Simd>(&self, simd: S, jacobian: S::Vector) -> S::Vector {
        let square = jacobian * jacobian;
        let relative = match self.law {
            VolumetricLaw::Quadratic => square,
            VolumetricLaw::Simo => square.add_scalar(1.0).mul_scalar(0.5),
        };
        relative.max(simd.splat(1.0)).mul_scalar(self.bulk_modulus)
    }
}
