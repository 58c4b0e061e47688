//! Solids that a section describes: a slice between held ends, a dome, a disc.

use softanvil_kernel::scenario::{Body, Ends, Formulation, Interface, Motion, Shape};
use softanvil_kernel::{Scenario, Simulation};
use softanvil_verification::relaxation::press_slowly;
use softanvil_verification::scenes::elastic;

/// A bonded anvil of a plain rubber under a large smooth face.
fn anvil(poissons_ratio: f64, element_size: f64) -> Scenario {
    let bulk_modulus = 0.6e6 * (1.0 + poissons_ratio) / (3.0 * (1.0 - 2.0 * poissons_ratio));
    let mut scenario = softanvil_kernel::preset::study();
    scenario.layers[0].material = elastic(0.15e6, 0.0, bulk_modulus);
    (scenario.core.interface, scenario.face.friction_coefficient) = (Interface::Bonded, 0.0);
    (scenario.impactor.motion, scenario.impactor.gap, scenario.impactor.face_diameter) = (Motion::Driven, 0.0, 0.5);
    (scenario.geometry.length, scenario.mesh.element_size) = (15e-3, element_size);
    scenario
}

/// Force at 3 mm of depth, N.
fn force(scenario: &Scenario) -> f64 {
    press_slowly(&mut Simulation::new(scenario).expect("a legal anvil"), 3e-3, 20e-3, 4e-3)
}

/// Force of a solid over that of the section.
fn ratio(scenario: &Scenario, solid: &Scenario) -> f64 {
    force(solid) / force(scenario)
}

#[test]
fn a_slice_between_held_ends_is_in_plane_strain() {
    for nu in [0.3, 0.48] {
        let mut scenario = anvil(nu, 2.5e-3);
        let section = scenario.clone();
        (scenario.geometry.formulation, scenario.geometry.ends) = (Formulation::Solid, Ends::Held);
        scenario.geometry.length = 5e-3;
        let found = ratio(&section, &scenario) * (section.geometry.length / scenario.geometry.length);
        assert!((found - 1.0).abs() < 5e-3, "nu {nu}: {found}");
    }
}

#[test]
fn a_dome_is_axisymmetric() {
    for nu in [0.3, 0.48] {
        let mut section = anvil(nu, 4e-3);
        section.geometry.formulation = Formulation::Axisymmetric;
        let mut dome = section.clone();
        (dome.geometry.formulation, dome.geometry.body) = (Formulation::Solid, Body::Revolved);
        let found = ratio(&section, &dome);
        assert!((found - 1.0).abs() < 1e-2, "nu {nu}: {found}");
    }
}

#[test]
fn a_disc_is_axisymmetric() {
    for nu in [0.3, 0.48, 0.49] {
        let mut section = anvil(nu, 2.5e-3);
        section.geometry.formulation = Formulation::Axisymmetric;
        (section.geometry.shape, section.geometry.block_width) = (Shape::Block, 40e-3);
        let mut disc = section.clone();
        (disc.geometry.formulation, disc.geometry.body) = (Formulation::Solid, Body::Revolved);
        let found = ratio(&section, &disc);
        assert!((found - 1.0).abs() < 1e-2, "nu {nu}: {found}");
    }
}
