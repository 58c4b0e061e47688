//! `softanvil measure`: instruments, and a measured trace beside the simulated one.

use std::path::Path;

use serde_json::Value;

use crate::common::{column, fail, json, succeed, svg_texts};

/// Writes `measured.csv`: the force of a run, a quarter of a second later, times `gain`.
fn measured_trace(folder: &Path, gain: f64) {
    succeed(folder, &["run", "--csv", "trace.csv"]);
    let path = folder.join("trace.csv");
    // A sample is the mean over its interval: its time is the middle of it.
    let rows = column(&path, "time [s]")
        .into_iter()
        .zip(column(&path, "contact.force [N]"))
        .map(|(time, force)| format!("{},{}\n", time - 25e-6 + 0.25, gain * force));
    let text = "time [s],force [N]\n".to_string() + &rows.collect::<String>();
    std::fs::write(folder.join("measured.csv"), text).unwrap();
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} in {value}"))
}

#[test]
fn a_trace_of_ours_at_another_time_is_scored_as_the_same() {
    let folder = tempfile::tempdir().unwrap();
    measured_trace(folder.path(), 1.0);
    let result = json(folder.path(), &["measure", "--trace", "measured.csv", "--cfc", "600", "--json"]);
    assert!(number(&result, "/comparison/r_squared") > 1.0 - 1e-9, "{result}");
    assert!(number(&result, "/comparison/cora/rating") > 1.0 - 1e-9, "{result}");
    for key in ["peak_force", "impact_duration", "impulse"] {
        assert!(number(&result, &format!("/comparison/numbers/{key}/error_percent")).abs() < 1e-6, "{key}");
    }
}

#[test]
fn a_gain_is_found_in_peak_and_impulse() {
    let folder = tempfile::tempdir().unwrap();
    measured_trace(folder.path(), 0.8);
    let arguments =
        ["measure", "--trace", "measured.csv", "--threshold", "1%", "--csv", "read.csv", "--plot", "read.svg"];
    let text = succeed(folder.path(), &arguments);
    assert!(text.contains("+25.0 %") && text.contains("size 0.640"), "{text}");
    let (ours, measured) = (
        column(&folder.path().join("read.csv"), "force [N]"),
        column(&folder.path().join("read.csv"), "measured force [N]"),
    );
    // With a part of the peak as the threshold both are aligned exactly.
    for (ours, measured) in ours.iter().zip(&measured) {
        assert!((0.8 * ours - measured).abs() < 1e-6, "{ours} {measured}");
    }
    assert!(svg_texts(&folder.path().join("read.svg")).iter().any(|text| text == "measured"));
}

/// Largest correlation lays the middle of a slow impact on that of a quick one, so that the slow one begins before.
#[test]
fn a_picture_shows_the_rise_of_both_forces() {
    let folder = tempfile::tempdir().unwrap();
    let force = |time: f64| if time < 16e-3 { 2500.0 * (std::f64::consts::PI * time / 16e-3).sin() } else { 0.0 };
    let rows: String = (0..500).map(|i| f64::from(i) * 5e-5).map(|t| format!("{t},{}\n", force(t))).collect();
    std::fs::write(folder.path().join("slow.csv"), format!("time [s],force [N]\n{rows}")).unwrap();
    succeed(folder.path(), &["measure", "--trace", "slow.csv", "--plot", "slow.svg"]);
    let svg = std::fs::read_to_string(folder.path().join("slow.svg")).unwrap();
    // Downwards, in the units of the drawing, of all dashes of a line; the legend stands behind its ground.
    let drawn = svg.split("opacity=\"0.85\"").next().unwrap();
    let heights = |line: &str| -> Vec<f64> {
        let points = line.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or_default();
        points.split_whitespace().filter_map(|point| point.split(',').nth(1)?.parse().ok()).collect()
    };
    for colour in ["#0072B2", "#D55E00"] {
        let dashes = drawn.split("<polyline").skip(1).filter(|line| line.contains(&format!("stroke=\"{colour}\"")));
        let curve: Vec<f64> = dashes.flat_map(heights).collect();
        assert!(curve.len() > 20, "{colour}: {curve:?}");
        let (top, bottom) = curve.iter().fold((f64::MAX, f64::MIN), |(t, b), y| (t.min(*y), b.max(*y)));
        assert!(curve[0] > bottom - 0.1 * (bottom - top), "begins at {} of {top} to {bottom}", curve[0]);
    }
}

#[test]
fn instruments_change_what_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let read = |options: &[&str]| json(folder.path(), &[&["measure", "--json"], options].concat());
    let plain = number(&read(&[]), "/peak_force");
    assert!(number(&read(&["--cfc", "60"]), "/peak_force") < 0.9 * plain);
    assert!(number(&read(&["--force", "core"]), "/peak_force") > plain);
    let noisy = ["--noise", "5", "--calibration-error", "1", "--seed", "4"];
    assert_eq!(read(&noisy), read(&noisy));
    assert!((number(&read(&noisy), "/peak_force") - plain).abs() > 0.1);
    let (long, short) = (read(&["--threshold", "1"]), read(&["--threshold", "10%"]));
    assert!(number(&long, "/impact_duration") > number(&short, "/impact_duration"));
}

#[test]
fn the_study_can_be_validated_as_the_load_cells_see_it() {
    let folder = tempfile::tempdir().unwrap();
    let [contact, core] =
        ["contact", "core"].map(|force| json(folder.path(), &["validate", "--force", force, "--json"]));
    for case in 0..3 {
        let peak = format!("/cases/{case}/peak_force");
        assert!(number(&core, &peak) > number(&contact, &peak));
    }
    assert_eq!(core["reading"], "core reaction (load cells), unfiltered");
}

#[test]
fn refused_readings_say_what_is_legal() {
    let folder = tempfile::tempdir().unwrap();
    for (options, message) in [
        (&["--cfc", "5000"][..], "5000 Hz is refused: expected 0 to 2000 Hz"),
        (&["--threshold", "-3"], "expected a force of 0 N or more"),
        (&["--noise", "-3"], "--noise = -3 N is refused: expected 0 N or more"),
        (&["--calibration-error", "nan"], "--calibration-error = NaN % is refused"),
        (&["--trace", "none.csv"], "none.csv cannot be read"),
        (&["--plot", "a.jpg"], "expected a file name that ends in .svg or .png"),
    ] {
        let error = fail(folder.path(), &[&["measure"], options].concat(), 2);
        assert!(error.contains(message), "{error}");
    }
    std::fs::write(folder.path().join("flat.csv"), "time [s],force [N]\n0,1\n0.01,1\n").unwrap();
    let error = fail(folder.path(), &["measure", "--trace", "flat.csv"], 2);
    assert!(error.contains("flat.csv: nothing hits"), "{error}");
}

#[test]
fn the_picture_names_the_force_that_is_read() {
    let folder = tempfile::tempdir().unwrap();
    for (force, axis) in [("contact", "contact force (N)"), ("core", "core reaction (N)")] {
        let name = format!("{force}.svg");
        succeed(folder.path(), &["measure", "--force", force, "--energy", "4.9", "--plot", &name]);
        let texts = svg_texts(&folder.path().join(&name));
        assert!(texts.iter().any(|text| text == axis), "{axis} in {texts:?}");
        assert_eq!(texts.iter().filter(|text| text.ends_with("(N)")).count(), 1, "{texts:?}");
        assert!(texts.iter().any(|text| text.starts_with("Softanvil, 4.9 J")), "{texts:?}");
    }
}

#[test]
fn a_measurement_that_ends_in_contact_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeed(folder.path(), &["measure", "--duration", "0.004"]);
    let row = text.lines().find(|line| line.starts_with("contact force, CFC 600")).unwrap();
    assert!(text.contains("! Cut off in contact") && row.matches('*').count() == 4, "{text}");
    let result = json(folder.path(), &["measure", "--duration", "0.004", "--json"]);
    assert_eq!((&result["complete"], &result["ending"]), (&false.into(), &"in_contact".into()));
}
