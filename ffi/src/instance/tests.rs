use std::string::ToString;
use std::vec;
use std::vec::Vec;

use softanvil_kernel::parameter::Name;
use softanvil_kernel::{OUTPUTS, Output};

use super::*;
use crate::variables::{ValueType, references};
use crate::whole_steps::SAME;

const SAMPLE: f64 = 50e-6;
const FORCE: u32 = 3000;
const MASS: u32 = 1007;
const GAP: u32 = 1010;
const FACTOR: u32 = 1025;
const ENERGY: u32 = 1014;
const STEP_BY: u32 = 1024;
const STEP: u32 = 1026;
const MOTION: u32 = 1006;
const ELEMENT_SIZE: u32 = 1023;
const POSITION: u32 = 3003;

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

/// An instance with these values, and what becomes of it at the end of initialization.
fn initialized(values: &[(u32, f64)]) -> (Instance, Result<Vec<Name>, Error>) {
    let mut instance = Instance::new(Version::Fmi2);
    instance.enter_initialization();
    instance.set_reals(values.iter().copied()).unwrap();
    let changes = instance.exit_initialization();
    let scenario = instance.values().scenario();
    let without_effect = changes.map(|changes| changes.without_effect(&scenario).map(|value| value.name).collect());
    (instance, without_effect)
}

#[test]
fn one_of_several_values_decides_and_what_has_no_effect_is_told() {
    const HEIGHT: u32 = 1013;
    let of_tau_2 = softanvil_kernel::Parameter::find("layers[0].prony_tau_2").unwrap();
    let tau_2 = references::of_parameter(of_tau_2);
    let (mut instance, told) = initialized(&[(HEIGHT, 0.1)]);
    assert_eq!(told, Ok(vec![]));
    let speed = references::of_output(Output::find("impactor.velocity").unwrap());
    let expected = (2.0_f64 * 9.81 * 0.1).sqrt();
    assert!((instance.real(speed).unwrap() + expected).abs() < 1e-3, "{expected} m/s");
    let (_, told) = initialized(&[(HEIGHT, 0.1), (ENERGY, 9.8)]);
    let error = told.unwrap_err().to_string();
    assert!(error.contains("state the same thing"), "{error}");
    // A master that sets every start value may set this one, too.
    assert_eq!(initialized(&[(tau_2, 0.1)]).1, Ok(vec![of_tau_2.name()]));
    // The same value as the preset's changes nothing.
    assert_eq!(initialized(&[(tau_2, 1.0)]).1, Ok(vec![]));
}

/// A drop on a coarse mesh, for speed, that starts at `start` s.
fn coarse(start: f64) -> Instance {
    let mut instance = Instance::new(Version::Fmi3);
    instance.set_reals([(ELEMENT_SIZE, 7e-3)].into_iter()).unwrap();
    instance.setup(start, None).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance
}

fn dt_of(instance: &mut Instance) -> f64 {
    instance.real(references::TIME_STEP).unwrap()
}

/// Every result and the trace, to the last bit.
fn outcome(instance: &mut Instance) -> Vec<u64> {
    let mut bits: Vec<_> =
        OUTPUTS.iter().map(|output| instance.real(references::of_output(output)).unwrap().to_bits()).collect();
    let digits = instance.text(references::TRACE_HASH).unwrap();
    bits.extend(digits.chunks(8).map(|digits| u64::from_be_bytes(digits.try_into().unwrap())));
    bits
}

/// Steps of any length, s: those of screens and of logs, some without a pattern, and some that never meet a kernel step.
fn lengths(dt: f64) -> Vec<f64> {
    let mut dice = 1_u64;
    let random = core::iter::repeat_with(|| {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        1e-7 + 100e-6 * (dice >> 11) as f64 / (1_u64 << 53) as f64
    });
    let pi = core::f64::consts::PI;
    let mut all =
        vec![1.0 / 60.0, 30e-6, 1e-6, 2.0_f64.sqrt() * 1e-5, pi * 1e-6, 0.5 * dt, 1.5 * dt, dt / 3.0, 15e-3 / 500.0];
    all.extend(random.take(4));
    all
}

#[test]
fn a_step_of_any_length_goes_to_the_nearest_kernel_step_and_slices_do_as_one() {
    let dt = dt_of(&mut coarse(0.0));
    for length in lengths(dt) {
        let count = (5e-3 / length).ceil() as u32;
        let (mut instance, mut whole) = (coarse(0.0), coarse(0.0));
        let mut point = 0.0;
        for i in 0..count {
            instance.do_step(point, length).unwrap();
            point = f64::from(i + 1) * length;
            let kernel = instance.real(references::KERNEL_TIME).unwrap();
            assert!((instance.time() - point).abs() < 1e-15, "{length}: {point}");
            assert!((kernel - point).abs() <= 0.5 * dt + 1e-14, "{length}: {kernel} at {point}");
            assert!((kernel / dt - (kernel / dt).round()).abs() < 1e-6, "{length}: {kernel} is between steps");
        }
        whole.do_step(0.0, f64::from(count) * length).unwrap();
        assert_eq!(outcome(&mut instance), outcome(&mut whole), "{length}");
    }
}

#[test]
fn steps_of_changing_length_do_as_one() {
    let dt = dt_of(&mut coarse(0.0));
    let lengths = lengths(dt);
    let (mut instance, mut whole) = (coarse(0.0), coarse(0.0));
    let mut point = 0.0;
    for i in 0..2000 {
        // Most of them shorter than a kernel step.
        let length = lengths[1 + (i * i) % (lengths.len() - 1)] * if i % 5 == 0 { 1.0 } else { 0.07 };
        instance.do_step(point, length).unwrap();
        point += length;
        assert!((instance.real(references::KERNEL_TIME).unwrap() - point).abs() <= 0.5 * dt + 1e-14);
    }
    whole.do_step(0.0, point).unwrap();
    assert_eq!(outcome(&mut instance), outcome(&mut whole));
}

#[test]
fn a_tie_goes_up() {
    let mut instance = coarse(0.0);
    let dt = dt_of(&mut instance);
    for (i, steps) in [(1, 1.0), (2, 1.0), (3, 2.0), (4, 2.0), (5, 3.0)] {
        instance.do_step(f64::from(i - 1) * 0.5 * dt, 0.5 * dt).unwrap();
        assert_eq!((instance.real(references::KERNEL_TIME).unwrap() / dt).round(), steps, "half step {i}");
    }
}

#[test]
fn steps_that_make_no_kernel_step_leave_the_results_alone() {
    let mut instance = coarse(0.0);
    let dt = dt_of(&mut instance);
    instance.do_step(0.0, 60.0 * SAMPLE).unwrap();
    let (before, from) = (outcome(&mut instance), instance.time());
    for i in 0..40 {
        instance.do_step(from + f64::from(i) * 0.01 * dt, 0.01 * dt).unwrap();
        assert_eq!(outcome(&mut instance), before);
    }
    assert!((instance.time() - from - 0.4 * dt).abs() < 1e-15);
    assert_eq!(instance.real(references::KERNEL_TIME).unwrap(), from);
}

#[test]
fn a_master_that_accumulates_its_times_makes_the_kernel_steps_of_one_that_does_not() {
    for length in [SAMPLE, 2.0 * SAMPLE, 30e-6, 1.0 / 3.0 * 1e-4] {
        let mut whole = coarse(0.0);
        whole.do_step(0.0, 1200.0 * length).unwrap();
        let expected = outcome(&mut whole);
        for start in [0.0, -3.0, 5e3, 1e7, 1.7e9, -1.7e9] {
            let mut instance = coarse(start);
            let dt = dt_of(&mut instance);
            let mut point = start;
            for _ in 0..1200 {
                instance.do_step(point, length).unwrap();
                point += length;
                assert!((instance.time() - point).abs() <= SAME * dt);
                let away = (instance.real(references::KERNEL_TIME).unwrap() - point).abs();
                assert!(away <= 0.5 * dt + 2.0 * f64::EPSILON * point.abs(), "{start}: {away} s away");
            }
            assert_eq!(outcome(&mut instance), expected, "from {start} s by {length} s");
        }
    }
}

#[test]
fn a_master_that_rounds_every_time_makes_the_same_kernel_steps() {
    for start in [0.0, 0.1, 1e7, 1.7e9] {
        let (mut instance, mut whole) = (coarse(start), coarse(0.0));
        for i in 0..600 {
            instance.do_step(start + f64::from(i) * SAMPLE, SAMPLE).unwrap();
        }
        whole.do_step(0.0, 600.0 * SAMPLE).unwrap();
        assert_eq!(outcome(&mut instance), outcome(&mut whole), "from {start} s");
    }
}

#[test]
fn many_steps_of_a_master_that_accumulates_are_none_too_many() {
    // A step that rounds in the same direction every time, and drifts by many kernel steps.
    for start in [0.0, 1e7, 1.7e9] {
        let mut instance = coarse(start);
        let mut point = start;
        for _ in 0..50_000 {
            instance.do_step(point, 1e-6).unwrap();
            point += 1e-6;
        }
        let mut whole = coarse(0.0);
        whole.do_step(0.0, 50_000.0 * 1e-6).unwrap();
        assert_eq!(outcome(&mut instance), outcome(&mut whole), "from {start} s");
    }
}

#[test]
fn a_point_within_half_a_kernel_step_is_the_same_and_moves_the_clock() {
    let mut instance = coarse(0.0);
    let dt = dt_of(&mut instance);
    // Always a little late: the steps lead from there.
    for i in 0..200 {
        let late = if i % 2 == 0 { 0.4 } else { -0.4 };
        let point = f64::from(i) * SAMPLE + if i == 0 { 0.0 } else { 0.5 * late * dt };
        instance.do_step(point, SAMPLE).unwrap();
        let kernel = instance.real(references::KERNEL_TIME).unwrap();
        assert!((kernel - (point + SAMPLE)).abs() <= 0.5 * dt + 1e-14);
    }
    let (mut whole, expected) = (coarse(0.0), instance.time());
    whole.do_step(0.0, 200.0 * SAMPLE).unwrap();
    assert_eq!(outcome(&mut instance), outcome(&mut whole));
    for wrong in [-1.0, -0.51 * dt, 0.51 * dt, 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = instance.do_step(expected + wrong, SAMPLE).unwrap_err();
        assert!(matches!(error, Error::CommunicationPoint { .. }), "{wrong}: {error}");
        assert_eq!(instance.time(), expected);
    }
    instance.do_step(expected + 0.49 * dt, SAMPLE).unwrap();
}

#[test]
fn a_master_that_goes_back_and_back_is_refused() {
    let mut instance = coarse(0.0);
    let dt = dt_of(&mut instance);
    instance.do_step(0.0, 60.0 * SAMPLE).unwrap();
    let gone = (0..10).find_map(|_| instance.do_step(instance.time() - 0.45 * dt, 1e-9 * dt).err());
    assert!(matches!(gone, Some(Error::CommunicationPoint { .. })));
}

#[test]
fn a_step_is_positive_and_not_too_long() {
    let mut instance = coarse(0.0);
    for step in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -SAMPLE, 0.0, -0.0, 100.1, 1e300] {
        let error = instance.do_step(0.0, step).unwrap_err();
        assert!(matches!(error, Error::StepSize { .. }), "{step}: {error}");
        assert!(error.to_string().ends_with("expected above 0 s up to 100 s"), "{error}");
    }
    for step in [f64::MIN_POSITIVE, 5e-324, 1e-20, 1e-12] {
        instance.do_step(instance.time(), step).unwrap();
    }
    // The shortest steps add up, too.
    let dt = dt_of(&mut instance);
    let short = 1e-3 * dt;
    for _ in 0..501 {
        instance.do_step(instance.time(), short).unwrap();
    }
    assert_eq!((instance.real(references::KERNEL_TIME).unwrap() / dt).round(), 1.0);
}

#[test]
fn the_stop_time_is_the_end_however_the_master_rounds() {
    for start in [0.0, 0.1, 1e7, 1.7e9] {
        for (count, length) in [(500, 15e-3 / 500.0), (300, SAMPLE), (150, 2.0 * SAMPLE), (900, 1.0 / 60.0 * 1e-3)] {
            let stop = start + f64::from(count) * length;
            let mut instance = coarse(start);
            instance.setup(start, Some(stop)).unwrap();
            let mut point = start;
            for _ in 0..count {
                instance.do_step(point, length).unwrap();
                point += length;
            }
            let past = instance.do_step(point, length.max(20e-6)).unwrap_err();
            assert!(matches!(past, Error::PastStop { .. }), "{start}, {length}: {past}");
        }
    }
    // A last step that is cut to the stop time, by a master whose clock has lost some time.
    let (start, stop) = (1.7e9, 1.7e9 + 15e-3);
    let mut instance = coarse(start);
    instance.setup(start, Some(stop)).unwrap();
    let mut point = start;
    while point < stop {
        let length = (2.0 * SAMPLE).min(stop - point);
        instance.do_step(point, length).unwrap();
        point += length;
    }
}

#[test]
fn a_saved_state_goes_on_between_kernel_steps() {
    for start in [0.0, 1.7e9] {
        let length = 2.0_f64.sqrt() * 1e-5;
        let mut instance = coarse(start);
        let mut point = start;
        let mut run = |instance: &mut Instance, count: u32| {
            for _ in 0..count {
                instance.do_step(point, length).unwrap();
                point += length;
            }
        };
        run(&mut instance, 177);
        let saved = instance.save().unwrap();
        let mut other = Instance::new(Version::Fmi3);
        other.restore(&other.read_state(saved.bytes()).unwrap()).unwrap();
        assert_eq!((other.time(), outcome(&mut other)), (instance.time(), outcome(&mut instance)));
        assert_eq!(other.save().unwrap(), saved);
        let there = instance.time();
        run(&mut instance, 200);
        let mut point = there;
        for _ in 0..200 {
            other.do_step(point, length).unwrap();
            point += length;
        }
        assert_eq!(other.save().unwrap(), instance.save().unwrap());
    }
}

/// A motion without corners: down into the layer and up again.
fn commanded(time: f64) -> [f64; 2] {
    let (depth, rate) = (3e-3, 2.0 * core::f64::consts::PI * 100.0);
    [2e-3 - depth * (1.0 - (rate * time).cos()), -depth * rate * (rate * time).sin()]
}

#[test]
fn a_driven_face_is_where_its_inputs_want_it_and_never_jumps() {
    for start in [0.0, 1e7] {
        for length in [1e-6, 4.4e-6, 1e-5, 2.0_f64.sqrt() * 1e-5, 30e-6] {
            let mut instance = Instance::new(Version::Fmi3);
            instance.set_choices([(MOTION, 1)].into_iter()).unwrap();
            instance.set_reals([(ELEMENT_SIZE, 7e-3)].into_iter()).unwrap();
            instance.setup(start, None).unwrap();
            instance.enter_initialization();
            instance.exit_initialization().unwrap();
            let dt = dt_of(&mut instance);
            let mut before = (0.0, commanded(0.0)[0]);
            for i in 0..(4e-3 / length) as u32 {
                let elapsed = f64::from(i) * length;
                let [position, velocity] = commanded(elapsed + length);
                let inputs = [(references::DRIVEN_POSITION, position), (references::DRIVEN_VELOCITY, velocity)];
                instance.set_reals(inputs.into_iter()).unwrap();
                instance.do_step(start + elapsed, length).unwrap();
                let kernel = instance.real(references::KERNEL_TIME).unwrap() - start;
                let height = instance.real(POSITION).unwrap();
                // The way is a cubic between points of a curve whose acceleration is below 1200 m/s2, or its tangent; times
                // at a late start are known to 2e-9 s.
                let (reach, fuzz) = (length + dt, if start > 0.0 { 2e-8 } else { 1e-14 });
                assert!(
                    (height - commanded(kernel)[0]).abs() <= 600.0 * reach * reach + fuzz,
                    "{length} s at {kernel} s"
                );
                // As fast as the command at most, but for that; half a micrometre in a step of some microseconds.
                let moved = (height - before.1).abs();
                assert!(moved <= 1.9 * (kernel - before.0) + 1200.0 * reach * reach + fuzz, "{length} s at {kernel} s");
                before = (kernel, height);
            }
            assert!(instance.real(FORCE).unwrap() > 100.0);
        }
    }
}

#[test]
fn a_driven_face_stays_where_the_scenario_puts_it_until_a_position_is_given() {
    for version in [Version::Fmi2, Version::Fmi3] {
        let mut instance = Instance::new(version);
        instance.set_choices([(MOTION, 1)].into_iter()).unwrap();
        instance.set_reals([(GAP, 5e-3)].into_iter()).unwrap();
        // One that goes on from the saved bytes follows as well.
        let saved = instance.save().unwrap();
        let mut other = Instance::new(version);
        other.restore(&other.read_state(saved.bytes()).unwrap()).unwrap();
        other.set_reals([(GAP, 4e-3)].into_iter()).unwrap();
        for (instance, gap) in [(&mut instance, 5e-3), (&mut other, 4e-3)] {
            instance.enter_initialization();
            instance.exit_initialization().unwrap();
            assert_eq!(instance.real(references::DRIVEN_POSITION).unwrap(), gap);
            run(instance, 3);
            assert_eq!(instance.real(POSITION).unwrap(), gap);
            // A position that is given holds, though it is that of the preset.
            instance.set_reals([(references::DRIVEN_POSITION, 2e-3)].into_iter()).unwrap();
            run(instance, 3);
            assert_eq!(instance.real(POSITION).unwrap(), 2e-3);
            instance.reset();
            assert_eq!(instance.real(references::DRIVEN_POSITION).unwrap(), preset::study().impactor.gap);
        }
    }
}

#[test]
fn a_position_given_before_the_start_counts_whatever_the_gap() {
    let given = (references::DRIVEN_POSITION, 1e-3);
    for values in [[given, (GAP, 5e-3)], [(GAP, 5e-3), given]] {
        let mut instance = Instance::new(Version::Fmi2);
        instance.set_choices([(MOTION, 1)].into_iter()).unwrap();
        instance.set_reals(values.into_iter()).unwrap();
        let saved = instance.save().unwrap();
        instance.reset();
        instance.restore(&saved).unwrap();
        instance.set_reals([(GAP, 6e-3)].into_iter()).unwrap();
        instance.enter_initialization();
        instance.exit_initialization().unwrap();
        assert_eq!(instance.real(POSITION).unwrap(), 6e-3);
        run(&mut instance, 1);
        assert_eq!(instance.real(POSITION).unwrap(), 1e-3);
    }
}

#[test]
fn start_values_and_first_results_can_be_read_after_instantiation() {
    let mut instance = Instance::new(Version::Fmi3);
    let rows: Vec<_> = Table::new().rows().to_vec();
    let mut ready = coarse(0.0);
    for variable in &rows {
        let reference = variable.reference;
        match variable.value {
            ValueType::Real { .. } => {
                let value = instance.real(reference).unwrap();
                assert!(value.is_finite(), "{}", variable.name);
                assert!(variable.start().is_none_or(|start| start == value), "{}", variable.name);
            }
            ValueType::Array { .. } => {
                let mut count = 0;
                instance.reals(reference, &mut |value| count += u64::from(value.is_finite())).unwrap();
                assert_eq!(count, profile::START_POINTS);
            }
            ValueType::Integer { range } => {
                let value = instance.integer(reference).unwrap();
                assert!(if range.is_some() { variable.start() == Some(f64::from(value)) } else { value > 0 });
            }
            ValueType::Enumeration { .. } => {
                assert_eq!(Some(f64::from(instance.choice(reference).unwrap())), variable.start())
            }
            ValueType::Boolean => assert!(!instance.boolean(reference).unwrap()),
            ValueType::String => assert!(instance.text(reference).is_ok()),
            ValueType::Size { .. } => assert_eq!(instance.size(reference).unwrap(), profile::START_POINTS),
        }
    }
    // The model follows the parameters.
    instance.set_reals([(ELEMENT_SIZE, 7e-3)].into_iter()).unwrap();
    assert_eq!(dt_of(&mut instance), dt_of(&mut ready));
    assert_eq!(outcome(&mut instance), outcome(&mut ready));
}

#[test]
fn a_failed_step_leads_to_an_instance_that_can_be_reset_or_restored() {
    let mut instance = Instance::new(Version::Fmi2);
    // The step of the study's own drop, at far more than its energy.
    instance.set_choices([(STEP_BY, 1)].into_iter()).unwrap();
    instance.set_reals([(STEP, 5e-6), (ENERGY, 1000.0)].into_iter()).unwrap();
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

#[test]
fn layers_are_counted_and_those_that_are_not_there_keep_what_is_said_of_them() {
    let of = |name: &str| references::of_parameter(softanvil_kernel::Parameter::find(name).unwrap());
    let (count, thickness, absent) = (of("layers.count"), of("layers[1].thickness"), of("layers[3].c10"));
    for version in [Version::Fmi2, Version::Fmi3] {
        let mut instance = Instance::new(version);
        instance.enter_initialization();
        assert!(matches!(instance.set_counts([(count, 5)].into_iter()), Err(Error::Value(_))));
        assert!(matches!(instance.set_reals([(count, 2.0)].into_iter()), Err(Error::Type { .. })));
        instance.set_counts([(count, 2)].into_iter()).unwrap();
        let refused = instance.exit_initialization().unwrap_err().to_string();
        assert_eq!(refused, "layers[1].thickness = 0 m is refused: expected at least 0.00001 m");
        instance.set_reals([(thickness, 2e-3), (absent, 3e5)].into_iter()).unwrap();
        let changes = instance.exit_initialization().unwrap();
        let scenario = instance.values().scenario();
        let told: Vec<_> = changes.without_effect(&scenario).map(|value| value.to_string()).collect();
        assert_eq!(told, ["layers[3].c10 = 300000 Pa has no effect: layers.count is 2"]);
        assert_eq!((scenario.layers.len(), scenario.thickness()), (2, 15e-3 + 2e-3));
        assert_eq!([instance.integer(count).unwrap(), instance.real(absent).unwrap() as i32], [2, 300_000]);
        let saved = instance.save().unwrap();
        let mut other = Instance::new(version);
        other.restore(&saved).unwrap();
        assert_eq!(other.values(), instance.values());
    }
}

#[test]
fn an_experiment_has_a_finite_start_and_ends_no_sooner() {
    let mut instance = Instance::new(Version::Fmi2);
    instance.setup(2.0, Some(3.0)).unwrap();
    for start in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(matches!(instance.setup(start, None), Err(Error::StartTime { .. })));
    }
    for stop in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.5] {
        assert!(matches!(instance.setup(2.0, Some(stop)), Err(Error::StopTime { start: 2.0, .. })), "{stop}");
    }
    // What is refused changes nothing.
    assert_eq!((instance.time(), instance.experiment.stop), (2.0, Some(3.0)));
    instance.setup(4.0, Some(4.0)).unwrap();
    assert_eq!((instance.time(), instance.experiment.stop), (4.0, Some(4.0)));
}

#[test]
fn a_function_is_legal_in_its_modes_alone() {
    let function = Function { name: "fmi2DoStep", legal: Mode::Step as u8 | Mode::Terminated as u8 };
    let mut instance = Instance::new(Version::Fmi2);
    assert_eq!(instance.check_call(&function), Err(Error::Call { mode: Mode::Instantiated }));
    instance.enter_initialization();
    assert_eq!(instance.check_call(&function), Err(Error::Call { mode: Mode::Initialization }));
    instance.exit_initialization().unwrap();
    assert_eq!(instance.check_call(&function), Ok(()));
    instance.terminate();
    assert_eq!(instance.check_call(&function), Ok(()));
    instance.reset();
    assert_eq!(instance.check_call(&function), Err(Error::Call { mode: Mode::Instantiated }));
}

#[test]
fn event_mode_is_for_masters_that_handle_events() {
    let mut without = Instance::new(Version::Fmi3);
    assert!(matches!(without.enter(Mode::Event), Err(Error::Unsupported { .. })));
    assert_eq!(without.mode, Mode::Instantiated);
    let mut with = Instance::new(Version::Fmi3).with_events();
    with.reset();
    assert_eq!([without.event_mode_used(), with.event_mode_used()], [false, true]);
    for (instance, mode) in [(&mut without, Mode::Step), (&mut with, Mode::Event)] {
        instance.enter_initialization();
        instance.exit_initialization().unwrap();
        assert_eq!(instance.mode, mode);
        instance.enter(Mode::Step).unwrap();
        assert_eq!(instance.mode, Mode::Step);
        instance.set_intermediate_update(true);
        assert_eq!(instance.mode, Mode::IntermediateUpdate);
        instance.set_intermediate_update(false);
        assert_eq!(instance.mode, Mode::Step);
    }
    with.enter(Mode::Event).unwrap();
    assert_eq!((with.mode, with.version()), (Mode::Event, Version::Fmi3));
    assert_eq!(ready().version(), Version::Fmi2);
}

#[test]
fn results_are_cut_off_from_the_first_contact_to_its_end() {
    let mut instance = coarse(0.0);
    let mut seen = vec![];
    for _ in 0..400 {
        let is_cut_off = instance.is_cut_off();
        if seen.last() != Some(&is_cut_off) {
            seen.push(is_cut_off);
        }
        // No force before, and none after.
        assert!(is_cut_off || instance.real(FORCE).unwrap() == 0.0);
        instance.do_step(instance.time(), SAMPLE).unwrap();
    }
    assert_eq!(seen, [false, true, false]);
    assert!(!instance.has_failed() && !Instance::new(Version::Fmi2).is_cut_off());
}

#[test]
fn a_model_is_told_in_a_line() {
    let mut instance = Instance::new(Version::Fmi2);
    assert_eq!(instance.summary().to_string(), "");
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    let dt = dt_of(&mut instance);
    assert_eq!(instance.summary().to_string(), std::format!("model of 240 elements, time step {dt} s"));
}

#[test]
fn the_same_drop_starts_anew_in_the_model_at_hand() {
    let mut instance = ready();
    let start = outcome(&mut instance);
    run(&mut instance, 60);
    let end = outcome(&mut instance);
    assert_ne!(start, end);
    instance.reset();
    assert!(instance.simulation.is_some());
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    assert_eq!(outcome(&mut instance), start);
    run(&mut instance, 60);
    assert_eq!(outcome(&mut instance), end);
}
