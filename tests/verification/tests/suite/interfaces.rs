//! Drops on layers that are not bonded: nothing gets into anything, the books close, momentum is kept.

use softanvil_kernel::scenario::{FaceShape, Formulation, Interface, Layer, LayerInterface, Section};
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::penetration::deepest;

/// The study's anvil with a pad.
fn padded(thickness: f64, width: f64, interface: LayerInterface, gap: f64) -> Scenario {
    let mut scenario = preset::study();
    let pad = Layer { thickness, width, interface, gap, ..preset::spare_layer() };
    scenario.add_layer(pad).unwrap();
    scenario
}

/// The deepest that a node gets into the other layer over the element size, and the largest residual over the energy.
fn drop(scenario: &Scenario) -> [f64; 2] {
    let mut simulation = Simulation::new(scenario).unwrap();
    let steps = simulation.constants().steps_in(scenario.time.duration);
    let (mut depth, mut residual) = (0.0_f64, 0.0_f64);
    for _ in 0..steps / 4 {
        simulation.step(4, &StepInput::default()).unwrap();
        residual = residual.max(simulation.scalars().energy.residual().abs() / scenario.impactor.drop_energy);
        depth = depth.max(simulation.with(|model, state| deepest(model, state)).unwrap());
    }
    assert!(simulation.scalars().metrics.peak_force > 1000.0);
    [depth / scenario.mesh.element_size, residual]
}

#[test]
fn nothing_gets_into_another_layer_and_the_books_close() {
    use LayerInterface::{Frictional, Separating};
    let mut dome = padded(10e-3, 80e-3, Frictional, 1e-3);
    dome.geometry.formulation = Formulation::Axisymmetric;
    let mut beside = padded(6e-3, 60e-3, Frictional, 0.0);
    (beside.geometry.section, beside.impactor.offset) = (Section::Full, 6e-3);
    (beside.impactor.shape, beside.impactor.face_diameter) = (FaceShape::Bar, 50e-3);
    beside.impactor = beside.impactor.with_energy(5.0);
    let mut three = padded(3e-3, 0.0, Separating, 0.0);
    let skin = Layer { thickness: 1e-3, rows: 1, interface: Frictional, ..preset::spare_layer() };
    three.add_layer(skin).unwrap();
    three.impactor = three.impactor.with_energy(5.0);
    for scenario in [padded(10e-3, 0.0, Frictional, 0.0), padded(10e-3, 70e-3, Separating, 2e-3), dome, beside, three] {
        let [depth, residual] = drop(&scenario);
        assert!(depth < 0.01, "{:?}: {depth} of a cell", scenario.layers[1]);
        assert!(residual < 5e-3, "{:?}: {residual} of the energy", scenario.layers[1]);
    }
}

/// A layer of one row of cells between the face and the core has contact on both sides at once.
#[test]
fn a_thin_layer_between_face_and_core_is_held() {
    let mut scenario = padded(1.5e-3, 0.0, LayerInterface::Frictional, 0.0);
    (scenario.layers[0].thickness, scenario.layers[0].rows, scenario.layers[1].rows) = (1.5e-3, 1, 1);
    scenario.core.interface = Interface::Frictional;
    scenario.impactor = scenario.impactor.with_energy(0.3);
    let [depth, residual] = drop(&scenario);
    assert!(depth * scenario.mesh.element_size < 0.01 * 1.5e-3, "{depth} of a cell");
    assert!(residual < 5e-3, "{residual} of the energy");
}

/// What one layer gives, the other takes: the momentum of two layers that collide stays, to round-off.
#[test]
fn momentum_passes_from_layer_to_layer() {
    let mut scenario = padded(6e-3, 40e-3, LayerInterface::Frictional, 1e-3);
    scenario.geometry.section = Section::Full;
    scenario.core.interface = Interface::Frictional;
    scenario.impactor.gap = 0.5;
    scenario.impactor.gravity = 0.0;
    scenario.impactor = scenario.impactor.with_energy(0.0);
    scenario.core.friction_coefficient = 0.0;
    let mut simulation = Simulation::new(&scenario).unwrap();
    let found = simulation.with(|model, state| {
        let grid = &model.constants.grid;
        let [_, above] = grid.interface_rows(1).unwrap();
        let masses = softanvil_verification::momentum::masses(model);
        let first = above * grid.stride();
        for (nodes, [x, y]) in [(first..masses.len(), [0.3, -2.0]), (0..first, [0.0, 3.0])] {
            for node in nodes {
                let [vx, vy] = state.velocity_mut();
                (vx[node], vy[node]) = if masses[node] > 0.0 { (x, y) } else { (0.0, 0.0) };
            }
        }
        let momentum = |state: &softanvil_kernel::State| {
            [0, 1].map(|i| masses.iter().zip(state.velocity()[i]).map(|(mass, v)| mass * v).sum::<f64>())
        };
        let (before, mut changed) = (momentum(state), 0.0_f64);
        let slab = |state: &softanvil_kernel::State| state.velocity()[1][grid.surface_node(grid.centre, 0)];
        for _ in 0..(1e-3 / model.constants.dt) as usize {
            softanvil_kernel::step(model, state, &StepInput::default()).unwrap();
            changed = changed.max((slab(state) + 2.0).abs());
        }
        (before, momentum(state), changed)
    });
    let (before, after, changed) = found.unwrap();
    assert!(changed > 0.5, "the layers have not met");
    for (after, before_it) in after.iter().zip(before) {
        assert!((after - before_it).abs() < 1e-10 * before[1].abs(), "{before:?} kg m/s, then {after}");
    }
}

/// A state of a stack with interfaces is saved and goes on with the same bits, and a reset starts anew.
#[test]
fn snapshots_of_interfaces_continue_with_the_same_bits() {
    let scenario = padded(6e-3, 60e-3, LayerInterface::Frictional, 0.5e-3);
    let mut whole = Simulation::new(&scenario).unwrap();
    let steps = whole.constants().steps_in(8e-3);
    whole.step(steps, &StepInput::default()).unwrap();
    let mut first = Simulation::new(&scenario).unwrap();
    first.step(steps / 2, &StepInput::default()).unwrap();
    let saved = first.save().unwrap();
    let mut second = Simulation::new(&scenario).unwrap();
    second.restore(&saved).unwrap();
    second.step(steps - steps / 2, &StepInput::default()).unwrap();
    assert_eq!(whole.scalars(), second.scalars());
    first.reset().unwrap();
    first.step(steps, &StepInput::default()).unwrap();
    assert_eq!(whole.scalars(), first.scalars());
}

/// Half a section and the whole of it say the same of a stack, but for what the passes over the pairs, from left to right, leave.
#[test]
fn half_and_full_sections_agree() {
    let mut scenario = padded(6e-3, 60e-3, LayerInterface::Frictional, 0.5e-3);
    let peak = |scenario: &Scenario| {
        let mut simulation = Simulation::new(scenario).unwrap();
        simulation.run(scenario.time.duration, &StepInput::default()).unwrap();
        simulation.scalars().metrics.peak_force
    };
    let half = peak(&scenario);
    scenario.geometry.section = Section::Full;
    let full = peak(&scenario);
    assert!((full / half - 1.0).abs() < 1e-3, "{full} N and {half} N");
}

/// A pad that is as wide as the anvil and one of which nothing is said are the same; one that lies loose lets more through than
/// its own weight would.
#[test]
fn widths_and_gaps_count() {
    let peak = |scenario: &Scenario| {
        let mut simulation = Simulation::new(scenario).unwrap();
        simulation.run(scenario.time.duration, &StepInput::default()).unwrap();
        simulation.scalars().metrics.peak_force
    };
    let whole = padded(8e-3, 0.0, LayerInterface::Bonded, 0.0);
    let mut said = whole.clone();
    said.layers[1].width = std::f64::consts::PI * (scenario_core(&whole) + whole.layers[0].thickness);
    assert!((peak(&said) / peak(&whole) - 1.0).abs() < 1e-6);
    let mut narrow = whole.clone();
    narrow.layers[1].width = 30e-3;
    assert!(peak(&narrow) > 1.02 * peak(&whole), "{} against {}", peak(&narrow), peak(&whole));
}

fn scenario_core(scenario: &Scenario) -> f64 {
    scenario.geometry.core_radius
}
