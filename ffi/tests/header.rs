//! Puts `include/softanvil.h` together and compares it with the committed file. `SOFTANVIL_BLESS=1` writes it instead.
//!
//! Functions and types come from the sources by cbindgen, one section per file of `src/c_api`; the numbers of
//! parameters, outputs, choices and presets come from the tables; the version comes from Cargo.toml.

use std::path::{Path, PathBuf};

use softanvil_kernel::parameter::Kind;
use softanvil_kernel::preset::PRESETS;
use softanvil_kernel::{FIELDS, KERNEL_DIGEST, OUTPUTS, Parameter};

#[test]
fn the_committed_header_is_what_the_sources_say() {
    let path = crate_folder().join("../include/softanvil.h");
    let header = header();
    if std::env::var_os("SOFTANVIL_BLESS").is_some() {
        std::fs::write(&path, &header).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap();
    let line = committed.lines().zip(header.lines()).position(|(a, b)| a != b).map_or(0, |index| index + 1);
    assert!(committed == header, "softanvil.h differs (first in line {line}): SOFTANVIL_BLESS=1 writes it anew");
}

#[test]
fn nothing_of_fmi_is_in_the_header() {
    assert!(!header().contains("fmi2"));
}

fn crate_folder() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The whole header.
fn header() -> String {
    let parts = [
        include_str!("../src/c_api/conventions.h").to_owned(),
        version(),
        title("Status and errors"),
        bindings("c_api/status.rs", &["SoftanvilStatus"]),
        "\n/** No parameter, no element. */\n#define SOFTANVIL_NONE UINT32_MAX\n".to_owned(),
        bindings("c_api/error.rs", &["SoftanvilError"]),
        title("Library"),
        bindings("c_api/library.rs", &[]),
        title("Numbers of presets, parameters, choices and outputs"),
        numbers(),
        title("Tables of parameters and outputs"),
        bindings("c_api/text.rs", &[]),
        bindings("c_api/tables.rs", &[]),
        title("Scenario"),
        bindings("c_api/scenario.rs", &[]),
        title("Simulation"),
        SIMULATION.to_owned(),
        bindings("c_api/simulation.rs", &[]),
        title("Trace"),
        bindings("c_api/trace.rs", &["SoftanvilTrace"]),
        title("Fields"),
        bindings("c_api/fields.rs", &[]),
        title("Snapshot"),
        bindings("c_api/snapshot.rs", &[]),
        "\n#ifdef __cplusplus\n}\n#endif\n\n#endif /* SOFTANVIL_H */\n".to_owned(),
    ];
    tidy(&parts.concat())
}

const SIMULATION: &str = "
/**
 * A simulation. Its content is private; it lives at the front of the memory given to `softanvil_init`.
 */
typedef struct SoftanvilSimulation SoftanvilSimulation;
";

fn title(text: &str) -> String {
    format!("\n/* {} */\n/* {text:<112} */\n/* {} */\n", "=".repeat(112), "=".repeat(112))
}

/// Version macros of this package.
fn version() -> String {
    let [major, minor, patch] =
        [env!("CARGO_PKG_VERSION_MAJOR"), env!("CARGO_PKG_VERSION_MINOR"), env!("CARGO_PKG_VERSION_PATCH")];
    format!(
        "
/** Version of this header. */
#define SOFTANVIL_VERSION_MAJOR {major}
/** Version of this header. */
#define SOFTANVIL_VERSION_MINOR {minor}
/** Version of this header. */
#define SOFTANVIL_VERSION_PATCH {patch}
/** Version of this header as one number, to be compared with softanvil_version(). */
#define SOFTANVIL_VERSION \\
    (SOFTANVIL_VERSION_MAJOR * 1000000 + SOFTANVIL_VERSION_MINOR * 1000 + SOFTANVIL_VERSION_PATCH)
/** Version of this header as text. */
#define SOFTANVIL_VERSION_TEXT \"{}\"
/** Digest of what the kernel of this version computes, to be compared with softanvil_kernel_digest(). */
#define SOFTANVIL_KERNEL_DIGEST UINT64_C(0x{KERNEL_DIGEST:016x})
",
        env!("CARGO_PKG_VERSION")
    )
}

/// What cbindgen makes of one source file; `types` that no function in it mentions are added.
fn bindings(file: &str, types: &[&str]) -> String {
    let mut config = cbindgen::Config::from_file(crate_folder().join("cbindgen.toml")).unwrap();
    config.export.include = types.iter().map(|name| (*name).to_owned()).collect();
    let source: PathBuf = crate_folder().join("src").join(file);
    let mut text = Vec::new();
    cbindgen::Builder::new().with_config(config).with_src(source).generate().unwrap().write(&mut text);
    format!("\n{}", String::from_utf8(text).unwrap())
}

/// The enumerations that the tables define.
fn numbers() -> String {
    let mut text = enumeration(
        "SoftanvilPreset",
        "Ready-made scenarios.",
        &PRESETS.iter().map(|row| (row.id, row.name.to_owned(), row.description.to_owned())).collect::<Vec<_>>(),
    );
    let test: Vec<_> = Parameter::all().filter(|parameter| parameter.layer().is_none()).collect();
    let layer: Vec<_> = Parameter::of_layer(0).collect();
    let about = "Parameters that belong to no layer: name, unit, legal range, meaning.";
    text += &enumeration("SoftanvilParameter", about, &test.iter().map(parameter).collect::<Vec<_>>());
    let about = "Parameters of a layer, to be given to SOFTANVIL_PARAMETER_OF_LAYER: name, unit, legal range, meaning.";
    text += &enumeration("SoftanvilLayer", about, &layer.iter().map(parameter).collect::<Vec<_>>());
    text += OF_LAYER;
    for parameter in test.iter().chain(&layer) {
        let labels = parameter.labels();
        if !labels.is_empty() {
            let about = format!("{}: {}.", short_name(parameter), parameter.description());
            text += &enumeration(&type_name(&short_name(parameter)), &about, &numbered(labels));
        }
    }
    let outputs: Vec<_> = OUTPUTS
        .iter()
        .map(|row| (row.id, row.name.to_owned(), format!("{}{}: {}.", row.name, unit(row.unit), row.description)))
        .collect();
    text += &enumeration("SoftanvilOutput", "Outputs of a simulation: name, unit, meaning.", &outputs);
    let fields: Vec<_> = FIELDS
        .iter()
        .map(|row| {
            let components =
                if row.components == 1 { String::new() } else { format!(", {} components", row.components) };
            let about = format!("{}{}{components}: {}.", row.name, unit(row.unit), row.description);
            (row.id, row.name.to_owned(), about)
        })
        .collect();
    text + &enumeration("SoftanvilField", "Fields of a simulation: name, unit, components, meaning.", &fields)
}

const OF_LAYER: &str = "
/** Number of a parameter of a layer, 0 next to the core: SOFTANVIL_PARAMETER_OF_LAYER(1, SOFTANVIL_LAYER_C10). */
#define SOFTANVIL_PARAMETER_OF_LAYER(layer, parameter) \\
    (SOFTANVIL_LAYERS_BEGIN + SOFTANVIL_LAYER_NUMBERS * (uint32_t)(layer) + (uint32_t)(parameter))
";

/// A row of an enumeration: number, name, meaning.
type Row = (u32, String, String);

fn numbered(labels: &[&str]) -> Vec<Row> {
    (0..).zip(labels).map(|(number, label)| (number, (*label).to_owned(), String::new())).collect()
}

/// Name of a parameter; of a layer's "layer.field", whatever the layer.
fn short_name(parameter: &Parameter) -> String {
    let name = parameter.name();
    if name.layer().is_some() { format!("layer.{}", name.field()) } else { name.to_string() }
}

fn parameter(parameter: &Parameter) -> Row {
    let (name, description) = (short_name(parameter), parameter.description());
    let (min, max) = parameter.range();
    let meaning = match parameter.kind() {
        Kind::Quantity => {
            format!("{name}{}, from {} to {}: {description}.", unit(parameter.unit()), number(min), number(max))
        }
        Kind::Count => format!("{name}, a whole number from {min} to {max}: {description}."),
        Kind::Choice { .. } => format!("{name}, a {}: {description}.", type_name(&name)),
    };
    let name = parameter.layer().map_or(name, |_| parameter.name().field().to_owned());
    (parameter.id(), name, meaning)
}

/// Short for very large and very small numbers.
fn number(value: f64) -> String {
    let plain = value == 0.0 || (1e-3..1e5).contains(&value.abs());
    if plain { format!("{value}") } else { format!("{value:e}") }
}

fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(", {unit}") }
}

/// "impactor.drop_by" to "SoftanvilImpactorDropBy".
fn type_name(name: &str) -> String {
    let words = name.split(['.', '_']).map(|word| word[..1].to_uppercase() + &word[1..]);
    format!("Softanvil{}", words.collect::<String>())
}

/// A C enumeration of `rows` with their numbers, each with a comment.
fn enumeration(name: &str, about: &str, rows: &[Row]) -> String {
    let prefix = name.chars().fold(String::new(), |text, c| match c {
        c if c.is_uppercase() && !text.is_empty() => format!("{text}_{c}"),
        c => text + &c.to_uppercase().to_string(),
    });
    let mut rows = rows.to_vec();
    rows.sort_by_key(|(number, ..)| *number);
    let mut text = format!("\n/** {about} */\nenum {name} {{\n");
    for (place, (number, row, meaning)) in rows.iter().enumerate() {
        if !meaning.is_empty() {
            text += &format!("    /** {meaning} */\n");
        }
        let comma = if place + 1 < rows.len() { "," } else { "" };
        text += &format!("    {prefix}_{} = {number}{comma}\n", row.replace(['.', '-'], "_").to_uppercase());
    }
    text + "};\n"
}

/// Takes out what concerns Rust alone and what cbindgen repeats per section, and shortens comments of one line.
fn tidy(header: &str) -> String {
    let mut text = header.replace(" *\n * # Safety\n * The conventions of the header.\n", "");
    text = text.replace("\n#ifdef __cplusplus\nextern \"C\" {\n#endif // __cplusplus\n", "");
    text = text.replace("\n#ifdef __cplusplus\n}  // extern \"C\"\n#endif  // __cplusplus\n", "");
    while text.contains("\n\n\n") {
        text = text.replace("\n\n\n", "\n\n");
    }
    let mut lines: Vec<String> = text.lines().map(without_tag).collect();
    for i in (2..lines.len()).rev() {
        let alone = lines[i].trim() == "*/" && lines[i - 2].trim() == "/**";
        if let (true, Some((indent, words))) = (alone, lines[i - 1].split_once("* ")) {
            lines[i - 2] = format!("{}/** {words} */", &indent[1..]);
            lines.drain(i - 1..=i);
        }
    }
    lines.join("\n") + "\n"
}

/// The line with type names instead of structure tags.
fn without_tag(line: &str) -> String {
    if line.starts_with("typedef") { line.to_owned() } else { line.replace("struct Softanvil", "Softanvil") }
}
