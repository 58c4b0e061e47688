//! What the surface shows under a face that presses a block which is free to slide: everything is uniform.
//!
//! Source: the mean pressure is the force over the area of the face, 2 w L of a block and pi r^2 of a cylinder; at small strain
//! e their sides give way by nu / (1 - nu) e (plane strain) and nu e (cylinder).

use std::f64::consts::PI;

use softanvil_kernel::material::VolumetricBy;
use softanvil_kernel::scenario::{Formulation, Section};
use softanvil_kernel::{Field, Simulation};
use softanvil_verification::relaxation::press_slowly;
use softanvil_verification::scenes::{block, elastic};
use softanvil_verification::tolerance::{FLAT_PRESSURE, FLAT_WIDTH, relative_error};

const HALF_WIDTH: f64 = 16e-3;
const HEIGHT: f64 = 8e-3;
const LENGTH: f64 = 50e-3;
const STRAIN: f64 = 1e-3;
const POISSONS_RATIO: f64 = 0.3;

#[test]
fn pressure_and_width_of_half_a_block() {
    check(Formulation::PlaneStrain, Section::Half, 16);
}

#[test]
fn pressure_and_width_of_a_whole_block() {
    check(Formulation::PlaneStrain, Section::Full, 32);
}

#[test]
fn pressure_and_width_of_a_cylinder() {
    check(Formulation::Axisymmetric, Section::Half, 16);
}

fn check(formulation: Formulation, section: Section, cells: usize) {
    use Formulation::{Axisymmetric, PlaneStrain};
    let mut material = elastic(0.1e6, 0.0, 1e6);
    (material.volumetric_by, material.poissons_ratio) = (VolumetricBy::PoissonsRatio, POISSONS_RATIO);
    let mut scenario = block(2.0 * HALF_WIDTH, HEIGHT, material);
    (scenario.geometry.formulation, scenario.geometry.section) = (formulation, section);
    (scenario.geometry.length, scenario.mesh.element_size, scenario.impactor.gap) = (LENGTH, 1e-3, 0.0);
    let mut simulation = Simulation::new(&scenario).expect("a legal block");
    let force = press_slowly(&mut simulation, STRAIN * HEIGHT, 2e-3, 0.5e-3);
    let widening = match formulation {
        PlaneStrain | Formulation::Solid => POISSONS_RATIO / (1.0 - POISSONS_RATIO) * STRAIN,
        Axisymmetric => POISSONS_RATIO * STRAIN,
    };
    let half_width = HALF_WIDTH * (1.0 + widening);
    let area = match formulation {
        PlaneStrain | Formulation::Solid => 2.0 * half_width * LENGTH,
        Axisymmetric => PI * half_width * half_width,
    };
    let what = format!("{formulation:?}, {section:?}");
    let found = simulation.scalars().contact_half_width;
    assert!(relative_error(found, half_width) < FLAT_WIDTH, "{what}: {found} m against {half_width} m");
    let shown = simulation.with(|model, state| {
        let field = Field::find("surface.contact_pressure").expect("a field");
        (0..=cells).map(|u| field.value(model, &state.as_view(), 0, u, 0).expect("a column")).collect::<Vec<f64>>()
    });
    // The node on the axis and that at the rim have less of the force than of the area, or more.
    for pressure in &shown.expect("memory of the right size")[1..cells] {
        let expected = force / area;
        assert!(relative_error(*pressure, expected) < FLAT_PRESSURE, "{what}: {pressure} Pa against {expected} Pa");
    }
}
