//! The model description against the variable table that it is written from.

use std::collections::HashMap;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use softanvil::variables::{Table, token};
use softanvil_fmu::description;

/// Every element, in the order of the file, with its attributes.
fn elements() -> Vec<(String, HashMap<String, String>)> {
    let text = description::fmi2();
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

#[test]
fn the_variables_are_those_of_the_table_in_its_order() {
    let elements = elements();
    let names: Vec<_> =
        elements.iter().filter(|(kind, _)| kind == "ScalarVariable").map(|(_, a)| a["name"].clone()).collect();
    let expected: Vec<_> = Table::new().rows().iter().map(|variable| variable.name.to_owned()).collect();
    assert_eq!(names, expected);
}

#[test]
fn start_values_read_back_as_the_compiled_numbers() {
    let elements = elements();
    let variables = elements.iter().zip(elements.iter().skip(1)).filter(|((kind, _), _)| kind == "ScalarVariable");
    for ((_, variable), (_, value)) in variables {
        let reference = variable["valueReference"].parse().unwrap();
        let compiled = Table::new().find(reference).unwrap().start();
        let written = value.get("start").map(|start| start.parse::<f64>().unwrap());
        assert_eq!(written.map(f64::to_bits), compiled.map(f64::to_bits), "{}", variable["name"]);
    }
}

#[test]
fn the_guid_is_the_token_that_the_library_asks_for() {
    assert_eq!(elements()[0].1["guid"], token());
}
