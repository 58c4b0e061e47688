//! `softanvil run` and `softanvil scenario`, as a user calls them.

use crate::common::{column, entries, fail, json, read_csv, softanvil, succeed, svg_texts};
use softanvil_kernel::{OUTPUTS, SAMPLING_INTERVAL, preset};

#[test]
fn json_has_every_key_with_a_plausible_value_in_si() {
    let folder = tempfile::tempdir().unwrap();
    let result = json(folder.path(), &["run", "--energy", "14.7", "--json"]);
    let number = |key: &str| result[key].as_f64().unwrap_or_else(|| panic!("{key} in {result}"));
    // Wide bands around the study's experiment: the units are right, whatever the calibration.
    for (key, low, high) in [
        ("peak_force", 4000.0, 7000.0),
        ("max_deformation", 3e-3, 8e-3),
        ("impact_duration", 3e-3, 15e-3),
        ("impulse", 10.0, 22.0),
        ("rebound_speed", 0.0, 2.42),
        ("energy_residual", -14.7e-3, 14.7e-3),
        ("dt", 1e-8, 50e-6),
    ] {
        assert!((low..=high).contains(&number(key)), "{key} = {}", number(key));
    }
    assert!(result["elements"].as_u64().unwrap() > 0);
    let samples = result["steps"].as_u64().unwrap() as f64 * number("dt") / SAMPLING_INTERVAL;
    assert!((samples - (preset::study().time.duration / SAMPLING_INTERVAL).round()).abs() < 1e-6);
    let hash = result["trace_hash"].as_str().unwrap();
    assert!(hash.len() == 16 && hash.chars().all(|c| c.is_ascii_digit() || ('a'..='f').contains(&c)), "{hash}");
}

#[test]
fn energy_height_and_speed_are_three_ways_to_say_the_same_drop() {
    let folder = tempfile::tempdir().unwrap();
    let hash = |option: &str, value: f64| {
        let result = json(folder.path(), &["run", option, &value.to_string(), "--duration", "0.004", "--json"]);
        assert!(result["peak_force"].as_f64().unwrap() > 0.0);
        result["trace_hash"].clone()
    };
    let impactor = preset::study().impactor;
    let speed = impactor.with_energy(14.7).start_speed();
    let by_speed = hash("--speed", speed);
    assert_eq!(hash("--energy", 14.7), by_speed);
    assert_ne!(hash("--energy", 14.8), by_speed);
    // sqrt(2 g h) need not hit the very bits of sqrt(2 E / m), so the height is checked against its own speed.
    let mut by_height = impactor;
    by_height.drop_by = softanvil_kernel::scenario::DropBy::Height;
    by_height.drop_height = 0.25;
    assert_eq!(hash("--height", 0.25), hash("--speed", by_height.start_speed()));
}

#[test]
fn the_trace_integrates_to_the_impulse_and_peaks_at_the_peak() {
    let folder = tempfile::tempdir().unwrap();
    let result = json(folder.path(), &["run", "--energy", "9.8", "--csv", "trace.csv", "--json"]);
    let path = folder.path().join("trace.csv");
    let force = column(&path, "contact.force [N]");
    let impulse: f64 = force.iter().map(|force| force * SAMPLING_INTERVAL).sum();
    let expected = result["impulse"].as_f64().unwrap();
    assert!((impulse - expected).abs() < 1e-9 * expected, "{impulse} {expected}");
    assert_eq!(force.iter().copied().fold(0.0, f64::max), result["peak_force"].as_f64().unwrap());
    let time = column(&path, "time [s]");
    for (number, time) in time.iter().enumerate() {
        assert!((time - number as f64 * SAMPLING_INTERVAL).abs() < 1e-12);
    }
    assert_eq!(entries(folder.path()), ["trace.csv"]);
}

#[test]
fn the_trace_names_outputs_of_the_kernel_with_their_units() {
    let folder = tempfile::tempdir().unwrap();
    succeed(folder.path(), &["run", "--duration", "0.0005", "--csv", "trace.csv"]);
    let (header, columns) = read_csv(&folder.path().join("trace.csv"));
    assert_eq!(header[0], "time [s]");
    for title in &header[1..] {
        assert!(OUTPUTS.iter().any(|output| *title == format!("{} [{}]", output.name, output.unit)), "{title}");
    }
    // The start and ten samples.
    assert!(columns.iter().all(|column| column.len() == 11));
}

#[test]
fn the_picture_has_axes_with_units_and_a_legend() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeed(folder.path(), &["run", "--energy", "4.9", "--plot", "drop.svg"]);
    assert!(text.contains("drop.svg") && text.contains("peak force"), "{text}");
    let texts = svg_texts(&folder.path().join("drop.svg"));
    for wanted in ["time since contact (ms)", "deformation (mm)", "contact force (N)", "Softanvil, 4.9 J"] {
        assert!(texts.iter().any(|text| text == wanted), "{wanted} in {texts:?}");
    }
    assert_eq!(entries(folder.path()), ["drop.svg"]);
}

#[test]
fn the_printed_scenario_gives_the_same_bits_as_the_preset() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeed(folder.path(), &["scenario", "--preset", "study"]);
    std::fs::write(folder.path().join("study.toml"), text).unwrap();
    let from_file = json(folder.path(), &["run", "--scenario", "study.toml", "--json"]);
    assert_eq!(from_file, json(folder.path(), &["run", "--json"]));
}

#[test]
fn a_scenario_file_and_an_option_together_change_the_run() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("heavy.toml"), "[impactor]\nmass = 10\n").unwrap();
    let impulse = |arguments: &[&str]| json(folder.path(), arguments)["impulse"].as_f64().unwrap();
    let light = impulse(&["run", "--speed", "1", "--json"]);
    let heavy = impulse(&["run", "--speed", "1", "--scenario", "heavy.toml", "--json"]);
    assert!(heavy > 1.2 * light, "{heavy} {light}");
}

#[test]
fn help_and_version_are_no_errors() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["--help"][..], &["run", "--help"], &["validate", "--help"], &["--version"]] {
        assert!(!succeed(folder.path(), arguments).is_empty());
    }
}

#[test]
fn a_step_that_fails_is_exit_code_1_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    // The step of the study's own drop, at forty times its energy.
    let given = tempfile::tempdir().unwrap();
    let path = given.path().join("given.toml");
    std::fs::write(&path, "[time]\nstep_by = \"given\"\nstep = 5e-6\n").unwrap();
    let scenario = path.to_str().unwrap();
    let arguments = ["run", "--scenario", scenario, "--energy", "600", "--csv", "trace.csv"];
    let output = softanvil(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(1));
    let line = fail(folder.path(), &arguments, 1);
    assert!(line.starts_with("the simulation failed: ") && line.contains(" s"), "{line}");
    assert!(entries(folder.path()).is_empty());
}
