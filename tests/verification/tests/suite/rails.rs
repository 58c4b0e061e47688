//! Rails that guide the falling mass: friction that stops it and holds it, damping, and what both take.

use softanvil_kernel::scenario::DropBy;
use softanvil_kernel::{Scenario, Simulation, StepInput, preset};
use softanvil_verification::tolerance::{RAILS, relative_error};

/// A fall from 50 mm above the anvil.
fn fall(speed: f64, friction: f64, damping: f64) -> Scenario {
    let mut scenario = preset::study();
    (scenario.impactor.gap, scenario.impactor.drop_by, scenario.impactor.drop_speed) = (50e-3, DropBy::Speed, speed);
    (scenario.impactor.rail_friction, scenario.impactor.rail_damping) = (friction, damping);
    scenario
}

/// Source: uniform acceleration g - F/m, v^2 = v0^2 + 2 (g - F/m) h.
#[test]
fn friction_slows_a_free_fall() {
    let mut simulation = Simulation::new(&fall(1.0, 12.0, 0.0)).unwrap();
    while simulation.scalars().impactor.position > 5e-3 {
        simulation.step(1, &StepInput::default()).unwrap();
    }
    let (scalars, acceleration) = (simulation.scalars(), 9.81 - 12.0 / 5.0);
    let travel = 50e-3 - scalars.impactor.position;
    let speed = (1.0 + 2.0 * acceleration * travel).sqrt();
    assert!(
        relative_error(-scalars.impactor.velocity, speed) < RAILS,
        "{} m/s against {speed}",
        scalars.impactor.velocity
    );
    assert!(relative_error(scalars.energy.guide, 12.0 * travel) < RAILS, "{} J", scalars.energy.guide);
    assert!(scalars.energy.residual().abs() < 1e-9 * scalars.energy.external);
}

/// Source: m v' = m g - c v, v = v_inf + (v0 - v_inf) exp(-c t / m), v_inf = m g / c.
#[test]
fn damping_brings_a_fall_to_its_last_speed() {
    let (damping, start) = (500.0, 1.0);
    let mut simulation = Simulation::new(&fall(start, 0.0, damping)).unwrap();
    let steps = simulation.constants().steps_in(20e-3);
    simulation.step(steps, &StepInput::default()).unwrap();
    let (last, decay) = (5.0 * 9.81 / damping, (-damping * simulation.time() / 5.0).exp());
    let speed = last + (start - last) * decay;
    let scalars = simulation.scalars();
    // The first step takes the force of its end, as the rest: of first order in the step.
    let allowed = 2.0 * damping / 5.0 * simulation.constants().dt;
    assert!(
        relative_error(-scalars.impactor.velocity, speed) < allowed,
        "{} against {speed}",
        scalars.impactor.velocity
    );
    assert!(scalars.energy.residual().abs() < 1e-9 * scalars.energy.external);
}

/// Rails that bear more than the weight stop the mass in the air, exactly, and hold it there.
#[test]
fn friction_above_the_weight_stops_and_holds() {
    let mut simulation = Simulation::new(&fall(0.5, 100.0, 0.0)).unwrap();
    let way = 0.5 * 0.5 / (2.0 * (100.0 / 5.0 - 9.81));
    let steps = simulation.constants().steps_in(60e-3);
    simulation.step(steps, &StepInput::default()).unwrap();
    let stopped = *simulation.scalars();
    assert_eq!([stopped.impactor.velocity, stopped.impactor.velocity_half], [0.0, 0.0]);
    // The first step takes all of the friction, which is half a step too much.
    let allowed = 100.0 / 5.0 * simulation.constants().dt / 0.5;
    assert!(relative_error(50e-3 - stopped.impactor.position, way) < allowed, "{way} m");
    simulation.step(1000, &StepInput::default()).unwrap();
    assert_eq!(simulation.scalars().impactor.position, stopped.impactor.position);
    assert!(stopped.energy.residual().abs() < 1e-8 * stopped.energy.external);
    // A force beyond the friction moves it, less than that does not.
    let push = |force: f64| {
        let mut pushed = simulation.clone();
        pushed.step(1000, &StepInput { external_force: force, ..StepInput::default() }).unwrap();
        pushed.scalars().impactor.position - stopped.impactor.position
    };
    let (weight, friction) = (5.0 * 9.81, 100.0);
    assert_eq!([push(weight + 0.99 * friction), push(weight - 0.99 * friction)], [0.0, 0.0]);
    assert!(push(weight + 1.01 * friction) > 0.0 && push(weight - 1.01 * friction) < 0.0);
}

/// A mass that the rails hold on the anvil rests with no speed at all, and the books close on the way there.
#[test]
fn a_mass_comes_to_rest_on_the_anvil() {
    for (friction, damping) in [(600.0, 0.0), (400.0, 50.0)] {
        let mut scenario = fall(1.5, friction, damping);
        scenario.impactor.gap = 2e-3;
        let mut simulation = Simulation::new(&scenario).unwrap();
        let mut worst: f64 = 0.0;
        for _ in 0..200 {
            simulation.run(1e-3, &StepInput::default()).unwrap();
            worst = worst.max(simulation.scalars().energy.residual().abs() / simulation.scalars().energy.external);
        }
        let scalars = simulation.scalars();
        assert!(worst < 5e-3, "{worst}");
        assert_eq!([scalars.impactor.velocity, scalars.impactor.velocity_half], [0.0, 0.0]);
        assert!(scalars.force.contact <= friction + 5.0 * 9.81, "{} N", scalars.force.contact);
        assert!(scalars.energy.guide > 0.0);
    }
}

/// The snapshot of a mass on rails holds what they have taken.
#[test]
fn a_snapshot_continues_on_the_rails() {
    let mut simulation = Simulation::new(&fall(1.0, 12.0, 3.0)).unwrap();
    simulation.step(2000, &StepInput::default()).unwrap();
    let saved = simulation.save().unwrap();
    let mut other = Simulation::new(&fall(1.0, 12.0, 3.0)).unwrap();
    other.restore(&saved).unwrap();
    for either in [&mut simulation, &mut other] {
        either.step(2000, &StepInput::default()).unwrap();
    }
    assert_eq!(simulation.scalars(), other.scalars());
    assert!(other.scalars().energy.guide > 0.0);
}
