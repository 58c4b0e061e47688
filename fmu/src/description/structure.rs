//! `ModelStructure`.
//!
//! No output depends on an input at the same communication point: inputs act in the step that follows. Before the first
//! step an output can depend on any parameter, which is what leaving the dependencies away says.

use std::io;

use softanvil::variables::{Variable, Version};

use super::Xml;

/// Causalities of what is computed at the start.
const COMPUTED: [&str; 2] = ["output", "calculatedParameter"];

pub(super) fn write(xml: &mut Xml, rows: &[&Variable], version: Version) -> io::Result<()> {
    xml.create_element("ModelStructure").write_inner_content(|xml| match version {
        Version::Fmi2 => {
            xml.create_element("Outputs").write_inner_content(|xml| {
                // Positions of variables in the model description, counted from 1.
                unknowns(xml, "Unknown", "index", &["output"], rows, |row, _| row as u32 + 1)
            })?;
            xml.create_element("InitialUnknowns").write_inner_content(|xml| {
                unknowns(xml, "Unknown", "index", &COMPUTED, rows, |row, _| row as u32 + 1)
            })?;
            Ok(())
        }
        Version::Fmi3 => {
            let reference = |_, variable: &Variable| variable.reference;
            unknowns(xml, "Output", "valueReference", &["output"], rows, reference)?;
            unknowns(xml, "InitialUnknown", "valueReference", &COMPUTED, rows, reference)
        }
    })?;
    Ok(())
}

/// One element for each variable of the given causalities; what is an output alone depends on nothing.
fn unknowns(
    xml: &mut Xml,
    element: &str,
    attribute: &str,
    causalities: &[&str],
    rows: &[&Variable],
    number: impl Fn(usize, &Variable) -> u32,
) -> io::Result<()> {
    let chosen = rows.iter().enumerate().filter(|(_, variable)| causalities.contains(&variable.causality()));
    for (row, variable) in chosen {
        let number = number(row, variable).to_string();
        let written = xml.create_element(element).with_attribute((attribute, number.as_str()));
        match causalities {
            ["output"] => written.with_attribute(("dependencies", "")).write_empty()?,
            _ => written.write_empty()?,
        };
    }
    Ok(())
}
