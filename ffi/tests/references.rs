//! Variables of the FMU against `references.txt`, the list that no version may go back on: a system model names them by their
//! references, and their types and units stand in its connections. `SOFTANVIL_BLESS=1` adds what is new to the list.

use std::fmt::Write;
use std::path::Path;

use softanvil::variables::{Table, ValueType, Variable, Version};

const FROZEN: &str = include_str!("references.txt");

#[test]
fn what_a_system_model_names_stays() {
    let table = Table::new();
    let present: Vec<String> = table.rows().iter().map(line).collect();
    let broken: Vec<_> = FROZEN.lines().filter(|frozen| !present.iter().any(|line| keeps(frozen, line))).collect();
    assert!(broken.is_empty(), "gone or changed since they were frozen: {broken:#?}");
    let listed: Vec<_> = FROZEN.lines().filter_map(|line| line.split_once(' ')).map(|(number, _)| number).collect();
    assert!(listed.is_sorted_by_key(|number| number.parse::<u32>().unwrap()));
    if std::env::var_os("SOFTANVIL_BLESS").is_some() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/references.txt");
        std::fs::write(path, present.iter().map(|line| format!("{line}\n")).collect::<String>()).unwrap();
    } else {
        let lines: Vec<_> = FROZEN.lines().collect();
        assert_eq!(lines, present, "SOFTANVIL_BLESS=1 adds to tests/references.txt");
    }
}

#[test]
fn a_change_is_told_from_an_addition() {
    let frozen = "5000 contact.active Enumeration - no|yes";
    assert!(keeps(frozen, frozen) && keeps(frozen, "5000 contact.active Enumeration - no|yes|perhaps"));
    for changed in [
        "5001 contact.active Enumeration - no|yes",
        "5000 contact.is_active Enumeration - no|yes",
        "5000 contact.active Real - no|yes",
        "5000 contact.active Enumeration m no|yes",
        "5000 contact.active Enumeration - yes|no",
        "5000 contact.active Enumeration - no",
        "5000 contact.active Enumeration - no|yessir",
    ] {
        assert!(!keeps(frozen, changed), "{changed}");
    }
}

/// Whether a variable is what it was. Its choices are numbered by their places, so that new ones go behind.
fn keeps(frozen: &str, line: &str) -> bool {
    line.strip_prefix(frozen).is_some_and(|rest| rest.is_empty() || rest.starts_with('|'))
}

/// Reference, name, type of FMI 3, causality, unit, and choices in their order.
fn line(variable: &Variable) -> String {
    let (unit, labels) = match variable.value {
        ValueType::Real { unit, .. } | ValueType::Array { unit } => (unit, [].as_slice()),
        ValueType::Enumeration { labels } => ("-", labels),
        _ => ("-", [].as_slice()),
    };
    let mut line = format!(
        "{} {} {} {} {unit}",
        variable.reference,
        variable.name,
        variable.value.name(Version::Fmi3),
        variable.causality()
    );
    if !labels.is_empty() {
        write!(line, " {}", labels.join("|")).unwrap();
    }
    line
}
