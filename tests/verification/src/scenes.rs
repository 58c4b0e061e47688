//! Scenarios and runs that several problems use.

use softanvil_kernel::scenario::{Interface, Material, Moduli, Motion, Shape, VolumetricBy};
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
        c10,
        c01,
        c11: 0.0,
        c20: 0.0,
        c02: 0.0,
        volumetric_by: VolumetricBy::BulkModulus,
        bulk_modulus,
        prony_g: [0.0; 5],
        slider_stiffness: 0.0,
        slider_yield_stress: 0.0,
        ..preset::study().silicone
    }
}

/// A flat block of `width` by `height` m on a frictionless core under a frictionless face that nothing moves.
pub fn block(width: f64, height: f64, material: Material) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.shape = Shape::Block;
    scenario.geometry.block_width = width;
    scenario.geometry.silicone_thickness = height;
    scenario.geometry.skin_thickness = 0.0;
    scenario.impactor.motion = Motion::Driven;
    scenario.core.interface = Interface::Frictional;
    scenario.core.friction_coefficient = 0.0;
    scenario.face.friction_coefficient = 0.0;
    scenario.silicone = material;
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
