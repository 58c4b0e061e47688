//! Scenarios to measure.

use softanvil_kernel::material::{ElasticLaw, Material, MooneyRivlin, Variant, VolumetricBy};
use softanvil_kernel::scenario::{Body, DropBy, Formulation, StepBy, Symmetry};
use softanvil_kernel::{Scenario, preset};

/// Element sizes, m, from some 70 to some 100,000 triangles. All but the first fill their lanes: the last block of a row
/// holds as many cells as the others.
pub const ELEMENT_SIZES: [f64; 9] = [5.9e-3, 4.42e-3, 3e-3, 1.77e-3, 1.47e-3, 0.736e-3, 0.368e-3, 0.2e-3, 0.145e-3];

/// The study's drop on a mesh of `element_size` m.
pub fn sized(element_size: f64) -> Scenario {
    let mut scenario = preset::study();
    scenario.mesh.element_size = element_size;
    scenario
}

/// The smallest mesh that still fills a row: a step is so short that the cost of a call shows.
pub fn tiny() -> Scenario {
    sized(15e-3)
}

/// The study's drop with other material.
pub fn with_material(material: Material) -> Scenario {
    let mut scenario = preset::study();
    scenario.layers[0].material = material;
    scenario
}

/// A part of the study's anvil in three dimensions, with a face on it that moves down; its step is given, so that no trial is made.
pub fn solid(material: Material, symmetry: Symmetry, element_size: f64) -> Scenario {
    let mut scenario = with_material(material);
    (scenario.geometry.formulation, scenario.geometry.body) = (Formulation::Solid, Body::Prism);
    (scenario.geometry.symmetry, scenario.mesh.element_size) = (symmetry, element_size);
    (scenario.impactor.gap, scenario.impactor.drop_by) = (0.0, DropBy::Energy);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 2e-6);
    scenario
}

/// Silicone without Prony terms and slider; its bulk modulus takes the study's drop without them.
fn bare() -> Material {
    Material {
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus: 1.5e6,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..preset::study().layers[0].material
    }
}

/// Shear modulus at rest, Pa, that takes the study's drop without memory or damping.
const STIFF_ENOUGH: f64 = 0.5e6;

/// The same of a foam.
const STIFF_FOAM: f64 = 4e6;

/// The elastic laws alone, each with all of its coefficients.
pub fn laws() -> Vec<(&'static str, Material)> {
    let law = |law: &ElasticLaw| {
        let description = law.description();
        let example = bare().with_values(*law, description.example);
        let modulus = if description.compressible { STIFF_FOAM } else { STIFF_ENOUGH };
        let coefficients = example.coefficients.scaled(modulus / example.shear_modulus_inf());
        let label = description.variants.last().map_or(description.label, |variant| variant.label);
        (label, Material { coefficients, ..example })
    };
    ElasticLaw::ALL.iter().map(law).collect()
}

/// A law of five coefficients with 0, 2 and 5 Prony terms, without and with the slider.
pub fn overlays() -> Vec<(String, Material)> {
    let series = [[0.0; 5], [0.94, 0.04, 0.0, 0.0, 0.0], [0.3, 0.25, 0.2, 0.15, 0.05]];
    let mut overlays = Vec::new();
    for prony_g in series {
        let terms = prony_g.iter().filter(|g| **g > 0.0).count();
        for slider in [false, true] {
            let (stiffness, limit) = if slider { (0.6e6, 1.3e3) } else { (0.0, 0.0) };
            let material = Material {
                prony_g,
                prony_tau: [0.3e-3, 1e-3, 10e-3, 0.1, 1.0],
                slider_stiffness: stiffness,
                slider_yield_stress: limit,
                ..bare().with(MooneyRivlin { c10: 0.15e6, c01: 0.1e6, c11: 0.09e6, c20: 0.1e3, c02: 15e3 })
            };
            let name = format!("{terms} Prony terms{}", if slider { ", slider" } else { "" });
            overlays.push((name, material));
        }
    }
    overlays
}

/// A law of five coefficients and foams of one to three terms, all with two Prony terms and the slider.
pub fn foams() -> Vec<(&'static str, Material)> {
    let (law, description) = (ElasticLaw::Hyperfoam, ElasticLaw::Hyperfoam.description());
    let damped = |material: Material| Material {
        prony_g: [0.3, 0.25, 0.0, 0.0, 0.0],
        prony_tau: [0.3e-3, 1e-3, 10e-3, 0.1, 1.0],
        slider_stiffness: 0.6e6,
        slider_yield_stress: 1.3e3,
        ..material
    };
    let foam = |variant: &Variant| {
        let example = bare().with_values(law, &description.example[..variant.n_coefficient]);
        let coefficients = example.coefficients.scaled(STIFF_FOAM / example.shear_modulus_inf());
        (variant.label, damped(Material { coefficients, ..example }))
    };
    let rubber = bare().with(MooneyRivlin { c10: 0.15e6, c01: 0.1e6, c11: 0.09e6, c20: 0.1e3, c02: 15e3 });
    [("Mooney-Rivlin 5", damped(rubber))].into_iter().chain(description.variants.iter().map(foam)).collect()
}
