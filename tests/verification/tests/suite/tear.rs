//! Tearing: nothing before the limit, the residual after the width, no return, and the energy it takes.
//!
//! Source: isotropic damage driven by the largest stretch so far, e.g. Simo, Computer Methods in Applied Mechanics and
//! Engineering 60 (1987): stress phi times that of the whole material, dissipation -phi' W. The fall is the cubic
//! smoothstep x^2 (3 - 2 x), and the planar extension of neo-Hooke has W = C10 (l - 1/l)^2.

use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_verification::problems::tear::{
    C10, RESIDUAL, cell, extension, factor, planar, stress_error, tearing, work,
};
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_RESIDUAL, TEAR_ENERGY, relative_error};

/// There and back over the limit, with the stress against that of the material that does not tear.
#[test]
fn the_stress_falls_once_and_for_all() {
    let error = stress_error();
    assert!(error < CLOSED_FORM, "{error:e}");
    assert!(relative_error(factor(1.7), RESIDUAL) < CLOSED_FORM);
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

#[test]
fn the_energy_of_a_tear_is_that_of_the_closed_form() {
    let extension = extension();
    let (tear, closed_form) = (extension.tear, extension.closed_form);
    assert!(relative_error(tear, closed_form) < TEAR_ENERGY, "{tear} J/m3 against {closed_form} J/m3");
    let (booked, work) = (tear + extension.elastic, extension.work);
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
    // Torn silicone keeps half of its stress, or the mass would press it flat.
    for (layers, tear, residual) in [(2, 1.1, 0.05), (1, 1.02, 0.5)] {
        let mut scenario = preset::study();
        if layers == 2 {
            scenario.add_layer(preset::chamois()).expect("room");
        }
        let layer = &mut scenario.layers[layers - 1].material;
        (layer.tear_stretch, layer.tear_width, layer.tear_residual) = (tear, 0.1, residual);
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let mut torn = 0.0;
        for _ in 0..simulation.constants().steps_in(scenario.time.duration) {
            simulation.step(1, &StepInput::default()).expect("a stable run");
            let ledger = simulation.scalars().energy;
            assert!(ledger.tear >= torn, "{} J after {torn} J", ledger.tear);
            torn = ledger.tear;
            assert!(ledger.residual().abs() < ENERGY_RESIDUAL * 14.7, "{layers}: {} J", ledger.residual());
        }
        assert!(torn > 1e-3, "{layers}: {torn} J");
    }
}
