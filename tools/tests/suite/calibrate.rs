//! `softanvil calibrate`, as a user calls it.

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::{fail, succeed};

/// A small search: two parameters, on a coarse mesh.
const PROBLEM: &str = r#"
[search]
evaluations = 24
population = 6

[fixed]
"mesh.element_size" = 7.5e-3
"time.duration" = 0.01

[parameters]
"silicone.c10" = { min = 2e4, max = 4e5, scale = "log", start = 3e5 }
"geometry.length" = { min = 0.06, max = 0.15 }

[[impact]]
energy = 14.7
table_1 = true
"#;

fn search(folder: &Path, out: &str, evaluations: &str, seed: &str) -> String {
    let options = ["calibrate", "problem.toml", "--out", out, "--evaluations", evaluations, "--seed", seed];
    succeed(folder, &options);
    fs::read_to_string(folder.join(out).join("evaluations.csv")).unwrap()
}

#[test]
fn a_search_that_was_cut_off_continues_as_if_nothing_had_happened() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let whole = search(folder, "whole", "24", "3");
    assert_eq!(whole.lines().count(), 25);

    let part = search(folder, "cut", "12", "3");
    assert!(whole.starts_with(&part) && part.len() < whole.len());
    // As a crash in the middle of a line would leave it.
    let log: PathBuf = folder.join("cut").join("evaluations.csv");
    fs::write(&log, &part[..part.len() - 20]).unwrap();
    assert_eq!(search(folder, "cut", "24", "3"), whole);

    // A scenario for the other commands.
    succeed(folder, &["run", "--scenario", "whole/best.toml", "--json"]);
    // Another search does not take this log for its own.
    let refused = fail(folder, &["calibrate", "problem.toml", "--out", "whole", "--seed", "4"], 2);
    assert!(refused.contains("another folder by --out"), "{refused}");
}

#[test]
fn the_best_values_score_better_than_the_start() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let log = search(folder, "out", "24", "1");
    let scores: Vec<f64> = log.lines().skip(1).map(|line| line.split(',').nth(2).unwrap().parse().unwrap()).collect();
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.join("out/summary.json")).unwrap()).unwrap();
    let best = summary["score"].as_f64().unwrap();
    assert!(scores.iter().all(|score| *score >= best) && best < scores[0], "{best} of {scores:?}");
}

#[test]
fn the_protocols_of_the_repository_are_legal() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../calibration");
    let mut count = 0;
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        // Beside them stand the scripts that run them.
        if path.extension().is_some_and(|extension| extension == "toml") {
            softanvil_tools::calibration::problem::Problem::read(&path).unwrap();
            count += 1;
        }
    }
    assert_eq!(count, 7);
}

/// The page is of the presets as they are: `calibration/run.sh` writes it anew.
#[test]
fn the_page_of_the_protocols_has_the_errors_of_the_presets() {
    let folder = tempfile::tempdir().unwrap();
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/protocols.md");
    let page = fs::read_to_string(page).unwrap();
    for preset in ["study", "study-14.7", "study-incompressible"] {
        let found = crate::common::json(folder.path(), &["validate", "--preset", preset, "--json"]);
        let mean = found["mean_error_percent"].as_f64().unwrap();
        let row = page.lines().find(|line| line.starts_with(&format!("| preset `{preset}`"))).unwrap();
        assert_eq!(row.split('|').nth(2).unwrap().trim(), format!("{mean:.1}"), "{row}");
    }
}
