//! The hyperelastic laws, and what they answer in the three tests.
//!
//! The stress of a law is the kernel's ([`stress`]), and so is what it says of its coefficients: a law stands once. [`linear`]
//! fits those that are linear in all of them, [`separable`] those that are not, but for [`ogden`], whose exponents have many minima,
//! and [`foam`], which changes its volume; [`parts`] tells the tests apart that residuals are told for,
//! [`statistics`] says how well, [`profile`] whether its errors can be believed, [`degeneracy`] whether the coefficients mean
//! anything, [`stability`] over which stretches they are stable; [`fit`] does all of it for every law, and [`ranking`]
//! compares. [`volume`] is what a specimen does that the laws are fitted without.

pub mod degeneracy;
pub mod fit;
pub mod foam;
pub mod interval;
pub mod linear;
pub mod ogden;
pub mod parts;
pub mod profile;
pub mod ranking;
pub mod separable;
pub mod stability;
pub mod statistics;
pub mod stress;
pub mod volume;

use std::sync::LazyLock;

use softanvil_kernel::material::{Coefficient, Coefficients, Elastic, ElasticLaw, Material, Moduli, VolumetricBy};
use softanvil_kernel::preset;

use interval::Interval;

/// A homogeneous test, with the stretches of an incompressible specimen; l is that of the loaded direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mode {
    /// One direction loaded, two free: l, l^(-1/2), l^(-1/2).
    Uniaxial,
    /// One loaded, one held, one free (pure shear): l, 1, 1/l.
    Planar,
    /// Two loaded, one free: l, l, l^-2.
    Equibiaxial,
    /// Two faces displaced along themselves by the amount of shear g times their distance: l, 1/l, 1 with g = l - 1/l.
    SimpleShear,
}

/// The tests whose deformations are looked at for stability; simple shear deforms as the planar test of an incompressible
/// specimen, but for a rotation.
pub const MODES: [Mode; 3] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial];

impl Mode {
    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniaxial => "uniaxial",
            Self::Planar => "planar",
            Self::Equibiaxial => "equibiaxial",
            Self::SimpleShear => "simple-shear",
        }
    }

    /// What its points are measured in, beside the stress.
    pub fn measured(self) -> &'static str {
        match self {
            Self::SimpleShear => "amount_of_shear",
            _ => "stretch",
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
    /// (stretch of the loaded direction, or amount of shear; nominal stress in Pa).
    pub points: Vec<(f64, f64)>,
}

impl DataSet {
    /// The smallest and the largest principal stretch of the states, where the free directions do not count.
    pub fn stretches(&self) -> (f64, f64) {
        let principal = self.points.iter().flat_map(|(x, _)| match self.mode {
            Mode::SimpleShear => {
                let [long, short, _] = stress::stretches(self.mode, *x);
                [long, short]
            }
            _ => [*x; 2],
        });
        principal.fold((f64::MAX, f64::MIN), |(low, high), l| (low.min(l), high.max(l)))
    }
}

/// A law of the kernel with a number of its coefficients; those of one law of the kernel are a family, of which one has the
/// other's terms and more.
///
/// ```
/// use softanvil_identify::law::Law;
///
/// let law = Law::find("mooney_rivlin_2").unwrap();
/// assert_eq!((law.parameters[1].name, law.parameters[1].unit), ("c01", "Pa"));
/// let material = law.material(&[1e5, 2e4]);
/// assert!((material.shear_modulus_inf() - 2.4e5).abs() < 1e-6);
/// ```
#[derive(Debug, PartialEq)]
pub struct Law {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// The law of the kernel.
    pub family: ElasticLaw,
    /// Its parameters, the first of the law's coefficients.
    pub parameters: &'static [Coefficient],
}

/// Every law of a constant volume, by its family and number of parameters, as the kernel describes them.
pub static LAWS: LazyLock<Vec<Law>> = LazyLock::new(|| listed(false));

/// Every law that says how the volume changes, likewise.
pub static FOAMS: LazyLock<Vec<Law>> = LazyLock::new(|| listed(true));

fn listed(compressible: bool) -> Vec<Law> {
    let of_law = |family: &'static ElasticLaw| {
        let description = family.description();
        description.variants.iter().map(|variant| Law {
            name: variant.name,
            label: variant.label,
            family: *family,
            parameters: &description.coefficients[..variant.n_coefficient],
        })
    };
    ElasticLaw::ALL.iter().filter(|law| law.description().compressible == compressible).flat_map(of_law).collect()
}

impl Law {
    /// The law called `name`.
    pub fn find(name: &str) -> Option<&'static Self> {
        LAWS.iter().chain(FOAMS.iter()).find(|law| law.name == name)
    }

    /// Whether it says how the volume changes.
    pub fn is_compressible(&self) -> bool {
        self.family.description().compressible
    }

    /// Whether the stress is linear in every parameter.
    pub fn is_linear(&self) -> bool {
        self.parameters.iter().all(Coefficient::is_modulus)
    }

    /// Values of a soft rubber.
    pub fn example(&self) -> &'static [f64] {
        &self.family.description().example[..self.parameters.len()]
    }

    /// Between which values each of its shapes is.
    fn intervals(&self) -> Vec<Interval> {
        self.parameters.iter().filter(|parameter| !parameter.is_modulus()).map(Interval::of).collect()
    }

    /// The moduli and the shapes among `values`.
    fn parted(&self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let of = |modulus: bool| {
            let own =
                self.parameters.iter().zip(values).filter(move |(parameter, _)| parameter.is_modulus() == modulus);
            own.map(|(_, value)| *value).collect()
        };
        (of(true), of(false))
    }

    /// The values of which these are the moduli and the shapes.
    fn values(&self, moduli: &[f64], shapes: &[f64]) -> Vec<f64> {
        let (mut moduli, mut shapes) = (moduli.iter(), shapes.iter());
        let next = |parameter: &Coefficient| if parameter.is_modulus() { moduli.next() } else { shapes.next() };
        self.parameters.iter().filter_map(next).copied().collect()
    }

    /// The long-term elastic material with these values of [`Law::parameters`], and nothing else to it.
    pub fn material(&self, values: &[f64]) -> Material {
        blank().with_values(self.family, values)
    }

    /// Its law in the kernel.
    pub fn elastic(&self, values: &[f64]) -> Elastic {
        Elastic::new(&self.material(values))
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
        coefficients: Coefficients::START,
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
