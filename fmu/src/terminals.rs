//! `terminalsAndIcons/terminalsAndIcons.xml` of FMI 3.0: what a model of the impactor is connected to, and the icon.

use std::io;

use crate::description::{Xml, document};

/// Variables of the terminal under the names that the other side sees.
const MEMBERS: [(&str, &str); 3] =
    [("impactor.driven_position", "position"), ("impactor.driven_velocity", "velocity"), ("contact.force", "force")];

/// The file.
pub fn xml() -> String {
    document(write)
}

fn write(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("fmiTerminalsAndIcons").with_attribute(("fmiVersion", "3.0")).write_inner_content(|xml| {
        let corners = [("x1", "-100"), ("y1", "-100"), ("x2", "100"), ("y2", "100")];
        xml.create_element("GraphicalRepresentation").write_inner_content(|xml| {
            xml.create_element("CoordinateSystem")
                .with_attributes(corners)
                .with_attribute(("suggestedScalingFactorTo_mm", "0.1"))
                .write_empty()?;
            xml.create_element("Icon").with_attributes(corners).write_empty()?;
            Ok(())
        })?;
        xml.create_element("Terminals").write_inner_content(terminal)?;
        Ok(())
    })?;
    Ok(())
}

fn terminal(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("Terminal")
        .with_attributes([
            ("name", "impactor"),
            ("matchingRule", "plug"),
            ("description", "motion of a driven impactor in, contact force on it out; positive upwards"),
        ])
        .write_inner_content(|xml| {
            for (variable, member) in MEMBERS {
                xml.create_element("TerminalMemberVariable")
                    .with_attributes([("variableName", variable), ("memberName", member), ("variableKind", "signal")])
                    .write_empty()?;
            }
            Ok(())
        })?;
    Ok(())
}
