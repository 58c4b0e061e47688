//! `ModelStructure`.
//!
//! No output depends on an input at the same communication point: inputs act in the step that follows. Before the first
//! step an output can depend on any parameter, which is what leaving the dependencies away says.

use std::io;

use softanvil::variables::Table;

use super::Xml;

pub(super) fn write(xml: &mut Xml, table: &Table) -> io::Result<()> {
    xml.create_element("ModelStructure").write_inner_content(|xml| {
        xml.create_element("Outputs").write_inner_content(|xml| {
            for index in indices(table, |causality| causality == "output") {
                let attributes = [("index", index.as_str()), ("dependencies", "")];
                xml.create_element("Unknown").with_attributes(attributes).write_empty()?;
            }
            Ok(())
        })?;
        xml.create_element("InitialUnknowns").write_inner_content(|xml| {
            for index in indices(table, |causality| matches!(causality, "output" | "calculatedParameter")) {
                xml.create_element("Unknown").with_attribute(("index", index.as_str())).write_empty()?;
            }
            Ok(())
        })?;
        Ok(())
    })?;
    Ok(())
}

/// Positions of variables in the model description, counted from 1.
fn indices(table: &Table, wanted: impl Fn(&str) -> bool) -> Vec<String> {
    let rows = table.rows().iter().enumerate();
    rows.filter(|(_, variable)| wanted(variable.causality())).map(|(row, _)| (row + 1).to_string()).collect()
}
