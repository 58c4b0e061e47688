//! Full section, offset impactor, and the ways in which a layer sits on its core.

use softanvil_kernel::scenario::{Interface, Section};
use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{SYMMETRY, relative_error};

/// The full section is two halves: same forces, and mirrored fields. Only the order of sums differs.
#[test]
fn a_full_section_is_two_halves() {
    let half = preset::study();
    let mut full = half.clone();
    full.geometry.section = Section::Full;
    let (half, mut full) = (run(&half), run(&full));
    assert_eq!(full.constants().grid.n_elem(), 2 * half.constants().grid.n_elem());
    let (a, b) = (half.scalars().metrics, full.scalars().metrics);
    for (name, a, b) in [
        ("peak force", a.peak_force, b.peak_force),
        ("deformation", a.max_deformation, b.max_deformation),
        ("impulse", a.impulse, b.impulse),
        ("rebound speed", a.rebound_speed, b.rebound_speed),
    ] {
        assert!(relative_error(b, a) < SYMMETRY, "{name}: half {a}, full {b}");
    }
    let largest = full
        .with(|model, state| {
            let grid = model.constants.grid;
            let [x, y] = state.displacement();
            let mut difference = 0.0_f64;
            for v in 0..=grid.n_v {
                for u in 0..=grid.centre {
                    let (left, right) = (v * grid.stride() + u, v * grid.stride() + grid.n_u - u);
                    difference = difference.max((x[left] + x[right]).abs()).max((y[left] - y[right]).abs());
                }
            }
            difference
        })
        .expect("memory of the right size");
    assert!(largest < SYMMETRY * a.max_deformation, "mirrored displacements differ by {largest} m");
}

/// An offset to the right gives the mirror image of one to the left, and less area under the face's chord.
#[test]
fn an_offset_impactor() {
    let drop = |offset: f64| {
        let mut scenario = preset::study();
        scenario.geometry.section = Section::Full;
        scenario.impactor.offset = offset;
        run(&scenario).scalars().metrics
    };
    let (left, right, centred) = (drop(-8e-3), drop(8e-3), drop(0.0));
    assert!(relative_error(left.peak_force, right.peak_force) < SYMMETRY);
    assert!(right.peak_force != centred.peak_force);
}

/// What a section cannot be is refused with a reason.
#[test]
fn impossible_sections_are_refused() {
    let mut offset_half = preset::study();
    offset_half.impactor.offset = 1e-3;
    let error = offset_half.validate().expect_err("an offset of a half section").to_string();
    assert!(error.contains("impactor.offset") && error.contains(" m"), "{error}");
    let mut full_dome = preset::study();
    full_dome.geometry.section = Section::Full;
    full_dome.geometry.formulation = softanvil_kernel::scenario::Formulation::Axisymmetric;
    assert!(full_dome.validate().is_err());
}

/// Frictional cores lie between rollers and glue: friction only adds stiffness.
#[test]
fn core_interfaces_are_ordered() {
    let peak = |interface: Interface, friction: f64| {
        let mut scenario = preset::study();
        scenario.core.interface = interface;
        scenario.core.friction_coefficient = friction;
        let simulation = run(&scenario);
        let ledger = simulation.scalars().energy;
        assert!(ledger.residual().abs() < 1e-3 * 14.7, "{interface:?}: residual {} J", ledger.residual());
        simulation.scalars().metrics.max_deformation
    };
    let rollers = peak(Interface::Sliding, 0.0);
    let slippery = peak(Interface::Frictional, 0.1);
    let rough = peak(Interface::Frictional, 5.0);
    let glued = peak(Interface::Bonded, 0.0);
    assert!(
        rollers > slippery && slippery > rough && rough >= glued * (1.0 - 1e-3),
        "{rollers} {slippery} {rough} {glued}"
    );
}

/// A core that separates is one with friction whose coefficient is zero, to the last bit; unlike rollers it lets the layer go,
/// which it takes up again: the anvil leaves it when the mass has left the anvil.
#[test]
fn a_core_that_separates_does_not_rub_and_lets_the_layer_go() {
    let drop = |interface: Interface| {
        let mut scenario = preset::elastic();
        // It counts with friction alone.
        let coefficient = if interface == Interface::Frictional { 0.0 } else { 0.3 };
        (scenario.core.interface, scenario.core.friction_coefficient) = (interface, coefficient);
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let (mut lifted, mut residual) = (0.0_f64, 0.0_f64);
        for _ in 0..simulation.constants().steps_in(30e-3) / 10 {
            simulation.step(10, &StepInput::default()).expect("a stable run");
            let energy = simulation.scalars().energy.residual().abs();
            let gap = simulation.with(|model, state| {
                let ([x, y], [ux, uy]) = (model.reference_position(), state.displacement());
                let radius = model.constants.scenario.geometry.core_radius;
                let height = |node: usize| (x[node] + ux[node]).hypot(y[node] + uy[node]) - radius;
                (0..=model.constants.grid.n_u).map(height).fold(0.0, f64::max)
            });
            (lifted, residual) = (lifted.max(gap.expect("memory of the right size")), residual.max(energy));
        }
        assert!(residual < 5e-3 * 14.7, "{interface:?}: residual {residual} J");
        (lifted, simulation.scalars().sampler.trace_hash)
    };
    let [(held, on_rollers), (lifted, separating), (_, frictional)] =
        [Interface::Sliding, Interface::Separating, Interface::Frictional].map(drop);
    assert_eq!(separating, frictional);
    assert_ne!(separating, on_rollers);
    // Rollers hold velocities: from step to step a node leaves the round core by a little.
    assert!(held < 1e-6 && lifted > 1e-3, "rollers {held} m, separating {lifted} m");
}

/// The extent of the contact grows with the load and ends with it.
#[test]
fn contact_half_width_follows_the_load() {
    let scenario = preset::study();
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(scenario.time.duration);
    let mut widest = 0.0_f64;
    for _ in 0..steps {
        simulation.step(1, &StepInput::default()).expect("a stable run");
        let scalars = simulation.scalars();
        assert_eq!(scalars.force.contact > 0.0, scalars.contact_half_width > 0.0);
        widest = widest.max(scalars.contact_half_width);
    }
    // The chord of the undeformed circle at the largest deformation, which bulging can only widen.
    let outer = scenario.geometry.core_radius + scenario.thickness();
    let depth = simulation.scalars().metrics.max_deformation;
    let chord = (depth * (2.0 * outer - depth)).sqrt();
    assert!(widest > 0.8 * chord && widest < outer, "{widest} m against a chord of {chord} m");
    assert_eq!(simulation.scalars().contact_half_width, 0.0);
}
