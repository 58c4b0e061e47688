use std::string::ToString;

use softanvil_kernel::parameter::Values;
use softanvil_kernel::{Parameter, preset};

use super::*;

#[test]
fn every_refusal_names_the_value_its_unit_and_what_is_legal() {
    let name = Parameter::find("impactor.mass").unwrap().name();
    let messages = [
        (Error::Call { mode: Mode::Terminated }, "the call is not legal after termination"),
        (Error::Null { argument: "nValues" }, "nValues is null"),
        (Error::Argument { argument: "kind", value: 9 }, "kind = 9 is not a value of the standard"),
        (Error::Unsupported { what: "this" }, "this is not supported, see the model description"),
        (Error::Unknown { reference: 999 }, "no variable has the value reference 999"),
        (Error::Type { name, is: "Real", asked: "String" }, "impactor.mass is of type Real, not String"),
        (
            Error::ReadOnly { name, causality: "output" },
            "impactor.mass has the causality output and cannot be set: expected parameters and inputs",
        ),
        (
            Error::Fixed { name, value: 4.5, unit: "kg" },
            "impactor.mass = 4.5 [kg] is refused: a fixed parameter can be set until initialization mode ends",
        ),
        (
            Error::Structural { name },
            "impactor.mass is refused: configuration mode is for structural parameters, and they for it alone",
        ),
        (Error::ValueCount { given: 3, needed: 2 }, "nValues = 3 is refused: the variables have 2 values together"),
        (Error::StartTime { start: f64::INFINITY }, "start time inf s is refused: expected a finite number"),
        (
            Error::StopTime { stop: 1.0, start: 2.0 },
            "stop time 1 s is refused: expected a finite time from the start at 2 s on",
        ),
        (
            Error::CommunicationPoint { given: 3.0, expected: 2.0, half: 0.25 },
            "communication point 3 s is refused: expected 2 s, where the instance is, within 0.25 s",
        ),
        (
            Error::StepSize { given: -1.0, largest: 100.0 },
            "communication step -1 s is refused: expected above 0 s up to 100 s",
        ),
        (Error::PastStop { end: 3.0, stop: 2.0 }, "the step leads to 3 s: expected up to the stop time of 2 s"),
        (Error::NoMemory { bytes: 64 }, "there is no memory for 64 bytes"),
        (Error::Snapshot(SnapshotError::Format), "the bytes are not a snapshot of this simulation"),
        (
            Error::StateSize { given: 7, needed: 8 },
            "the buffer has 7 bytes: expected exactly 8, the size of the saved state",
        ),
    ];
    for (error, message) in messages {
        assert_eq!(error.to_string(), message);
    }
}

#[test]
fn what_the_kernel_refuses_is_told_in_its_words() {
    let parameter = Parameter::find("impactor.mass").unwrap();
    let refused = Values::of(&preset::study()).set(parameter, -1.0).unwrap_err();
    let words = refused.to_string();
    assert!(words.starts_with("impactor.mass = -1 kg is refused"), "{words}");
    assert_eq!(Error::from(refused).to_string(), words);
    let model = ModelError::Scenario(refused.into());
    assert_eq!(Error::Model(model).to_string(), model.to_string());
    assert!(!model.to_string().is_empty());
}

#[test]
fn every_mode_has_a_name_and_a_bit_of_its_own() {
    let names = [
        (Mode::Instantiated, "after instantiation"),
        (Mode::Initialization, "in initialization mode"),
        (Mode::Step, "between communication steps"),
        (Mode::Terminated, "after termination"),
        (Mode::Failed, "after a failed step"),
        (Mode::Event, "in event mode"),
        (Mode::Configuration, "in configuration mode"),
        (Mode::IntermediateUpdate, "in intermediate update mode"),
    ];
    let mut seen = 0;
    for (mode, name) in names {
        assert_eq!(mode.name(), name);
        assert_eq!((mode as u8).count_ones(), 1);
        seen |= mode as u8;
        let is_saved = !matches!(mode, Mode::Failed | Mode::IntermediateUpdate);
        assert_eq!(Mode::from_code(mode as u64), is_saved.then_some(mode));
        let is_before = matches!(mode, Mode::Instantiated | Mode::Initialization | Mode::Configuration);
        assert_eq!(Mode::BEFORE_WORK & mode as u8 != 0, is_before, "{name}");
    }
    assert_eq!(seen, u8::MAX);
    for code in [0, 3, 256] {
        assert_eq!(Mode::from_code(code), None);
    }
}
