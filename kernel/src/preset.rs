//! Ready-made scenarios. The parameter sets stand here and nowhere else.

use crate::scenario::{
    CoreInterface, DropBy, FaceInterface, Formulation, Geometry, Impactor, Interface, Material, Measurement, Mesh,
    Moduli, Motion, Scenario, Section, Shape, StepBy, Time, VolumetricBy,
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
            section: Section::Half,
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
            offset: 0.0,
            gap: 2e-3,
            gravity: 9.81,
            drop_by: DropBy::Energy,
            drop_height: 0.3,
            drop_energy: 14.7,
            drop_speed: 2.42,
        },
        silicone: study_silicone(),
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
        moduli: Moduli::LongTerm,
        c10: 0.101e6,
        c01: 0.0658e6,
        c11: 0.0274e6,
        c20: 0.00133e6,
        c02: 0.0515e6,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus: 1.67e6,
        poissons_ratio: 0.48,
        prony_g: [19.9 / 21.25, 0.35 / 21.25, 0.0, 0.0, 0.0],
        prony_tau: [0.38e-3, 22e-3, 1.0, 1.0, 1.0],
        slider_stiffness: 61.6e6,
        slider_yield_stress: 0.126e6,
    }
}
