//! The long-term law of what a user says of a material, and its moduli at rest.

use crate::material::{Elastic, Material, VolumetricBy};
use crate::number::real::Real;

impl Elastic {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        Self::of(material.law, material.coefficients.values(), material.long_term_scale())
    }
}

impl Material {
    /// Shear modulus of the long-term law at rest, Pa.
    pub fn shear_modulus_inf(&self) -> Real {
        Elastic::new(self).shear_modulus()
    }

    /// Shear modulus at rest before anything has relaxed or slipped, Pa.
    pub fn shear_modulus_0(&self) -> Real {
        let maxwell = self.maxwell_g.iter().fold(0.0, |sum, g| sum + g);
        self.shear_modulus_inf() / self.prony_g_inf() + maxwell + self.slider_stiffness
    }

    /// Poisson's ratio of a shear modulus, Pa, beside the bulk modulus of this material: nu = (3 K - 2 G) / (6 K + 2 G).
    pub fn poissons_ratio_of(&self, shear_modulus: Real) -> Real {
        let bulk = self.effective_bulk_modulus();
        (3.0 * bulk - 2.0 * shear_modulus) / (6.0 * bulk + 2.0 * shear_modulus)
    }

    /// Bulk modulus, Pa, from whichever of bulk modulus and Poisson's ratio is chosen.
    pub fn effective_bulk_modulus(&self) -> Real {
        match self.volumetric_by {
            VolumetricBy::BulkModulus => self.bulk_modulus,
            VolumetricBy::PoissonsRatio => {
                let nu = self.poissons_ratio;
                2.0 * self.shear_modulus_inf() * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu))
            }
        }
    }
}
