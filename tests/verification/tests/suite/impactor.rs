//! The rigid impactor: free fall, and a mass on a linear spring.

use softanvil_kernel::scenario::{DropBy, Motion};
use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_verification::scenes::{block, elastic};
use softanvil_verification::tolerance::{FREE_FALL, SPRING, relative_error};

/// Source: uniform acceleration, v^2 = v0^2 + 2 g h and t = (v - v0) / g.
#[test]
fn free_fall_through_the_gap() {
    for (gap, speed) in [(2e-3, 2.4), (50e-3, 0.0), (10e-3, 0.5)] {
        let mut scenario = preset::study();
        scenario.impactor.gap = gap;
        scenario.impactor.drop_by = DropBy::Speed;
        scenario.impactor.drop_speed = speed;
        let gravity = scenario.impactor.gravity;
        let contact_speed = (speed * speed + 2.0 * gravity * gap).sqrt();
        let contact_time = (contact_speed - speed) / gravity;
        let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
        let dt = simulation.constants().dt;
        while simulation.scalars().metrics.impulse == 0.0 {
            let (time, impactor) = (simulation.time(), simulation.scalars().impactor);
            let height = gap - speed * time - 0.5 * gravity * time * time;
            assert!((impactor.position - height).abs() < FREE_FALL * gap.max(speed * time) * 10.0);
            let velocity = speed + gravity * time;
            assert!((impactor.velocity(dt) + velocity).abs() <= FREE_FALL * velocity);
            simulation.step(1, &StepInput::default()).expect("free fall");
        }
        // The force that keeps the face from passing acts in the step that would pass.
        let first = simulation.time() - dt;
        assert!(first <= contact_time && contact_time <= first + dt, "{first} s against {contact_time} s");
        // Recorded half a step before the forces of that step, so at most one and a half steps before contact.
        let measured = simulation.scalars().metrics.impact_speed;
        assert!(
            (measured - contact_speed).abs() <= 1.5 * gravity * dt * (1.0 + FREE_FALL),
            "{measured} m/s against {contact_speed} m/s"
        );
    }
}

/// Source: m x'' = m g - k x from x = 0 at v0: F_max = m g + sqrt((m g)^2 + k m v0^2), contact time
/// (2/w)(pi - atan(v0 w / g)); k = E' b w / H with E' = E / (1 - nu^2) for a block free to widen in plane strain.
#[test]
fn mass_on_a_linear_layer() {
    let (width, height, length) = (30e-3, 15e-3, 100e-3);
    let (shear, bulk) = (1e8, 4e8);
    let mut scenario = block(width, height, elastic(0.5 * shear, 0.0, bulk));
    scenario.silicone.density = 100.0;
    scenario.geometry.length = length;
    scenario.impactor.motion = Motion::Drop;
    scenario.impactor.mass = 500.0;
    scenario.impactor.gap = 0.0;
    scenario.impactor.gravity = 1.0;
    scenario.impactor.drop_by = DropBy::Speed;
    scenario.measurement.force_threshold = 0.0;
    // E' = E / (1 - nu^2) in terms of G and K.
    let modulus = 4.0 * shear * (shear + 3.0 * bulk) / (3.0 * bulk + 4.0 * shear);
    let stiffness = modulus * length * width / height;
    let (mass, gravity) = (scenario.impactor.mass, scenario.impactor.gravity);
    let omega = (stiffness / mass).sqrt();
    // A strain of 0.3 %.
    let speed = 0.003 * height * omega;
    scenario.impactor.drop_speed = speed;
    let weight = mass * gravity;
    let peak = weight + (weight * weight + stiffness * mass * speed * speed).sqrt();
    let contact_time = 2.0 / omega * (std::f64::consts::PI - (speed * omega / gravity).atan());

    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(1.3 * contact_time);
    simulation.step(steps, &StepInput::default()).expect("a stable run");
    let metrics = simulation.scalars().metrics;
    assert!(relative_error(metrics.peak_force, peak) < SPRING, "peak {} N against {peak} N", metrics.peak_force);
    assert!(
        relative_error(metrics.contact_time, contact_time) < SPRING,
        "contact {} s against {contact_time} s",
        metrics.contact_time
    );
    assert!(relative_error(metrics.rebound_speed, speed) < SPRING, "rebound {} m/s", metrics.rebound_speed);
}
