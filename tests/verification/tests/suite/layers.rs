//! Two layers: the same numbers as one where both have the same material, and conservation where they differ.

use softanvil_kernel::material::{MAX_PRONY_TERMS, Material, NeoHookean};
use softanvil_kernel::scenario::{Formulation, Layers, StepBy};
use softanvil_kernel::state::{restore, save, snapshot_size};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{ENERGY_RESIDUAL, LAYERS, relative_error};

/// Rows of 3 mm, which a layer of 12 mm and a skin of 3 mm share with one layer of 15 mm.
fn coinciding(layers: Layers) -> Scenario {
    let mut scenario = preset::study();
    set_layers(&mut scenario, layers, 12e-3, 3e-3);
    // The preset has no slider.
    (scenario.layers[0].material.slider_stiffness, scenario.layers[0].material.slider_yield_stress) = (1e6, 10e3);
    scenario.skin = scenario.layers[0].material;
    // The same step for both: trials on coarse meshes have rows of their own.
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 4e-6);
    scenario
}

/// The same thickness of one layer as of two.
fn set_layers(scenario: &mut Scenario, layers: Layers, silicone: f64, skin: f64) {
    let whole = if layers == Layers::Two { silicone } else { silicone + skin };
    let geometry = &mut scenario.geometry;
    (geometry.layers, geometry.silicone_thickness, geometry.skin_thickness) = (layers, whole, skin);
}

fn two(formulation: Formulation) -> Scenario {
    let mut scenario = preset::study();
    set_layers(&mut scenario, Layers::Two, 14e-3, 1e-3);
    scenario.geometry.formulation = formulation;
    scenario
}

#[test]
fn a_skin_of_silicone_changes_nothing() {
    let (one, two) = (run(&coinciding(Layers::One)), run(&coinciding(Layers::Two)));
    assert_eq!(one.constants().dt, two.constants().dt);
    assert_eq!((one.constants().grid.n_v, two.constants().grid.n_v), (5, 5));
    let (a, b) = (one.scalars(), two.scalars());
    for (name, a, b) in [
        ("peak force", a.metrics.peak_force, b.metrics.peak_force),
        ("deformation", a.metrics.max_deformation, b.metrics.max_deformation),
        ("impulse", a.metrics.impulse, b.metrics.impulse),
        ("rebound", a.metrics.rebound_speed, b.metrics.rebound_speed),
        ("viscous work", a.energy.viscous, b.energy.viscous),
        ("slider dissipation", a.energy.slider_dissipation, b.energy.slider_dissipation),
    ] {
        assert!(relative_error(a, b) < LAYERS, "{name}: {a} against {b}");
    }
}

/// In numbers that are exact in binary the rows coincide to the last bit, and so does everything else.
#[test]
fn rows_that_coincide_exactly_give_the_same_bits() {
    let exact = |layers| {
        let mut scenario = coinciding(layers);
        set_layers(&mut scenario, layers, 8.0 / 1024.0, 8.0 / 1024.0);
        scenario.mesh.element_size = 4.0 / 1024.0;
        run(&scenario)
    };
    let (one, two) = (exact(Layers::One), exact(Layers::Two));
    assert_eq!(one.constants().grid.n_v_silicone, 4);
    assert_eq!(two.constants().grid.n_v_silicone, 2);
    assert_eq!(one.scalars(), two.scalars());
}

#[test]
fn the_skin_has_rows_and_mass_of_its_own() {
    let mut scenario = two(Formulation::PlaneStrain);
    let grid = Simulation::new(&scenario).expect("a legal scenario").constants().grid;
    assert_eq!((grid.n_v_silicone, grid.n_v), (5, 6));
    scenario.impactor.gap = 1.0;
    scenario.skin.density = 2.0 * scenario.layers[0].material.density;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    // The surface moves at 1 m/s over a layer at rest: the kinetic energy of the step is half its mass.
    let kinetic = |simulation: &mut Simulation| {
        simulation
            .with(|model, state| {
                for row in state.velocity_mut() {
                    row.fill(0.0);
                }
                let grid = model.constants.grid;
                let above = grid.n_v * grid.stride();
                let nodes = above..=above + grid.n_u;
                state.velocity_mut()[1][nodes].fill(1.0);
            })
            .expect("memory");
        simulation.step(1, &StepInput::default()).expect("a stable step");
        simulation.scalars().energy.layer_kinetic
    };
    let heavy = kinetic(&mut simulation);
    scenario.skin.density = scenario.layers[0].material.density;
    let light = kinetic(&mut Simulation::new(&scenario).expect("a legal scenario"));
    // The surface nodes have mass of the skin alone.
    assert!(relative_error(heavy, 2.0 * light) < 1e-3, "{heavy} J against twice {light} J");
}

/// Source: conservation of energy, also across an interface of different laws and numbers of viscous terms.
#[test]
fn energy_closes_in_a_drop_on_two_layers() {
    let mut relaxing = preset::study().skin;
    relaxing.prony_g = [0.1; MAX_PRONY_TERMS];
    relaxing.maxwell_g[0] = 1e6;
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for skin in [preset::study().skin, relaxing] {
            let mut scenario = two(formulation);
            scenario.skin = skin;
            let simulation = run(&scenario);
            let ledger = simulation.scalars().energy;
            assert!(simulation.scalars().metrics.peak_force > 0.0);
            assert!(ledger.residual().abs() < ENERGY_RESIDUAL * ledger.external, "{} J", ledger.residual());
        }
    }
}

/// A thin, stiff skin makes the stable step smaller.
#[test]
fn the_step_is_that_of_the_layer_that_needs_the_smallest() {
    let soft = Simulation::new(&two(Formulation::PlaneStrain)).expect("a legal scenario").constants().dt;
    let mut scenario = two(Formulation::PlaneStrain);
    scenario.skin = Material { coefficients: scenario.skin.coefficients.scaled(400.0), ..scenario.skin };
    let stiff = Simulation::new(&scenario).expect("a legal scenario").constants().dt;
    assert!(stiff < 0.25 * soft, "{stiff} s against {soft} s");
}

#[test]
fn snapshots_hold_the_history_of_both_layers() {
    let mut scenario = two(Formulation::PlaneStrain);
    scenario.skin.prony_g = [0.1; MAX_PRONY_TERMS];
    scenario.skin.tear_stretch = 1.1;
    let whole = run(&scenario);
    let mut first = Simulation::new(&scenario).expect("a legal scenario");
    first.step(2000, &StepInput::default()).expect("a stable run");
    let mut bytes = vec![0; snapshot_size(first.constants())];
    first.with(|model, state| save(model, state, &mut bytes)).expect("memory").expect("a snapshot");
    let mut second = Simulation::new(&scenario).expect("a legal scenario");
    second.with(|model, state| restore(model, state, &bytes)).expect("memory").expect("a snapshot of this model");
    let steps = second.constants().steps_in(scenario.time.duration);
    second.step(steps - 2000, &StepInput::default()).expect("a stable run");
    assert_eq!(second.scalars(), whole.scalars());
}

/// What two layers make illegal is refused by the name of its row.
#[test]
fn refusals_name_the_layer() {
    let refusal = |change: fn(&mut Scenario)| {
        let mut scenario = two(Formulation::PlaneStrain);
        change(&mut scenario);
        scenario.validate().err().map(|error| error.to_string()).unwrap_or_default()
    };
    assert_eq!(
        refusal(|s| s.skin = s.skin.with(NeoHookean { c10: -1.0 })),
        "skin.c10 gives a shear modulus of -2 Pa: expected above 0 Pa"
    );
    assert_eq!(
        refusal(|s| s.skin.prony_g = [0.25; 5]),
        "skin.prony_g_1 to _5 sum to 1.25: expected at least 0 and below 1"
    );
    assert_eq!(
        refusal(|s| s.geometry.skin_thickness = 0.0),
        "geometry.skin_thickness = 0 m is refused: expected at least 0.00001 m with two layers"
    );
    // A material that is not in the anvil is no reason to refuse it.
    assert_eq!(
        refusal(|s| {
            s.geometry.layers = Layers::One;
            s.skin = s.skin.with(NeoHookean { c10: -1.0 });
        }),
        ""
    );
}
