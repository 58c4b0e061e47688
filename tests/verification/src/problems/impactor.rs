//! The rigid impactor as a mass on a linear spring, a block free to widen in plane strain.

use softanvil_kernel::scenario::{DropBy, Motion};
use softanvil_kernel::{Simulation, StepInput};

use crate::row::Check;
use crate::scenes::{block, elastic};

/// A quantity of the impact and its closed form.
pub struct Measured {
    /// What it is.
    pub what: &'static str,
    /// By the kernel.
    pub value: f64,
    /// By the closed form.
    pub reference: f64,
}

/// Peak force in N, contact time in s and rebound speed in m/s.
///
/// # Panics
/// If the run fails.
pub fn spring() -> [Measured; 3] {
    let (width, height, length) = (30e-3, 15e-3, 100e-3);
    let (shear, bulk) = (1e8, 4e8);
    let mut scenario = block(width, height, elastic(0.5 * shear, 0.0, bulk));
    scenario.layers[0].material.density = 100.0;
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
    [
        Measured { what: "peak force", value: metrics.peak_force, reference: peak },
        Measured { what: "contact time", value: metrics.contact_time, reference: contact_time },
        Measured { what: "rebound speed", value: metrics.rebound_speed, reference: speed },
    ]
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |Measured { what, value, reference }| Check {
        problem: "impactor",
        quantity: format!("mass on a linear layer: {what}"),
        reference: "closed form, layer without mass",
        error: (value / reference - 1.0_f64).abs(),
    };
    spring().map(check).into()
}
