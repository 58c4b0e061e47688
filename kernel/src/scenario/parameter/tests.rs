extern crate alloc;
use alloc::string::ToString;

use super::*;
use crate::error::ScenarioError;
use crate::number::real::Real;
use crate::scenario::{MAX_LAYERS, Scenario, preset};

/// The study with as many layers as there can be.
fn whole() -> Scenario {
    let mut scenario = preset::study();
    scenario.set_layer_count(MAX_LAYERS);
    scenario
}

#[test]
fn every_value_survives_a_round_trip() {
    for parameter in Parameter::all() {
        let (min, max) = parameter.range();
        for value in [min, max] {
            let mut scenario = whole();
            parameter.set(&mut scenario, value).unwrap();
            assert_eq!(parameter.get(&scenario), value, "{}", parameter.name());
            let mut values = Values::of(&preset::study());
            values.set(parameter, value).unwrap();
            assert_eq!(values.get(parameter), value, "{}", parameter.name());
            let others = Parameter::all().filter(|other| *other != parameter);
            others.for_each(|other| assert_eq!(values.get(other), other.get(&preset::study()), "{}", other.name()));
        }
    }
}

#[test]
fn illegal_values_are_refused_and_change_nothing() {
    for parameter in Parameter::all() {
        let (min, max) = parameter.range();
        for value in [min - 1.0 - min.abs(), max + 1.0 + max.abs(), Real::NAN, Real::INFINITY, Real::NEG_INFINITY] {
            let mut scenario = whole();
            let Err(ScenarioError::Parameter(error)) = parameter.set(&mut scenario, value) else { panic!("legal") };
            assert_eq!((error.name, error.min, error.max), (parameter.name(), min, max));
            assert_eq!(scenario, whole());
        }
    }
}

#[test]
fn names_and_numbers_are_unique_and_lead_back() {
    for (i, parameter) in Parameter::all().enumerate() {
        let (name, number) = (parameter.name(), parameter.number());
        assert!((number as usize) < NUMBERS, "{name}");
        assert!(Parameter::all().take(i).all(|other| other.name() != name && other.number() != number), "{name}");
        assert_eq!(Parameter::find(&name.to_string()).map(|found| found.number()), Some(number));
        assert_eq!(Parameter::by_number(number).map(|found| found.name()), Some(name));
        assert!(!Parameter::is_retired(number), "{name} has a retired number");
        if let Kind::Choice { .. } | Kind::Count = parameter.kind() {
            assert!(parameter.check(1.5).is_err(), "{name}");
        }
    }
    for unknown in
        ["layers[4].c10", "layers[+1].c10", "layers[].c10", "layers[0]", "layers[0].c", "layers.c10", "c10", ""]
    {
        assert!(Parameter::find(unknown).is_none(), "{unknown}");
    }
    let unknown = [NUMBERS as u32, TEST_NUMBERS - 1, TEST_NUMBERS + LAYER_NUMBERS - 1, u32::MAX];
    unknown.iter().for_each(|number| assert!(Parameter::by_number(*number).is_none(), "{number}"));
}

#[test]
fn every_layer_has_the_same_parameters() {
    let fields = |layer| Parameter::of_layer(layer).map(|parameter| (parameter.name().field(), parameter.id()));
    for layer in 1..MAX_LAYERS {
        assert!(fields(layer).eq(fields(0)));
    }
    assert_eq!(Parameter::of_layer(MAX_LAYERS).count(), 0);
    assert!(Parameter::of(&preset::study()).filter_map(|parameter| parameter.layer()).all(|layer| layer == 0));
}

#[test]
fn a_layer_goes_by_its_name_where_it_has_one() {
    let mut scenario = preset::study();
    assert_eq!(Parameter::find_in(&scenario, "silicone.c10"), Parameter::find("layers[0].c10"));
    assert_eq!(Parameter::find_in(&scenario, "skin.c10"), None);
    scenario.set_layer_count(2);
    assert_eq!(Parameter::find_in(&scenario, ".c10"), None);
    scenario.layers[1] = preset::chamois();
    assert_eq!(Parameter::find_in(&scenario, "skin.c10"), Parameter::find("layers[1].c10"));
    assert_eq!(Parameter::find_in(&scenario, "impactor.mass"), Parameter::find("impactor.mass"));
}

#[test]
fn a_value_of_an_absent_layer_is_refused_and_changes_nothing() {
    let mut scenario = preset::study();
    let refused = Parameter::find("layers[2].c10").unwrap().set(&mut scenario, 1e5).unwrap_err();
    assert_eq!(refused.to_string(), "layers[2].c10 = 100000 Pa has no effect: layers.count is 1");
    assert_eq!(scenario, preset::study());
}

#[test]
fn values_keep_those_of_absent_layers() {
    let c10 = Parameter::find("layers[3].c10").unwrap();
    let mut values = Values::of(&preset::study());
    values.set(c10, 3e5).unwrap();
    let mut two = preset::study();
    two.add_layer(preset::chamois()).unwrap();
    values.update(&two);
    assert_eq!((values.scenario(), values.get(c10)), (two, 3e5));
}

#[test]
fn a_refused_value_names_itself_its_unit_and_its_range() {
    let error = Parameter::find("impactor.mass").unwrap().set(&mut preset::study(), -1.0).unwrap_err();
    assert_eq!(error.to_string(), "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg");
}
