//! The documentation as a whole: its table of contents, its links, the paths and the numbers that it states.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use softanvil_kernel::material::ElasticLaw;
use softanvil_kernel::mesh::Grid;
use softanvil_kernel::{FIELDS, INPUTS, OUTPUTS, Parameter, preset};

use crate::common::{read_csv, succeed};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_path_buf()
}

/// Every Markdown file of the repository, by its path from the root.
fn pages() -> BTreeMap<PathBuf, String> {
    let root = root();
    let mut found = BTreeMap::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
            let (path, name) = (entry.path(), entry.file_name().into_string().unwrap());
            // Links lead to folders that are visited anyway; what is built, or belongs to a tool, is no documentation.
            if entry.file_type().unwrap().is_dir() && name != "target" && !name.starts_with('.') {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") && path.is_file() {
                let text = std::fs::read_to_string(&path).unwrap();
                found.insert(path.strip_prefix(&root).unwrap().to_path_buf(), text);
            }
        }
    }
    found
}

/// The lines of a page that are no code.
fn prose(text: &str) -> impl Iterator<Item = &str> {
    let mut code = false;
    text.lines().filter(move |line| {
        let fence = line.trim_start().starts_with("```");
        code ^= fence;
        !code && !fence
    })
}

/// The pieces of a line outside and inside of backticks, in turns.
fn pieces(line: &str) -> impl Iterator<Item = (bool, &str)> {
    line.split('`').enumerate().map(|(place, piece)| (place % 2 == 1, piece))
}

/// Where the links of a page lead to.
fn links(text: &str) -> Vec<String> {
    let mut links = Vec::new();
    for line in prose(text) {
        let plain: String = pieces(line).filter(|(code, _)| !code).map(|(_, piece)| piece).collect();
        let ends = plain.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
        links.extend(ends.map(|(link, _)| link.to_string()));
    }
    links
}

/// The anchor of a heading: its letters, digits, dashes and underscores in small letters, with dashes for blanks.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

fn anchors(text: &str) -> BTreeSet<String> {
    let headings = prose(text).filter(|line| line.starts_with('#'));
    headings.map(|line| anchor(line.trim_start_matches('#').trim())).collect()
}

/// A path without `.` and `..`; none that leads out of the repository.
fn normal(path: &Path) -> Option<PathBuf> {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => parts.push(part),
            Component::CurDir => {}
            _ => drop(parts.pop()?),
        }
    }
    Some(parts.iter().collect())
}

#[test]
fn every_link_leads_to_a_file_and_a_heading() {
    let pages = pages();
    assert!(pages.len() > 30);
    let mut broken = Vec::new();
    for (page, text) in &pages {
        for link in links(text) {
            if link.contains("://") || link.starts_with("mailto:") {
                continue;
            }
            let (file, heading) = link.split_once('#').unwrap_or((&link, ""));
            let target = if file.is_empty() { Some(page.clone()) } else { normal(&page.parent().unwrap().join(file)) };
            let found = target.is_some_and(|target| match pages.get(&target) {
                Some(text) => heading.is_empty() || anchors(text).contains(heading),
                None => heading.is_empty() && root().join(target).exists(),
            });
            if !found {
                broken.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// Links of the book lead to what is in the book, or beside it: the pages of the root, and what lies in docs.
#[test]
fn the_table_of_contents_lists_every_page_once() {
    let pages = pages();
    let listed = links(&pages[Path::new("docs/SUMMARY.md")]);
    let listed: Vec<PathBuf> = listed.iter().map(|link| normal(&Path::new("docs").join(link)).unwrap()).collect();
    let once: BTreeSet<&PathBuf> = listed.iter().collect();
    assert_eq!(once.len(), listed.len());
    let there = pages.keys().filter(|page| page.components().count() == 1 || page.starts_with("docs"));
    let there: BTreeSet<&PathBuf> = there.filter(|page| !page.ends_with("SUMMARY.md")).collect();
    assert_eq!(once, there);
    for page in &there {
        for link in links(&pages[*page]).iter().filter(|link| !link.contains("://") && !link.starts_with('#')) {
            let target = normal(&page.parent().unwrap().join(link.split('#').next().unwrap())).unwrap();
            let beside = target.components().count() == 1 || target.starts_with("docs");
            assert!(beside || target.ends_with("LiberationSans-LICENSE"), "{}: {link}", page.display());
        }
    }
}

/// What is made and not kept.
const MADE: [&str; 1] = ["python/dist"];

#[test]
fn every_path_that_a_page_names_is_there() {
    let root = root();
    let folders: BTreeSet<String> = std::fs::read_dir(&root)
        .unwrap()
        .map(|entry| entry.unwrap())
        .filter(|entry| entry.file_type().unwrap().is_dir())
        .map(|entry| entry.file_name().into_string().unwrap())
        .filter(|name| name != "target" && !name.starts_with('.'))
        .collect();
    let mut missing = Vec::new();
    for (page, text) in pages() {
        for (_, token) in prose(&text).flat_map(pieces).filter(|(code, _)| *code) {
            for word in token.split_whitespace() {
                let word = word.trim_end_matches([',', ':', ';', '/']);
                let named = word.split_once('/').is_some_and(|(folder, _)| folders.contains(folder));
                let pattern = word.contains(['*', '<', '{', '=']) || MADE.contains(&word);
                if named
                    && !pattern
                    && !root.join(word).exists()
                    && !root.join(page.parent().unwrap()).join(word).exists()
                {
                    missing.push(format!("{}: {word}", page.display()));
                }
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Whether a parameter, an input, an output or a field is called so.
fn is_name(name: &str) -> bool {
    // Variables that the FMU alone has.
    let of_fmu = ["model.time", "model.time_step"];
    Parameter::find(name).is_some()
        || INPUTS.iter().any(|input| input.name == name)
        || OUTPUTS.iter().any(|output| output.name == name)
        || FIELDS.iter().any(|field| field.name == name)
        || of_fmu.contains(&name)
}

/// Names in the table of symbols are those of parameters, outputs and fields; every law, every choice that has an equation and
/// every energy has its place.
#[test]
fn the_theory_names_what_there_is() {
    let theory = &pages()[Path::new("docs/theory.md")];
    let (_, table) = theory.split_once("## Symbols").unwrap();
    let (table, _) = table.split_once("## Sources").unwrap();
    let rows: Vec<&str> = table.lines().filter(|line| line.starts_with("| `")).collect();
    assert!(rows.len() > 25);
    for row in rows {
        let cells: Vec<&str> = row.split('|').collect();
        assert_eq!(cells.len(), 8, "{row}");
        for (_, name) in pieces(cells[4]).filter(|(code, _)| *code) {
            assert!(is_name(name) || is_name(&format!("layers[0].{name}")), "{name}");
        }
    }
    for law in ElasticLaw::ALL {
        assert!(theory.contains(&format!("\n| `{}` |", law.description().name)), "{law:?}");
    }
    for name in ["core.interface", "geometry.formulation"] {
        for label in Parameter::find(name).unwrap().labels() {
            assert!(theory.contains(&format!("\n| `{label}` |")), "{name}: {label}");
        }
    }
    for label in Parameter::find("layers[0].volumetric_law").unwrap().labels() {
        assert!(theory.contains(&format!("\n{label}: ")), "{label}");
    }
    for output in OUTPUTS.iter().filter(|output| output.name.starts_with("energy.")) {
        assert!(theory.contains(output.name.strip_prefix("energy.").unwrap()), "{}", output.name);
    }
}

/// What a page calls by a name of a group is there.
#[test]
fn the_names_on_the_pages_are_those_of_the_tables() {
    let groups: BTreeSet<String> = Parameter::all()
        .map(|parameter| parameter.name().group().to_string())
        .chain(OUTPUTS.iter().map(|output| output.name.split('.').next().unwrap().into()))
        .chain(FIELDS.iter().map(|field| field.name.split('.').next().unwrap().into()))
        .collect();
    let mut unknown = Vec::new();
    for (page, text) in pages().iter().filter(|(page, _)| !page.ends_with("CHANGELOG.md")) {
        for (_, token) in prose(text).flat_map(pieces).filter(|(code, _)| *code) {
            let name = token.split([' ', '=']).next().unwrap();
            let (group, field) = name.split_once('.').unwrap_or((name, ""));
            let group = group.split('[').next().unwrap();
            let is_file = ["rs", "py", "c", "sh", "toml", "md", "csv", "svg"].contains(&field);
            let plain = !field.is_empty() && field.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            if plain && !is_file && groups.contains(group) && !is_name(name) {
                unknown.push(format!("{}: {name}", page.display()));
            }
        }
    }
    assert!(unknown.is_empty(), "{unknown:#?}");
}

/// Commands of pages whose output nobody compares.
#[test]
fn the_commands_of_the_first_pages_run() {
    let pages = pages();
    for (name, least) in [("README.md", 4), ("docs/first-drop.md", 3), ("docs/scenarios.md", 5)] {
        let (folder, mut count) = (tempfile::tempdir().unwrap(), 0);
        for block in pages[Path::new(name)].split("\n```sh\n").skip(1) {
            let (block, _) = block.split_once("\n```").unwrap();
            for line in block.lines().filter_map(|line| line.strip_prefix("softanvil ")) {
                let line = line.split(" # ").next().unwrap().trim();
                let (arguments, file) = line.split_once(" > ").map_or((line, None), |(line, file)| (line, Some(file)));
                let printed = succeed(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
                if let Some(file) = file {
                    std::fs::write(folder.path().join(file), printed).unwrap();
                }
                count += 1;
            }
        }
        assert!(count >= least, "{name}: {count} commands");
    }
}

/// Numbers that stand in prose.
#[test]
fn the_numbers_of_the_pages_hold() {
    let pages = pages();
    let page = |name: &str| pages[Path::new(name)].split_whitespace().collect::<Vec<_>>().join(" ");
    let holds = |name: &str, statement: &str| assert!(page(name).contains(statement), "{name}: {statement}");
    let manifest = std::fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let of = |text: &str, key: &str| {
        let line = text.lines().find(|line| line.starts_with(key)).unwrap_or_else(|| panic!("{key}"));
        line.split('"').nth(1).unwrap().trim_start_matches(">=").to_string()
    };
    let rust = of(&manifest, "rust-version");
    for name in ["README.md", "docs/first-drop.md", "docs/python.md"] {
        holds(name, &format!("Rust toolchain ({rust} or newer)"));
    }
    let python = std::fs::read_to_string(root().join("python/pyproject.toml")).unwrap();
    holds("docs/first-drop.md", &format!("CPython {} or newer", of(&python, "requires-python")));
    let citation = std::fs::read_to_string(root().join("CITATION.cff")).unwrap();
    assert!(citation.contains(&format!("\nversion: {}\n", env!("CARGO_PKG_VERSION"))));
    holds("docs/first-drop.md", &format!("find_package(softanvil {}", &env!("CARGO_PKG_VERSION")[..3]));

    let grid = Grid::new(&preset::study()).unwrap();
    assert_eq!(grid.n_v, 5);
    holds("docs/verification-guide.md", "the default mesh of the study has five rows of cells");
    let (_, columns) = read_csv_with_comments(&root().join("data/foam/compression.csv"));
    assert_eq!(columns[0].iter().copied().fold(f64::INFINITY, f64::min), 0.4);
    holds("docs/pads.md", "pressed to a stretch of 0.4, that is, by 60 %");
}

fn read_csv_with_comments(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("table.csv");
    let rows: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    std::fs::write(&copy, rows.join("\n")).unwrap();
    read_csv(&copy)
}
