//! The main job: `softanvil` without a command, and `softanvil validate`.

use std::fs;

use crate::common::{column, entries, fail, json, succeed, svg_texts};
use serde_json::Value;
use softanvil_tools::paper::TABLE_1;
use softanvil_tools::quantity::QUANTITIES;

const FILES: [&str; 8] = [
    "force-deformation.svg",
    "force-time.svg",
    "scenario.toml",
    "summary.json",
    "table.txt",
    "trace-14.7J.csv",
    "trace-4.9J.csv",
    "trace-9.8J.csv",
];

#[test]
fn the_report_is_complete_and_its_parts_agree() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeed(folder.path(), &[]);
    assert!(text.contains("softanvil-report") && text.contains("LS-DYNA"), "{text}");
    assert_eq!(entries(folder.path()), ["softanvil-report"]);
    let report = folder.path().join("softanvil-report");
    assert_eq!(entries(&report), FILES);
    assert!(text.starts_with(&fs::read_to_string(report.join("table.txt")).unwrap()));
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");

    let summary: Value = serde_json::from_str(&fs::read_to_string(report.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["validation"], json(folder.path(), &["validate", "--json"]));
    for case in summary["validation"]["cases"].as_array().unwrap() {
        let force = column(&report.join(format!("trace-{}J.csv", case["energy"])), "contact.force [N]");
        assert_eq!(force.iter().copied().fold(0.0, f64::max), case["peak_force"].as_f64().unwrap());
    }
    for picture in ["force-time.svg", "force-deformation.svg"] {
        let texts = svg_texts(&report.join(picture));
        for wanted in ["contact force (N)", "Softanvil, 14.7 J", "Softanvil, 9.8 J", "Softanvil, 4.9 J"] {
            assert!(texts.iter().any(|text| text == wanted), "{wanted} in {texts:?}");
        }
        assert!(texts.iter().any(|text| text.starts_with("experiment")), "{texts:?}");
    }
}

#[test]
fn a_report_is_replaced_and_anything_else_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("out");
    fs::create_dir(&report).unwrap();
    succeed(folder.path(), &["--out", "out"]);
    let first = fs::read(report.join("summary.json")).unwrap();
    fs::write(report.join("table.txt"), "stale").unwrap();
    succeed(folder.path(), &["--out", "out"]);
    assert_eq!(fs::read(report.join("summary.json")).unwrap(), first);
    assert_ne!(fs::read_to_string(report.join("table.txt")).unwrap(), "stale");
    assert_eq!(entries(folder.path()), ["out"]);

    fs::write(report.join("notes.txt"), "mine").unwrap();
    let line = fail(folder.path(), &["--out", "out"], 2);
    assert!(line.contains("--out out") && line.contains("notes.txt"), "{line}");
    assert_eq!(entries(&report).len(), FILES.len() + 1);

    fs::write(folder.path().join("file"), "mine").unwrap();
    fail(folder.path(), &["--out", "file"], 2);
    assert_eq!(fs::read_to_string(folder.path().join("file")).unwrap(), "mine");
}

#[test]
fn a_folder_that_only_pretends_to_be_a_report_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("out");
    fs::create_dir_all(report.join("table.txt")).unwrap();
    fs::write(
        report.join("summary.json"),
        r#"{"generator": "softanvil report", "files": ["summary.json", "table.txt"]}"#,
    )
    .unwrap();
    // A folder where the report has a file.
    assert!(fail(folder.path(), &["--out", "out"], 2).contains("table.txt"));
    fs::remove_dir(report.join("table.txt")).unwrap();
    fs::write(report.join("summary.json"), r#"{"files": ["summary.json"]}"#).unwrap();
    assert!(fail(folder.path(), &["--out", "out"], 2).contains("summary.json"));
    assert_eq!(entries(&report), ["summary.json"]);
}

#[cfg(unix)]
#[test]
fn a_report_is_as_readable_as_any_other_folder() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("ordinary")).unwrap();
    succeed(folder.path(), &["--out", "out"]);
    let mode = |name: &str| fs::metadata(folder.path().join(name)).unwrap().permissions().mode();
    assert_eq!(mode("out"), mode("ordinary"));
}

#[test]
fn validate_recomputes_every_error_from_values() {
    let folder = tempfile::tempdir().unwrap();
    let result = json(folder.path(), &["validate", "--json"]);
    let cases = result["cases"].as_array().unwrap();
    assert_eq!(cases.len(), TABLE_1.len());
    let mut sum = 0.0;
    for (case, paper) in cases.iter().zip(&TABLE_1) {
        assert_eq!(case["energy"].as_f64().unwrap(), paper.energy);
        for (quantity, experiment) in QUANTITIES.iter().zip(paper.experiment) {
            let value = case[quantity.key].as_f64().unwrap();
            let error = 100.0 * (value / experiment - 1.0);
            assert!((case["error_percent"][quantity.key].as_f64().unwrap() - error).abs() < 1e-9);
            sum += error.abs();
        }
        let energy = paper.energy.to_string();
        let run = json(folder.path(), &["run", "--energy", &energy, "--json"]);
        assert_eq!(run["trace_hash"], case["trace_hash"]);
    }
    assert!((result["mean_error_percent"].as_f64().unwrap() - sum / 12.0).abs() < 1e-9);
}

#[test]
fn the_preset_is_as_near_to_the_experiment_as_the_study_s_own_model() {
    let folder = tempfile::tempdir().unwrap();
    let result = json(folder.path(), &["validate", "--json"]);
    assert!(
        result["mean_error_percent"].as_f64().unwrap() <= result["ls_dyna"]["mean_error_percent"].as_f64().unwrap()
    );
    for case in result["cases"].as_array().unwrap() {
        assert!(case["error_percent"]["peak_force"].as_f64().unwrap().abs() <= 5.0, "{case}");
    }
}
