//! docs/reference/commands.md: commands and their options, as `softanvil COMMAND -h` prints them.

use tempfile::tempdir;

use super::{code, compare, table};
use crate::common::succeed;

const COMMANDS: [&str; 13] = [
    "run",
    "report",
    "page",
    "measure",
    "protect",
    "validate",
    "calibrate",
    "sweep",
    "reduction",
    "scenario",
    "fit",
    "fmu",
    "golden",
];

#[test]
fn the_page_of_the_commands_is_that_of_their_help() {
    let folder = tempdir().unwrap();
    let help = |arguments: &[&str]| succeed(folder.path(), arguments);
    let whole = help(&["-h"]);
    let mut text = format!("{}\n", sections(&whole, ""));
    for command in COMMANDS {
        assert!(whole.contains(&format!("\n  {command} ")), "{command}");
        text += &sections(&help(&[command, "-h"]), command);
    }
    let (_, listed) = whole.split_once("\nCommands:\n").unwrap();
    // The last is that of the help.
    assert_eq!(listed.lines().take_while(|line| !line.is_empty()).count(), COMMANDS.len() + 1, "{whole}");
    compare("commands.md", "Commands", &text);
}

/// The help of a command as Markdown.
fn sections(help: &str, command: &str) -> String {
    let mut blocks = help.trim().split("\n\n");
    let about = blocks.next().unwrap();
    let mut text = if command.is_empty() { format!("{about}\n\n") } else { format!("## {command}\n{about}.\n\n") };
    for block in blocks {
        let (title, lines) = block.split_once('\n').unwrap_or((block, ""));
        if let Some(usage) = title.strip_prefix("Usage: ") {
            let usage = [usage].into_iter().chain(lines.lines().map(str::trim));
            text += &format!("```text\n{}\n```\n", usage.collect::<Vec<_>>().join("\n"));
        } else if lines.is_empty() {
            text += &format!("{title}\n\n");
        } else if !rows(lines).is_empty() {
            let heading = title.trim_end_matches(':');
            let heading = if heading == "Options" { String::new() } else { format!("{heading}:\n\n") };
            text += &format!("{heading}{}", table(&[&first_title(title), "meaning"], rows(lines)));
        }
    }
    text
}

fn first_title(title: &str) -> String {
    match title {
        "Commands:" => "command",
        "Arguments:" => "argument",
        _ => "option",
    }
    .into()
}

/// Names with what they mean, in one line or in two.
fn rows(lines: &str) -> Vec<Vec<String>> {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for line in lines.lines() {
        let line = line.trim();
        match (line.split_once("  "), rows.last_mut()) {
            (Some((name, meaning)), _) => rows.push(vec![code(name), meaning.trim().into()]),
            (None, Some(row)) if row[1].is_empty() => row[1] = line.into(),
            (None, _) => rows.push(vec![code(line), String::new()]),
        }
    }
    // Nobody looks for these here.
    rows.retain(|row| !row[0].contains("--help") && !row[0].contains("--version") && row[0] != "`help`");
    assert!(rows.iter().all(|row| !row[1].is_empty()), "{rows:?}");
    rows
}
