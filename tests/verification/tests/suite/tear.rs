//! Tearing: nothing before the limit, the residual after the width, no return, and the energy it takes.
//!
//! Source: isotropic damage driven by the largest stretch so far, e.g. Simo, Computer Methods in Applied Mechanics and
//! Engineering 60 (1987): stress phi times that of the whole material, dissipation -phi' W. The fall is the cubic
//! smoothstep x^2 (3 - 2 x), and the planar extension of neo-Hooke has W = C10 (l - 1/l)^2.

use softanvil_kernel::scenario::{Formulation, Layers, Material};
use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_verification::element::{Cell, Gradient};
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_RESIDUAL, TEAR_ENERGY, relative_error};

const LIMIT: f64 = 1.3;
const WIDTH: f64 = 0.2;
const RESIDUAL: f64 = 0.1;
const C10: f64 = 0.1e6;

fn tearing(material: Material) -> Material {
    Material { tear_stretch: LIMIT, tear_width: WIDTH, tear_residual: RESIDUAL, ..material }
}

fn cell(material: Material) -> Cell {
    Cell::new(material, Formulation::PlaneStrain, 1e-5)
}

fn planar(l: f64) -> Gradient {
    [[1.0 / l, 0.0], [0.0, l]]
}

/// phi after the largest stretch `m`.
fn factor(m: f64) -> f64 {
    let x = ((m - LIMIT) / WIDTH).clamp(0.0, 1.0);
    1.0 - (1.0 - RESIDUAL) * x * x * (3.0 - 2.0 * x)
}

/// There and back over the limit, with the stress against that of the material that does not tear.
#[test]
fn the_stress_falls_once_and_for_all() {
    let (mut torn, mut whole) = (cell(tearing(elastic(C10, 0.0, 1e6))), cell(elastic(C10, 0.0, 1e6)));
    let mut largest = 1.0_f64;
    for l in [1.1, 1.3, 1.2, 1.35, 1.1, 1.0, 1.35, 1.42, 0.8, 1.42, 1.5, 1.7, 1.05, 1.2] {
        // Compression across is a stretch along the other direction.
        largest = largest.max(l).max(1.0 / l);
        let (stress, expected) = (torn.deform(planar(l)), whole.deform(planar(l)));
        for i in 0..2 {
            let reference = factor(largest) * expected[i][i];
            assert!((stress[i][i] - reference).abs() < CLOSED_FORM * C10, "{l} after {largest}: {}", stress[i][i]);
        }
    }
    assert!(relative_error(factor(largest), RESIDUAL) < CLOSED_FORM);
}

/// A torn layer still carries pressure: the volumetric stress is untouched.
#[test]
fn pressure_survives() {
    let (mut torn, mut whole) = (cell(tearing(elastic(C10, 0.0, 1e6))), cell(elastic(C10, 0.0, 1e6)));
    torn.deform(planar(2.0));
    let squeezed = [[0.9, 0.0], [0.0, 0.9]];
    let (a, b) = (torn.deform(squeezed), whole.deform(squeezed));
    let deviatoric = b[0][0] - 1e6 * (0.81 - 1.0) * 0.9;
    assert!(relative_error(a[0][0], b[0][0] - (1.0 - RESIDUAL) * deviatoric) < CLOSED_FORM, "{a:?} {b:?}");
}

/// Work of the nodal forces along a path of planar stretches, J/m3.
fn work(cell: &mut Cell, path: impl Iterator<Item = f64>) -> f64 {
    let mut work = 0.0;
    let mut before = (planar(1.0), cell.deform(planar(1.0)));
    for l in path {
        let gradient = planar(l);
        let stress = cell.deform(gradient);
        for i in 0..2 {
            work += 0.5 * (stress[i][i] + before.1[i][i]) * (gradient[i][i] - before.0[i][i]);
        }
        before = (gradient, stress);
    }
    work
}

#[test]
fn the_energy_of_a_tear_is_that_of_the_closed_form() {
    let mut torn = cell(tearing(elastic(C10, 0.0, 1e6)));
    let path = (0..=4000).map(|n| 1.0 + 0.7 * f64::from(n) / 4000.0);
    let work = work(&mut torn, path);
    // Simpson's rule over -phi' W from the limit to the end of the width.
    let integrand = |x: f64| {
        let l = LIMIT + WIDTH * x;
        (1.0 - RESIDUAL) * 6.0 * x * (1.0 - x) * C10 * (l - 1.0 / l) * (l - 1.0 / l)
    };
    let simpson: f64 = (0..1000)
        .map(|n| {
            let (a, h) = (f64::from(n) / 1000.0, 1e-3);
            h / 6.0 * (integrand(a) + 4.0 * integrand(a + 0.5 * h) + integrand(a + h))
        })
        .sum();
    assert!(relative_error(torn.tear, simpson) < TEAR_ENERGY, "{} J/m3 against {simpson} J/m3", torn.tear);
    let booked = torn.tear + torn.elastic_energy;
    assert!(relative_error(booked, work) < TEAR_ENERGY, "{booked} J/m3 against {work} J/m3");
}

/// With every mechanism at once the books still balance, and tearing never gives energy back.
#[test]
fn the_ledger_closes_with_memory_and_damping() {
    let mut material = tearing(elastic(C10, 0.0, 1e6));
    material.prony_g[0] = 0.6;
    material.prony_tau[0] = 5e-3;
    material.maxwell_g[0] = 0.05e6;
    material.slider_stiffness = 1e6;
    material.slider_yield_stress = 0.02e6;
    let mut torn = cell(material);
    // Three ever larger swings between extension and compression.
    let path = (0..=12_000).map(|n| {
        let phase = f64::from(n) / 4000.0;
        (0.2 * phase * (2.0 * std::f64::consts::PI * phase).sin()).exp()
    });
    let work = work(&mut torn, path);
    let booked = torn.elastic_energy + torn.viscous_work + torn.slider_stored + torn.slider_dissipation + torn.tear;
    assert!(torn.tear > 0.0);
    assert!(relative_error(booked, work) < TEAR_ENERGY, "{booked} J/m3 against {work} J/m3");
}

/// Source: conservation of energy, in a drop that tears the skin, and in one that tears the silicone.
#[test]
fn energy_closes_in_a_drop_that_tears() {
    for (layers, tear) in [(Layers::Two, 1.1), (Layers::One, 1.02)] {
        let mut scenario = preset::study();
        scenario.geometry.layers = layers;
        let layer = if layers == Layers::Two { &mut scenario.skin } else { &mut scenario.silicone };
        (layer.tear_stretch, layer.tear_width, layer.tear_residual) = (tear, 0.1, 0.05);
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let mut torn = 0.0;
        for _ in 0..simulation.constants().steps_in(scenario.time.duration) {
            simulation.step(1, &StepInput::default()).expect("a stable run");
            let ledger = simulation.scalars().energy;
            assert!(ledger.tear >= torn, "{} J after {torn} J", ledger.tear);
            torn = ledger.tear;
            assert!(ledger.residual().abs() < ENERGY_RESIDUAL * 14.7, "{layers:?}: {} J", ledger.residual());
        }
        assert!(torn > 1e-3, "{layers:?}: {torn} J");
    }
}
