//! What a user says of a material.

use strum::{FromRepr, VariantNames};

use crate::material::relaxation::MAX_BRANCHES;
use crate::number::real::Real;

/// The volumetric law.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum VolumetricLaw {
    /// K/2 (J - 1)^2.
    Quadratic,
    /// K/4 (J^2 - 1 - 2 ln J), without bound as J goes to 0.
    Simo,
}

/// Which of the two numbers states the compressibility.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum VolumetricBy {
    /// [`Material::bulk_modulus`].
    BulkModulus,
    /// [`Material::poissons_ratio`], by K = 2 G (1 + nu) / (3 (1 - 2 nu)) with the shear modulus G at rest of the
    /// long-term law.
    PoissonsRatio,
}

/// The isochoric hyperelastic law.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum ElasticLaw {
    /// C10.
    NeoHookean,
    /// C10, C01, C11, C20, C02; zeros give the laws of two and three parameters.
    MooneyRivlin,
    /// C10, C20, C30.
    Yeoh,
    /// Up to three pairs of mu and alpha.
    Ogden,
}

/// Which moduli the coefficients of the elastic law are.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Moduli {
    /// The law after full relaxation.
    LongTerm,
    /// The law before any relaxation; the long-term law is g_inf = 1 - sum g_i times it.
    Instantaneous,
}

/// Most terms of an Ogden law.
pub const MAX_OGDEN_TERMS: usize = 3;
/// Most terms of a Prony series.
pub const MAX_PRONY_TERMS: usize = MAX_BRANCHES;
/// Most additive Maxwell terms.
pub const MAX_MAXWELL_TERMS: usize = MAX_BRANCHES;

/// A visco-hyperelastic material with frequency-independent damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// EnergyDensity, kg/m3.
    pub density: Real,
    /// Isochoric hyperelastic law; it uses those of the next coefficients that belong to it.
    pub law: ElasticLaw,
    /// Whether the coefficients are long-term or instantaneous.
    pub moduli: Moduli,
    /// Coefficient of (I1 - 3) in all laws but Ogden's, Pa.
    pub c10: Real,
    /// Mooney-Rivlin coefficient of (I2 - 3), Pa.
    pub c01: Real,
    /// Mooney-Rivlin coefficient of (I1 - 3)(I2 - 3), Pa.
    pub c11: Real,
    /// Mooney-Rivlin and Yeoh coefficient of (I1 - 3)^2, Pa.
    pub c20: Real,
    /// Mooney-Rivlin coefficient of (I2 - 3)^2, Pa.
    pub c02: Real,
    /// Yeoh coefficient of (I1 - 3)^3, Pa.
    pub c30: Real,
    /// Ogden coefficients mu_i, Pa; a term with mu = 0 is off.
    pub ogden_mu: [Real; MAX_OGDEN_TERMS],
    /// Ogden exponents alpha_i.
    pub ogden_alpha: [Real; MAX_OGDEN_TERMS],
    /// Energy of volume change.
    pub volumetric_law: VolumetricLaw,
    /// Which of the next two counts.
    pub volumetric_by: VolumetricBy,
    /// Bulk modulus, Pa.
    pub bulk_modulus: Real,
    /// Poisson's ratio.
    pub poissons_ratio: Real,
    /// Prony coefficients g_i, normalised on the instantaneous modulus; a term with g = 0 is off.
    pub prony_g: [Real; MAX_PRONY_TERMS],
    /// Relaxation times tau_i, s.
    pub prony_tau: [Real; MAX_PRONY_TERMS],
    /// Shear moduli G_i of the additive Maxwell terms, Pa; a term with G = 0 is off.
    pub maxwell_g: [Real; MAX_MAXWELL_TERMS],
    /// Their decay constants beta_i, 1/s.
    pub maxwell_beta: [Real; MAX_MAXWELL_TERMS],
    /// Shear modulus G of the damping spring, Pa; 0 switches the spring-slider off.
    pub slider_stiffness: Real,
    /// Von Mises stress SIGF at which the slider slips, Pa.
    pub slider_yield_stress: Real,
    /// Largest principal stretch at which the material begins to tear; 0 switches tearing off.
    pub tear_stretch: Real,
    /// Stretch over which the deviatoric stress falls.
    pub tear_width: Real,
    /// Part of the deviatoric stress that remains.
    pub tear_residual: Real,
}

impl Material {
    /// g_inf = 1 - sum g_i: the part of the instantaneous modulus that does not relax.
    pub fn prony_g_inf(&self) -> Real {
        1.0 - self.prony_g.iter().fold(0.0, |sum, g| sum + g)
    }

    /// Viscous terms that are on, quasi-linear and additive.
    pub fn n_viscous_term(&self) -> usize {
        self.prony_g.iter().chain(&self.maxwell_g).filter(|g| **g > 0.0).count()
    }

    /// Factor from the given coefficients to the long-term law.
    pub fn long_term_scale(&self) -> Real {
        match self.moduli {
            Moduli::LongTerm => 1.0,
            Moduli::Instantaneous => self.prony_g_inf(),
        }
    }
}
