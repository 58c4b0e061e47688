//! An SSP parameter set (System Structure and Parameterization 1.0, `.ssv`) for the FMU, whose variables have the names
//! of the kernel's parameters.

use std::collections::BTreeMap;
use std::io;

use quick_xml::events::{BytesDecl, BytesStart, Event};
use quick_xml::{Reader, Writer};
use softanvil_kernel::material::Material;

use super::card::Card;
use super::{Layer, ReadBackError, label, read_rows, rows};

/// The parameter set of `material`, called `name`.
///
/// # Errors
/// Never, as it is written to memory.
pub fn text(name: &str, material: &Material, layer: &Layer) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let attributes = [
        ("xmlns:ssv", "http://ssp-standard.org/SSP1/SystemStructureParameterValues"),
        ("xmlns:ssc", "http://ssp-standard.org/SSP1/SystemStructureCommon"),
        ("version", "1.0"),
        ("name", name),
        ("generationTool", "Softanvil"),
    ];
    xml.create_element("ssv:ParameterSet").with_attributes(attributes).write_inner_content(|xml| {
        xml.create_element("ssv:Parameters").write_inner_content(|xml| {
            for (parameter, value) in rows(material, layer) {
                xml.create_element("ssv:Parameter")
                    .with_attribute(("name", parameter.name().to_string().as_str()))
                    .write_inner_content(|xml| {
                        match label(&parameter, value) {
                            Some(label) => {
                                xml.create_element("ssv:Enumeration").with_attribute(("value", label)).write_empty()?
                            }
                            // Display gives the shortest decimal that reads back to the same bits.
                            None => {
                                let value = value.to_string();
                                xml.create_element("ssv:Real")
                                    .with_attribute(("value", value.as_str()))
                                    .write_empty()?
                            }
                        };
                        Ok(())
                    })?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n")
}

/// What the parameter set in `text` sets.
///
/// # Errors
/// What is no XML, or a value that a scenario refuses.
pub fn read(text: &str, layer: &Layer) -> Result<Card, ReadBackError> {
    let refuse = |error: &dyn std::fmt::Display| ReadBackError::new(error.to_string());
    let mut reader = Reader::from_str(text);
    let (mut name, mut values) = (String::new(), BTreeMap::new());
    loop {
        match reader.read_event().map_err(|error| refuse(&error))? {
            Event::Eof => break,
            Event::Start(element) | Event::Empty(element) => match element.name().as_ref() {
                "ssv:Parameter" => name = attribute(&element, "name")?,
                "ssv:Real" | "ssv:Enumeration" => {
                    values.insert(name.clone(), attribute(&element, "value")?);
                }
                _ => {}
            },
            _ => {}
        }
    }
    Ok(Card::of(&read_rows(|parameter| values.get(&parameter.name().to_string()).cloned(), layer)?))
}

fn attribute(element: &BytesStart, name: &str) -> Result<String, ReadBackError> {
    let attribute = element.try_get_attribute(name).ok().flatten();
    let text = attribute.map(|attribute| attribute.value.into_owned());
    text.ok_or_else(|| ReadBackError::new(format!("an element without {name}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    #[test]
    fn every_parameter_of_the_layer_is_there_once_with_its_value() {
        let material = Law::find("yeoh_3").unwrap().material(&[1.0 / 3.0, 2e-7, 3e8]);
        let text = text("rubber", &material, &Layer::parse("skin").unwrap()).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let value = |name: &str| {
            let found: Vec<_> = document.descendants().filter(|node| node.attribute("name") == Some(name)).collect();
            assert_eq!(found.len(), 1, "{name}");
            found[0].first_element_child().unwrap().attribute("value").unwrap().to_string()
        };
        assert_eq!(value("layers[1].c10").parse::<f64>().unwrap(), 1.0 / 3.0);
        assert_eq!(value("layers[1].c20").parse::<f64>().unwrap(), 2e-7);
        assert_eq!(value("layers[1].law"), "yeoh");
        assert!(!text.contains("layers[0]"));
    }
}
