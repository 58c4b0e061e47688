//! The rigid impactor: free fall, and a mass on a linear spring.

use softanvil_kernel::scenario::DropBy;
use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_verification::problems::impactor::{Measured, spring};
use softanvil_verification::tolerance::{FREE_FALL, FREE_FALL_ENERGY, SPRING, relative_error};

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
            assert!((impactor.velocity + velocity).abs() <= FREE_FALL * velocity);
            // Kinetic energy is that of the velocity beside it, and all of it comes from the start and from gravity.
            let (energy, mass) = (simulation.scalars().energy, scenario.impactor.mass);
            assert_eq!(energy.impactor_kinetic, 0.5 * mass * impactor.velocity * impactor.velocity);
            let at_contact = 0.5 * mass * contact_speed * contact_speed;
            assert!(energy.residual().abs() <= FREE_FALL_ENERGY * at_contact, "{} J", energy.residual());
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
    for Measured { what, value, reference } in spring() {
        assert!(relative_error(value, reference) < SPRING, "{what} {value} against {reference}");
    }
}
