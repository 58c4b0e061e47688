//! The kernel in single precision against that in double precision: the study's drops.

use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_kernel_f32 as single;
use softanvil_verification::tolerance::SINGLE_PRECISION;

/// Peak force, N; largest deformation, m; impact duration, s; impulse, N s.
const QUANTITIES: [&str; 4] =
    ["result.peak_force", "result.max_deformation", "result.impact_duration", "result.impulse"];

/// The numbers, and the step, s.
fn in_double(energy: f64) -> ([f64; 4], f64) {
    let mut scenario = preset::study();
    scenario.impactor = scenario.impactor.with_energy(energy);
    let mut simulation = Simulation::new(&scenario).unwrap();
    let steps = simulation.constants().steps_in(scenario.time.duration);
    simulation.step(steps, &StepInput::default()).unwrap();
    let read =
        |name| (softanvil_kernel::Output::find(name).unwrap().read)(simulation.constants(), simulation.scalars());
    (QUANTITIES.map(read), simulation.constants().dt)
}

/// With the step of `double`, which rounding might make one more or less in an interval.
fn in_single(energy: f32, step: f64) -> [f64; 4] {
    let mut scenario = single::preset::study();
    scenario.impactor = scenario.impactor.with_energy(energy);
    (scenario.time.step_by, scenario.time.step) = (single::scenario::StepBy::Given, step as f32);
    let mut simulation = single::Simulation::new(&scenario).unwrap();
    let steps = simulation.constants().steps_in(scenario.time.duration);
    simulation.step(steps, &single::StepInput::default()).unwrap();
    let read = |name| (single::Output::find(name).unwrap().read)(simulation.constants(), simulation.scalars());
    QUANTITIES.map(|name| f64::from(read(name)))
}

#[test]
fn single_precision_gives_the_four_numbers() {
    for energy in [14.7, 9.8, 4.9] {
        let (double, step) = in_double(energy);
        let single = in_single(energy as f32, step);
        for ((name, double), single) in QUANTITIES.iter().zip(double).zip(single) {
            let deviation = (single - double) / double;
            println!("{energy} J, {name}: {double:.6} and {single:.6}, {:+.5} %", 100.0 * deviation);
            assert!(deviation.abs() <= SINGLE_PRECISION, "{energy} J: {name} deviates by {deviation:e}");
        }
    }
}

/// The energy ledger closes as well as the digits allow, and the golden traces hold the bits.
#[test]
fn single_precision_closes_its_books() {
    let mut simulation = single::Simulation::new(&single::preset::study()).unwrap();
    let steps = simulation.constants().steps_in(15e-3);
    simulation.step(steps, &single::StepInput::default()).unwrap();
    let residual = f64::from(simulation.scalars().energy.residual());
    assert!(residual.abs() <= SINGLE_PRECISION * 14.7, "{residual} J");
}
