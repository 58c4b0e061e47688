//! Volumetric laws U(J) with the bulk modulus K at rest, and their pressure-like stress p = dU/dJ, positive in tension:
//!
//! * quadratic: U = K/2 (J - 1)^2, p = K (J - 1): finite at J = 0, so nothing but the mesh keeps J positive;
//! * Simo (Simo, Taylor and Pister 1985; Simo and Miehe 1992): U = K/4 (J^2 - 1 - 2 ln J), p = K/2 (J - 1/J), which
//!   grows without bound as J goes to 0 and so keeps J positive.

use crate::lanes::{LANES, Lane};
use crate::math;
use crate::real::Real;
use crate::scenario::{Material, VolumetricLaw};

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

    /// dU/dJ at each lane's mean `jacobian`, Pa.
    #[inline(always)]
    pub fn stress(&self, jacobian: &Lane) -> Lane {
        let mut stress = [0.0; LANES];
        match self.law {
            VolumetricLaw::Quadratic => {
                for l in 0..LANES {
                    stress[l] = self.bulk_modulus * (jacobian[l] - 1.0);
                }
            }
            VolumetricLaw::Simo => {
                let half = 0.5 * self.bulk_modulus;
                for l in 0..LANES {
                    // (J - 1)(J + 1) / J, which is exact near rest.
                    stress[l] = half * ((jacobian[l] - 1.0) * (jacobian[l] + 1.0)) / jacobian[l];
                }
            }
        }
        stress
    }

    /// U at each lane's mean `jacobian`, J/m3 of reference volume. Error of Simo's: below 10^-15 K, from the logarithm.
    #[inline(always)]
    pub fn strain_energy_density(&self, jacobian: &Lane) -> Lane {
        let mut energy = [0.0; LANES];
        match self.law {
            VolumetricLaw::Quadratic => {
                for l in 0..LANES {
                    let dilatation = jacobian[l] - 1.0;
                    energy[l] = 0.5 * self.bulk_modulus * dilatation * dilatation;
                }
            }
            VolumetricLaw::Simo => {
                let quarter = 0.25 * self.bulk_modulus;
                for l in 0..LANES {
                    let dilatation = jacobian[l] - 1.0;
                    // J^2 - 1 - 2 ln J with d = J - 1.
                    let first_order = dilatation - math::ln_1p(dilatation);
                    energy[l] = quarter * (dilatation * dilatation + 2.0 * first_order);
                }
            }
        }
        energy
    }

    /// An upper bound of the modulus of volume strain at `jacobian`, Pa: J^2 d2U/dJ2, the modulus against spatial
    /// gradients, and not less than that at rest.
    pub fn tangent(&self, jacobian: Real) -> Real {
        let square = jacobian * jacobian;
        let relative = match self.law {
            VolumetricLaw::Quadratic => square,
            VolumetricLaw::Simo => 0.5 * (square + 1.0),
        };
        self.bulk_modulus * math::larger(1.0, relative)
    }
}
