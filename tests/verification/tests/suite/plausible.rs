//! Plausible drops go through with the step that is chosen for them. `plausible-drops` tries as many as one likes.

use softanvil_kernel::material::Hyperfoam;
use softanvil_kernel::scenario::{FaceShape, Formulation, Layer, LayerInterface, Motion, Shape, StepBy};
use softanvil_kernel::step::critical_time_step;
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::deformation::Samples;
use softanvil_verification::plausible::{foam, outcome, outcome_of, samples_of, scenario, stack, summary};
use softanvil_verification::scenes::{elastic, neo_hookean};
use softanvil_verification::tolerance::{
    LAYER_PENETRATION, PLAUSIBLE_RESIDUAL, STEPS_FOR_THE_NEXT_IMPACT, STEPS_OVER_HINDSIGHT,
};

/// Drops that are tried.
const COUNT: usize = 40;

/// Drops on stacks.
const STACKS: usize = 16;

/// Drops on pads of foam alone.
const FOAMS: usize = 16;

#[test]
fn random_drops_go_through_with_few_steps_too_many() {
    let mut samples = Samples::new(2_718);
    let mut ratios = Vec::new();
    for _ in 0..COUNT {
        let scenario = scenario(&mut samples);
        let outcome = outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{}: {}", outcome.residual, summary(&scenario));
        ratios.push(outcome.steps_over_hindsight);
    }
    ratios.sort_by(f64::total_cmp);
    assert!(ratios[COUNT / 2] <= STEPS_OVER_HINDSIGHT, "{ratios:?}");
}

/// Stacks with layers that are not bonded, or narrower, under faces of every kind.
#[test]
fn random_stacks_go_through_and_nothing_gets_into_anything() {
    let mut samples = Samples::new(31_415);
    for _ in 0..STACKS {
        let scenario = stack(&mut samples);
        let outcome = outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{}: {}", outcome.residual, summary(&scenario));
        assert!(outcome.penetration < LAYER_PENETRATION, "{}: {}", outcome.penetration, summary(&scenario));
    }
}

/// Drop 67 of seed 1 of `plausible-drops`: 3 mm of foam lie loose on a dome and flap when the mass has left, so that a cell folds, at a
/// step that no trial with another one foresees.
#[test]
fn a_loose_foam_that_flaps_goes_through() {
    let scenario = stack(&mut samples_of(1, 67));
    let outcome = outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
    assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{outcome:?}");
}

/// Pads of foam alone, soft and stiff, thin and thick, pressed to 30 % of their height.
#[test]
fn random_foams_go_through() {
    let mut samples = Samples::new(1_618);
    for _ in 0..FOAMS {
        let scenario = foam(&mut samples);
        let outcome = outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{}: {}", outcome.residual, summary(&scenario));
    }
}

/// Foams that stiffen steeply under a fast blow, found by `plausible-drops 300 1`: a trial that looks too late, or on too coarse a
/// mesh, turns cells inside out or chooses too large a step.
#[test]
fn foams_that_stiffen_steeply_go_through() {
    let foam = |mu: [f64; 3], alpha: [f64; 3], nu: [f64; 3], thickness: f64, density: f64| {
        let mut scenario = preset::study();
        let layer = &mut scenario.layers[0];
        (layer.thickness, layer.material) = (thickness, elastic(0.0, 0.0, 1e6).with(Hyperfoam::new(mu, alpha, nu)));
        layer.material.density = density;
        scenario.impactor = scenario.impactor.with_energy(50.0);
        scenario.impactor.face_diameter = 2.1 * (scenario.geometry.core_radius + thickness);
        scenario.time.duration = 20e-3;
        scenario
    };
    let block = |mut scenario: Scenario| {
        scenario.geometry.shape = Shape::Block;
        (scenario.geometry.block_width, scenario.geometry.length) = (0.1, 0.1);
        scenario.impactor.shape = FaceShape::Rectangular;
        (scenario.impactor.face_width, scenario.impactor.face_length) = (0.11, 0.1);
        scenario
    };
    let mut fine = foam([32.26e3, 3.42e3, 3.39e3], [7.36, 13.63, 9.13], [0.254, 0.191, 0.437], 44.5e-3, 128.0);
    fine.mesh.element_size = 1.5e-3;
    let stiff = foam([1.262e6, 79.5e3, 101.2e3], [17.2, 22.2, 10.45], [0.144, 0.249, 0.04], 48.1e-3, 41.2);
    let mut damped = foam([304.5e3, 34.6e3, 0.0], [14.27, 7.6, 4.0], [0.448, 0.307, 0.0], 44.8e-3, 99.6);
    (damped.layers[0].material.maxwell_g[0], damped.layers[0].material.maxwell_beta[0]) = (340e3, 2.1e3);
    for scenario in [fine, block(stiff), block(damped)] {
        let outcome = outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{}: {}", outcome.residual, summary(&scenario));
    }
}

/// A foam on a dome bears the drop, and softened by it not the next one: the single drop takes a few times the steps that it
/// needs, not thousands of times, and the next one ends with the step that would do.
#[test]
fn a_drop_on_a_softening_foam_does_not_pay_for_one_that_presses_it_flat() {
    let mut scenario = preset::study();
    scenario.geometry.formulation = Formulation::Axisymmetric;
    let layer = &mut scenario.layers[0];
    let foam = Hyperfoam::new([115e3, 0.0, 0.0], [5.3, 1.0, 1.0], [0.03, 0.0, 0.0]);
    (layer.thickness, layer.material) = (7.7e-3, elastic(0.0, 0.0, 1e6).with(foam));
    layer.material.density = 100.0;
    (layer.material.softening_r, layer.material.softening_m, layer.material.softening_beta) = (2.0, 555.0, 0.2);
    scenario.impactor = scenario.impactor.with_energy(0.02);
    scenario.time.duration = 60e-3;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let outcome = outcome_of(&mut simulation, 600).unwrap();
    assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{outcome:?}");
    assert!((1.0..STEPS_FOR_THE_NEXT_IMPACT).contains(&outcome.steps_over_hindsight), "{outcome:?}");
    simulation.next_impact(60.0).expect("a legal rest");
    let steps = simulation.constants().steps_in(scenario.time.duration);
    let error = simulation.step(steps, &StepInput::default()).expect_err("a foam that is pressed flat").to_string();
    assert!(error.contains("would do there (time.step_by = given with time.step"), "{error}");
}

/// A pad that bulges past the edge of a narrow face comes against its side, and not into it.
#[test]
fn a_pad_bulges_beside_a_narrow_face() {
    let mut scenario = preset::study();
    scenario.impactor = scenario.impactor.with_energy(5.0);
    scenario.impactor.shape = FaceShape::Rectangular;
    (scenario.impactor.face_width, scenario.impactor.face_length) = (40e-3, 30e-3);
    let (interface, spare) = (LayerInterface::Frictional, preset::spare_layer);
    scenario.add_layer(Layer { thickness: 10e-3, width: 90e-3, gap: 2e-3, interface, ..spare() }).unwrap();
    scenario.add_layer(Layer { thickness: 3e-3, width: 60e-3, ..spare() }).unwrap();
    scenario.time.duration = 25e-3;
    let outcome = outcome(&scenario).unwrap();
    assert!(outcome.residual < PLAUSIBLE_RESIDUAL && outcome.penetration < LAYER_PENETRATION, "{outcome:?}");
}

/// A layer of c10 = 100 kPa at the study's energy, presets far beyond it, and a fine press.
#[test]
fn drops_that_a_fixed_design_refused_go_through() {
    let mut soft = preset::study();
    soft.layers[0].material = neo_hookean(0.2e6, 0.2e6 * 2.0 * 1.48 / (3.0 * 0.04));
    let hard = |energy: f64| {
        let mut scenario = preset::study();
        scenario.impactor = scenario.impactor.with_energy(energy);
        scenario
    };
    let mut press = preset::study();
    press.impactor.motion = Motion::Prescribed;
    (press.impactor.prescribed_depth, press.impactor.prescribed_speed) = (5e-3, 1.0);
    press.mesh.element_size = 0.75e-3;
    for scenario in [soft, hard(50.0), hard(200.0), hard(1e3), press] {
        outcome(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
    }
}

/// A driven face may go as deep as the scenario says, whatever its path.
#[test]
fn a_driven_face_may_go_as_deep_as_the_design_says() {
    for compression in [0.2, 0.4, 0.6] {
        let mut driven = preset::study();
        driven.impactor.motion = Motion::Driven;
        driven.time.design_compression = compression;
        let mut simulation = Simulation::new(&driven).expect("a legal scenario");
        let (gap, depth) = (driven.impactor.gap, compression * driven.thickness());
        let steps = simulation.constants().steps_in(8e-3);
        for step in 1..=steps {
            // Down in a half wave and up again.
            let part = 0.5 * (1.0 - (std::f64::consts::TAU * step as f64 / steps as f64).cos());
            let driven_position = Some(gap - (gap + depth) * part);
            let input = StepInput { driven_position, ..StepInput::default() };
            simulation.step(1, &input).unwrap_or_else(|error| panic!("{compression}: {error}"));
        }
    }
}

/// The step that an error names carries the drop past it, and a larger safety factor would not have.
#[test]
fn the_step_that_an_error_names_is_enough() {
    let mut scenario = preset::study();
    scenario.impactor = scenario.impactor.with_energy(200.0);
    let mut chosen = Simulation::new(&scenario).expect("a legal scenario");
    let at_rest = chosen.with(|model, state| critical_time_step(model, state).0).expect("memory of the right size");
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 0.95 * at_rest);
    let mut given = Simulation::new(&scenario).expect("a legal step");
    let steps = given.constants().steps_in(scenario.time.duration);
    let error = given.step(steps, &StepInput::default()).expect_err("too large a step").to_string();
    let named: f64 = error.split(": ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap().parse().unwrap();
    let failed_at = given.time();
    scenario.time.step = named;
    let mut mended = Simulation::new(&scenario).expect("a legal step");
    let steps = mended.constants().steps_in(failed_at);
    mended.step(steps, &StepInput::default()).unwrap_or_else(|later| panic!("{error}; then {later}"));
}
