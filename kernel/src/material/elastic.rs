//! The choice of isochoric hyperelastic law, made once per block of triangles and outside the loop over lanes.

use crate::material::{ElasticLaw, Material, MooneyRivlin, NeoHookean, Ogden, Yeoh};
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// Long-term isochoric elasticity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elastic {
    /// See [`crate::material::neo_hookean`].
    NeoHookean(NeoHookean),
    /// See [`crate::material::mooney_rivlin`].
    MooneyRivlin(MooneyRivlin),
    /// See [`crate::material::yeoh`].
    Yeoh(Yeoh),
    /// See [`crate::material::ogden`].
    Ogden(Ogden),
}

impl Elastic {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        match material.law {
            ElasticLaw::NeoHookean => Self::NeoHookean(NeoHookean::new(material)),
            ElasticLaw::MooneyRivlin => Self::MooneyRivlin(MooneyRivlin::new(material)),
            ElasticLaw::Yeoh => Self::Yeoh(Yeoh::new(material)),
            ElasticLaw::Ogden => Self::Ogden(Ogden::new(material)),
        }
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        match self {
            Self::NeoHookean(law) => law.strain_energy_density(stretch),
            Self::MooneyRivlin(law) => law.strain_energy_density(stretch),
            Self::Yeoh(law) => law.strain_energy_density(stretch),
            Self::Ogden(law) => law.strain_energy_density(stretch),
        }
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of `N` neighbouring triangles each; without `axisymmetric`,
    /// U33 = 1.
    #[inline(always)]
    pub fn stress<S: Simd, const N: usize>(
        &self,
        simd: S,
        kinematics: &[Kinematics<S::Vector>; N],
        axisymmetric: bool,
    ) -> [(Deviator<S::Vector>, S::Vector); N] {
        let zero = simd.splat(0.0);
        let mut response = [(Deviator { mean: zero, difference: zero, shear: zero }, zero); N];
        // The law is chosen outside the loop, so that the triangles go through it side by side.
        match self {
            Self::NeoHookean(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i]);
                }
            }
            Self::MooneyRivlin(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i], axisymmetric);
                }
            }
            Self::Yeoh(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i]);
                }
            }
            Self::Ogden(law) => {
                let kinematics = *kinematics;
                for i in 0..N {
                    response[i] = law.stress(simd, &kinematics[i]);
                }
            }
        }
        response
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        match self {
            Self::NeoHookean(law) => law.shear_modulus(),
            Self::MooneyRivlin(law) => law.shear_modulus(),
            Self::Yeoh(law) => law.shear_modulus(),
            Self::Ogden(law) => law.shear_modulus(),
        }
    }

    /// A majorant of the shear tangent at a stretch with the geometric stiffness of the stress, Pa.
    #[inline(always)]
    pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        match self {
            Self::NeoHookean(law) => law.shear_tangent(simd, stretch),
            Self::MooneyRivlin(law) => law.shear_tangent(simd, stretch),
            Self::Yeoh(law) => law.shear_tangent(simd, stretch),
            Self::Ogden(law) => law.shear_tangent(simd, stretch),
        }
    }
}
