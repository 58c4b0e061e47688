//! The pages of docs/reference, which are written from what the code says of itself. `SOFTANVIL_BLESS=1` writes them anew.

mod commands;
mod files;
mod json_keys;
mod outputs;
mod scenario;

use std::path::Path;

/// Every page begins so, behind its title.
const WRITTEN: &str = "Written from the tables of the code by `SOFTANVIL_BLESS=1 cargo test --profile checked -p softanvil --test suite \
                       reference`; a test compares.";

/// Compares a page with the committed one, or writes it.
fn compare(name: &str, title: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/reference").join(name);
    let page = format!("# {title}\n\n{WRITTEN}\n\n{}\n", text.trim());
    if std::env::var_os("SOFTANVIL_BLESS").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let line = 1 + committed.lines().zip(page.lines()).take_while(|(old, new)| old == new).count();
    assert!(
        committed == page,
        "docs/reference/{name} differs (first in line {line}): SOFTANVIL_BLESS=1 writes it anew"
    );
}

/// A table of Markdown.
fn table(header: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let mut text = line(&header.iter().map(|title| (*title).to_string()).collect::<Vec<_>>());
    text += &format!("|{}\n", "---|".repeat(header.len()));
    for row in rows {
        assert_eq!(row.len(), header.len(), "{row:?}");
        text += &line(&row.iter().map(|cell| cell.replace('|', "\\|")).collect::<Vec<_>>());
    }
    text + "\n"
}

/// As code.
fn code(text: impl std::fmt::Display) -> String {
    format!("`{text}`")
}

/// A number without more zeros than it needs.
fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}
