//! Layers of a solid that are not bonded, or narrower: nothing gets into anything, the books close, momentum is kept, and the section
//! says the same.

use softanvil_kernel::scenario::{
    Body, FaceShape, Formulation, Interface, Layer, LayerInterface, Motion, StepBy, Symmetry,
};
use softanvil_kernel::step::critical_time_step;
use softanvil_kernel::{InstructionSet, Model, Scenario, Simulation, State, StepInput, preset, step_with};
use softanvil_verification::deformation::Samples;
use softanvil_verification::penetration::deepest;
use softanvil_verification::plausible::{outcome_of, solid, summary};
use softanvil_verification::solid::nodes;
use softanvil_verification::tolerance::{ENERGY_RESIDUAL, LAYER_PENETRATION, PLAUSIBLE_RESIDUAL};

/// A coarse solid of the study with a pad.
fn padded(thickness: f64, width: f64, interface: LayerInterface, gap: f64) -> Scenario {
    let mut scenario = preset::study();
    scenario.geometry.formulation = Formulation::Solid;
    (scenario.geometry.length, scenario.mesh.element_size, scenario.impactor.gap) = (32e-3, 8e-3, 0.0);
    scenario.add_layer(Layer { thickness, width, interface, gap, ..preset::spare_layer() }).unwrap();
    scenario.impactor = scenario.impactor.with_energy(4.0);
    scenario
}

/// The deepest that a node gets into the other layer over the element size, and the largest residual over the energy.
fn drop(scenario: &Scenario) -> [f64; 2] {
    let mut simulation = Simulation::new(scenario).unwrap();
    let steps = simulation.constants().steps_in(10e-3);
    let (mut depth, mut residual) = (0.0_f64, 0.0_f64);
    for _ in 0..50 {
        simulation.step(steps / 50, &StepInput::default()).unwrap();
        residual = residual.max(simulation.scalars().energy.residual().abs() / scenario.impactor.drop_energy);
        depth = depth.max(simulation.with(|model, state| deepest(model, state)).unwrap());
    }
    assert!(simulation.scalars().metrics.peak_force > 500.0);
    [depth / scenario.mesh.element_size, residual]
}

#[test]
fn nothing_gets_into_another_layer_and_the_books_close() {
    use LayerInterface::{Frictional, Separating};
    let mut dome = padded(10e-3, 60e-3, Frictional, 1e-3);
    dome.geometry.body = Body::Revolved;
    let mut beside = padded(6e-3, 60e-3, Frictional, 0.0);
    (beside.geometry.symmetry, beside.impactor.offset) = (Symmetry::Half, 6e-3);
    (beside.impactor.shape, beside.impactor.face_diameter, beside.impactor.face_length) =
        (FaceShape::Bar, 50e-3, 60e-3);
    let mut three = padded(6e-3, 0.0, Separating, 0.0);
    three.add_layer(Layer { thickness: 2e-3, rows: 1, interface: Frictional, ..preset::spare_layer() }).unwrap();
    three.geometry.symmetry = Symmetry::Full;
    for scenario in [padded(10e-3, 0.0, Frictional, 0.0), padded(10e-3, 70e-3, Separating, 2e-3), dome, beside, three] {
        let [depth, residual] = drop(&scenario);
        assert!(depth < LAYER_PENETRATION, "{:?}: {depth} of a cell", scenario.layers[1]);
        assert!(residual < ENERGY_RESIDUAL, "{:?}: {residual} of the energy", scenario.layers[1]);
    }
}

/// Solids of every kind, half of them stacks.
#[test]
fn random_solids_go_through_and_nothing_gets_into_anything() {
    let mut samples = Samples::new(1_729);
    let mut open = 0;
    for _ in 0..5 {
        let mut scenario = solid(&mut samples);
        scenario.mesh.element_size = 9e-3;
        let mut simulation =
            Simulation::new(&scenario).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        let outcome = outcome_of(&mut simulation, 50).unwrap_or_else(|error| panic!("{error}: {}", summary(&scenario)));
        assert!(outcome.residual < PLAUSIBLE_RESIDUAL, "{}: {}", outcome.residual, summary(&scenario));
        assert!(outcome.penetration < LAYER_PENETRATION, "{}: {}", outcome.penetration, summary(&scenario));
        open += usize::from((1..scenario.layers.len()).any(|place| scenario.is_open(place)));
    }
    assert!(open > 0, "no stack was open");
}

/// What one layer gives, the other takes, in all three directions, to round-off.
#[test]
fn momentum_passes_from_layer_to_layer() {
    let mut scenario = padded(6e-3, 40e-3, LayerInterface::Frictional, 1e-3);
    scenario.geometry.symmetry = Symmetry::Full;
    scenario.core.interface = Interface::Separating;
    (scenario.impactor.motion, scenario.impactor.gap) = (Motion::Driven, 0.5);
    let mut simulation = Simulation::new(&scenario).unwrap();
    let input = StepInput { driven_position: Some(0.5), ..StepInput::default() };
    let found = simulation.with(|model, state| {
        let [_, above] = model.constants.grid.interface_rows(1).unwrap();
        let of_pad = |[_, v, _]: [usize; 3]| v >= above;
        for node in nodes(model) {
            let velocity = if of_pad(node) { [0.3, -2.0, 0.5] } else { [0.0, 3.0, 0.0] };
            set_velocity(model, state, node, velocity);
        }
        let before = momentum(model, state);
        let of_pad_before: f64 = momentum_along_y(model, state, &of_pad);
        for _ in 0..(1e-3 / model.constants.dt) as usize {
            softanvil_kernel::step(model, state, &input).unwrap();
        }
        (before, momentum(model, state), of_pad_before, momentum_along_y(model, state, &of_pad))
    });
    let (before, after, of_pad_before, of_pad_after) = found.unwrap();
    assert!((of_pad_after - of_pad_before).abs() > 0.5 * of_pad_before.abs(), "the layers have not met");
    for (after, before_it) in after.iter().zip(before) {
        assert!((after - before_it).abs() < 1e-10 * before[1].abs(), "{before:?} kg m/s, then {after}");
    }
}

fn set_velocity(model: &Model, state: &mut State, [u, v, w]: [usize; 3], [x, y, z]: [f64; 3]) {
    let node = model.constants.grid.node(u, v, w);
    let there = model.nodal_mass(u, v, w) > 0.0;
    let [vx, vy] = state.velocity_mut();
    (vx[node], vy[node]) = if there { (x, y) } else { (0.0, 0.0) };
    state.along_z_mut(model)[1][node] = if there { z } else { 0.0 };
}

fn momentum(model: &Model, state: &State) -> [f64; 3] {
    let ([vx, vy], [_, vz, ..]) = (state.velocity(), state.as_view().along_z(model));
    let mut sum = [0.0; 3];
    for [u, v, w] in nodes(model) {
        let (node, mass) = (model.constants.grid.node(u, v, w), model.nodal_mass(u, v, w));
        [vx, vy, vz].iter().zip(&mut sum).for_each(|(velocity, sum)| *sum += mass * velocity[node]);
    }
    sum
}

fn momentum_along_y(model: &Model, state: &State, counts: &dyn Fn([usize; 3]) -> bool) -> f64 {
    let of =
        |[u, v, w]: [usize; 3]| model.nodal_mass(u, v, w) * state.velocity()[1][model.constants.grid.node(u, v, w)];
    nodes(model).filter(|node| counts(*node)).map(of).sum()
}

/// Saved and restored, begun anew, on other instruction sets and on other threads: the same bits.
#[test]
fn open_layers_have_the_same_bits_in_every_way() {
    let mut scenario = padded(6e-3, 60e-3, LayerInterface::Frictional, 0.5e-3);
    (scenario.mesh.element_size, scenario.geometry.length) = (4e-3, 40e-3);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 1e-7);
    let at_rest = Simulation::new(&scenario).unwrap().with(|model, state| critical_time_step(model, state).0).unwrap();
    scenario.time.step = 0.4 * at_rest;
    let (input, start) = (StepInput::default(), Simulation::new(&scenario).unwrap());
    let steps = start.constants().steps_in(1.5e-3);
    let mut whole = start.clone();
    whole.step(steps, &input).unwrap();
    let expected = whole.save().unwrap();
    let mut first = start.clone();
    first.step(steps / 2, &input).unwrap();
    let saved = first.save().unwrap();
    let mut second = start.clone();
    second.restore(&saved).unwrap();
    second.step(steps - steps / 2, &input).unwrap();
    assert_eq!(second.save().unwrap(), expected, "restored");
    first.reset().unwrap();
    first.step(steps, &input).unwrap();
    assert_eq!(first.save().unwrap(), expected, "begun anew");
    for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
        let mut other = start.clone();
        let run = |model: &Model, state: &mut State| (0..steps).try_for_each(|_| step_with(set, model, state, &input));
        other.with(run).unwrap().unwrap();
        assert_eq!(other.save().unwrap(), expected, "{set:?}");
    }
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mut other = start.clone();
        pool.install(|| other.step(steps, &input)).unwrap();
        assert_eq!(other.save().unwrap(), expected, "{threads} threads");
    }
}

/// A quarter, a half and the whole are one and the same drop, but for what the passes over the pairs leave.
#[test]
fn symmetry_changes_nothing_but_the_cost() {
    for body in [Body::Prism, Body::Revolved] {
        let peak = |symmetry| {
            let mut scenario = padded(6e-3, 60e-3, LayerInterface::Frictional, 0.5e-3);
            (scenario.geometry.body, scenario.geometry.symmetry) = (body, symmetry);
            let mut anvil = Simulation::new(&scenario).unwrap();
            anvil.run(5e-3, &StepInput::default()).unwrap();
            anvil.scalars().metrics.peak_force
        };
        let quarter = peak(Symmetry::Quarter);
        for symmetry in [Symmetry::Half, Symmetry::Full] {
            let ratio = peak(symmetry) / quarter;
            assert!((ratio - 1.0).abs() < 1e-3, "{body:?}, {symmetry:?}: {ratio}");
        }
    }
}

/// A pad on the anvil that is used again: it lies where it lay, and the next impact meets it so.
#[test]
fn the_next_impact_finds_every_layer_where_it_was() {
    let mut anvil = Simulation::new(&padded(6e-3, 60e-3, LayerInterface::Separating, 1e-3)).unwrap();
    anvil.run(6e-3, &StepInput::default()).unwrap();
    let first = anvil.scalars().metrics.peak_force;
    anvil.next_impact(1e3).unwrap();
    anvil.run(6e-3, &StepInput::default()).unwrap();
    let again = anvil.scalars().metrics.peak_force;
    assert!((again / first - 1.0).abs() < 1e-6, "{again} N after {first} N");
}
