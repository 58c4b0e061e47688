//! Layers: the same numbers as one where all have the same material, those of springs in series where they differ, and
//! conservation.

use softanvil_kernel::material::{MAX_PRONY_TERMS, Material, NeoHookean};
use softanvil_kernel::scenario::{Formulation, Interface, Layer, MAX_LAYERS, Motion, Shape, StepBy};
use softanvil_kernel::state::{restore, save, snapshot_size};
use softanvil_kernel::{Field, Scenario, Simulation, StepInput, preset};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{ENERGY_RESIDUAL, LAYERS, SERIES, relative_error};

/// The study's anvil in layers of these thicknesses, m, and of one material.
fn coinciding(thicknesses: &[f64]) -> Scenario {
    let mut scenario = preset::study();
    // The preset has no slider.
    (scenario.layers[0].material.slider_stiffness, scenario.layers[0].material.slider_yield_stress) = (1e6, 10e3);
    let material = scenario.layers[0].material;
    scenario.layers.clear();
    for thickness in thicknesses {
        scenario.add_layer(Layer::new("", *thickness, material)).expect("room");
    }
    // The same step for all: trials on coarse meshes have rows of their own.
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 4e-6);
    scenario
}

fn two(formulation: Formulation) -> Scenario {
    let mut scenario = preset::study();
    scenario.layers[0].thickness = 14e-3;
    scenario.add_layer(preset::chamois()).expect("room");
    scenario.geometry.formulation = formulation;
    scenario
}

/// Rows of 3 mm, which a layer of 12 mm and a skin of 3 mm share with one layer of 15 mm.
#[test]
fn a_skin_of_silicone_changes_nothing() {
    let (one, two) = (run(&coinciding(&[15e-3])), run(&coinciding(&[12e-3, 3e-3])));
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
    let unit = 4.0 / 1024.0;
    let exact = |parts: &[f64]| {
        let thicknesses: Vec<f64> = parts.iter().map(|part| part * unit).collect();
        let mut scenario = coinciding(&thicknesses);
        scenario.mesh.element_size = unit;
        let simulation = run(&scenario);
        (simulation.constants().grid, *simulation.scalars())
    };
    let (whole, one) = exact(&[4.0]);
    assert_eq!((whole.n_v, whole.layer_end), (4, [4; MAX_LAYERS]));
    for (parts, ends) in [
        (&[2.0, 2.0][..], [2, 4, 4, 4]),
        (&[1.0, 2.0, 1.0], [1, 3, 4, 4]),
        (&[2.0, 1.0, 1.0], [2, 3, 4, 4]),
        (&[1.0; 4], [1, 2, 3, 4]),
    ] {
        let (grid, several) = exact(parts);
        assert_eq!(grid.layer_end, ends);
        assert_eq!(several, one, "{parts:?}");
    }
}

/// A layer that says its rows has them, whatever the element size: here those of the layer as a whole.
#[test]
fn four_layers_with_the_rows_of_one_give_its_bits() {
    let scenario = |layers: u32, rows: usize| {
        let mut scenario = coinciding(&vec![f64::from(16 / layers) / 1024.0; layers as usize]);
        scenario.layers.iter_mut().for_each(|layer| layer.rows = rows);
        scenario.mesh.element_size = 2e-3;
        scenario
    };
    let (one, four) = (run(&scenario(1, 8)), run(&scenario(4, 2)));
    assert_eq!((one.constants().grid.n_v, four.constants().grid.layer_end), (8, [2, 4, 6, 8]));
    assert_eq!(one.scalars(), four.scalars());
}

/// A trial chooses the step of layers that say their rows, few or many.
#[test]
fn a_step_is_found_whatever_rows_the_layers_say() {
    for rows in [[1, 1], [1, 4], [8, 1], [0, 2]] {
        let mut scenario = two(Formulation::PlaneStrain);
        scenario.layers.iter_mut().zip(rows).for_each(|(layer, rows)| layer.rows = rows);
        let simulation = run(&scenario);
        let grid = simulation.constants().grid;
        assert_eq!(
            [grid.rows_of(0).len().max(1), grid.rows_of(1).len()],
            [if rows[0] == 0 { 5 } else { rows[0] }, rows[1]]
        );
        assert!(simulation.scalars().energy.residual().abs() < ENERGY_RESIDUAL * 14.7, "{rows:?}");
    }
}

/// Three layers that do not widen (Poisson's ratio of 0), pressed slowly between plates without friction: springs in series, of
/// stiffness E A / t each.
///
/// Source: the force is u A / sum(t / E) and each layer takes its part F t / (E A) of the travel u, with E = 2 G.
#[test]
fn a_stack_is_springs_in_series() {
    let layers = [(4e-3, 100e3), (3e-3, 300e3), (5e-3, 200e3)];
    let mut scenario = preset::block();
    scenario.geometry.formulation = Formulation::Axisymmetric;
    scenario.geometry.block_width = 20e-3;
    scenario.layers.clear();
    for (thickness, c10) in layers {
        let material = Material { poissons_ratio: 0.0, ..preset::spare_layer().material.with(NeoHookean { c10 }) };
        scenario.add_layer(Layer::new("", thickness, material)).expect("room");
    }
    (scenario.core.interface, scenario.face.friction_coefficient) = (Interface::Sliding, 0.0);
    scenario.mesh.element_size = 1e-3;
    let travel = 1e-3 * scenario.thickness();
    let impactor = &mut scenario.impactor;
    (impactor.motion, impactor.gap, impactor.prescribed_depth) = (Motion::Prescribed, 0.0, travel);
    // Many periods of the stack, so that it does not swing at the end.
    (impactor.prescribed_speed, impactor.prescribed_rise) = (travel / 0.1, 0.05);
    scenario.time.duration = 0.16;
    assert_eq!(scenario.geometry.shape, Shape::Block);
    let mut simulation = run(&scenario);

    let area = std::f64::consts::PI * 10e-3 * 10e-3;
    let compliance: f64 = layers.iter().map(|(thickness, c10)| thickness / (4.0 * c10)).sum();
    let force = travel * area / compliance;
    let found = simulation.output("contact.force").expect("an output");
    assert!(relative_error(found, force) < SERIES, "{found} N against {force} N");
    let displacement = Field::find("node.displacement").expect("a field");
    let ends = simulation.constants().grid.layer_end;
    let lowered: Vec<f64> = simulation
        .with(|model, state| {
            let view = state.as_view();
            ends.iter().map(|row| -displacement.value(model, &view, *row, 0, 1).expect("a node")).collect()
        })
        .expect("memory");
    let mut expected = 0.0;
    for ((thickness, c10), lowered) in layers.iter().zip(lowered) {
        expected += force * thickness / (4.0 * c10 * area);
        assert!(relative_error(lowered, expected) < SERIES, "{lowered} m against {expected} m");
    }
}

#[test]
fn the_skin_has_rows_and_mass_of_its_own() {
    let mut scenario = two(Formulation::PlaneStrain);
    let grid = Simulation::new(&scenario).expect("a legal scenario").constants().grid;
    assert_eq!((grid.rows_of(0), grid.rows_of(1), grid.n_v), (0..5, 5..6, 6));
    scenario.impactor.gap = 1.0;
    scenario.layers[1].material.density = 2.0 * scenario.layers[0].material.density;
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
    scenario.layers[1].material.density = scenario.layers[0].material.density;
    let light = kinetic(&mut Simulation::new(&scenario).expect("a legal scenario"));
    // The surface nodes have mass of the skin alone.
    assert!(relative_error(heavy, 2.0 * light) < 1e-3, "{heavy} J against twice {light} J");
}

/// Source: conservation of energy, also across an interface of different laws and numbers of viscous terms.
#[test]
fn energy_closes_in_a_drop_on_two_layers() {
    let mut relaxing = preset::chamois().material;
    relaxing.prony_g = [0.1; MAX_PRONY_TERMS];
    relaxing.maxwell_g[0] = 1e6;
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for skin in [preset::chamois().material, relaxing] {
            let mut scenario = two(formulation);
            scenario.layers[1].material = skin;
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
    let coefficients = &mut scenario.layers[1].material.coefficients;
    *coefficients = coefficients.scaled(400.0);
    let stiff = Simulation::new(&scenario).expect("a legal scenario").constants().dt;
    assert!(stiff < 0.25 * soft, "{stiff} s against {soft} s");
}

#[test]
fn snapshots_hold_the_history_of_both_layers() {
    let mut scenario = two(Formulation::PlaneStrain);
    scenario.layers[1].material.prony_g = [0.1; MAX_PRONY_TERMS];
    scenario.layers[1].material.tear_stretch = 1.1;
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

/// What layers make illegal is refused by the name of its parameter.
#[test]
fn refusals_name_the_layer() {
    let refusal = |change: fn(&mut Scenario)| {
        let mut scenario = two(Formulation::PlaneStrain);
        change(&mut scenario);
        scenario.validate().err().map(|error| error.to_string()).unwrap_or_default()
    };
    assert_eq!(
        refusal(|s| s.layers[1].material = s.layers[1].material.with(NeoHookean { c10: -1.0 })),
        "layers[1].c10 gives a shear modulus of -2 Pa: expected above 0 Pa"
    );
    assert_eq!(
        refusal(|s| s.layers[1].material.prony_g = [0.25; 5]),
        "layers[1].prony_g_1 to _5 sum to 1.25: expected at least 0 and below 1"
    );
    assert_eq!(
        refusal(|s| s.layers[1].thickness = 0.0),
        "layers[1].thickness = 0 m is refused: expected at least 0.00001 m"
    );
    assert_eq!(refusal(|s| s.layers.clear()), "layers.count = 0 is refused: expected 1 to 4");
    assert_eq!(
        refusal(|s| s.layers[1].width = 0.2),
        "layers[1].width = 0.2 m is refused: expected at most 0.16179202166 m, the width of what is below it"
    );
    assert_eq!(
        refusal(|s| {
            s.set_layer_count(3);
            (s.layers[2].thickness, s.layers[1].width, s.layers[2].width) = (1e-3, 0.04, 0.05);
        })
        .split(" m is")
        .next(),
        Some("layers[2].width = 0.05")
    );
    assert_eq!(refusal(|s| s.layers.swap(0, 1)), "");
}

#[test]
fn there_is_an_end_to_layers() {
    let mut scenario = preset::study();
    for _ in 1..MAX_LAYERS {
        scenario.add_layer(preset::chamois()).expect("room");
    }
    let full = scenario.clone();
    let refused = scenario.add_layer(preset::chamois()).unwrap_err().to_string();
    assert_eq!(refused, "layers.count = 5 is refused: expected 1 to 4");
    assert_eq!(scenario, full);
    assert!(run(&full).scalars().metrics.peak_force > 0.0);
}
