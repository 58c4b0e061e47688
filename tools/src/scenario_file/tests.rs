//! Tests of scenario files.

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::scenario::DropBy;
use softanvil_kernel::{PARAMETERS, Scenario, preset};

use super::{parse, to_toml};

fn refused(text: &str) -> String {
    parse(text, &preset::study()).unwrap_err().to_string()
}

/// A scenario in which every parameter differs from the study's, as far as the scenario stays legal.
fn other() -> Scenario {
    let mut scenario = preset::study();
    for parameter in PARAMETERS {
        let before = scenario;
        let value = match parameter.kind {
            Kind::Real { .. } => parameter.get(&scenario) * 0.9 + 1e-7 / 3.0,
            Kind::Choice { labels, .. } => labels.len() as f64 - 1.0 - parameter.get(&scenario),
        };
        let _ = parameter.set(&mut scenario, value);
        if scenario.validate().is_err() {
            scenario = before;
        }
    }
    scenario
}

#[test]
fn a_written_scenario_reads_back_to_the_same_bits_whatever_it_is_read_upon() {
    for (scenario, base) in [(preset::study(), other()), (other(), preset::study())] {
        assert_ne!(scenario, base);
        let read = parse(&to_toml(&scenario), &base).unwrap();
        for parameter in PARAMETERS.iter().filter(|parameter| parameter.without_effect(&scenario).is_none()) {
            assert_eq!(parameter.get(&read), parameter.get(&scenario), "{}", parameter.name);
            assert!(parameter.without_effect(&read).is_none(), "{}", parameter.name);
        }
    }
}

#[test]
fn what_has_no_effect_is_written_as_a_comment_and_refused() {
    let text = to_toml(&preset::study());
    assert!(text.contains("\n# drop_height = ") && text.contains("\ndrop_energy = "), "{text}");
    assert_eq!(
        refused("[silicone]\nlaw = \"neo_hookean\"\nc10 = 1e5\nc20 = 1e4"),
        "silicone.c20 = 10000 Pa has no effect: silicone.law is neo_hookean"
    );
    assert_eq!(parse("[impactor]\ndrop_height = 0.1", &preset::study()).unwrap().impactor.drop_by, DropBy::Height);
}

#[test]
fn every_line_tells_unit_and_meaning() {
    let text = to_toml(&preset::study()).replace("\n# ", "\n");
    for parameter in PARAMETERS {
        let field = parameter.name.split('.').next_back().unwrap();
        let line = text
            .lines()
            .find(|line| line.starts_with(&format!("{field} = ")) && line.ends_with(parameter.description))
            .unwrap_or_else(|| panic!("{}", parameter.name));
        assert!(parameter.unit() == "1" || line.contains(&format!("# {} ", parameter.unit())), "{line}");
    }
}

#[test]
fn keys_left_out_keep_their_value() {
    let scenario = parse("[impactor]\nmass = 4\n", &preset::study()).unwrap();
    let mut expected = preset::study();
    expected.impactor.mass = 4.0;
    assert_eq!(scenario, expected);
}

#[test]
fn a_refused_line_tells_its_number_and_what_is_legal() {
    for (text, message) in [
        ("\n[impactor]\nmass = -1", "line 3: impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
        ("impactor.mass = nan", "line 1: impactor.mass = NaN kg is refused: expected 0.001 to 10000 kg"),
        ("impactor = { mass = inf }", "line 1: impactor.mass = inf kg is refused: expected 0.001 to 10000 kg"),
        ("[impactor]\nmass = \"5\"", "line 2: impactor.mass = \"5\" is refused: expected a number, 0.001 to 10000 kg"),
        ("[impactor]\nmas = 5", "line 2: impactor.mas is unknown (did you mean impactor.mass?)"),
        ("[impacter]\nmass = 5", "line 1: impacter is unknown (did you mean impactor?)"),
        ("mass = 5", "line 1: mass is unknown"),
        ("impactor = 5", "line 1: impactor = 5 is refused: expected a section [impactor] of keys"),
        (
            "[impactor.mass]\nx = 5",
            "line 1: impactor.mass = a section is refused: expected a number, 0.001 to 10000 kg",
        ),
        (
            "[geometry]\nshape = \"cube\"",
            "line 2: geometry.shape = \"cube\" is refused: expected \"round\" or \"block\"",
        ),
        ("[geometry]\nshape = 1", "line 2: geometry.shape = 1 is refused: expected \"round\" or \"block\""),
    ] {
        assert_eq!(refused(text), message, "{text}");
    }
}

#[test]
fn broken_toml_tells_its_line() {
    for text in ["[impactor]\nmass = ", "[impactor]\nmass = 5\nmass = 5", "[impactor]\n= 5"] {
        let message = refused(text);
        assert!(message.starts_with("line 2: ") || message.starts_with("line 3: "), "{message}");
        assert!(!message.contains('\n'), "{message}");
    }
}

#[test]
fn parameters_that_do_not_fit_together_are_refused() {
    assert!(refused("[impactor]\nface_diameter = 0.05").starts_with("impactor.face_diameter = 0.05 m is refused"));
}
