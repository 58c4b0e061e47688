//! `TypeDefinitions` and `ModelVariables`.

use std::fmt::Display;
use std::io;

use softanvil::variables::{Source, ValueType, Variable, Version, references, units};

use super::{Xml, number};

/// Attributes of an element.
type Attributes = Vec<(&'static str, String)>;

/// One enumeration type per choice.
pub(super) fn write_types(xml: &mut Xml, rows: &[&Variable], version: Version) -> io::Result<()> {
    xml.create_element("TypeDefinitions").write_inner_content(|xml| {
        for variable in rows {
            let is_shared = variable.name.layer().is_some_and(|layer| layer > 0);
            if let (ValueType::Enumeration { labels }, false) = (variable.value, is_shared) {
                write_type(xml, variable, labels, version)?;
            }
        }
        Ok(())
    })?;
    Ok(())
}

/// Types and variables share no name, by the capital that the type's starts with. All layers share a type.
fn type_name(variable: &Variable) -> String {
    format!("Types.{}.{}", variable.name.group(), variable.name.field())
}

fn write_type(xml: &mut Xml, variable: &Variable, labels: &[&str], version: Version) -> io::Result<()> {
    let name = type_name(variable);
    let attributes = [("name", name.as_str()), ("description", variable.description)];
    let items = |xml: &mut Xml| {
        for (index, label) in labels.iter().enumerate() {
            let attributes = [("name", *label), ("value", &index.to_string())];
            xml.create_element("Item").with_attributes(attributes).write_empty()?;
        }
        Ok(())
    };
    match version {
        Version::Fmi2 => xml.create_element("SimpleType").with_attributes(attributes).write_inner_content(|xml| {
            xml.create_element("Enumeration").write_inner_content(items)?;
            Ok(())
        })?,
        Version::Fmi3 => {
            xml.create_element("EnumerationType").with_attributes(attributes).write_inner_content(items)?
        }
    };
    Ok(())
}

pub(super) fn write(xml: &mut Xml, rows: &[&Variable], version: Version) -> io::Result<()> {
    xml.create_element("ModelVariables").write_inner_content(|xml| {
        rows.iter().try_for_each(|variable| match version {
            Version::Fmi2 => write_fmi2(xml, variable),
            Version::Fmi3 => write_fmi3(xml, variable),
        })
    })?;
    Ok(())
}

/// FMI 2.0 puts the type into an element of its own.
fn write_fmi2(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    xml.create_element("ScalarVariable").with_attributes(borrowed(&role(variable))).write_inner_content(|xml| {
        let kind = variable.value.name(Version::Fmi2);
        xml.create_element(kind).with_attributes(borrowed(&value(variable))).write_empty()?;
        Ok(())
    })?;
    Ok(())
}

fn write_fmi3(xml: &mut Xml, variable: &Variable) -> io::Result<()> {
    let mut attributes = role(variable);
    attributes.extend(value(variable));
    if matches!(variable.source, Source::Output(_) | Source::KernelTime | Source::Profile(_)) {
        attributes.push(("intermediateUpdate", "true".to_owned()));
    }
    let element = xml.create_element(variable.value.name(Version::Fmi3)).with_attributes(borrowed(&attributes));
    if let ValueType::Array { .. } = variable.value {
        let points = references::SURFACE_POINTS.to_string();
        element.write_inner_content(|xml| {
            xml.create_element("Dimension").with_attribute(("valueReference", points.as_str())).write_empty()?;
            Ok(())
        })?;
    } else {
        element.write_empty()?;
    }
    Ok(())
}

fn borrowed(attributes: &Attributes) -> impl Iterator<Item = (&str, &str)> {
    attributes.iter().map(|(name, value)| (*name, value.as_str()))
}

/// Name, reference and what FMI wants to know about every variable.
fn role(variable: &Variable) -> Attributes {
    let mut attributes = vec![
        ("name", variable.name.to_string()),
        ("valueReference", variable.reference.to_string()),
        ("description", variable.description.to_owned()),
        ("causality", variable.causality().to_owned()),
        ("variability", variable.variability().to_owned()),
    ];
    attributes.extend(variable.initial().map(|initial| ("initial", initial.to_owned())));
    attributes
}

/// Unit, range and start.
fn value(variable: &Variable) -> Attributes {
    match variable.value {
        ValueType::Real { unit, range } => quantity(variable, unit, range),
        ValueType::Array { unit } => quantity(variable, unit, None),
        ValueType::Enumeration { labels } => {
            let mut attributes = vec![
                ("declaredType", type_name(variable)),
                ("min", "0".to_owned()),
                ("max", (labels.len() - 1).to_string()),
            ];
            attributes.extend(variable.start().map(|start| ("start", start.to_string())));
            attributes
        }
        ValueType::Size { range: (min, max) } => count(variable, &min, &max),
        ValueType::Integer { range: Some((min, max)) } => count(variable, &min, &max),
        ValueType::Boolean => variable.start().map(|start| ("start", (start != 0.0).to_string())).into_iter().collect(),
        ValueType::Integer { range: None } | ValueType::String => Vec::new(),
    }
}

fn count(variable: &Variable, min: &dyn Display, max: &dyn Display) -> Attributes {
    let mut attributes = vec![("min", min.to_string()), ("max", max.to_string())];
    attributes.extend(variable.start().map(|start| ("start", start.to_string())));
    attributes
}

fn quantity(variable: &Variable, unit: &str, range: Option<(f64, f64)>) -> Attributes {
    let mut attributes = vec![("unit", unit.to_owned())];
    if let Some(unit) = units::find(unit) {
        attributes.extend(unit.display.map(|(display, _)| ("displayUnit", display.to_owned())));
        attributes.push(("nominal", number(unit.nominal)));
    }
    if let Some((min, max)) = range {
        attributes.push(("min", number(min)));
        attributes.push(("max", number(max)));
    }
    attributes.extend(variable.start().map(|start| ("start", number(start))));
    attributes
}
