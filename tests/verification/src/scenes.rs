//! Scenarios and runs that several problems use.

use crate::deformation::Samples;
use softanvil_kernel::material::{ElasticLaw, Material, Moduli, VolumetricBy, VolumetricLaw};
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
        law: ElasticLaw::MooneyRivlin,
        moduli: Moduli::LongTerm,
        c10,
        c01,
        c11: 0.0,
        c20: 0.0,
        c02: 0.0,
        volumetric_law: VolumetricLaw::Quadratic,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..preset::study().layers[0].material
    }
}

/// Ogden's law without memory or damping.
pub fn ogden(bulk_modulus: f64, mu: [f64; 3], alpha: [f64; 3]) -> Material {
    Material { law: ElasticLaw::Ogden, ogden_mu: mu, ogden_alpha: alpha, ..elastic(0.0, 0.0, bulk_modulus) }
}

/// One material of each law, and of each number of parameters, without memory or damping.
pub fn laws(bulk_modulus: f64) -> Vec<(&'static str, Material)> {
    let base = elastic(0.1e6, 0.0, bulk_modulus);
    vec![
        ("neo-Hooke", Material { law: ElasticLaw::NeoHookean, ..base }),
        ("Mooney-Rivlin 2", elastic(0.1e6, 0.05e6, bulk_modulus)),
        ("Mooney-Rivlin 3", Material { c11: 0.02e6, ..elastic(0.1e6, 0.05e6, bulk_modulus) }),
        (
            "Mooney-Rivlin 5",
            Material { c11: 0.02e6, c20: 0.004e6, c02: 0.003e6, ..elastic(0.1e6, 0.05e6, bulk_modulus) },
        ),
        ("Yeoh 1", Material { law: ElasticLaw::Yeoh, ..base }),
        ("Yeoh 2", Material { law: ElasticLaw::Yeoh, c20: -0.002e6, ..base }),
        ("Yeoh 3", Material { law: ElasticLaw::Yeoh, c20: -0.002e6, c30: 0.0004e6, ..base }),
        ("Ogden 1", ogden(bulk_modulus, [0.15e6, 0.0, 0.0], [1.3, 0.0, 0.0])),
        ("Ogden 2", ogden(bulk_modulus, [0.02e6, -0.03e6, 0.0], [4.5, -3.1, 0.0])),
        ("Ogden 3", ogden(bulk_modulus, [0.63e6, 0.0012e6, -0.01e6], [1.3, 5.0, -2.0])),
    ]
}

/// A law at random without memory or damping, as stiff at rest as a neo-Hookean material of the coefficient `c10`, Pa.
pub fn random_law(samples: &mut Samples, c10: f64) -> Material {
    let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + samples.number());
    let base = elastic(c10, 0.0, 1e6);
    let part = between(0.0, 1.0);
    let (first, second) = (c10 * part, c10 * (1.0 - part));
    match between(0.0, 7.0) as usize {
        0 => Material { law: ElasticLaw::NeoHookean, ..base },
        1 => Material { c10: first, c01: second, ..base },
        2 => Material { c10: first, c01: second, c11: c10 * between(0.0, 0.4), ..base },
        3 => {
            let [c11, c20, c02] = [0.4, 0.2, 0.2].map(|most| c10 * between(0.0, most));
            Material { c10: first, c01: second, c11, c20, c02, ..base }
        }
        4 => {
            let (c20, c30) = (c10 * between(-0.05, 0.3), c10 * between(0.001, 0.1));
            Material { law: ElasticLaw::Yeoh, c20, c30, ..base }
        }
        5 => {
            let alpha = between(0.5, 6.0);
            let alpha = if between(0.0, 1.0) < 0.5 { alpha } else { -alpha };
            ogden(1e6, [4.0 * c10 / alpha, 0.0, 0.0], [alpha, 2.0, 2.0])
        }
        _ => {
            let alpha = [between(1.0, 6.0), -between(1.0, 6.0), between(4.0, 8.0)];
            let mu = [first / alpha[0], 0.8 * second / alpha[1], 0.2 * second / alpha[2]].map(|mu| 4.0 * mu);
            ogden(1e6, mu, alpha)
        }
    }
}

/// A flat block of `width` by `height` m on a frictionless core under a frictionless face that nothing moves.
pub fn block(width: f64, height: f64, material: Material) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.shape = Shape::Block;
    scenario.geometry.block_width = width;
    scenario.layers[0].thickness = height;
    scenario.impactor.motion = Motion::Driven;
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
