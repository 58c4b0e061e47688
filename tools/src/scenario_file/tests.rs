//! Tests of scenario files.

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::scenario::DropBy;
use softanvil_kernel::{Parameter, Scenario, preset};

use super::{parse, to_toml};

fn refused(text: &str) -> String {
    parse(text, &preset::study()).unwrap_err().to_string()
}

/// A scenario in which every parameter differs from the study's, as far as the scenario stays legal.
fn other() -> Scenario {
    let mut scenario = preset::study();
    scenario.add_layer(preset::chamois()).unwrap();
    scenario.set_layer_count(3);
    scenario.layers[2].thickness = 2e-3;
    for parameter in Parameter::of(&scenario).filter(|parameter| parameter.name() != "layers.count") {
        let before = scenario.clone();
        let value = match parameter.kind() {
            Kind::Quantity => parameter.get(&scenario) * 0.9 + 1e-7 / 3.0,
            Kind::Count => parameter.get(&scenario) + 3.0,
            Kind::Choice { labels } => labels.len() as f64 - 1.0 - parameter.get(&scenario),
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
        let names = |scenario: &Scenario| scenario.layers.iter().map(|layer| layer.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&read), names(&scenario));
        for parameter in Parameter::all().filter(|parameter| parameter.without_effect(&scenario).is_none()) {
            assert_eq!(parameter.get(&read), parameter.get(&scenario), "{}", parameter.name());
            assert!(parameter.without_effect(&read).is_none(), "{}", parameter.name());
        }
    }
}

#[test]
fn what_has_no_effect_is_written_as_a_comment_and_refused() {
    let text = to_toml(&preset::study());
    assert!(text.contains("\n# drop_height = ") && text.contains("\ndrop_energy = "), "{text}");
    assert_eq!(
        refused("[silicone]\nlaw = \"neo_hookean\"\nc10 = 1e5\nc20 = 1e4"),
        "layers[0].c20 = 10000 Pa has no effect: layers[0].law is neo_hookean"
    );
    assert_eq!(parse("[impactor]\ndrop_height = 0.1", &preset::study()).unwrap().impactor.drop_by, DropBy::Height);
}

#[test]
fn every_line_tells_unit_and_meaning() {
    let text = to_toml(&preset::study()).replace("\n# ", "\n");
    for parameter in Parameter::of(&preset::study()).filter(|parameter| parameter.name() != "layers.count") {
        let field = parameter.name().field();
        let line = text
            .lines()
            .find(|line| line.starts_with(&format!("{field} = ")) && line.ends_with(parameter.description()))
            .unwrap_or_else(|| panic!("{}", parameter.name()));
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

/// One of the two would win without a word.
#[test]
fn a_parameter_has_one_value_in_a_file_by_whatever_name() {
    assert_eq!(
        refused("[[layers]]\nthickness = 0.010\n[silicone]\nthickness = 0.02\n"),
        "line 4: layers[0].thickness and silicone.thickness state the same thing: expected one of them"
    );
    let named = "[[layers]]\n[[layers]]\nname = \"skin\"\nthickness = 1e-3\n[skin]\ndensity = 900\nthickness = 2e-3\n";
    assert_eq!(
        refused(named),
        "line 7: layers[1].thickness and skin.thickness state the same thing: expected one of them"
    );
    assert!(parse(&named.replace("thickness = 2e-3\n", ""), &preset::study()).is_ok());
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
    assert!(refused("[impactor]\nface_diameter = 0.005").starts_with("impactor.face_diameter = 0.005 m is refused"));
}

#[test]
fn layers_are_tables_from_the_core_to_the_surface() {
    let text = "[[layers]]\n[[layers]]\nname = \"gel\"\nthickness = 2e-3\nrows = 2\n\
                [[layers]]\nname = \"skin\"\nthickness = 1e-3\nlaw = \"yeoh\"\nc10 = 5e5\n[gel]\nc10 = 3e4\n";
    let scenario = parse(text, &preset::study()).unwrap();
    assert_eq!(scenario.layers[0], preset::study().layers[0]);
    let names: Vec<_> = scenario.layers.iter().map(|layer| layer.name.as_str()).collect();
    assert_eq!((names, scenario.thickness()), (vec!["silicone", "gel", "skin"], 15e-3 + 2e-3 + 1e-3));
    assert_eq!((scenario.layers[1].rows, scenario.layers[1].material.coefficient("c10")), (2, Some(3e4)));
    let inline = "layers = [{ thickness = 12e-3 }, { thickness = 1e-3 }]";
    assert_eq!(parse(inline, &preset::study()).unwrap().thickness(), 12e-3 + 1e-3);
    // The tables are the layers: one of them leaves one.
    let one = parse("[[layers]]\nc10 = 2e5\n", &scenario).unwrap();
    assert_eq!((one.layers.len(), one.layers[0].material.coefficient("c10"), one.thickness()), (1, Some(2e5), 15e-3));
}

#[test]
fn a_section_is_a_layer_by_its_name() {
    let mut base = preset::study();
    base.add_layer(preset::chamois()).unwrap();
    let scenario = parse("[silicone]\nc10 = 2e5\n[skin]\nthickness = 2e-3\n", &base).unwrap();
    assert_eq!((scenario.layers[0].material.coefficient("c10"), scenario.layers[1].thickness), (Some(2e5), 2e-3));
}

#[test]
fn what_was_written_otherwise_is_refused_with_how_it_is_written_now() {
    for (text, message) in [
        (
            "[geometry]\nlayers = \"two\"",
            "line 2: geometry.layers is refused: expected layers.count = 2 or, in a file, a table [[layers]] for each layer",
        ),
        (
            "[geometry]\nsilicone_thickness = 0.014",
            "line 2: geometry.silicone_thickness is refused: expected silicone.thickness",
        ),
        ("geometry.skin_thickness = 1e-3", "line 1: geometry.skin_thickness is refused: expected layers[1].thickness"),
        (
            "\n[skin]\nc10 = 1e5",
            "line 2: skin is refused: no layer is called skin: expected a table [[layers]] with name = \"skin\"",
        ),
    ] {
        assert_eq!(refused(text), message);
    }
}

#[test]
fn refused_layers_tell_their_line_and_place() {
    for (text, message) in [
        ("[layers]\ncount = 2", "line 1: layers = a section is refused: expected a table [[layers]] for each layer"),
        ("layers = 2", "line 1: layers = 2 is refused: expected a table [[layers]] for each layer"),
        ("[[layers]]\n[[layers]]\nc1 = 2", "line 3: layers[1].c1 is unknown"),
        ("[[layers]]\nc10 = 1e12", "line 2: layers[0].c10 = 1000000000000 Pa is refused: expected -1000000000 to"),
        ("[[layers]]\nrows = 1.5", "line 2: layers[0].rows = 1.5 is refused: expected 0 to 10000"),
        ("[[layers]]\n[[layers]]\nc10 = 1e5", "layers[1].thickness = 0 m is refused: expected at least 0.00001 m"),
        (
            "[[layers]]\n[[layers]]\nname = \"silicone\"",
            "line 3: layers[1].name = \"silicone\" is refused: expected a name",
        ),
        ("[[layers]]\nname = \"impactor\"", "line 2: layers[0].name = \"impactor\" is refused: expected a name that"),
        ("[[layers]]\nname = \"a.b\"", "line 2: layers[0].name = \"a.b\" is refused: expected 1 to 23 letters"),
        ("[[layers]]\nname = 1", "line 2: layers[0].name = 1 is refused: expected a text"),
        (&"[[layers]]\n".repeat(5), "line 1: layers.count = 5 is refused: expected 1 to 4"),
    ] {
        let refused = refused(text);
        assert!(refused.starts_with(message), "{refused}");
    }
}
