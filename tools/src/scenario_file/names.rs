//! Names of parameters as people write them: those of a layer by its place, `layers[0].c10`, or by the layer's name,
//! `silicone.c10`.

use softanvil_kernel::parameter::Values;
use softanvil_kernel::scenario::MAX_LAYER_NAME;
use softanvil_kernel::{Parameter, Scenario};

/// The group of the parameters of layers.
pub(super) const LAYERS: &str = "layers";

/// The parameter that `name` means beside `values`.
///
/// # Errors
/// That there is none, with the nearest name, or how it is written now.
pub fn find(values: &Values, name: &str) -> Result<Parameter, String> {
    values.find(name).ok_or_else(|| unknown(&values.scenario(), name))
}

/// Why `name` is no parameter of `scenario`.
pub fn unknown(scenario: &Scenario, name: &str) -> String {
    match moved(scenario, name) {
        Some(spelling) => format!("{name} is refused: {spelling}"),
        None => format!("{name} is unknown{}", suggestion(scenario, name)),
    }
}

/// Whether `name` may mean a parameter, of whatever layers.
pub fn may_be(name: &str) -> bool {
    let is_field = |field| Parameter::of_layer(0).any(|parameter| parameter.name().field() == field);
    Parameter::find(name).is_some() || name.split_once('.').is_some_and(|(_, field)| is_field(field))
}

/// How a name of an older version, or one of a layer that is not there, is written.
pub(super) fn moved(scenario: &Scenario, name: &str) -> Option<String> {
    let first = |field: &str| match scenario.layers.first() {
        Some(layer) if !layer.name.is_empty() => format!("{}.{field}", layer.name),
        _ => format!("layers[0].{field}"),
    };
    let (group, field) = name.split_once('.').unwrap_or((name, ""));
    if scenario.layers.iter().any(|layer| layer.name == group) {
        return None;
    }
    let place = match (group, field) {
        ("geometry", "layers") => {
            return Some("expected layers.count = 2 or, in a file, a table [[layers]] for each layer".into());
        }
        ("geometry", "silicone_thickness") => return Some(format!("expected {}", first("thickness"))),
        ("geometry", "skin_thickness") => return Some("expected layers[1].thickness".into()),
        ("silicone", _) => 0,
        ("skin", _) => 1,
        _ => return None,
    };
    let table = format!("a table [[layers]] with name = \"{group}\"");
    Some(match field {
        "" => format!("no layer is called {group}: expected {table}"),
        field => format!("no layer is called {group}: expected layers[{place}].{field} or, in a file, {table}"),
    })
}

/// The known name most like `name`, if one is like it.
pub fn suggestion(scenario: &Scenario, name: &str) -> String {
    /// Below this similarity (0 to 1) a suggestion confuses more than it helps.
    const SIMILAR: f64 = 0.8;
    let (mut best, mut known) = ((SIMILAR, None), Vec::new());
    for parameter in Parameter::of(scenario) {
        known.extend([parameter.name().to_string(), parameter.name().group().to_string()]);
        let layer = parameter.layer().and_then(|place| scenario.layers.get(place));
        if let Some(layer) = layer.filter(|layer| !layer.name.is_empty()) {
            known.extend([format!("{}.{}", layer.name, parameter.name().field()), layer.name.to_string()]);
        }
    }
    for known in known {
        let similarity = strsim::normalized_damerau_levenshtein(&known, name);
        if similarity >= best.0 {
            best = (similarity, Some(known));
        }
    }
    best.1.map_or_else(String::new, |known| format!(" (did you mean {known}?)"))
}

/// Refuses a name for the layer at `place` that would be taken for something else.
///
/// # Errors
/// What is legal.
pub fn check_layer_name(values: &Values, place: usize, name: &str) -> Result<(), String> {
    let letters = name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'-');
    if name.is_empty() || name.len() > MAX_LAYER_NAME || !letters {
        return Err(format!("1 to {MAX_LAYER_NAME} letters, digits, _ and -"));
    }
    if Parameter::all().any(|parameter| parameter.name().group() == name) {
        return Err("a name that is no group of parameters".into());
    }
    let scenario = values.scenario();
    if scenario.layers.iter().enumerate().any(|(other, layer)| other != place && layer.name == name) {
        return Err("a name that no other layer has".into());
    }
    Ok(())
}
