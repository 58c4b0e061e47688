//! Prints the prototypes in C of the exported functions of FMI, as cbindgen reads them from the sources, to be compiled
//! beside the official header: `cargo run -p softanvil-ffi --example fmi_prototypes -- 2|3`.
//!
//! Numbers, pointers and their constness come from the sources. What is opaque, a function or an enumeration in the official
//! header goes by its name there, and so does a truth value that a master passes, which the sources take as a byte.

use std::error::Error;
use std::fs;
use std::path::Path;

/// Types that go by their official names: objects of ours, functions of the master, and enumerations, which the sources
/// take as integers because a master can pass any.
const OFFICIAL: [&[(&str, &str)]; 2] = [
    &[
        ("Component", "fmi2Component"),
        ("FmuState", "fmi2FMUstate"),
        ("FmuStateSlot", "fmi2FMUstate*"),
        ("Status", "fmi2Status"),
        ("Byte", "fmi2Byte"),
        ("EventInfo", "fmi2EventInfo"),
        ("FmuType", "fmi2Type"),
        ("StatusKind", "fmi2StatusKind"),
        ("CallbackFunctions", "fmi2CallbackFunctions"),
    ],
    &[
        ("Instance", "fmi3Instance"),
        ("FmuState", "fmi3FMUState"),
        ("FmuStateSlot", "fmi3FMUState*"),
        ("Status", "fmi3Status"),
        ("Flag", "fmi3Boolean"),
        ("Clock", "fmi3Clock"),
        ("TextLogger", "fmi3LogMessageCallback"),
        ("IntermediateUpdate", "fmi3IntermediateUpdateCallback"),
        ("ClockUpdate", "fmi3ClockUpdateCallback"),
        ("LockPreemption", "fmi3LockPreemptionCallback"),
        ("UnlockPreemption", "fmi3UnlockPreemptionCallback"),
    ],
];

fn main() -> Result<(), Box<dyn Error>> {
    let official = match std::env::args().nth(1).as_deref() {
        Some("2") => (2, OFFICIAL[0]),
        Some("3") => (3, OFFICIAL[1]),
        _ => return Err("usage: fmi_prototypes 2|3".into()),
    };
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/fmi");
    let mut text = fs::read_to_string(sources.join("foreign.rs"))? + &fs::read_to_string(sources.join("updates.rs"))?;
    let mut files: Vec<_> = fs::read_dir(sources.join(format!("fmi{}", official.0)))?.collect::<Result<_, _>>()?;
    files.sort_by_key(fs::DirEntry::path);
    for file in files.iter().filter(|file| file.file_name() != "mod.rs") {
        text += &expanded(&fs::read_to_string(file.path())?);
    }
    print!("{}", prototypes(&text, official.1)?);
    Ok(())
}

/// What cbindgen makes of Rust source.
fn prototypes(text: &str, official: &[(&str, &str)]) -> Result<String, Box<dyn Error>> {
    let source = tempfile::Builder::new().suffix(".rs").tempfile()?;
    // The comments on modules, each at the front of a file.
    let text: Vec<_> = text.lines().filter(|line| !line.starts_with("//!")).collect();
    // A pointer to a function that may be null is the pointer itself in C.
    let text = official.iter().fold(text.join("\n"), |text, (ours, _)| text.replace(&format!("Option<{ours}>"), ours));
    fs::write(source.path(), text)?;
    let mut config = cbindgen::Config { language: cbindgen::Language::C, no_includes: true, ..Default::default() };
    config.usize_is_size_t = true;
    for (ours, theirs) in official {
        config.export.exclude.push((*ours).to_owned());
        config.export.rename.insert((*ours).to_owned(), (*theirs).to_owned());
    }
    let mut bindings = Vec::new();
    cbindgen::Builder::new().with_config(config).with_src(source.path()).generate()?.write(&mut bindings);
    Ok(String::from_utf8(bindings)?)
}

/// The source with the functions that its macros make, which cbindgen does not see: `name!(fmi3GetInt8, i8, "Int8");`.
fn expanded(source: &str) -> String {
    let mut text = source.to_owned();
    for definition in source.split("macro_rules! ").skip(1) {
        let (Some((name, _)), Some((_, body))) = (definition.split_once(' '), definition.split_once("=> {")) else {
            continue;
        };
        let body = body.split("\n    };\n}").next().unwrap_or_default();
        for call in source.split(&format!("\n{name}!(")).skip(1) {
            let arguments: Vec<_> = call.split(')').next().unwrap_or_default().split(", ").collect();
            if let [function, value, kind] = arguments[..] {
                let body = body.lines().filter(|line| !line.contains("#[doc")).collect::<Vec<_>>().join("\n");
                text += &body.replace("$name", function).replace("$value", value).replace("$type", kind);
            }
        }
    }
    text + "\n"
}
