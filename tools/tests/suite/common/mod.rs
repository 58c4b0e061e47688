//! Runs the binary in a folder of its own.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// Runs `softanvil` with `arguments` in `folder`.
pub fn softanvil(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_softanvil")).args(arguments).current_dir(folder).output().unwrap()
}

/// Runs `softanvil`, which must succeed in silence on standard error; returns its standard output.
pub fn succeed(folder: &Path, arguments: &[&str]) -> String {
    let output = softanvil(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), stderr.as_str()), (Some(0), ""), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The JSON that `softanvil` prints.
pub fn json(folder: &Path, arguments: &[&str]) -> Value {
    serde_json::from_str(&succeed(folder, arguments)).unwrap()
}

/// Runs `softanvil`, which must fail with `exit_code`, one line on standard error and nothing on standard output;
/// returns the line without `error: `.
pub fn fail(folder: &Path, arguments: &[&str], exit_code: i32) -> String {
    let output = softanvil(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(exit_code), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
    stderr.trim_end().strip_prefix("error: ").unwrap_or_else(|| panic!("{stderr}")).to_string()
}

/// Names of everything in `folder`, sorted.
pub fn entries(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Header and lines of a CSV file.
pub fn read_table(path: &Path) -> (Vec<String>, Vec<Vec<String>>) {
    let texts = |record: &csv::StringRecord| record.iter().map(String::from).collect();
    let mut reader = csv::Reader::from_path(path).unwrap();
    let header = texts(reader.headers().unwrap());
    (header, reader.records().map(|record| texts(&record.unwrap())).collect())
}

/// Header and columns of a CSV file of numbers.
pub fn read_csv(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let (header, lines) = read_table(path);
    let column = |i: usize| lines.iter().map(|line| line[i].parse().unwrap()).collect();
    let columns = (0..header.len()).map(column).collect();
    (header, columns)
}

/// The column called `name`.
pub fn column(path: &Path, name: &str) -> Vec<f64> {
    let (header, columns) = read_csv(path);
    let index = header.iter().position(|title| title == name).unwrap_or_else(|| panic!("{name} in {header:?}"));
    columns[index].clone()
}

/// The texts of an SVG picture, which must be well formed.
pub fn svg_texts(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(document.root_element().tag_name().name(), "svg");
    document
        .descendants()
        .filter(|node| node.has_tag_name((document.root_element().tag_name().namespace().unwrap(), "text")))
        .map(|node| node.text().unwrap_or_default().trim().to_string())
        .collect()
}

/// Runs a page: its files are written, its commands run, and what it quotes of their output is there. How many commands there are.
pub fn run_page(page: &str) -> usize {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let data = format!("{}/data/", root.display());
    let page = std::fs::read_to_string(root.join("docs").join(page)).unwrap();
    let (folder, mut printed, mut commands) = (tempfile::tempdir().unwrap(), String::new(), 0);
    for block in page.split("\n```").skip(1).step_by(2) {
        let (language, lines) = block.split_once('\n').unwrap();
        match language {
            "toml" => {
                let name = lines.lines().next().unwrap().strip_prefix("# ").unwrap();
                std::fs::write(folder.path().join(name), lines.replace("data/", &data)).unwrap();
            }
            "sh" => {
                for line in lines.replace("\\\n", " ").lines() {
                    let words: Vec<String> = line.split_whitespace().map(|word| word.replace("data/", &data)).collect();
                    assert_eq!(words[0], "softanvil", "{line}");
                    let arguments: Vec<&str> = words[1..].iter().map(String::as_str).collect();
                    printed = succeed(folder.path(), &arguments);
                    commands += 1;
                }
            }
            // Columns are as wide as the names in them.
            "text" => lines
                .lines()
                .for_each(|line| assert!(squeezed(&printed).contains(&squeezed(line)), "{line} in\n{printed}")),
            _ => panic!("{language}"),
        }
    }
    commands
}

/// With one blank wherever there are several.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
