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

    /// Bulk modulus before anything has relaxed, Pa: that of a compressible law relaxes as its shear modulus does, any other
    /// stays.
    pub fn bulk_modulus_0(&self) -> Real {
        let bulk = self.effective_bulk_modulus();
        if self.law.is_compressible() { bulk / self.prony_g_inf() } else { bulk }
    }

    /// Poisson's ratio of a shear modulus, Pa, beside the long-term bulk modulus of this material.
    pub fn poissons_ratio_of(&self, shear_modulus: Real) -> Real {
        poissons_ratio(self.effective_bulk_modulus(), shear_modulus)
    }

    /// Poisson's ratio at rest before anything has relaxed or slipped.
    pub fn poissons_ratio_0(&self) -> Real {
        poissons_ratio(self.bulk_modulus_0(), self.shear_modulus_0())
    }

    /// Bulk modulus of the long-term law, Pa: of a compressible law its own, else from whichever of bulk modulus and Poisson's
    /// ratio is chosen.
    pub fn effective_bulk_modulus(&self) -> Real {
        if let Some(own) = Elastic::new(self).bulk_modulus() {
            return own;
        }
        match self.volumetric_by {
            VolumetricBy::BulkModulus => self.bulk_modulus,
            VolumetricBy::PoissonsRatio => {
                let nu = self.poissons_ratio;
                2.0 * self.shear_modulus_inf() * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu))
            }
        }
    }
}

/// nu = (3 K - 2 G) / (6 K + 2 G) of a bulk and a shear modulus, Pa.
fn poissons_ratio(bulk_modulus: Real, shear_modulus: Real) -> Real {
    (3.0 * bulk_modulus - 2.0 * shear_modulus) / (6.0 * bulk_modulus + 2.0 * shear_modulus)
}
