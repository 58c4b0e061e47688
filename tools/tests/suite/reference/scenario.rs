//! docs/reference/scenario.md: parameters and presets.

use softanvil_kernel::material::ElasticLaw;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::preset::{self, Fitted, PRESETS};
use softanvil_kernel::{Parameter, Scenario};

use super::{code, compare, number, table};

const ABOUT: &str = "\
A scenario has one value for each of these parameters. They go by the same names everywhere: in scenario files, on the command
line (`--set impactor.mass=6`), in C, in the FMU, in Python and in Rust.

* Values are in the unit of the table, that is, in SI. Both ends of a range are legal.
* A choice is written by its label in files and options. In C and in the FMU it is a number, counted from 0 in the order here.
* In C a parameter goes by its name or by its number: `impactor.mass` is `SOFTANVIL_PARAMETER_IMPACTOR_MASS`, and `thickness` of
  layer 1 is `SOFTANVIL_PARAMETER_OF_LAYER(1, SOFTANVIL_LAYER_THICKNESS)`. The numbers in the table stay for ever.
* A value that has no effect beside the others is refused.
* The column `study` has the value of the preset that is the default. A value in brackets has no effect there.";

const LAYERS: &str = "\
Every layer has these. In a scenario file they stand in a table `[[layers]]` for each layer, from the core to the surface. Elsewhere
`layers[0].thickness` is that of the layer next to the core, and `silicone.thickness` that of the layer called so.";

#[test]
fn the_page_of_the_scenario_is_that_of_the_tables() {
    let study = preset::study();
    let groups: [(&str, &str, &[&str]); 4] = [
        ("Geometry", "", &["geometry"]),
        ("Impactor", "", &["impactor"]),
        ("Layers", LAYERS, &["layers"]),
        ("Interfaces, mesh, time, measurement", "", &["core", "face", "mesh", "time", "measurement"]),
    ];
    let mut text = format!("{ABOUT}\n\n");
    let mut count = 0;
    for (title, about, names) in groups {
        // All layers are alike.
        let rows = Parameter::all().filter(|parameter| parameter.layer().is_none_or(|layer| layer == 0));
        let rows: Vec<_> = rows
            .filter(|parameter| match parameter.layer() {
                Some(_) => names == ["layers"],
                None => names.contains(&parameter.name().group()),
            })
            .map(|parameter| row(&study, parameter))
            .collect();
        count += rows.len();
        let header = ["name", "unit", "legal", "`study`", "number", "meaning"];
        text += &format!("## {title}\n{about}{}{}", if about.is_empty() { "" } else { "\n\n" }, table(&header, rows));
    }
    assert_eq!(count, Parameter::all().filter(|parameter| parameter.layer().is_none_or(|layer| layer == 0)).count());
    text += &format!("## Elastic laws\n{}", laws());
    text += &format!("## Presets\n{}", presets());
    compare("scenario.md", "Parameters and presets", &text);
}

fn row(study: &Scenario, parameter: Parameter) -> Vec<String> {
    let name = parameter.name();
    let shown = if parameter.layer().is_some() { name.field().to_string() } else { name.to_string() };
    let (value, (low, high)) = (parameter.get(study), parameter.range());
    let (legal, value) = match parameter.kind() {
        Kind::Quantity | Kind::Count => (format!("{} to {}", number(low), number(high)), number(value)),
        Kind::Choice { labels } => {
            (labels.iter().map(code).collect::<Vec<_>>().join(", "), code(labels[value as usize]))
        }
    };
    let idle = parameter.without_effect(study).is_some();
    let unit = if parameter.kind() == Kind::Quantity { parameter.unit() } else { "" };
    vec![
        code(shown),
        unit.into(),
        legal,
        if idle { format!("({value})") } else { value },
        parameter.id().to_string(),
        parameter.description().into(),
    ]
}

fn laws() -> String {
    let rows = ElasticLaw::ALL.iter().map(|law| {
        let law = law.description();
        let coefficients = law.coefficients.iter().map(|coefficient| code(coefficient.name));
        let variants = law.variants.iter().map(|variant| code(variant.name));
        vec![
            code(law.name),
            law.description.into(),
            coefficients.collect::<Vec<_>>().join(", "),
            variants.collect::<Vec<_>>().join(", "),
        ]
    });
    format!(
        "The choice `law` of a layer, its coefficients, and the names by which `softanvil fit` has it with some of them. \
         [theory.md](../theory.md#elastic-laws) has the equations.\n\n{}",
        table(&["law", "energy", "coefficients", "in fits"], rows)
    )
}

fn presets() -> String {
    let rows = PRESETS.iter().map(|preset| {
        let fitted = if preset.fitted == Fitted::NONE { String::new() } else { preset.fitted.to_string() };
        vec![code(preset.name), preset.description.into(), fitted]
    });
    table(&["preset", "what", "fitted"], rows)
}
