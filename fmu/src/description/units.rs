//! `UnitDefinitions`.

use std::io;

use softanvil::variables::units::{UNITS, Unit};

use super::{Xml, number};

pub(super) fn write(xml: &mut Xml) -> io::Result<()> {
    xml.create_element("UnitDefinitions")
        .write_inner_content(|xml| UNITS.iter().try_for_each(|unit| write_unit(xml, unit)))?;
    Ok(())
}

fn write_unit(xml: &mut Xml, unit: &Unit) -> io::Result<()> {
    xml.create_element("Unit").with_attribute(("name", unit.name)).write_inner_content(|xml| {
        let exponents = ["kg", "m", "s"].into_iter().zip(unit.base).filter(|(_, exponent)| *exponent != 0);
        exponents
            .fold(xml.create_element("BaseUnit"), |element, (base, exponent)| {
                element.with_attribute((base, exponent.to_string().as_str()))
            })
            .with_attribute(("factor", "1"))
            .write_empty()?;
        if let Some((name, factor)) = unit.display {
            let attributes = [("name", name), ("factor", &number(factor))];
            xml.create_element("DisplayUnit").with_attributes(attributes).write_empty()?;
        }
        Ok(())
    })?;
    Ok(())
}
