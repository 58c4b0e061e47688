//! Every type that the kernel names at its root has an example in its documentation, which is a test of its own.

use std::fs;
use std::path::Path;

/// The types among the names that `root`, the text of a crate's root, hands on.
fn types(root: &str) -> Vec<&str> {
    let lists = root.split("\npub use ").skip(1).filter_map(|text| text.split_once(';'));
    let names = lists.flat_map(|(list, _)| list.rsplit("::").next().unwrap_or(list).split(','));
    // Constants are written in capitals, functions in small letters.
    let is_type = |name: &&str| name.starts_with(char::is_uppercase) && name.contains(char::is_lowercase);
    names.map(|name| name.trim_matches(|c: char| "{} \n".contains(c))).filter(is_type).collect()
}

/// Whether the documentation of the type called `name` has an example that is run; none where `source` does not define it.
fn has_example(source: &str, name: &str) -> Option<bool> {
    let is_definition = |line: &&str| {
        let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.next() == Some("pub") && matches!(words.next(), Some("struct" | "enum")) && words.next() == Some(name)
    };
    let lines: Vec<&str> = source.lines().collect();
    let definition = lines.iter().position(is_definition)?;
    let above = lines[..definition].iter().rev().take_while(|line| !line.is_empty());
    // A fence with words behind it may say that the example is not run.
    let fences = above.filter(|line| line.starts_with("/// ```")).map(|line| *line == "/// ```");
    Some(fences.clone().count() >= 2 && fences.clone().all(|plain| plain))
}

fn sources(folder: &Path, found: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else {
            found.push(fs::read_to_string(path).unwrap());
        }
    }
}

#[test]
fn every_type_at_the_root_of_the_kernel_has_an_example() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../kernel/src");
    let root = fs::read_to_string(folder.join("lib.rs")).unwrap();
    let mut texts = Vec::new();
    sources(&folder, &mut texts);
    let names = types(&root);
    assert!(["ModelError", "Simulation", "StateMemory"].iter().all(|name| names.contains(name)), "{names:?}");
    for name in names {
        let found: Vec<bool> = texts.iter().filter_map(|text| has_example(text, name)).collect();
        assert_eq!(found, [true], "{name} has no example that is run, or not one definition");
    }
}

#[test]
fn a_type_without_an_example_is_seen() {
    assert_eq!(
        types("\npub use a::{FIELDS, Field};\n#[cfg(x)]\npub use b::C;\npub use step::{step, Ab};"),
        ["Field", "Ab"]
    );
    for (text, expected) in [
        ("/// A.\n///\n/// ```\n/// a()\n/// ```\n#[derive(Clone)]\npub struct A<'a> {", Some(true)),
        ("/// A.\n///\n/// ```no_run\n/// a()\n/// ```\npub struct A;", Some(false)),
        ("/// B.\n///\n/// ```\n/// b()\n/// ```\npub struct B;\n\n/// A.\npub enum A {", Some(false)),
        ("/// A.\npub struct Ab;", None),
    ] {
        assert_eq!(has_example(text, "A"), expected, "{text}");
    }
}
