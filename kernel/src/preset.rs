//! Ready-made scenarios. The parameter sets stand here and nowhere else.

use crate::scenario::{
    CoreInterface, DropBy, ElasticLaw, FaceInterface, Formulation, Geometry, Impactor, Interface, Layers, Material,
    Measurement, Mesh, Moduli, Motion, Scenario, Section, Shape, StepBy, Time, VolumetricBy, VolumetricLaw,
};

/// A scenario with a name.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Name.
    pub name: &'static str,
    /// Makes the scenario.
    pub scenario: fn() -> Scenario,
    /// Meaning, one line.
    pub description: &'static str,
}

/// Every preset; the first is the default.
pub static PRESETS: &[Preset] = &[
    Preset {
        name: "study",
        scenario: study,
        description: "the soft anvil of the study, one set of parameters for 4.9, 9.8 and 14.7 J",
    },
    Preset {
        name: "study-14.7",
        scenario: study_14_7,
        description: "the soft anvil of the study, tuned at 14.7 J alone, as its own model was",
    },
];

/// The soft anvil of "Finite element model to simulate impact on a soft tissue simulant", Sports Engineering (2023),
/// doi 10.1007/s12283-023-00407-7, dropped on with 14.7 J.
///
/// Geometry, impactor, density, friction under the face and element size are the paper's; the core is bonded, as in its
/// experiment. The coefficients of its material models are not published: [`study_silicone`] and the effective length
/// (the largest out-of-plane thickness) were identified with this kernel from the twelve numbers of its measured drops.
/// The force threshold of the impact duration, which the paper does not state, is just under 1 % of its smallest peak.
pub fn study() -> Scenario {
    Scenario {
        geometry: Geometry {
            shape: Shape::Round,
            formulation: Formulation::PlaneStrain,
            layers: Layers::One,
            section: Section::Half,
            core_radius: 37.5e-3,
            silicone_thickness: 14e-3,
            skin_thickness: 1e-3,
            length: 150e-3,
            block_width: 30e-3,
        },
        impactor: Impactor {
            motion: Motion::Drop,
            mass: 5.0,
            face_diameter: 130e-3,
            offset: 0.0,
            gap: 2e-3,
            gravity: 9.81,
            drop_by: DropBy::Energy,
            drop_height: 0.3,
            drop_energy: 14.7,
            drop_speed: 2.42,
            prescribed_speed: 0.1,
            prescribed_depth: 5e-3,
            prescribed_rise: 5e-3,
        },
        silicone: study_silicone(),
        skin: chamois(),
        core: CoreInterface { interface: Interface::Bonded, friction_coefficient: 0.3 },
        face: FaceInterface { friction_coefficient: 0.3 },
        mesh: Mesh { element_size: 3e-3 },
        time: Time {
            step_by: StepBy::SafetyFactor,
            safety_factor: 0.9,
            step: 2e-6,
            design_compression: 0.4,
            duration: 15e-3,
        },
        measurement: Measurement { force_threshold: 20.0, channel_class: 600.0 },
    }
}

/// The silicone of [`study`]: the best of `calibration/all.toml`, rounded, for all twelve numbers of Table 1, with a step
/// of at least an eighth of a sampling interval.
///
/// `docs/protocols.md` says what the numbers pin. The fast Prony term does nearly all of the damping, and the damping
/// spring and slider little, although the paper uses them; the slow one acts as elasticity in an impact and relaxes in
/// seconds. Poisson's ratio is low because it also stands for what flows out of the plane of the section.
/// It is a fit to impacts: with so low a bulk modulus the quadratic law gives way where the volume is halved, and a free
/// cylinder pressed at 0.67 1/s has no equilibrium beyond 46 % strain. [`study_14_7`] has one.
fn study_silicone() -> Material {
    // Instantaneous overstress of the two Prony terms over the long-term stress.
    let overstress = [83.5, 4.0];
    let instantaneous = 1.0 + overstress[0] + overstress[1];
    Material {
        density: 1072.0,
        law: ElasticLaw::MooneyRivlin,
        moduli: Moduli::LongTerm,
        c10: 97.8e3,
        c01: 5.6e3,
        c11: 0.22e3,
        c20: 2.04e3,
        c02: 10.8e3,
        c30: 0.0,
        ogden_mu: [0.0; 3],
        ogden_alpha: [2.0, -2.0, 4.0],
        volumetric_law: VolumetricLaw::Quadratic,
        volumetric_by: VolumetricBy::PoissonsRatio,
        bulk_modulus: 0.448e6,
        poissons_ratio: 0.30,
        prony_g: [overstress[0] / instantaneous, overstress[1] / instantaneous, 0.0, 0.0, 0.0],
        prony_tau: [0.284e-3, 3.0, 1.0, 1.0, 1.0],
        maxwell_g: [0.0; 5],
        maxwell_beta: [1e3; 5],
        slider_stiffness: 0.585e6,
        slider_yield_stress: 1.34e3,
        tear_stretch: 0.0,
        tear_width: 0.1,
        tear_residual: 0.0,
    }
}

/// [`study`] with five parameters from the four numbers at 14.7 J alone: the best of `calibration/only-14.7.toml`, rounded.
///
/// One fast Prony term on a law of two coefficients (I1 - 3 and the square of I2 - 3) meets all four; 9.8 and 4.9 J are
/// predictions. Poisson's ratio comes out near the paper's 0.48.
pub fn study_14_7() -> Scenario {
    let study = study();
    let overstress = 47.9;
    let silicone = Material {
        c10: 57.3e3,
        c01: 0.0,
        c11: 0.0,
        c20: 0.0,
        c02: 29.6e3,
        bulk_modulus: 1.51e6,
        poissons_ratio: 0.463,
        prony_g: [overstress / (1.0 + overstress), 0.0, 0.0, 0.0, 0.0],
        prony_tau: [0.561e-3, 1.0, 1.0, 1.0, 1.0],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..study.silicone
    };
    Scenario { silicone, ..study }
}

/// A synthetic chamois for two layers. Not from the study, which gives its skin the silicone's material: the density and
/// the modulus of 3 MPa are of the order of soft leather, and nothing is fitted.
fn chamois() -> Material {
    Material {
        density: 600.0,
        law: ElasticLaw::NeoHookean,
        c10: 0.5e6,
        c01: 0.0,
        c11: 0.0,
        c20: 0.0,
        c02: 0.0,
        poissons_ratio: 0.45,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..study_silicone()
    }
}
