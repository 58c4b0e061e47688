//! Ready-made scenarios. The parameter sets stand here and nowhere else.

use crate::scenario::{
    CoreInterface, DropBy, ElasticLaw, FaceInterface, Formulation, Geometry, Impactor, Interface, Layers, Material,
    Measurement, Mesh, Moduli, Motion, Scenario, Shape, StepBy, Time, VolumetricBy, VolumetricLaw,
};

/// The soft anvil of "Finite element model to simulate impact on a soft tissue simulant", Sports Engineering (2023),
/// doi 10.1007/s12283-023-00407-7, dropped on with 14.7 J.
///
/// Geometry, impactor, density, friction under the face and element size are the paper's. The coefficients of its
/// material models are not published; [`study_silicone`] and the effective length were identified with this kernel
/// from the paper's measured drops.
pub fn study() -> Scenario {
    Scenario {
        geometry: Geometry {
            shape: Shape::Round,
            formulation: Formulation::PlaneStrain,
            layers: Layers::One,
            core_radius: 37.5e-3,
            silicone_thickness: 14e-3,
            skin_thickness: 1e-3,
            length: 99e-3,
            block_width: 30e-3,
        },
        impactor: Impactor {
            motion: Motion::Drop,
            mass: 5.0,
            face_diameter: 130e-3,
            gap: 2e-3,
            gravity: 9.81,
            drop_by: DropBy::Energy,
            drop_height: 0.3,
            drop_energy: 14.7,
            drop_speed: 2.42,
        },
        silicone: study_silicone(),
        skin: chamois(),
        core: CoreInterface { interface: Interface::Bonded, friction_coefficient: 0.3 },
        face: FaceInterface { friction_coefficient: 0.3 },
        mesh: Mesh { element_size: 3e-3 },
        time: Time { step_by: StepBy::SafetyFactor, safety_factor: 0.9, step: 2e-6, duration: 15e-3 },
        measurement: Measurement { force_threshold: 50.0 },
    }
}

/// The silicone of [`study`].
fn study_silicone() -> Material {
    Material {
        density: 1072.0,
        law: ElasticLaw::MooneyRivlin,
        moduli: Moduli::LongTerm,
        c10: 0.101e6,
        c01: 0.0658e6,
        c11: 0.0274e6,
        c20: 0.00133e6,
        c02: 0.0515e6,
        c30: 0.0,
        ogden_mu: [0.0; 3],
        ogden_alpha: [2.0, -2.0, 4.0],
        volumetric_law: VolumetricLaw::Quadratic,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus: 1.67e6,
        poissons_ratio: 0.48,
        prony_g: [19.9 / 21.25, 0.35 / 21.25, 0.0, 0.0, 0.0],
        prony_tau: [0.38e-3, 22e-3, 1.0, 1.0, 1.0],
        maxwell_g: [0.0; 5],
        maxwell_beta: [1e3; 5],
        slider_stiffness: 61.6e6,
        slider_yield_stress: 0.126e6,
        tear_stretch: 0.0,
        tear_width: 0.1,
        tear_residual: 0.0,
    }
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
        volumetric_by: VolumetricBy::PoissonsRatio,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..study_silicone()
    }
}
