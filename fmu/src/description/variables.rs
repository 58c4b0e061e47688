//! `TypeDefinitions` and `ModelVariables`.

use std::io;

use softanvil::variables::{Table, ValueType, Variable, units};

use super::{Xml, number};

/// One enumeration type per choice.
pub(super) fn write_types(xml: &mut Xml, table: &Table) -> io::Result<()> {
    xml.create_element("TypeDefinitions").write_inner_content(|xml| {
        for variable in table.rows() {
            if let ValueType::Enumeration { labels } = variable.value {
                write_type(xml, variable, labels)?;
            }
        }
        Ok(())
    })?;
    Ok(())
}

/// Types and variables share no name, by the capital that the type's starts with.
fn type_name(variable: &Variable) -> String {
    format!("Types.{}", variable.name)
}

fn write_type(xml: &mut Xml, variable: &Variable, labels: &[&str]) -> io::Result<()> {
    let name = type_name(variable);
    let attributes = [("name", name.as_str()), ("description", variable.description)];
    xml.create_element("SimpleType").with_attributes(attributes).write_inner_content(|xml| {
        xml.create_element("Enumeration").write_inner_content(|xml| {
            for (index, label) in labels.iter().enumerate() {
                let attributes = [("name", *label), ("value", &index.to_string())];
                xml.create_element("Item").with_attributes(attributes).write_empty()?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(())
}

pub(super) fn write(xml: &mut Xml, table: &Table) -> io::Result<()> {
    xml.create_element("ModelVariables")
        .write_inner_content(|xml| table.rows().iter().try_for_each(|variable| write_variable(xml, variable)))?;
    Ok(())
}

fn write_variable(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let mut attributes = vec![
        ("name", variable.name.to_owned()),
        ("valueReference", variable.reference.to_string()),
        ("description", variable.description.to_owned()),
        ("causality", variable.causality().to_owned()),
        ("variability", variable.variability().to_owned()),
    ];
    if let Some(initial) = variable.initial() {
        attributes.push(("initial", initial.to_owned()));
    }
    xml.create_element("ScalarVariable")
        .with_attributes(attributes.iter().map(|(name, value)| (*name, value.as_str())))
        .write_inner_content(|xml| write_value(xml, variable))?;
    Ok(())
}

/// The element of the variable's type, with unit, range and start.
fn write_value(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let mut attributes: Vec<(&str, String)> = Vec::new();
    match variable.value {
        ValueType::Real { unit, range } => describe_quantity(&mut attributes, variable, unit, range),
        ValueType::Enumeration { labels } => {
            attributes.push(("declaredType", type_name(variable)));
            attributes.push(("min", "0".to_owned()));
            attributes.push(("max", (labels.len() - 1).to_string()));
            attributes.extend(variable.start().map(|start| ("start", start.to_string())));
        }
        ValueType::Integer | ValueType::Boolean | ValueType::String => {}
    }
    xml.create_element(variable.value.name())
        .with_attributes(attributes.iter().map(|(name, value)| (*name, value.as_str())))
        .write_empty()?;
    Ok(())
}

fn describe_quantity(attributes: &mut Vec<(&str, String)>, variable: &Variable, unit: &str, range: Option<(f64, f64)>) {
    attributes.push(("unit", unit.to_owned()));
    if let Some(unit) = units::find(unit) {
        attributes.extend(unit.display.map(|(display, _)| ("displayUnit", display.to_owned())));
        attributes.push(("nominal", number(unit.nominal)));
    }
    if let Some((min, max)) = range {
        attributes.push(("min", number(min)));
        attributes.push(("max", number(max)));
    }
    attributes.extend(variable.start().map(|start| ("start", number(start))));
}
