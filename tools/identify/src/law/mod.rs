//! The hyperelastic laws, and what they answer in the three tests.
//!
//! The stress of a law is the kernel's ([`stress`]), so a law stands once. [`linear`] and [`ogden`] fit them,
//! [`statistics`] says how well, [`profile`] whether its errors can be believed, [`degeneracy`] whether the coefficients mean
//! anything, [`stability`] over which stretches they are stable; [`fit`] does all of it for every law, and [`ranking`]
//! compares. [`volume`] is what a specimen does that the laws are fitted without.

pub mod degeneracy;
pub mod fit;
pub mod linear;
pub mod ogden;
pub mod profile;
pub mod ranking;
pub mod stability;
pub mod statistics;
pub mod stress;
pub mod volume;

use softanvil_kernel::material::{ElasticLaw, Material, Moduli, VolumetricBy};
use softanvil_kernel::preset;

/// A homogeneous test of an incompressible specimen; l is the stretch of the loaded direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mode {
    /// One direction loaded, two free: l, l^(-1/2), l^(-1/2).
    Uniaxial,
    /// One loaded, one held, one free (pure shear): l, 1, 1/l.
    Planar,
    /// Two loaded, one free: l, l, l^-2.
    Equibiaxial,
}

/// The three tests.
pub const MODES: [Mode; 3] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial];

impl Mode {
    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniaxial => "uniaxial",
            Self::Planar => "planar",
            Self::Equibiaxial => "equibiaxial",
        }
    }
}

/// Measured states of one test, in SI units.
///
/// ```
/// use softanvil_identify::law::fit::predict;
/// use softanvil_identify::law::{DataSet, Law, Mode};
///
/// // Pure shear of a neo-Hookean material: P = 2 C10 (l - l^-3).
/// let test = DataSet { mode: Mode::Planar, points: vec![(1.5, 1.2e5), (2.0, 1.9e5)] };
/// let stresses = predict(Law::find("neo_hookean").unwrap(), &[5e4], &[test]);
/// assert!((stresses[1] - 1e5 * (2.0 - 0.125)).abs() < 1e-6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DataSet {
    /// The test.
    pub mode: Mode,
    /// (stretch of the loaded direction, nominal stress in Pa).
    pub points: Vec<(f64, f64)>,
}

/// Laws of which one has the other's terms and more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// One coefficient.
    NeoHookean,
    /// Polynomials of I1 and I2.
    MooneyRivlin,
    /// Polynomials of I1.
    Yeoh,
    /// Powers of the principal stretches.
    Ogden,
}

/// A law with a number of parameters.
///
/// ```
/// use softanvil_identify::law::Law;
///
/// let law = Law::find("mooney_rivlin_2").unwrap();
/// assert_eq!((law.parameters, law.unit(0)), (&["c10", "c01"][..], "Pa"));
/// let material = law.material(&[1e5, 2e4]);
/// assert!((material.shear_modulus_inf() - 2.4e5).abs() < 1e-6);
/// ```
#[derive(Debug, PartialEq)]
pub struct Law {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Its family.
    pub family: Family,
    /// Its parameters, by the names of the kernel's table without their group.
    pub parameters: &'static [&'static str],
}

/// Every law, in order of its number of parameters within a family.
pub static LAWS: [Law; 10] = [
    law("neo_hookean", "neo-Hookean", Family::NeoHookean, &["c10"]),
    law("mooney_rivlin_2", "Mooney-Rivlin 2", Family::MooneyRivlin, &["c10", "c01"]),
    law("mooney_rivlin_3", "Mooney-Rivlin 3", Family::MooneyRivlin, &["c10", "c01", "c11"]),
    law("mooney_rivlin_5", "Mooney-Rivlin 5", Family::MooneyRivlin, &["c10", "c01", "c11", "c20", "c02"]),
    law("yeoh_1", "Yeoh 1", Family::Yeoh, &["c10"]),
    law("yeoh_2", "Yeoh 2", Family::Yeoh, &["c10", "c20"]),
    law("yeoh_3", "Yeoh 3", Family::Yeoh, &["c10", "c20", "c30"]),
    law("ogden_1", "Ogden 1", Family::Ogden, &["ogden_mu_1", "ogden_alpha_1"]),
    law("ogden_2", "Ogden 2", Family::Ogden, &["ogden_mu_1", "ogden_alpha_1", "ogden_mu_2", "ogden_alpha_2"]),
    law(
        "ogden_3",
        "Ogden 3",
        Family::Ogden,
        &["ogden_mu_1", "ogden_alpha_1", "ogden_mu_2", "ogden_alpha_2", "ogden_mu_3", "ogden_alpha_3"],
    ),
];

const fn law(name: &'static str, label: &'static str, family: Family, parameters: &'static [&'static str]) -> Law {
    Law { name, label, family, parameters }
}

impl Law {
    /// The law called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        LAWS.iter().find(|law| law.name == name)
    }

    /// Unit of the parameter with this index.
    pub fn unit(&self, parameter: usize) -> &'static str {
        if self.family == Family::Ogden && parameter % 2 == 1 { "1" } else { "Pa" }
    }

    /// The long-term elastic material with these values of [`Law::parameters`], and nothing else to it.
    pub fn material(&self, values: &[f64]) -> Material {
        let mut material = blank();
        material.law = match self.family {
            Family::NeoHookean => ElasticLaw::NeoHookean,
            Family::MooneyRivlin => ElasticLaw::MooneyRivlin,
            Family::Yeoh => ElasticLaw::Yeoh,
            Family::Ogden => ElasticLaw::Ogden,
        };
        for (name, value) in self.parameters.iter().zip(values) {
            match *name {
                "c10" => material.c10 = *value,
                "c01" => material.c01 = *value,
                "c11" => material.c11 = *value,
                "c20" => material.c20 = *value,
                "c02" => material.c02 = *value,
                "c30" => material.c30 = *value,
                "ogden_mu_1" => material.ogden_mu[0] = *value,
                "ogden_alpha_1" => material.ogden_alpha[0] = *value,
                "ogden_mu_2" => material.ogden_mu[1] = *value,
                "ogden_alpha_2" => material.ogden_alpha[1] = *value,
                "ogden_mu_3" => material.ogden_mu[2] = *value,
                _ => material.ogden_alpha[2] = *value,
            }
        }
        material
    }
}

/// Density, kg/m3, and Poisson's ratio of the study's silicone, for what a fit does not identify.
pub const STUDY_DENSITY: f64 = 1072.0;
/// See [`STUDY_DENSITY`].
pub const STUDY_POISSONS_RATIO: f64 = 0.48;

/// A material without any stiffness, viscosity, damping or tear, with the study's density and Poisson's ratio.
pub fn blank() -> Material {
    Material {
        density: STUDY_DENSITY,
        moduli: Moduli::LongTerm,
        c10: 0.0,
        c01: 0.0,
        c11: 0.0,
        c20: 0.0,
        c02: 0.0,
        c30: 0.0,
        ogden_mu: [0.0; 3],
        ogden_alpha: [2.0, -2.0, 4.0],
        volumetric_by: VolumetricBy::PoissonsRatio,
        poissons_ratio: STUDY_POISSONS_RATIO,
        prony_g: [0.0; 5],
        prony_tau: [1.0; 5],
        maxwell_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        tear_stretch: 0.0,
        ..preset::study().layers[0].material
    }
}
