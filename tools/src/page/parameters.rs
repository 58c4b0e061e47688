//! The controls of the page, from the kernel's table of parameters.

use serde_json::{Map, Value, json};
use softanvil_kernel::material::ElasticLaw;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::preset::PRESETS;
use softanvil_kernel::scenario::MAX_LAYERS;
use softanvil_kernel::{Parameter, Scenario};

/// Those that are sliders of their own, by their names, of every layer where they are of one; the coefficients of a layer's law
/// are, too. All others are in the list.
const MAIN: [&str; 13] = [
    "impactor.drop_energy",
    "impactor.mass",
    "layers.count",
    "layers[].thickness",
    "layers[].law",
    "layers[].bulk_modulus",
    "layers[].poissons_ratio",
    "layers[].prony_g_1",
    "layers[].prony_tau_1",
    "layers[].slider_stiffness",
    "layers[].slider_yield_stress",
    "core.friction_coefficient",
    "face.friction_coefficient",
];

/// All that does not depend on a drop: parameters with unit, range and meaning, presets, examples of the laws.
pub fn table() -> Value {
    json!({
        "parameters": Parameter::all().map(row).collect::<Vec<_>>(),
        "presets": PRESETS.iter().map(|preset| json!({ "name": preset.name, "description": preset.description })).collect::<Vec<_>>(),
        "laws": laws(),
        "most_layers": MAX_LAYERS,
    })
}

fn row(parameter: Parameter) -> Value {
    let name = parameter.name();
    let (low, high) = parameter.range();
    let main = match parameter.layer() {
        Some(_) => MAIN.contains(&format!("layers[].{}", name.field()).as_str()),
        None => MAIN.contains(&name.to_string().as_str()),
    };
    json!({
        "name": name.to_string(),
        "field": name.field(),
        "layer": parameter.layer(),
        "kind": match parameter.kind() {
            Kind::Quantity => "quantity",
            Kind::Count => "count",
            Kind::Choice { .. } => "choice",
        },
        "labels": parameter.labels(),
        "unit": parameter.unit(),
        "range": [low, high],
        "description": parameter.description(),
        "main": main,
    })
}

/// Plausible coefficients of every law, which a page gives with it: a law that is given starts from zero.
fn laws() -> Value {
    let labels = Parameter::find("layers[0].law").map_or(&[] as &[&str], |parameter| parameter.labels());
    let examples = labels.iter().enumerate().filter_map(|(index, label)| {
        let description = ElasticLaw::from_repr(index)?.description();
        let named = description.coefficients.iter().zip(description.example);
        Some((
            label.to_string(),
            named.map(|(c, value)| (c.name.to_string(), json!(value))).collect::<Map<_, _>>().into(),
        ))
    });
    Value::Object(examples.collect())
}

/// The values of `scenario` by the names of their parameters, and why those without effect have none.
pub fn values(scenario: &Scenario) -> Value {
    let (mut values, mut idle) = (Map::new(), Map::new());
    for parameter in Parameter::of(scenario) {
        let (name, value) = (parameter.name().to_string(), parameter.get(scenario));
        if let Some(reason) = parameter.without_effect(scenario) {
            idle.insert(name.clone(), format!("{} is {}", reason.by, reason.says).into());
        }
        let text = match parameter.labels().get(value as usize) {
            Some(label) => (*label).into(),
            None => format!("{value}"),
        };
        values.insert(name, text.into());
    }
    json!({ "values": values, "idle": idle, "layers": scenario.layers.iter().map(|layer| layer.name.as_str()).collect::<Vec<_>>() })
}
