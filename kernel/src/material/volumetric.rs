//! Volumetric law: U(J) = K/2 (J - 1)^2, pressure-like stress p = dU/dJ = K (J - 1), positive in tension.

use crate::lanes::{LANES, Lane};

/// U(J) = K/2 (J - 1)^2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumetric {
    /// Bulk modulus K, Pa.
    pub bulk_modulus: f64,
}

impl Volumetric {
    /// dU/dJ at each lane's mean `jacobian`, Pa.
    #[inline(always)]
    pub fn stress(&self, jacobian: &Lane) -> Lane {
        let mut stress = [0.0; LANES];
        for l in 0..LANES {
            stress[l] = self.bulk_modulus * (jacobian[l] - 1.0);
        }
        stress
    }

    /// U at each lane's mean `jacobian`, J/m3 of reference volume.
    #[inline(always)]
    pub fn strain_energy_density(&self, jacobian: &Lane) -> Lane {
        let mut energy = [0.0; LANES];
        for l in 0..LANES {
            let dilatation = jacobian[l] - 1.0;
            energy[l] = 0.5 * self.bulk_modulus * dilatation * dilatation;
        }
        energy
    }

    /// d2U/dJ2, Pa.
    pub fn tangent(&self) -> f64 {
        self.bulk_modulus
    }
}
