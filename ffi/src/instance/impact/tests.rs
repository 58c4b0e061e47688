use softanvil_kernel::{OUTPUTS, Parameter, StepInput};

use crate::instance::{Error, Instance, Mode};
use crate::variables::{Version, references};

const DROP: f64 = 15e-3;
const REST: f64 = 0.02;

/// A drop from `start` s on a coarse anvil that softens and relaxes.
fn softening(version: Version, start: f64) -> Instance {
    let mut instance = Instance::new(version);
    begin(&mut instance, start);
    instance
}

/// The same of an instance that is new or reset.
fn begin(instance: &mut Instance, start: f64) {
    let of = |name: &str| references::of_parameter(Parameter::find(name).unwrap());
    let values = [
        (of("mesh.element_size"), 7e-3),
        (of("layers[0].softening_r"), 1.5),
        (of("layers[0].softening_m"), 2e4),
        (references::REST, REST),
    ];
    instance.set_reals(values.into_iter()).unwrap();
    instance.setup(start, None).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
}

fn ask(instance: &mut Instance, next: bool) {
    instance.set_booleans([(references::NEXT_IMPACT, next)].into_iter()).unwrap();
}

/// Goes on for `duration` s in steps of `length`, the last of which is what is left.
fn go(instance: &mut Instance, duration: f64, length: f64) {
    let end = instance.time() + duration;
    while end - instance.time() > 1e-12 {
        let step = length.min(end - instance.time());
        instance.do_step(instance.time(), step).unwrap();
    }
}

/// Every output, to the last bit, and the trace.
fn outcome(instance: &mut Instance) -> (std::vec::Vec<u64>, [u8; 16]) {
    let bits = OUTPUTS.iter().map(|output| instance.real(references::of_output(output)).unwrap().to_bits()).collect();
    (bits, instance.text(references::TRACE_HASH).unwrap())
}

#[test]
fn impacts_of_a_master_are_those_of_the_kernel_however_time_is_cut() {
    for (start, length) in [(0.0, 1.0), (0.25, 50e-6), (-1.0, 37e-6), (1e4, 1.0 / 600.0)] {
        let mut instance = softening(Version::Fmi3, start);
        let mut kernel = softanvil_kernel::Simulation::new(&instance.values().scenario()).unwrap();
        for number in 1..=3 {
            if number > 1 {
                ask(&mut instance, true);
                kernel.next_impact(REST).unwrap();
            }
            go(&mut instance, DROP / 2.0, length);
            assert_eq!(instance.integer(references::IMPACT_NUMBER), Ok(number));
            ask(&mut instance, false);
            go(&mut instance, DROP / 2.0, length);
            kernel.run(DROP, &StepInput::default()).unwrap();
            let (bits, digits) = outcome(&mut instance);
            let hash = std::format!("{:016x}", kernel.scalars().sampler.trace_hash);
            assert_eq!(hash.as_bytes(), digits, "impact {number} from {start} s in steps of {length} s");
            let expected: std::vec::Vec<_> =
                OUTPUTS.iter().map(|output| (output.read)(kernel.constants(), kernel.scalars()).to_bits()).collect();
            assert_eq!(bits, expected, "impact {number} from {start} s in steps of {length} s");
            let end = start + f64::from(number) * DROP;
            assert!((instance.kernel_time() - end).abs() <= kernel.constants().dt, "impact {number}");
        }
    }
}

#[test]
fn the_next_impact_begins_where_the_request_rises_alone() {
    let mut instance = softening(Version::Fmi2, 0.0);
    let number = |instance: &mut Instance| instance.integer(references::IMPACT_NUMBER).unwrap();
    assert_eq!((number(&mut instance), instance.boolean(references::NEXT_IMPACT)), (1, Ok(false)));
    let mut numbers = std::vec![];
    for next in [false, true, true, false, false, true] {
        ask(&mut instance, next);
        go(&mut instance, 1e-3, 1e-3);
        numbers.push(number(&mut instance));
    }
    assert_eq!(numbers, [1, 2, 2, 2, 2, 3]);
}

/// Before, in or after initialization, from a state saved there as well, and in the event mode that follows it.
#[test]
fn what_is_asked_for_before_the_first_step_is_no_other_impact() {
    let number = |instance: &mut Instance| instance.integer(references::IMPACT_NUMBER).unwrap();
    for (early, events, restores) in
        [(true, false, false), (true, true, false), (false, false, false), (false, true, false), (false, true, true)]
    {
        let mut instance = Instance::new(Version::Fmi3);
        if events {
            instance = instance.with_events();
        }
        instance.setup(-2.0, None).unwrap();
        instance.enter_initialization();
        if early {
            ask(&mut instance, true);
        }
        instance.exit_initialization().unwrap();
        if restores {
            let saved = instance.save().unwrap();
            instance.restore(&saved).unwrap();
        }
        ask(&mut instance, true);
        instance.enter(Mode::Step).unwrap();
        go(&mut instance, 1e-3, 1e-3);
        assert_eq!(number(&mut instance), 1);
    }
}

/// A master that handles events asks in event mode, where the standard has it set discrete inputs.
#[test]
fn event_mode_is_where_masters_with_events_ask() {
    let mut instance = Instance::new(Version::Fmi3).with_events();
    begin(&mut instance, 0.0);
    instance.enter(Mode::Step).unwrap();
    let mut other = softening(Version::Fmi3, 0.0);
    for next in [false, true, false, true] {
        instance.enter(Mode::Event).unwrap();
        for instance in [&mut instance, &mut other] {
            ask(instance, next);
        }
        instance.enter(Mode::Step).unwrap();
        for instance in [&mut instance, &mut other] {
            go(instance, DROP / 2.0, 1e-3);
        }
    }
    assert_eq!(instance.integer(references::IMPACT_NUMBER), Ok(3));
    assert_eq!(outcome(&mut instance), outcome(&mut other));
}

#[test]
fn a_step_that_is_refused_begins_no_impact() {
    let number = |instance: &mut Instance| instance.integer(references::IMPACT_NUMBER).unwrap();
    let mut instance = Instance::new(Version::Fmi2);
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    go(&mut instance, 1e-3, 1e-3);
    let before = outcome(&mut instance);
    ask(&mut instance, true);
    assert!(instance.do_step(0.0, -1.0).is_err());
    assert_eq!((number(&mut instance), outcome(&mut instance)), (1, before));
    go(&mut instance, 1e-3, 1e-3);
    assert_eq!(number(&mut instance), 2);
}

#[test]
fn a_state_between_impacts_goes_on_elsewhere_and_a_reset_has_a_fresh_anvil() {
    let mut instance = softening(Version::Fmi3, 0.5);
    go(&mut instance, DROP, DROP);
    let first = outcome(&mut instance);
    ask(&mut instance, true);
    // The shortest step begins the impact and makes no step of the kernel.
    go(&mut instance, 1e-9, 1e-9);
    assert_eq!(instance.integer(references::IMPACT_NUMBER), Ok(2));
    let saved = instance.save().unwrap();
    go(&mut instance, DROP, 1e-3);
    let second = outcome(&mut instance);
    assert_ne!(first, second);
    let mut other = Instance::new(Version::Fmi3);
    let read = other.read_state(saved.bytes()).unwrap();
    other.restore(&read).unwrap();
    assert_eq!(other.save().unwrap(), saved);
    go(&mut other, DROP, 1e-3);
    assert_eq!((outcome(&mut other), other.integer(references::IMPACT_NUMBER)), (second, Ok(2)));
    // Also where the kernel has not left the start of the impact.
    other.restore(&read).unwrap();
    for mut used in [instance, other] {
        used.reset();
        begin(&mut used, 0.5);
        assert_eq!(used.integer(references::IMPACT_NUMBER), Ok(1));
        go(&mut used, DROP, DROP);
        assert_eq!(outcome(&mut used), first);
    }
}

#[test]
fn a_rest_that_is_not_legal_is_refused_with_its_range() {
    let mut instance = softening(Version::Fmi2, 0.0);
    for rest in [-1.0, f64::NAN, 2e9] {
        let Err(Error::Value(error)) = instance.set_reals([(references::REST, rest)].into_iter()) else {
            panic!("{rest} s is taken")
        };
        assert_eq!((error.min, error.max, error.unit), (0.0, 1e9, "s"));
    }
    assert_eq!(instance.real(references::REST), Ok(REST));
    let active = references::CONTACT_ACTIVE;
    let refused = instance.set_booleans([(references::NEXT_IMPACT, true), (active, true)].into_iter());
    assert!(matches!(refused, Err(Error::ReadOnly { .. })));
    assert_eq!(instance.boolean(references::NEXT_IMPACT), Ok(false));
}
