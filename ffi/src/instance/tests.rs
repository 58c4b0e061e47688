use std::string::ToString;

use super::*;
use crate::variables::references;

const SAMPLE: f64 = 50e-6;
const FORCE: u32 = 3000;
const MASS: u32 = 1101;
const FACTOR: u32 = 1601;
const ENERGY: u32 = 1107;

fn ready() -> Instance {
    let mut instance = Instance::new(Version::Fmi2);
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance
}

fn run(instance: &mut Instance, steps: u32) {
    for _ in 0..steps {
        instance.do_step(instance.time(), SAMPLE).unwrap();
    }
}

#[test]
fn a_master_that_accumulates_its_times_is_followed() {
    let mut instance = ready();
    let dt = instance.real(references::TIME_STEP).unwrap();
    // Whole kernel steps, summed up by a master whose rounding errors grow.
    let (mut time, step) = (0.0, 7.0 * dt);
    for _ in 0..1000 {
        instance.do_step(time, step).unwrap();
        time += step;
    }
    assert!((instance.time() - time).abs() < 1e-12);
}

#[test]
fn a_step_is_whole_or_refused_with_the_kernels_step() {
    let mut instance = ready();
    let dt = instance.real(references::TIME_STEP).unwrap();
    for step in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -SAMPLE, 0.0, -0.0, 0.5 * dt, 1.01 * dt, 1e300] {
        let error = instance.do_step(0.0, step).unwrap_err();
        assert!(matches!(error, Error::StepSize { .. }), "{step}: {error}");
        assert!(error.to_string().contains(&dt.to_string()), "{error}");
    }
    for (step, count) in [(dt, 1.0), (dt * (1.0 + 1e-7), 1.0), (SAMPLE, (SAMPLE / dt).round())] {
        let before = instance.time();
        instance.do_step(before, step).unwrap();
        assert!(((instance.time() - before) / dt - count).abs() < 1e-6);
    }
}

#[test]
fn a_failed_step_leads_to_an_instance_that_can_be_reset_or_restored() {
    let mut instance = Instance::new(Version::Fmi2);
    instance.set_reals([(FACTOR, 1.0), (ENERGY, 1000.0)].into_iter()).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    let saved = instance.save().unwrap();
    let error = (0..300).find_map(|_| instance.do_step(instance.time(), SAMPLE).err()).unwrap();
    assert!(matches!(error, Error::Step(_)), "{error}");
    assert!(instance.has_failed());
    assert!(instance.save().is_err());
    instance.restore(&saved).unwrap();
    run(&mut instance, 1);
    instance.reset();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    run(&mut instance, 60);
}

#[test]
fn one_refused_value_changes_none() {
    let mut instance = Instance::new(Version::Fmi2);
    let before = instance.real(MASS).unwrap();
    for second in [(FACTOR, f64::NAN), (FORCE, 1.0), (999, 1.0), (references::TIME, 1.0)] {
        assert!(instance.set_reals([(MASS, 4.0), second].into_iter()).is_err());
        assert_eq!(instance.real(MASS).unwrap(), before);
    }
}

#[test]
fn saved_bytes_are_checked_before_anything_changes() {
    let mut instance = ready();
    run(&mut instance, 60);
    let saved = instance.save().unwrap();
    let bytes = saved.bytes();
    assert_eq!(instance.read_state(bytes).unwrap(), saved);
    for length in (0..bytes.len()).step_by(61) {
        assert!(instance.read_state(&bytes[..length]).is_err());
    }
    for index in (0..bytes.len()).step_by(509) {
        let mut altered = bytes.to_vec();
        altered[index] ^= 0x10;
        assert!(instance.read_state(&altered).is_err(), "byte {index}");
    }
}

#[test]
fn initial_results_follow_the_parameters_as_they_stand() {
    const POSITION: u32 = 3200;
    const GAP: u32 = 1103;
    let mut instance = Instance::new(Version::Fmi2);
    instance.enter_initialization();
    for gap in [1e-3, 3e-3] {
        instance.set_reals([(GAP, gap)].into_iter()).unwrap();
        assert_eq!(instance.real(POSITION).unwrap(), gap);
    }
}

#[test]
fn the_longest_step_is_the_longest_run() {
    let duration = softanvil_kernel::Parameter::find("time.duration").unwrap();
    assert_eq!(stepping::LONGEST_STEP, duration.range().1);
}
