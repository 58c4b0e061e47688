//! A face driven from outside: where it is at the end of a call, how it gets there, what its outputs say, and which inputs
//! are legal.

use softanvil_kernel::scenario::{DropBy, Motion};
use softanvil_kernel::{Output, Scenario, Simulation, StepError, StepInput, preset, steps};
use softanvil_verification::tolerance::{COUPLED_PEAK, PATH, relative_error};

fn scenario() -> Scenario {
    let mut scenario = preset::study();
    scenario.impactor.motion = Motion::Driven;
    scenario.mesh.element_size = 7e-3;
    scenario
}

fn driven() -> Simulation {
    Simulation::new(&scenario()).expect("a legal scenario")
}

fn to(position: f64, velocity: Option<f64>) -> StepInput {
    StepInput { driven_position: Some(position), driven_velocity: velocity, ..StepInput::default() }
}

/// Source: uniform motion. The velocity is that of the face from its first step on, and 0 from the first step of a rest on.
#[test]
fn a_straight_line_has_one_velocity() {
    let mut simulation = driven();
    let (gap, dt) = (simulation.constants().scenario.impactor.gap, simulation.constants().dt);
    for count in [1, 7, 100] {
        let from = simulation.scalars().impactor.position;
        simulation.step(count, &to(from - count as f64 * dt, None)).expect("a stable run");
        assert_eq!(simulation.scalars().impactor.position, from - count as f64 * dt);
        assert!((simulation.scalars().impactor.velocity + 1.0).abs() < PATH);
    }
    assert!(simulation.scalars().impactor.position < gap);
    let rest = simulation.scalars().impactor.position;
    for count in [1, 5] {
        simulation.step(count, &StepInput::default()).expect("a stable run");
        assert_eq!((simulation.scalars().impactor.position, simulation.scalars().impactor.velocity), (rest, 0.0));
    }
}

/// Source: a cubic has one course through two positions and two velocities, so a call along one gives every point of it,
/// and calls of any length the same points.
#[test]
fn a_position_and_a_velocity_are_reached_along_the_cubic() {
    let (mut whole, mut pieces) = (driven(), driven());
    let (gap, dt) = (whole.constants().scenario.impactor.gap, whole.constants().dt);
    let count = 120;
    let duration = f64::from(count) * dt;
    // From rest, and up again at the end.
    let cubic = |t: f64| {
        let s = t / duration;
        [gap - 0.4e-3 * s * s * (3.0 - s * 2.5), -0.4e-3 * s * (6.0 - s * 7.5) / duration]
    };
    whole
        .with(|model, state| {
            let [position, velocity] = cubic(duration);
            steps(model, state, count as u64, &to(position, Some(velocity))).expect("a stable run");
            assert_eq!([state.scalars.impactor.position, state.scalars.impactor.velocity], [position, velocity]);
        })
        .expect("memory of the right size");
    let mut made = 0;
    for length in [1, 9, 2, 30, 1, 77] {
        made += length;
        let [position, velocity] = cubic(f64::from(made) * dt);
        pieces.step(length as u64, &to(position, Some(velocity))).expect("a stable run");
    }
    assert_eq!(made, count);
    let forces = [whole, pieces].map(|simulation| simulation.scalars().impactor);
    assert!((forces[0].position - forces[1].position).abs() < PATH * gap);
    assert!((forces[0].velocity_half - forces[1].velocity_half).abs() < 1e-6 * forces[0].velocity.abs());
}

/// The work of the drive is what the layer takes up, whatever the path.
#[test]
fn the_books_close_while_a_face_is_driven() {
    for velocity in [None, Some(-1.0)] {
        let mut simulation = driven();
        let gap = simulation.constants().scenario.impactor.gap;
        for sample in 1..=160 {
            let down = f64::from(sample) * 50e-6;
            let count = u64::from(simulation.constants().steps_per_sample);
            simulation.step(count, &to(gap - down, velocity)).expect("a stable run");
        }
        let ledger = simulation.scalars().energy;
        assert!(ledger.external > 1.0, "{} J", ledger.external);
        assert!(ledger.residual().abs() < 1e-3 * ledger.external, "{} J of {} J", ledger.residual(), ledger.external);
    }
}

/// A mass outside, which predicts its motion with the force that it expects and corrects itself by the impulse that came.
fn coupled(size: u64, with_velocity: bool) -> f64 {
    let mut scenario = preset::study();
    let (mass, gravity) = (scenario.impactor.mass, scenario.impactor.gravity);
    let mut position = scenario.impactor.gap;
    let mut velocity = -scenario.impactor.start_speed();
    scenario.impactor.motion = Motion::Driven;
    scenario.time.design_compression = 0.8;
    let mut anvil = Simulation::new(&scenario).expect("a legal scenario");
    let count = size * u64::from(anvil.constants().steps_per_sample);
    let duration = size as f64 * 50e-6;
    let (mut impulse, mut forces) = (0.0, [0.0_f64; 2]);
    for _ in 0..300 / size {
        let expected = (2.0 * forces[1] - forces[0]).max(0.0) / mass - gravity;
        let end_velocity = velocity + duration * expected;
        let end = position + 0.5 * duration * (velocity + end_velocity);
        anvil.step(count, &to(end, with_velocity.then_some(end_velocity))).expect("a stable run");
        let now = anvil.scalars().metrics.impulse;
        forces = [forces[1], (now - impulse) / duration];
        impulse = now;
        let change = duration * (forces[1] / mass - gravity);
        position += duration * (velocity + 0.5 * change);
        velocity += change;
    }
    anvil.scalars().metrics.peak_force
}

/// Source: the same drop with the mass inside.
#[test]
fn a_mass_outside_gives_the_peak_of_the_drop() {
    let mut inside = Simulation::new(&preset::study()).expect("a legal scenario");
    let count = inside.constants().steps_in(15e-3);
    inside.step(count, &StepInput::default()).expect("a stable run");
    let peak = inside.scalars().metrics.peak_force;
    for (size, most) in COUPLED_PEAK {
        for with_velocity in [false, true] {
            let found = coupled(size, with_velocity);
            println!(
                "{} us, velocity {with_velocity}: {found:.1} N, {:+.3} %",
                50 * size,
                100.0 * (found / peak - 1.0)
            );
            assert!(relative_error(found, peak) < most, "{size} samples: {found} N against {peak} N");
        }
    }
}

/// Every input that acts has a range; a refusal names input, value, unit and range, makes no step, and stops nothing.
#[test]
fn inputs_that_are_not_legal_are_refused_and_change_nothing() {
    let mut falling = scenario();
    (falling.impactor.motion, falling.impactor.drop_by) = (Motion::Drop, DropBy::Energy);
    let force = |external_force| StepInput { external_force, ..StepInput::default() };
    let cases = [
        (falling.clone(), force(1e300), "impactor.external_force = 1e300 N is refused: expected -1000000 to 1000000 N"),
        (falling, force(f64::NAN), "impactor.external_force = NaN N is refused: expected -1000000 to 1000000 N"),
        (scenario(), to(1.5, None), "impactor.driven_position = 1.5 m is refused: expected -1 to 1 m"),
        (scenario(), to(f64::NAN, None), "impactor.driven_position = NaN m is refused: expected -1 to 1 m"),
        (scenario(), to(0.0, Some(-101.0)), "impactor.driven_velocity = -101 m/s is refused: expected -100 to 100 m/s"),
        (scenario(), to(0.0, Some(f64::INFINITY)), "impactor.driven_velocity = inf m/s is refused"),
    ];
    for (scenario, input, text) in cases {
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        simulation.step(3, &StepInput::default()).expect("a stable run");
        let before = *simulation.scalars();
        for count in [1, 5] {
            let error = simulation.step(count, &input).expect_err("a refusal");
            assert!(matches!(error, StepError::Input { .. }) && error.to_string().starts_with(text), "{error}");
        }
        let alone = simulation.with(|model, state| softanvil_kernel::step(model, state, &input)).expect("memory");
        assert!(matches!(alone, Err(StepError::Input { .. })));
        assert_eq!(*simulation.scalars(), before);
        simulation.step(1, &StepInput::default()).expect("a run that goes on");
    }
    // What does not act may be any number, as the force on a driven face, but no NaN.
    let mut simulation = driven();
    simulation.step(2, &force(1e300)).expect("a force that does not act");
    assert!(simulation.step(2, &force(f64::NAN)).is_err());
    let external = Output::find("energy.external").expect("an output");
    assert_eq!((external.read)(simulation.constants(), simulation.scalars()), 0.0);
}
