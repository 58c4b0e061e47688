//! `softanvil run --vtu`: the series for ParaView. What is in its files, readers that others wrote check in tests/report.

use std::fs;

use crate::common::{entries, fail, json, succeed};

const SHORT: [&str; 4] = ["run", "--duration", "0.001", "--vtu"];

fn run<'a>(more: &[&'a str]) -> Vec<&'a str> {
    SHORT.into_iter().chain(more.iter().copied()).collect()
}

#[test]
fn a_series_has_a_frame_at_every_interval() {
    let folder = tempfile::tempdir().unwrap();
    for (interval, frames) in [("250e-6", 5), ("0.0005", 3), ("50e-6", 21)] {
        let text = succeed(folder.path(), &run(&["series", "--vtu-interval", interval]));
        assert!(text.contains(&format!("impact.pvd, {frames} frames")), "{text}");
        let mut files: Vec<_> = ["impactor", "section"]
            .iter()
            .flat_map(|part| (0..frames).map(move |number| format!("{part}-{number:05}.vtu")))
            .collect();
        files.push("impact.pvd".into());
        files.sort();
        // The series before it is replaced, whole.
        assert_eq!(entries(&folder.path().join("series")), files);
    }
    assert_eq!(entries(folder.path()), ["series"]);
}

#[test]
fn watching_a_run_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let watched = json(folder.path(), &run(&["series", "--json"]));
    assert_eq!(watched, json(folder.path(), &["run", "--duration", "0.001", "--json"]));
}

#[test]
fn a_folder_that_is_no_series_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("mine");
    fs::create_dir(&mine).unwrap();
    fs::write(mine.join("section-00000.vtu"), "mine").unwrap();
    let line = fail(folder.path(), &run(&["mine"]), 2);
    assert!(line.contains("--vtu mine") && line.contains("section-00000.vtu"), "{line}");
    // A collection of another program.
    fs::write(mine.join("impact.pvd"), r#"<VTKFile><DataSet file="section-00000.vtu"/></VTKFile>"#).unwrap();
    fail(folder.path(), &run(&["mine"]), 2);
    assert_eq!(fs::read_to_string(mine.join("section-00000.vtu")).unwrap(), "mine");
    assert!(fail(folder.path(), &run(&["none/series"]), 2).contains("there is no folder"));
}

#[test]
fn an_interval_that_no_sample_meets_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for interval in ["0", "-0.001", "60e-6", "1e-9", "2", "nan", "often"] {
        let line = fail(folder.path(), &run(&["series", "--vtu-interval", interval]), 2);
        assert!(line.contains(interval) && line.contains("0.00005 s"), "{line}");
    }
    assert!(entries(folder.path()).is_empty());
}
