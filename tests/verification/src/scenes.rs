//! Scenarios and runs that several problems use.

use crate::deformation::Samples;
use softanvil_kernel::material::{ElasticLaw, Material, Moduli, MooneyRivlin, Ogden, VolumetricBy, VolumetricLaw};
use softanvil_kernel::scenario::{Interface, Motion, Shape};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};

/// The impact energies of the study, J.
pub const ENERGIES: [f64; 3] = [4.9, 9.8, 14.7];

/// The study's drop with `energy` J on a mesh of `element_size` m, run to its end.
pub fn study_drop(energy: f64, element_size: f64) -> Simulation {
    let mut scenario = preset::study();
    scenario.impactor = scenario.impactor.with_energy(energy);
    scenario.mesh.element_size = element_size;
    run(&scenario)
}

/// A drop run to its end.
pub fn run(scenario: &Scenario) -> Simulation {
    let mut simulation = Simulation::new(scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(scenario.time.duration);
    simulation.step(steps, &StepInput::default()).expect("a stable run");
    simulation
}

/// Mooney-Rivlin without memory or damping.
pub fn elastic(c10: f64, c01: f64, bulk_modulus: f64) -> Material {
    Material {
        moduli: Moduli::LongTerm,
        volumetric_law: VolumetricLaw::Quadratic,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..preset::study().layers[0].material.with(MooneyRivlin { c10, c01, ..MooneyRivlin::ZERO })
    }
}

/// Ogden's law without memory or damping.
pub fn ogden(bulk_modulus: f64, mu: [f64; 3], alpha: [f64; 3]) -> Material {
    elastic(0.0, 0.0, bulk_modulus).with(Ogden::new(mu, alpha))
}

/// The example of each law, and of each number of its coefficients, without memory or damping.
pub fn laws(bulk_modulus: f64) -> Vec<(&'static str, Material)> {
    let of_law = |law: &ElasticLaw| {
        let (law, description) = (*law, law.description());
        description.variants.iter().map(move |variant| {
            let values = &description.example[..variant.n_coefficient];
            (variant.label, elastic(0.0, 0.0, bulk_modulus).with_values(law, values))
        })
    };
    ElasticLaw::ALL.iter().flat_map(of_law).collect()
}

/// A law at random without memory or damping, as stiff at rest as a neo-Hookean material of the coefficient `c10`, Pa: any of
/// the kernel's, with any number of coefficients, which are drawn from where they are plausible.
pub fn random_law(samples: &mut Samples, c10: f64) -> Material {
    let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + samples.number());
    let laws: Vec<_> = ElasticLaw::ALL
        .iter()
        .flat_map(|law| law.description().variants.iter().map(move |variant| (*law, variant.n_coefficient)))
        .collect();
    let (law, n) = laws[(between(0.0, laws.len() as f64) as usize).min(laws.len() - 1)];
    let plausible = law.description().coefficients[..n].iter().map(|coefficient| coefficient.plausible);
    let mut values: Vec<f64> = plausible.map(|(low, high)| between(low, high)).collect();
    // Alone, a term of Ogden's may have an exponent of either sign, and be weak.
    if let (ElasticLaw::Ogden, [_, alpha]) = (law, &mut values[..]) {
        let size = between(0.5, 6.0);
        *alpha = if between(0.0, 1.0) < 0.5 { size } else { -size };
    }
    let material = elastic(0.0, 0.0, 1e6).with_values(law, &values);
    let coefficients = material.coefficients.scaled(2.0 * c10 / material.shear_modulus_inf());
    Material { coefficients, ..material }
}

/// A flat block of `width` by `height` m on a frictionless core under a frictionless face that covers it and that nothing moves.
pub fn block(width: f64, height: f64, material: Material) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.shape = Shape::Block;
    scenario.geometry.block_width = width;
    scenario.layers[0].thickness = height;
    scenario.impactor.motion = Motion::Driven;
    scenario.impactor.face_diameter = scenario.impactor.face_diameter.max(1.1 * width);
    scenario.core.interface = Interface::Frictional;
    scenario.core.friction_coefficient = 0.0;
    scenario.face.friction_coefficient = 0.0;
    scenario.layers[0].material = material;
    scenario
}

/// A block of `n_u` by `n_v` cells, held at its base and far below the face, for bodies whose nodes are placed by
/// [`Simulation::with_positions`].
pub fn grid(n_u: usize, n_v: usize, material: Material) -> Scenario {
    let mut scenario = block(2.0 * n_u as f64 * GRID_CELL, n_v as f64 * GRID_CELL, material);
    scenario.mesh.element_size = GRID_CELL;
    scenario.core.interface = Interface::Bonded;
    scenario.impactor.gap = 1.0;
    scenario.geometry.length = 1.0;
    scenario
}

/// Nominal cell of [`grid`], m, which only the count of cells depends on.
const GRID_CELL: f64 = 1e-3;

/// Neo-Hookean with a shear modulus, Pa, and a bulk modulus, Pa.
pub fn neo_hookean(shear_modulus: f64, bulk_modulus: f64) -> Material {
    elastic(0.5 * shear_modulus, 0.0, bulk_modulus)
}
