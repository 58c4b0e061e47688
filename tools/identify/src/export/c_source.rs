//! A C header that gives a scenario the material.

use std::fmt::Write;

use softanvil_kernel::Parameter;
use softanvil_kernel::material::Material;

use super::card::Card;
use super::{Layer, ReadBackError, label, read_rows, rows};

/// The header; `comment` says where the numbers come from.
pub fn text(comment: &str, material: &Material, layer: &Layer) -> String {
    let mut text = String::from("/*\n");
    for line in comment.lines() {
        // A comment cannot hold its own end.
        let _ = writeln!(text, " * {}", line.replace("*/", "* /"));
    }
    let guard = format!("SOFTANVIL_MATERIAL_{}_H", layer.name.to_uppercase());
    let _ =
        write!(text, " */\n#ifndef {guard}\n#define {guard}\n\n#include <stddef.h>\n\n#include \"softanvil.h\"\n\n");
    let _ = writeln!(
        text,
        "/** Sets the material of the {0} in `scenario`; the first refusal ends it, details in `error` if it is not NULL. */",
        layer.name
    );
    let _ = writeln!(
        text,
        "static inline SoftanvilStatus softanvil_material_{}(SoftanvilScenario *scenario, SoftanvilError *error)\n{{",
        layer.name
    );
    text += "    static const struct {\n        uint32_t parameter;\n        double value;\n    } rows[] = {\n";
    for (parameter, value) in rows(material, layer) {
        let id = id(&parameter);
        let value = match label(&parameter, value) {
            Some(label) => format!("{id}_{}", label.to_uppercase()),
            None => format!("{value:e}"),
        };
        let _ = writeln!(text, "        {{ SOFTANVIL_PARAMETER_OF_LAYER({}, {id}), {value} }},", layer.place);
    }
    text += "    };\n    size_t i;\n    for (i = 0; i < sizeof rows / sizeof rows[0]; i++) {\n";
    text +=
        "        SoftanvilStatus status = softanvil_scenario_set(scenario, rows[i].parameter, rows[i].value, error);\n";
    text += "        if (status != SOFTANVIL_STATUS_OK) return status;\n    }\n    return SOFTANVIL_STATUS_OK;\n}\n\n#endif\n";
    text
}

/// The constant that names a parameter of a layer.
fn id(parameter: &Parameter) -> String {
    format!("SOFTANVIL_LAYER_{}", parameter.name().field().to_uppercase())
}

/// What the rows of the header in `text` set.
///
/// # Errors
/// A value that a scenario refuses.
pub fn read(text: &str, layer: &Layer) -> Result<Card, ReadBackError> {
    let value = |parameter: &Parameter| {
        let id = id(parameter);
        let row = format!("{{ SOFTANVIL_PARAMETER_OF_LAYER({}, {id}), ", layer.place);
        let value = text.lines().find_map(|line| line.trim().strip_prefix(&row)?.strip_suffix(" },"))?;
        Some(value.strip_prefix(&format!("{id}_")).unwrap_or(value).to_string())
    };
    Ok(Card::of(&read_rows(value, layer)?))
}
