use crate::instance::Error;
use crate::variables::{Version, references};

use super::*;

/// Of the last kernel step.
const FORCE: u32 = 3001;
const ELEMENT_SIZE: u32 = 1023;

/// A coarse drop that starts at `start` s, and its time step, s.
fn drop_from(start: f64) -> (Instance, f64) {
    let mut instance = Instance::new(Version::Fmi3);
    instance.set_reals([(ELEMENT_SIZE, 7e-3)].into_iter()).unwrap();
    instance.setup(start, None).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    let dt = instance.real(references::TIME_STEP).unwrap();
    (instance, dt)
}

fn touches(instance: &mut Instance) -> bool {
    instance.real(FORCE).unwrap() > 0.0
}

#[test]
fn a_step_can_pause_after_every_kernel_step() {
    let (mut instance, dt) = drop_from(0.5);
    let mut advance = instance.begin_step(0.5, 4.25 * dt).unwrap();
    for made in 1..=4 {
        assert!(!advance.is_complete());
        assert_eq!(instance.advance(&mut advance, Pause::AtSteps), Ok(false));
        let end = 0.5 + if made < 4 { f64::from(made) } else { 4.25 } * dt;
        assert!((instance.time() - end).abs() < 1e-15, "{made}");
        assert!((instance.kernel_time() - 0.5 - f64::from(made) * dt).abs() < 1e-15, "{made}");
    }
    assert!(advance.is_complete());
    // Complete, it makes no more.
    assert_eq!(instance.advance(&mut advance, Pause::AtSteps), Ok(false));
    assert!((instance.kernel_time() - 0.5 - 4.0 * dt).abs() < 1e-15);
}

#[test]
fn a_step_pauses_where_contact_begins_and_where_it_ends() {
    let (mut instance, dt) = drop_from(0.0);
    let (mut other, _) = drop_from(0.0);
    let whole = 15e-3;
    let mut advance = instance.begin_step(0.0, whole).unwrap();
    for event in 0..2 {
        let before = touches(&mut instance);
        assert_eq!(before, event == 1);
        assert_eq!(instance.advance(&mut advance, Pause::AtEvents), Ok(true));
        assert!(!advance.is_complete());
        assert_ne!(touches(&mut instance), before);
        // It is the step after which it is so for the first time.
        let last = instance.time() - other.time() - dt;
        let mut until = other.begin_step(other.time(), last).unwrap();
        assert_eq!(other.advance(&mut until, Pause::AtEvents), Ok(false));
        assert_eq!(touches(&mut other), before);
        let mut until = other.begin_step(other.time(), dt).unwrap();
        assert_eq!(other.advance(&mut until, Pause::Never), Ok(true));
        assert!((other.time() - instance.time()).abs() < 1e-15);
    }
    // In one go the events are told as well, and nothing pauses.
    let (mut third, _) = drop_from(0.0);
    let mut advance = third.begin_step(0.0, whole).unwrap();
    assert_eq!(third.advance(&mut advance, Pause::Never), Ok(true));
    assert!(advance.is_complete());
    assert_eq!(third.time(), whole);
}

#[test]
fn before_the_start_the_kernel_is_where_the_experiment_starts() {
    let mut instance = Instance::new(Version::Fmi2);
    instance.setup(3.5, None).unwrap();
    assert_eq!([instance.time(), instance.kernel_time()], [3.5, 3.5]);
    assert!(matches!(instance.begin_step(3.5, 1e-3), Err(Error::Call { mode: Mode::Instantiated })));
}

#[test]
fn the_last_step_may_end_at_the_stop_time_and_not_later() {
    for start in [0.0, 2.0] {
        let (mut instance, dt) = drop_from(start);
        let stop = start + 20.0 * dt;
        instance.setup(start, Some(stop)).unwrap();
        let refused = |instance: &mut Instance, step: f64| instance.begin_step(instance.time(), step).err();
        assert_eq!(refused(&mut instance, 20.0 * dt), None);
        assert_eq!(refused(&mut instance, 5.0 * dt), None);
        let Some(Error::PastStop { end, stop: told }) = refused(&mut instance, 20.1 * dt) else { panic!() };
        assert!((end - (start + 20.1 * dt)).abs() < 1e-15);
        assert_eq!(told, stop);
        instance.do_step(start, 12.0 * dt).unwrap();
        assert_eq!(refused(&mut instance, 8.0 * dt), None);
        assert!(matches!(refused(&mut instance, 8.1 * dt), Some(Error::PastStop { .. })));
    }
}
