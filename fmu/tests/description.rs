//! The model description against the variable table that it is written from.

use std::collections::HashMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use softanvil::variables::{Table, Version, token};
use softanvil_fmu::description;

const VERSIONS: [Version; 2] = [Version::Fmi2, Version::Fmi3];

/// Every element, in the order of the file, with its attributes.
fn elements(version: Version) -> Vec<(String, HashMap<String, String>)> {
    let text = description::xml(version);
    let mut reader = Reader::from_str(&text);
    let mut found = Vec::new();
    loop {
        match reader.read_event().unwrap() {
            Event::Start(element) | Event::Empty(element) => found.push(element_of(&element)),
            Event::Eof => return found,
            _ => {}
        }
    }
}

fn element_of(element: &BytesStart) -> (String, HashMap<String, String>) {
    let attributes = element.attributes().map(|attribute| {
        let attribute = attribute.unwrap();
        (attribute.key.as_ref().to_owned(), attribute.value.into_owned())
    });
    (element.name().as_ref().to_owned(), attributes.collect())
}

/// The variables with the attributes of their types, which FMI 2.0 has in the element that follows.
fn variables(version: Version) -> Vec<HashMap<String, String>> {
    let elements = elements(version);
    let pairs = elements.iter().zip(elements.iter().skip(1));
    pairs
        .filter(|((_, attributes), _)| attributes.contains_key("causality"))
        .map(|((kind, attributes), (_, next))| {
            let of_type = if kind == "ScalarVariable" { next } else { attributes };
            attributes.clone().into_iter().chain(of_type.clone()).collect()
        })
        .collect()
}

#[test]
fn the_variables_are_those_of_the_table_in_its_order() {
    for version in VERSIONS {
        let names: Vec<_> = variables(version).iter().map(|variable| variable["name"].clone()).collect();
        let table = Table::new();
        let expected: Vec<_> = table.rows().iter().filter(|v| v.is_in(version)).map(|v| v.name.to_string()).collect();
        assert_eq!(names, expected);
    }
}

#[test]
fn start_values_read_back_as_the_compiled_numbers() {
    for version in VERSIONS {
        for variable in variables(version) {
            let reference = variable["valueReference"].parse().unwrap();
            let compiled = Table::new().find(reference).unwrap().start();
            let number = |start: &String| match start.as_str() {
                "false" => 0.0,
                "true" => 1.0,
                number => number.parse::<f64>().unwrap(),
            };
            let written = variable.get("start").map(number);
            assert_eq!(written.map(f64::to_bits), compiled.map(f64::to_bits), "{}", variable["name"]);
        }
    }
}

#[test]
fn the_token_is_the_one_that_the_library_asks_for() {
    assert_eq!(elements(Version::Fmi2)[0].1["guid"], token().as_str());
    assert_eq!(elements(Version::Fmi3)[0].1["instantiationToken"], token().as_str());
}
