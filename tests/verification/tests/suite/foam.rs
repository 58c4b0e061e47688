//! Foams: closed forms through the element, and layers pressed to a seventh of their thickness.
//!
//! Source: the closed forms are in `problems/foam.rs`; conservation of energy.

use softanvil_kernel::material::{Hyperfoam, Material};
use softanvil_kernel::scenario::{Formulation, Motion};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::problems::foam::{MODES, RATIOS, error, error_of_relaxation, error_of_turns};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_RESIDUAL};

#[test]
fn stresses_are_those_of_the_closed_forms() {
    for ((mode, name), nu) in MODES.into_iter().flat_map(|mode| RATIOS.map(|nu| (mode, nu))) {
        let error = error(mode, nu);
        assert!(error < CLOSED_FORM, "{name}, nu = {nu}: {error:e}");
    }
    let [turned, relaxing] = [error_of_turns(), error_of_relaxation()];
    assert!(turned < CLOSED_FORM && relaxing < CLOSED_FORM, "{turned:e} {relaxing:e}");
}

/// A soft foam of 20 mm on the study's core, with memory, a slider and softening.
fn pad(formulation: Formulation) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.formulation = formulation;
    let layer = &mut scenario.layers[0];
    layer.thickness = 20e-3;
    let mut foam = Material { density: 120.0, ..layer.material };
    foam = foam.with(Hyperfoam::new([0.1e6, 0.03e6, 0.0], [8.0, -2.0, 1.0], [0.0, 0.1, 0.0]));
    (foam.prony_g[0], foam.prony_tau[0]) = (0.4, 2e-3);
    (foam.slider_stiffness, foam.slider_yield_stress) = (20e3, 1e3);
    (foam.softening_r, foam.softening_m, foam.softening_beta) = (1.6, 1e3, 0.2);
    layer.material = foam;
    scenario
}

/// No triangle turns inside out, and the step that was chosen holds.
#[test]
fn a_press_to_85_percent_goes_through() {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        let mut scenario = pad(formulation);
        let impactor = &mut scenario.impactor;
        (impactor.motion, impactor.gap) = (Motion::Prescribed, 0.0);
        (impactor.prescribed_depth, impactor.prescribed_speed) = (0.85 * scenario.layers[0].thickness, 2.0);
        impactor.prescribed_rise = 1e-3;
        scenario.time.duration = 11e-3;
        let simulation = run(&scenario);
        let (energy, metrics) = (simulation.scalars().energy, simulation.scalars().metrics);
        assert!(metrics.max_deformation > 0.8499 * 20e-3, "{formulation:?}: {}", metrics.max_deformation);
        assert!(energy.residual().abs() < ENERGY_RESIDUAL * energy.external, "{formulation:?}: {energy:?}");
        assert!(energy.softening > 0.05 * energy.external, "{formulation:?}: {energy:?}");
    }
}

/// Dropped on again and again, the pad softens, and each balance closes by itself.
#[test]
fn drops_on_a_used_pad_go_deeper_and_their_energies_close() {
    let mut scenario = pad(Formulation::PlaneStrain);
    scenario.impactor = scenario.impactor.with_energy(2.5);
    scenario.time.duration = 25e-3;
    let mut anvil = Simulation::new(&scenario).expect("a legal scenario");
    let (mut depths, mut softening) = (Vec::new(), Vec::new());
    for _ in 0..3 {
        let steps = anvil.constants().steps_in(scenario.time.duration);
        anvil.step(steps, &StepInput::default()).expect("a stable run");
        let energy = anvil.scalars().energy;
        assert!(energy.residual().abs() < ENERGY_RESIDUAL * energy.external, "{energy:?}");
        depths.push(anvil.scalars().metrics.max_deformation);
        softening.push(energy.softening);
        anvil.next_impact(60.0).expect("a legal rest");
        assert_eq!((anvil.time(), anvil.scalars().energy.softening), (0.0, 0.0));
    }
    assert!(depths[0] < depths[1] && depths[1] < depths[2] && depths[2] < 0.95 * 20e-3, "{depths:?}");
    assert!(softening[0] > 1.5 * softening[1] && softening[1] > 1.5 * softening[2], "{softening:?}");
}

/// What the rest leaves of an overstress goes by its exponential: the force of a face that holds still shows it.
#[test]
fn overstresses_decay_exactly_in_a_rest() {
    let mut scenario = pad(Formulation::PlaneStrain);
    scenario.layers[0].material.slider_stiffness = 0.0;
    scenario.layers[0].material.prony_tau[0] = 1.0;
    let reaction = |rest: f64| {
        let mut anvil = Simulation::new(&scenario).expect("a legal scenario");
        anvil.run(8e-3, &StepInput::default()).expect("a stable run");
        anvil.next_impact(rest).expect("a legal rest");
        // At rest, the core feels nothing but what is left of the overstress.
        anvil.step(1, &StepInput::default()).expect("a stable run");
        anvil.scalars().force.core_reaction
    };
    // With the shape going back steadily over the rest, H e^-x - Q (1 - e^-x) / x is left of H and the stress Q.
    let left = [0.5, 1.0, 2.0].map(reaction);
    let part = |x: f64| [(-x).exp(), (1.0 - (-x).exp()) / x];
    let [a, b, c] = [0.5, 1.0, 2.0].map(part);
    let determinant = a[0] * b[1] - a[1] * b[0];
    let overstress = (left[0] * b[1] - left[1] * a[1]) / determinant;
    let stress = (a[0] * left[1] - b[0] * left[0]) / determinant;
    let expected = overstress * c[0] + stress * c[1];
    assert!(left[0].abs() > 1e-3 && (left[2] / expected - 1.0).abs() < 1e-9, "{left:?} N, expected {expected} N");
}

/// Without damage and memory an anvil is after its rest as it was.
#[test]
fn an_elastic_anvil_gives_the_same_bits_again() {
    let mut anvil = Simulation::new(&preset::elastic()).expect("a legal scenario");
    let trace = |anvil: &mut Simulation| {
        anvil.run(10e-3, &StepInput::default()).expect("a stable run");
        *anvil.scalars()
    };
    let first = trace(&mut anvil);
    anvil.next_impact(1.0).expect("a legal rest");
    assert_eq!(trace(&mut anvil), first);
    for rest in [-1.0, f64::NAN, f64::INFINITY, 1e10] {
        assert!(anvil.next_impact(rest).is_err());
        assert_eq!(*anvil.scalars(), first);
    }
}

/// Snapshots carry the damage: a restored pad goes on with the same bits, into the next impact and through it.
#[test]
fn snapshots_carry_what_has_softened() {
    let mut scenario = pad(Formulation::PlaneStrain);
    scenario.impactor = scenario.impactor.with_energy(2.5);
    let mut anvil = Simulation::new(&scenario).expect("a legal scenario");
    anvil.run(9e-3, &StepInput::default()).expect("a stable run");
    let saved = anvil.save().expect("a snapshot");
    let finish = |anvil: &mut Simulation| {
        anvil.run(3e-3, &StepInput::default()).expect("a stable run");
        anvil.next_impact(0.01).expect("a legal rest");
        anvil.run(9e-3, &StepInput::default()).expect("a stable run");
        *anvil.scalars()
    };
    let expected = finish(&mut anvil);
    let mut restored = Simulation::new(&scenario).expect("a legal scenario");
    restored.restore(&saved).expect("its own snapshot");
    assert_eq!(finish(&mut restored), expected);
}
