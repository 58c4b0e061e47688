use std::vec::Vec;

use crate::variables::references;

use super::*;

const FORCE: u32 = 3000;
const ELEMENT_SIZE: u32 = 1023;

/// Words of the format, by their places.
const MAGIC_AT: usize = 0;
const VERSION_AT: usize = 1;
const TABLE_AT: usize = 2;
const LENGTH_AT: usize = 3;
const MODE_AT: usize = 4;
const START_AT: usize = 5;
const POINT_AT: usize = 8;
const AHEAD_AT: usize = 9;
const NUMBER_AT: usize = 10;
const IMPACT_START_AT: usize = 11;
const POINTS_AT: usize = 13;

/// A coarse drop, in the middle of its contact.
fn in_contact(version: Version) -> Instance {
    let mut instance = Instance::new(version);
    instance.set_reals([(ELEMENT_SIZE, 7e-3)].into_iter()).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance.do_step(0.0, 4e-3).unwrap();
    assert!(instance.real(FORCE).unwrap() > 100.0);
    instance
}

/// Fowler, Noll and Vo's FNV-1a of 64 bits, as published.
fn fnv_1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}

/// The saved bytes with another word at `place`, and a checksum that fits.
fn altered(saved: &SavedState, place: usize, word: u64) -> Vec<u8> {
    let mut bytes = saved.bytes().to_vec();
    bytes[8 * place..8 * place + 8].copy_from_slice(&word.to_le_bytes());
    let end = bytes.len() - 8;
    let checksum = fnv_1a(&bytes[..end]);
    bytes[end..].copy_from_slice(&checksum.to_le_bytes());
    bytes
}

fn refusal(instance: &Instance, bytes: &[u8]) -> Option<SnapshotError> {
    match instance.read_state(bytes) {
        Ok(_) => None,
        Err(Error::Snapshot(error)) => Some(error),
        Err(other) => panic!("{other}"),
    }
}

fn words(saved: &SavedState) -> Vec<u64> {
    saved.bytes().chunks_exact(8).map(|chunk| u64::from_le_bytes(chunk.try_into().unwrap())).collect()
}

#[test]
fn the_format_is_as_described() {
    let mut instance = in_contact(Version::Fmi3);
    let saved = instance.save().unwrap();
    let words = words(&saved);
    assert_eq!(&saved.bytes()[..8], b"SOFTAFMU");
    assert_eq!(words[LENGTH_AT], saved.bytes().len() as u64);
    assert_eq!([words[MODE_AT], words[POINTS_AT]], [Mode::Step as u64, 25]);
    assert_eq!([words[START_AT], words[POINT_AT], words[AHEAD_AT]].map(f64::from_bits), [0.0, 4e-3, 0.0]);
    assert_eq!((words[NUMBER_AT], f64::from_bits(words[IMPACT_START_AT])), (1, 0.0));
    let end = saved.bytes().len() - 8;
    assert_eq!(words.last(), Some(&fnv_1a(&saved.bytes()[..end])));
    assert_eq!(instance.read_state(saved.bytes()), Ok(saved));
}

#[test]
fn bytes_of_another_format_are_told_from_bytes_that_are_damaged() {
    let mut instance = in_contact(Version::Fmi3);
    let saved = instance.save().unwrap();
    let version = words(&saved)[VERSION_AT];
    let other = SnapshotError::Version { given: version - 1, expected: version };
    assert_eq!(refusal(&instance, &altered(&saved, VERSION_AT, version - 1)), Some(other));
    for place in [MAGIC_AT, LENGTH_AT] {
        let word = words(&saved)[place] + 8;
        assert_eq!(refusal(&instance, &altered(&saved, place, word)), Some(SnapshotError::Format), "{place}");
    }
    let other_table = altered(&saved, TABLE_AT, 1);
    assert_eq!(refusal(&instance, &other_table), Some(SnapshotError::Foreign));
    // Longer or shorter than they say, and no whole number of words.
    let bytes = saved.bytes();
    let longer: Vec<u8> = bytes.iter().copied().chain([0; 8]).collect();
    let odd = |length: usize| {
        let mut bytes = bytes[..length].to_vec();
        bytes[8 * LENGTH_AT..8 * LENGTH_AT + 8].copy_from_slice(&(length as u64).to_le_bytes());
        bytes
    };
    for wrong in [&longer[..], &longer[..bytes.len() + 1], &bytes[..bytes.len() - 8], &odd(bytes.len() - 1), b""] {
        assert_eq!(refusal(&instance, wrong), Some(SnapshotError::Format), "{}", wrong.len());
    }
    // Cut within its header, with a checksum that fits.
    let mut short = odd(48);
    let checksum = fnv_1a(&short[..40]);
    short[40..].copy_from_slice(&checksum.to_le_bytes());
    assert_eq!(refusal(&instance, &short), Some(SnapshotError::Corrupt));
}

#[test]
fn words_that_no_instance_writes_are_refused_though_the_checksum_fits() {
    let mut instance = in_contact(Version::Fmi3);
    let at_work = instance.save().unwrap();
    let fresh = Instance::new(Version::Fmi3).save().unwrap();
    let number = |value: f64| value.to_bits();
    let wrong = [
        (&at_work, START_AT, number(f64::INFINITY)),
        (&at_work, POINT_AT, number(f64::NAN)),
        (&at_work, AHEAD_AT, number(51e-6)),
        (&at_work, AHEAD_AT, number(-51e-6)),
        (&at_work, AHEAD_AT, number(f64::NAN)),
        (&at_work, NUMBER_AT, 0),
        (&at_work, NUMBER_AT, 1 << 32),
        (&at_work, IMPACT_START_AT, number(f64::NEG_INFINITY)),
        (&at_work, POINTS_AT, 1),
        (&at_work, POINTS_AT, 10_001),
        (&at_work, MODE_AT, Mode::Failed as u64),
        (&at_work, MODE_AT, 0),
        // A state of a drop in a mode before it, and the other way round.
        (&at_work, MODE_AT, Mode::Instantiated as u64),
        (&fresh, MODE_AT, Mode::Step as u64),
        (&fresh, MODE_AT, Mode::Terminated as u64),
    ];
    for (saved, place, word) in wrong {
        assert_eq!(refusal(&instance, &altered(saved, place, word)), Some(SnapshotError::Corrupt), "{place}: {word:x}");
    }
    let right = [
        (&at_work, START_AT, number(-1e9)),
        (&at_work, AHEAD_AT, number(50e-6)),
        (&at_work, AHEAD_AT, number(-50e-6)),
        (&at_work, NUMBER_AT, 3),
        (&at_work, IMPACT_START_AT, number(2.0)),
        (&at_work, POINTS_AT, 2),
        (&at_work, POINTS_AT, 10_000),
        (&at_work, MODE_AT, Mode::Terminated as u64),
        (&fresh, MODE_AT, Mode::Initialization as u64),
    ];
    for (saved, place, word) in right {
        assert_eq!(refusal(&instance, &altered(saved, place, word)), None, "{place}: {word:x}");
    }
}

#[test]
fn a_value_out_of_range_is_refused() {
    let mut instance = in_contact(Version::Fmi3);
    let saved = instance.save().unwrap();
    // The first input, a force of at most 1 MN.
    let bytes = altered(&saved, HEADER_WORDS, 2e6_f64.to_bits());
    assert!(matches!(instance.read_state(&bytes), Err(Error::Value(error)) if error.value == 2e6));
}

#[test]
fn everything_that_was_set_is_there_again() {
    let mut instance = Instance::new(Version::Fmi3);
    instance.enter(Mode::Configuration).unwrap();
    instance.set_sizes([(references::SURFACE_POINTS, 11)].into_iter()).unwrap();
    instance.enter(Mode::Instantiated).unwrap();
    instance.set_reals([(ELEMENT_SIZE, 7e-3), (references::EXTERNAL_FORCE, 2.5)].into_iter()).unwrap();
    instance.setup(2.0, Some(2.001)).unwrap();
    instance.enter_initialization();
    instance.exit_initialization().unwrap();
    instance.do_step(2.0, 0.5e-3).unwrap();
    let saved = instance.save().unwrap();
    let mut other = Instance::new(Version::Fmi3);
    other.restore(&saved).unwrap();
    assert_eq!((other.mode, other.experiment, other.clock), (instance.mode, instance.experiment, instance.clock));
    assert_eq!((other.points, other.inputs), (11, instance.inputs));
    assert_eq!(other.real(references::EXTERNAL_FORCE), Ok(2.5));
    assert_eq!(other.values(), instance.values());
    assert!(matches!(other.do_step(other.time(), 0.6e-3), Err(Error::PastStop { .. })));
    other.do_step(other.time(), 0.5e-3).unwrap();
    // Without a stop time there is none afterwards.
    let endless = in_contact(Version::Fmi3).save().unwrap();
    other.restore(&endless).unwrap();
    assert_eq!(other.experiment.stop, None);
    other.do_step(4e-3, 1e-3).unwrap();
}

#[test]
fn what_the_master_gives_is_given_again_and_what_it_does_not_is_not() {
    let given = [(references::DRIVEN_POSITION, 1e-3), (references::DRIVEN_VELOCITY, 0.5)];
    for count in 0..=2 {
        let mut instance = Instance::new(Version::Fmi2);
        instance.set_reals(given.into_iter().take(count)).unwrap();
        let mut other = Instance::new(Version::Fmi2);
        other.restore(&instance.save().unwrap()).unwrap();
        assert_eq!([other.inputs.has_position, other.inputs.has_velocity], [count > 0, count > 1]);
    }
}

#[test]
fn a_mode_that_the_instance_does_not_have_is_refused() {
    let mut with_events = Instance::new(Version::Fmi3).with_events();
    with_events.enter_initialization();
    with_events.exit_initialization().unwrap();
    let event = with_events.save().unwrap();
    let mut configured = Instance::new(Version::Fmi3);
    configured.enter(Mode::Configuration).unwrap();
    let configuration = configured.save().unwrap();
    let mut of_2 = Instance::new(Version::Fmi2);
    let mut of_3 = Instance::new(Version::Fmi3);
    let foreign = Err(Error::Snapshot(SnapshotError::Foreign));
    assert_eq!([of_2.restore(&event), of_3.restore(&event), of_2.restore(&configuration)], [foreign; 3]);
    assert_eq!([of_2.mode, of_3.mode], [Mode::Instantiated; 2]);
    of_3.restore(&configuration).unwrap();
    with_events.restore(&configuration).unwrap();
    assert_eq!([of_3.mode, with_events.mode], [Mode::Configuration; 2]);
    with_events.restore(&event).unwrap();
    assert_eq!(with_events.mode, Mode::Event);
}

#[test]
fn a_state_of_another_model_brings_its_model() {
    let mut instance = in_contact(Version::Fmi2);
    let (saved, force) = (instance.save().unwrap(), instance.real(FORCE).unwrap());
    let mut other = Instance::new(Version::Fmi2);
    other.enter_initialization();
    other.exit_initialization().unwrap();
    assert_eq!(other.integer(references::ELEMENTS), Ok(240));
    other.restore(&saved).unwrap();
    assert_eq!(other.integer(references::ELEMENTS), instance.integer(references::ELEMENTS));
    assert_ne!(other.integer(references::ELEMENTS), Ok(240));
    assert_eq!(other.real(FORCE), Ok(force));
    // Back in the model at hand.
    other.do_step(4e-3, 1e-3).unwrap();
    assert_ne!(other.real(FORCE), Ok(force));
    other.restore(&saved).unwrap();
    assert_eq!((other.real(FORCE), other.time()), (Ok(force), 4e-3));
}
