//! `modelDescription.xml`, from the variable table that also serves the getters and setters.

mod structure;
mod units;
mod variables;

use std::io;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, Event};
use softanvil::variables::{Table, Variable, Version, token};
use softanvil_kernel::{KERNEL_DIGEST, SAMPLING_INTERVAL, preset};

use crate::MODEL_IDENTIFIER;

/// Where the XML goes.
pub(crate) type Xml = Writer<Vec<u8>>;

/// Name of the model in tools.
const MODEL_NAME: &str = "Softanvil";
/// What the model is, in one line.
const DESCRIPTION: &str = "Impact of a falling or driven rigid mass on a soft anvil (visco-hyperelastic layer on a rigid \
                           core), explicit finite elements with a fixed step";

/// The model description for co-simulation in a version of the standard.
pub fn xml(version: Version) -> String {
    document(|xml| write(xml, version))
}

/// An indented XML document that `content` writes.
pub(crate) fn document(content: impl FnOnce(&mut Xml) -> io::Result<()>) -> String {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
    // Writing to memory does not fail.
    let _ = xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None))).and_then(|()| content(&mut xml));
    String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n"
}

/// The variables that `version` has.
fn rows(table: &Table, version: Version) -> Vec<&Variable> {
    table.rows().iter().filter(|variable| variable.is_in(version)).collect()
}

fn write(xml: &mut Xml, version: Version) -> io::Result<()> {
    let table = Table::new();
    let rows = rows(&table, version);
    let (number, token_name) = match version {
        Version::Fmi2 => ("2.0", "guid"),
        Version::Fmi3 => ("3.0", "instantiationToken"),
    };
    xml.create_element("fmiModelDescription")
        .with_attributes([
            ("fmiVersion", number),
            ("modelName", MODEL_NAME),
            (token_name, token().as_str()),
            ("description", DESCRIPTION),
            ("author", env!("CARGO_PKG_AUTHORS")),
            ("version", env!("CARGO_PKG_VERSION")),
            ("license", env!("CARGO_PKG_LICENSE")),
            ("generationTool", concat!("softanvil ", env!("CARGO_PKG_VERSION"))),
            ("variableNamingConvention", "structured"),
        ])
        .write_inner_content(|xml| {
            co_simulation(xml, version)?;
            units::write(xml)?;
            variables::write_types(xml, &rows, version)?;
            log_categories(xml)?;
            default_experiment(xml)?;
            if version == Version::Fmi2 {
                vendor_annotations(xml)?;
            }
            variables::write(xml, &rows, version)?;
            structure::write(xml, &rows, version)?;
            if version == Version::Fmi3 {
                annotations(xml)?;
            }
            Ok(())
        })?;
    Ok(())
}

fn co_simulation(xml: &mut Xml, version: Version) -> io::Result<()> {
    let sample = number(SAMPLING_INTERVAL);
    let capabilities: &[(&str, &str)] = match version {
        Version::Fmi2 => &[
            ("canHandleVariableCommunicationStepSize", "true"),
            ("canBeInstantiatedOnlyOncePerProcess", "false"),
            ("canNotUseMemoryManagementFunctions", "true"),
            ("canGetAndSetFMUstate", "true"),
            ("canSerializeFMUstate", "true"),
        ],
        Version::Fmi3 => &[
            ("canHandleVariableCommunicationStepSize", "true"),
            // The kernel's own step depends on the scenario and divides this one always.
            ("fixedInternalStepSize", &sample),
            ("canBeInstantiatedOnlyOncePerProcess", "false"),
            ("canGetAndSetFMUState", "true"),
            ("canSerializeFMUState", "true"),
            ("hasEventMode", "true"),
            ("mightReturnEarlyFromDoStep", "true"),
            ("canReturnEarlyAfterIntermediateUpdate", "true"),
            ("providesIntermediateUpdate", "true"),
        ],
    };
    xml.create_element("CoSimulation")
        .with_attribute(("modelIdentifier", MODEL_IDENTIFIER))
        .with_attributes(capabilities.iter().copied())
        .write_empty()?;
    Ok(())
}

fn log_categories(xml: &mut Xml) -> io::Result<()> {
    let categories = [
        ("logEvents", "changes of mode"),
        ("logStatusWarning", "results that are not what they seem, and values that have no effect"),
        ("logStatusError", "refused calls and failed steps"),
        ("logStatusDiscard", "steps that may be tried otherwise, and status inquiries that have no answer"),
        ("logAll", "all of them"),
    ];
    xml.create_element("LogCategories").write_inner_content(|xml| {
        for (name, description) in categories {
            let attributes = [("name", name), ("description", description)];
            xml.create_element("Category").with_attributes(attributes).write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}

fn default_experiment(xml: &mut Xml) -> io::Result<()> {
    let (stop, step) = (number(preset::study().time.duration), number(SAMPLING_INTERVAL));
    xml.create_element("DefaultExperiment")
        .with_attributes([("startTime", "0.0"), ("stopTime", &stop), ("stepSize", &step)])
        .write_empty()?;
    Ok(())
}

/// Which kernel is inside, where FMI 2.0 has a place for it.
fn vendor_annotations(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("VendorAnnotations").write_inner_content(|xml| {
        xml.create_element("Tool").with_attribute(("name", MODEL_IDENTIFIER)).write_inner_content(kernel)?;
        Ok(())
    })?;
    Ok(())
}

/// The same where FMI 3.0 has it.
fn annotations(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("Annotations").write_inner_content(|xml| {
        xml.create_element("Annotation").with_attribute(("type", MODEL_IDENTIFIER)).write_inner_content(kernel)?;
        Ok(())
    })?;
    Ok(())
}

fn kernel(xml: &mut Xml) -> io::Result<()> {
    let digest = format!("{KERNEL_DIGEST:016x}");
    xml.create_element("Kernel").with_attribute(("digest", digest.as_str())).write_empty()?;
    Ok(())
}

/// The shortest text that reads back as the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}
