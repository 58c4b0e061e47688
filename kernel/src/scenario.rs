//! The description of one drop test: geometry, impactor, material, interfaces, mesh, time.
//!
//! A [`Scenario`] is plain data. Every field is a row of [`crate::parameter::PARAMETERS`], which holds its name,
//! unit, legal range and meaning; [`Scenario::validate`] checks the rows and what several fields say together.

use crate::error::ScenarioError;
use crate::material::{Elastic, MAX_MAXWELL_TERMS, MAX_OGDEN_TERMS, MAX_PRONY_TERMS};
use crate::parameter::PARAMETERS;
use crate::real::Real;

/// Everything that defines a simulation, in SI units.
///
/// ```
/// use softanvil_kernel::preset;
///
/// let mut scenario = preset::study();
/// scenario.geometry.silicone_thickness = 20e-3;
/// scenario.impactor.mass = 4.0;
/// scenario.impactor = scenario.impactor.with_energy(8.0);
/// scenario.validate()?;
/// assert_eq!(scenario.impactor.start_speed(), 2.0);
/// scenario.impactor.face_diameter = 10e-3;
/// let refused = scenario.validate().unwrap_err().to_string();
/// assert!(refused.starts_with("impactor.face_diameter = 0.01 m is refused: over this anvil legal is at least "));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scenario {
    /// Shape and size of the anvil.
    pub geometry: Geometry,
    /// The drop mass.
    pub impactor: Impactor,
    /// Material of the silicone.
    pub silicone: Material,
    /// Material of the skin where [`Geometry::layers`] gives it one of its own.
    pub skin: Material,
    /// Interface between layer and core.
    pub core: CoreInterface,
    /// Interface between impactor and layer.
    pub face: FaceInterface,
    /// Spatial discretisation.
    pub mesh: Mesh,
    /// Temporal discretisation and simulated time.
    pub time: Time,
    /// How the numbers of the test are read from the force.
    pub measurement: Measurement,
}

/// Shape of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A layer on a round core: half a cylinder in plane strain, half a sphere when axisymmetric.
    Round,
    /// A flat block on a flat core, for material and verification tests.
    Block,
}

/// Kinematics of the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// No strain out of the section, whose thickness is the chord of the face (limited to the length).
    PlaneStrain,
    /// The section turned about its centre line.
    Axisymmetric,
}

/// Layers of different material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layers {
    /// The silicone's material through the whole thickness: the study's simplification.
    One,
    /// A skin with a material, and rows of the mesh, of its own.
    Two,
}

/// Most layers of different material.
pub const MAX_LAYERS: usize = 2;

/// A layer of the anvil.
#[derive(Clone, Copy, Debug)]
pub struct Layer<'a> {
    /// Group of its parameters.
    pub name: &'static str,
    /// Its material.
    pub material: &'a Material,
}

/// How much of the section is meshed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Section {
    /// The right half, with a centre line that moves only vertically.
    Half,
    /// Both halves (plane strain).
    Full,
}

/// Shape and size of the anvil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry {
    /// Round or block.
    pub shape: Shape,
    /// Plane strain or axisymmetric.
    pub formulation: Formulation,
    /// One material, or two.
    pub layers: Layers,
    /// Half or full section.
    pub section: Section,
    /// Radius of the rigid core of a round anvil, m.
    pub core_radius: Real,
    /// Thickness of the silicone, m; of the whole layer where there is one.
    pub silicone_thickness: Real,
    /// Thickness of the skin on top of it where there are two layers, m.
    pub skin_thickness: Real,
    /// Largest out-of-plane thickness in plane strain, m.
    pub length: Real,
    /// Full width (plane strain) or diameter (axisymmetric) of a block, m.
    pub block_width: Real,
}

impl Geometry {
    /// Thickness of the whole soft layer, m.
    pub fn layer_thickness(&self) -> Real {
        match self.layers {
            Layers::One => self.silicone_thickness,
            Layers::Two => self.silicone_thickness + self.skin_thickness,
        }
    }
}

/// How the impactor moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// A free mass that falls.
    Drop,
    /// The position is given from outside at every step.
    Driven,
    /// Down at a speed to a depth, then hold; see [`crate::prescribed`].
    Prescribed,
}

/// Which of the three numbers states the drop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropBy {
    /// [`Impactor::drop_height`].
    Height,
    /// [`Impactor::drop_energy`].
    Energy,
    /// [`Impactor::drop_speed`].
    Speed,
}

/// The drop mass: rigid, flat, one vertical degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impactor {
    /// Free, driven or prescribed.
    pub motion: Motion,
    /// Mass, kg.
    pub mass: Real,
    /// Diameter of the flat face, m.
    pub face_diameter: Real,
    /// Distance of the face's centre from the centre line, m, to the right (full section).
    pub offset: Real,
    /// Height of the face above the anvil at the start, m.
    pub gap: Real,
    /// Acceleration of gravity on the impactor, m/s2.
    pub gravity: Real,
    /// Which of the next three counts.
    pub drop_by: DropBy,
    /// Free fall before the start, m: speed sqrt(2 g h).
    pub drop_height: Real,
    /// Kinetic energy at the start, J.
    pub drop_energy: Real,
    /// Speed at the start, m/s.
    pub drop_speed: Real,
    /// Speed of the prescribed motion, m/s, downwards.
    pub prescribed_speed: Real,
    /// Depth below the undeformed anvil at which it ends, m.
    pub prescribed_depth: Real,
    /// Time over which its speed rises at the start and falls at the end, s.
    pub prescribed_rise: Real,
}

impl Impactor {
    /// Downward speed at the start, m/s, from whichever of height, energy and speed is chosen.
    pub fn start_speed(&self) -> Real {
        match self.drop_by {
            DropBy::Height => crate::math::sqrt(2.0 * self.gravity * self.drop_height),
            DropBy::Energy => crate::math::sqrt(2.0 * self.drop_energy / self.mass),
            DropBy::Speed => self.drop_speed,
        }
    }

    /// The same mass dropped with a kinetic energy of `energy` J.
    pub fn with_energy(self, energy: Real) -> Self {
        Self { drop_by: DropBy::Energy, drop_energy: energy, ..self }
    }
}

/// The volumetric law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VolumetricLaw {
    /// K/2 (J - 1)^2.
    Quadratic,
    /// K/4 (J^2 - 1 - 2 ln J), without bound as J goes to 0.
    Simo,
}

/// Which of the two numbers states the compressibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VolumetricBy {
    /// [`Material::bulk_modulus`].
    BulkModulus,
    /// [`Material::poissons_ratio`], by K = 2 G (1 + nu) / (3 (1 - 2 nu)) with the shear modulus G at rest of the
    /// long-term law.
    PoissonsRatio,
}

/// The isochoric hyperelastic law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Moduli {
    /// The law after full relaxation.
    LongTerm,
    /// The law before any relaxation; the long-term law is g_inf = 1 - sum g_i times it.
    Instantaneous,
}

/// A visco-hyperelastic material with frequency-independent damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Density, kg/m3.
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

    /// Factor from the given coefficients to the long-term law.
    pub fn long_term_scale(&self) -> Real {
        match self.moduli {
            Moduli::LongTerm => 1.0,
            Moduli::Instantaneous => self.prony_g_inf(),
        }
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

/// How the layer sits on the core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interface {
    /// Glued: no relative motion.
    Bonded,
    /// Unilateral contact with Coulomb friction.
    Frictional,
    /// Neither lifts nor rubs: rollers.
    Sliding,
}

/// Interface between layer and core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoreInterface {
    /// Bonded or frictional.
    pub interface: Interface,
    /// Coulomb coefficient of a frictional interface.
    pub friction_coefficient: Real,
}

/// Interface between impactor and layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceInterface {
    /// Coulomb coefficient under the impactor.
    pub friction_coefficient: Real,
}

/// Spatial discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh {
    /// Edge length that the structured mesh aims at, m.
    pub element_size: Real,
}

/// Which of the two numbers states the time step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepBy {
    /// [`Time::safety_factor`] times the stability limit of the stiffest expected state.
    SafetyFactor,
    /// [`Time::step`].
    Given,
}

/// Temporal discretisation and simulated time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// Which of the next two counts.
    pub step_by: StepBy,
    /// Fraction of the stability limit.
    pub safety_factor: Real,
    /// Requested step, s; the largest whole divisor of the sampling interval not above it is used.
    pub step: Real,
    /// Part of the layer's thickness that a driven face is expected to press it by at most; the step is chosen for it.
    pub design_compression: Real,
    /// Simulated time that a run covers unless told otherwise, s.
    pub duration: Real,
}

/// How the numbers of the test are read from the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Force that begins and ends the impact duration, N.
    pub force_threshold: Real,
    /// Channel frequency class of the filtered force (SAE J211, ISO 6487), Hz.
    pub channel_class: Real,
}

impl Scenario {
    /// Checks every parameter against its legal range, then what several parameters say together.
    ///
    /// # Errors
    /// The first refused value, by name, with its unit and legal range.
    pub fn validate(&self) -> Result<(), ScenarioError> {
        for parameter in PARAMETERS {
            parameter.check(parameter.get(self))?;
        }
        self.layers().iter().try_for_each(Layer::validate)?;
        self.validate_geometry()
    }

    /// The layers from the core to the surface; one material through the whole thickness counts for both.
    pub fn layers(&self) -> [Layer<'_>; MAX_LAYERS] {
        let silicone = Layer { name: "silicone", material: &self.silicone };
        let skin = match self.geometry.layers {
            Layers::One => silicone,
            Layers::Two => Layer { name: "skin", material: &self.skin },
        };
        [silicone, skin]
    }

    fn validate_geometry(&self) -> Result<(), ScenarioError> {
        let geometry = &self.geometry;
        if geometry.layers == Layers::Two && geometry.skin_thickness < MIN_SKIN {
            return Err(ScenarioError::SkinTooThin { thickness: geometry.skin_thickness, minimum: MIN_SKIN });
        }
        let outer = geometry.core_radius + geometry.layer_thickness();
        let chord_ends = geometry.shape == Shape::Round && geometry.formulation == Formulation::PlaneStrain;
        let reach = FACE_MARGIN * outer + crate::math::abs(self.impactor.offset);
        if geometry.section == Section::Full && geometry.formulation == Formulation::Axisymmetric {
            return Err(ScenarioError::FullAxisymmetric);
        }
        if geometry.section == Section::Half && self.impactor.offset != 0.0 {
            return Err(ScenarioError::OffsetOfHalf { offset: self.impactor.offset });
        }
        if chord_ends && 0.5 * self.impactor.face_diameter < reach {
            let minimum = 2.0 * reach;
            return Err(ScenarioError::FaceTooSmall { diameter: self.impactor.face_diameter, minimum });
        }
        Ok(())
    }
}

impl Layer<'_> {
    fn validate(&self) -> Result<(), ScenarioError> {
        let (layer, material) = (self.name, self.material);
        if material.prony_g_inf() <= 0.0 {
            return Err(ScenarioError::PronySum { layer, sum: 1.0 - material.prony_g_inf() });
        }
        let modulus = material.shear_modulus_inf();
        if modulus <= 0.0 {
            return Err(ScenarioError::ShearModulus { layer, law: material.law, modulus });
        }
        let stretch = material.tear_stretch;
        if stretch > 0.0 && stretch < 1.0 {
            return Err(ScenarioError::TearStretch { layer, stretch });
        }
        Ok(())
    }
}

/// Thinnest skin with a material of its own, m: as thin as the smallest element.
const MIN_SKIN: Real = 1e-5;

/// The face's chord is the thickness of the section, so the face must reach past the anvil's side by this factor.
const FACE_MARGIN: Real = 1.02;
