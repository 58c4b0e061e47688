//! The kernel in single precision against that in double precision: the study's drops.

use softanvil_kernel::{Simulation, StepInput, preset};
use softanvil_kernel_f32 as single;
use softanvil_verification::tolerance::{SINGLE_BRANCH, SINGLE_PRECISION};

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

/// A branch of whatever relaxation time carries in single precision what it does in double: from relaxed within a step to
/// not at all.
#[test]
fn a_branch_of_any_time_carries_its_part_in_single_precision() {
    let mut largest = [0.0_f64, f64::INFINITY];
    for tau in (-7..=6).map(|exponent| 10_f64.powi(exponent)) {
        let mut scenario = preset::study();
        scenario.mesh.element_size = 5e-3;
        scenario.layers[0].material.prony_g = [0.5, 0.0, 0.0, 0.0, 0.0];
        scenario.layers[0].material.prony_tau[0] = tau;
        let mut double = Simulation::new(&scenario).unwrap();
        let step = double.constants().dt;
        double.step(double.constants().steps_in(8e-3), &StepInput::default()).unwrap();
        let mut scenario = single::preset::study();
        scenario.mesh.element_size = 5e-3;
        scenario.layers[0].material.prony_g = [0.5, 0.0, 0.0, 0.0, 0.0];
        scenario.layers[0].material.prony_tau[0] = tau as f32;
        (scenario.time.step_by, scenario.time.step) = (single::scenario::StepBy::Given, step as f32);
        let mut found = single::Simulation::new(&scenario).unwrap();
        found.step(found.constants().steps_in(8e-3), &single::StepInput::default()).unwrap();
        let [expected, found] = [double.scalars().metrics.peak_force, f64::from(found.scalars().metrics.peak_force)];
        println!("tau = {tau:e} s: {expected:.1} and {found:.1} N");
        assert!((found / expected - 1.0).abs() < SINGLE_BRANCH, "tau = {tau:e} s: {found} N, not {expected} N");
        largest = [largest[0].max(expected), largest[1].min(expected)];
    }
    assert!(largest[0] > 1.2 * largest[1], "the branch carries nothing: {largest:?}");
}

/// As in double precision: no sample is lost to rounding in a minute.
#[test]
fn a_duration_has_as_many_samples_as_it_is_long_in_single_precision() {
    let simulation = single::Simulation::new(&single::preset::study()).unwrap();
    let per_sample = u64::from(simulation.constants().steps_per_sample);
    let samples = |duration: f64| simulation.constants().steps_in(duration as f32) / per_sample;
    for whole in (0..3000).chain((3000..2_000_000).step_by(997)) {
        assert_eq!(samples(whole as f64 / 20e3), whole, "{whole} samples");
    }
    for seconds in 1..=100 {
        assert_eq!(samples(f64::from(seconds)), 20_000 * seconds as u64, "{seconds} s");
    }
    assert_eq!((samples(0.015_001), samples(1.000_01)), (301, 20_001));
}
