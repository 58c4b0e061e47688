//! What a user says of a material.

use strum::{FromRepr, VariantNames};

use crate::material::coefficients::Coefficients;
use crate::material::elastic::{ElasticLaw, ListedLaw};
use crate::material::relaxation::{MAX_BRANCHES, PACKS_OF_ENTRY};
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

/// Which moduli the coefficients of the elastic law are.
#[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq, VariantNames)]
#[strum(serialize_all = "snake_case")]
pub enum Moduli {
    /// The law after full relaxation.
    LongTerm,
    /// The law before any relaxation; the long-term law is g_inf = 1 - sum g_i times it.
    Instantaneous,
}

/// Most terms of a Prony series.
pub const MAX_PRONY_TERMS: usize = MAX_BRANCHES;
/// Most additive Maxwell terms.
pub const MAX_MAXWELL_TERMS: usize = MAX_BRANCHES;

/// A visco-hyperelastic material with frequency-independent damping.
///
/// ```
/// use softanvil_kernel::material::{ElasticLaw, MooneyRivlin};
/// use softanvil_kernel::preset::elastic_silicone;
///
/// let silicone = elastic_silicone().with(MooneyRivlin { c10: 148e3, c01: 104e3, c20: 132e3, ..MooneyRivlin::ZERO });
/// assert_eq!((silicone.law, silicone.coefficient("c20")), (ElasticLaw::MooneyRivlin, Some(132e3)));
/// assert_eq!(silicone.shear_modulus_inf(), 504e3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Mass density, kg/m3.
    pub density: Real,
    /// Hyperelastic law.
    pub law: ElasticLaw,
    /// Whether the coefficients are long-term or instantaneous.
    pub moduli: Moduli,
    /// Coefficients of the laws, of which those act that belong to the chosen one.
    pub coefficients: Coefficients,
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
    /// r of the softening after the first load; 0 switches it off.
    pub softening_r: Real,
    /// m of the softening, J/m3.
    pub softening_m: Real,
    /// beta of the softening.
    pub softening_beta: Real,
}

impl Material {
    /// The same with another elastic law; every coefficient that is not of it is as where none is given.
    #[must_use]
    pub fn with<L: ListedLaw>(self, law: L) -> Self {
        Self { law: L::LAW, coefficients: Coefficients::of(&law), ..self }
    }

    /// The same with `law` by the values of its coefficients, in its order, of which the last may be missing: they are as where
    /// none is given.
    #[must_use]
    pub fn with_values(self, law: ElasticLaw, values: &[Real]) -> Self {
        Self { law, coefficients: Coefficients::of_values(law, values), ..self }
    }

    /// The coefficient called `name`, whether or not the law has it; none of a name that no law has.
    pub fn coefficient(&self, name: &str) -> Option<Real> {
        self.coefficients.get(name)
    }

    /// g_inf = 1 - sum g_i: the part of the instantaneous modulus that does not relax.
    pub fn prony_g_inf(&self) -> Real {
        1.0 - self.prony_g.iter().fold(0.0, |sum, g| sum + g)
    }

    /// Viscous terms that are on, quasi-linear and additive.
    pub fn n_viscous_term(&self) -> usize {
        self.prony_g.iter().chain(&self.maxwell_g).filter(|g| **g > 0.0).count()
    }

    /// Entries of the history that its triangles have beside that of every material: a deviator for each viscous term, and
    /// what compressible and softening laws remember besides.
    pub fn n_history_entry(&self) -> usize {
        let quasi_linear = self.prony_g.iter().filter(|g| **g > 0.0).count();
        let compressible = self.law.is_compressible();
        self.n_viscous_term() + n_extra_entry(compressible, quasi_linear, self.softening_r > 0.0)
    }

    /// Factor from the given coefficients to the long-term law.
    pub fn long_term_scale(&self) -> Real {
        match self.moduli {
            Moduli::LongTerm => 1.0,
            Moduli::Instantaneous => self.prony_g_inf(),
        }
    }
}

/// Entries beside those of the viscous terms; see [`Material::n_history_entry`].
pub(crate) fn n_extra_entry(compressible: bool, quasi_linear: usize, softens: bool) -> usize {
    let means = if compressible { quasi_linear.div_ceil(PACKS_OF_ENTRY) } else { 0 };
    means + usize::from(means > 0 || softens)
}
