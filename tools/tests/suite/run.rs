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
    let mut from_file = json(folder.path(), &["run", "--scenario", "study.toml", "--json"]);
    assert_eq!(from_file["drop"]["scenario_file"].take(), "study.toml");
    assert_eq!(from_file, json(folder.path(), &["run", "--json"]));
}

/// A layer on which the contact lasts longer than the preset's 15 ms.
const SOFT: [&str; 7] = ["run", "--set", "silicone.c10=2e3", "--set", "silicone.c01=0", "--set", "silicone.c20=1e3"];

#[test]
fn a_drop_is_simulated_until_the_contact_has_ended_unless_a_duration_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let run = |more: &[&str]| json(folder.path(), &[&SOFT[..], more, &["--json"]].concat());
    let whole = run(&[]);
    assert_eq!((&whole["complete"], &whole["ending"]), (&true.into(), &"complete".into()));
    assert!(whole["simulated_time"].as_f64().unwrap() > 15e-3 && whole["cut"].as_array().unwrap().is_empty());
    assert!(whole["restitution"].as_f64().unwrap() > 0.0);
    std::fs::write(folder.path().join("short.toml"), "[time]\nduration = 0.008\n").unwrap();
    for own in [&["--duration", "0.008"][..], &["--set", "time.duration=8e-3"], &["--scenario", "short.toml"]] {
        let cut = run(own);
        assert_eq!((&cut["complete"], &cut["ending"]), (&false.into(), &"in_contact".into()), "{own:?}");
        assert!((cut["simulated_time"].as_f64().unwrap() - 8e-3).abs() < 1e-9);
        let keys: Vec<&str> = cut["cut"].as_array().unwrap().iter().map(|key| key.as_str().unwrap()).collect();
        for key in ["peak_force", "impulse", "impact_duration", "restitution", "rebound_speed", "contact_time"] {
            assert!(keys.contains(&key), "{key} in {keys:?}");
        }
        assert!(cut["impulse"].as_f64().unwrap() < whole["impulse"].as_f64().unwrap());
    }
    // The preset itself is not extended.
    let preset = json(folder.path(), &["run", "--json"]);
    assert!((preset["simulated_time"].as_f64().unwrap() - 15e-3).abs() < 1e-9 && preset["complete"] == true);
}

#[test]
fn numbers_that_are_cut_are_marked_wherever_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    let cut = ["run", "--duration", "0.004", "--plot", "cut.svg"];
    let text = succeed(folder.path(), &cut);
    assert!(text.contains("! Cut off in contact after 4 ms, the duration asked for"), "{text}");
    let row = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap().to_string();
    for name in ["peak force", "impulse", "restitution", "rebound speed"] {
        assert!(row(name).contains('*'), "{text}");
    }
    assert!(!row("impact speed").contains('*'));
    let label = "Softanvil, 14.7 J, cut off in contact";
    assert!(svg_texts(&folder.path().join("cut.svg")).iter().any(|text| text == label));
    assert!(!succeed(folder.path(), &["run"]).contains('*'));
}

#[test]
fn what_never_touches_has_no_results() {
    let folder = tempfile::tempdir().unwrap();
    let press = ["--set", "impactor.motion=prescribed"];
    for (more, what) in [(&[][..], "impactor"), (&press[..], "press")] {
        let arguments = [&["run", "--duration", "0.0005"], more].concat();
        let text = succeed(folder.path(), &arguments);
        assert!(text.contains(&format!("! The {what} did not touch the layer in 0.5 ms")), "{text}");
        let result = json(folder.path(), &[&arguments[..], &["--json"]].concat());
        assert_eq!((&result["ending"], &result["complete"]), (&"no_contact".into(), &false.into()));
        assert!(result["peak_force"].is_null() && result["impulse"].is_null(), "{result}");
    }
    // Without a duration a press goes on until it has come to its depth.
    let held = json(folder.path(), &[&["run", "--json"], &press[..]].concat());
    assert_eq!((&held["ending"], &held["max_deformation"]), (&"held".into(), &5e-3.into()));
    assert!(held["cut"].as_array().unwrap().iter().any(|key| key == "impulse"));
}

/// What comes to rest on the layer never leaves it.
#[test]
fn the_wait_for_the_end_of_a_contact_is_bounded() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["run", "--energy", "0", "--set", "impactor.gap=0", "--set", "mesh.element_size=7.5e-3"];
    let text = succeed(folder.path(), &arguments);
    assert!(text.contains("! Cut off in contact after 300 ms, 20 times time.duration"), "{text}");
}

#[test]
fn the_first_lines_say_which_drop_was_simulated() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("mine.toml"), "[impactor]\nmass = 4\n").unwrap();
    for command in ["run", "measure"] {
        let arguments = [command, "--scenario", "mine.toml", "--set", "silicone.thickness=0.012", "--height", "0.1"];
        let text = succeed(folder.path(), &arguments);
        let lines: Vec<&str> = text.lines().take(3).collect();
        assert_eq!(lines[0], "Scenario: preset study, mine.toml, silicone.thickness=0.012.");
        assert_eq!(lines[1], "Drop: 4 kg with 3.924 J, at 1.401 m/s, as from a height of 0.100 m.");
        assert!(lines[2].starts_with("Anvil: a layer of 12 mm on a core of 75 mm diameter"), "{text}");
        let result = json(folder.path(), &[&arguments[..], &["--json"]].concat());
        let drop = &result["drop"];
        assert_eq!((&drop["preset"], &drop["scenario_file"]), (&"study".into(), &"mine.toml".into()));
        assert_eq!(drop["set"], serde_json::json!(["silicone.thickness=0.012"]));
        assert_eq!((&drop["impactor"]["mass"], &drop["impactor"]["height"]), (&4.0.into(), &0.1.into()));
        assert!((drop["layer_thickness"].as_f64().unwrap() - 0.012).abs() < 1e-12);
    }
}

#[test]
fn a_parameter_is_set_over_the_files() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("mine.toml"),
        "[[layers]]\nc10 = 2e5\nthickness = 0.014\n[[layers]]\nname = \"skin\"\nthickness = 1e-3\n",
    )
    .unwrap();
    let mut from_file = json(folder.path(), &["run", "--scenario", "mine.toml", "--json"]);
    let given = ["silicone.c10=2e5", "layers.count=2", "layers[1].thickness=1e-3", "silicone.thickness=0.014"];
    let arguments = given.iter().flat_map(|text| ["--set", text]).chain(["--json"]);
    let mut set = json(folder.path(), &["run"].into_iter().chain(arguments).collect::<Vec<_>>());
    for result in [&mut from_file, &mut set] {
        result["drop"].take();
    }
    assert_eq!(from_file, set);
    for (text, message) in [
        ("silicone.c10", "--set silicone.c10: silicone.c10 is refused: expected group.field=value"),
        ("silicone.c1=1", "silicone.c1 is unknown (did you mean silicone.c11?)"),
        ("silicone.prony_tau_2=1", "layers[0].prony_tau_2 = 1 s has no effect: layers[0].prony_g_2 is 0"),
        ("layers.count=2", "layers[1].thickness = 0 m is refused: expected at least 0.00001 m"),
        (
            "geometry.layers=two",
            "geometry.layers is refused: expected layers.count = 2 or, in a file, a table [[layers]]",
        ),
        ("skin.c10=1e5", "skin.c10 is refused: no layer is called skin: expected layers[1].c10 or, in a file, a table"),
        ("layers[1].c10=1e5", "layers[1].c10 = 100000 Pa has no effect: layers.count is 1"),
        ("impactor.mass=0", "impactor.mass = 0 kg is refused: expected 0.001 to 10000 kg"),
        ("impactor.face_diameter=0.005", "impactor.face_diameter = 0.005 m is refused: expected at least 0.006 m"),
    ] {
        let line = fail(folder.path(), &["run", "--set", text], 2);
        assert!(line.contains(message), "{line}");
    }
}

/// One to four layers by a scenario file; the JSON tells them, and a file that `scenario` would write runs the same.
#[test]
fn any_number_of_layers_runs_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    for count in 1..=4 {
        let layer = |place: usize| format!("[[layers]]\nname = \"l{place}\"\nthickness = {}e-3\n", 5 - place);
        let text: String = (0..count).map(layer).collect();
        std::fs::write(folder.path().join("stack.toml"), format!("{text}[mesh]\nelement_size = 4e-3\n")).unwrap();
        let result = json(folder.path(), &["run", "--scenario", "stack.toml", "--preset", "elastic", "--json"]);
        let layers = result["drop"]["layers"].as_array().unwrap();
        let names: Vec<_> = layers.iter().map(|layer| layer["name"].as_str().unwrap()).collect();
        assert_eq!(names, ["l0", "l1", "l2", "l3"][..count]);
        assert_eq!(layers[count - 1]["thickness"], (5 - (count - 1)) as f64 * 1e-3);
    }
    let told = succeed(folder.path(), &["run", "--scenario", "stack.toml", "--preset", "elastic"]);
    assert!(told.contains("Anvil: 5 mm of l0, 4 mm of l1, 3 mm of l2, 2 mm of l3, from the core"), "{told}");
    assert!(told.contains("\nl3: neo-Hookean"), "{told}");
}

#[test]
fn a_mesh_too_coarse_for_the_layer_is_warned_of() {
    let folder = tempfile::tempdir().unwrap();
    let coarse = ["run", "--set", "mesh.element_size=0.05"];
    let text = succeed(folder.path(), &coarse);
    assert!(text.contains("! Warning: the mesh is too coarse") && text.contains("1 row of cells"), "{text}");
    let result = json(folder.path(), &[&coarse[..], &["--json"]].concat());
    assert!(result["warnings"][0].as_str().unwrap().contains("mesh.element_size = 50 mm"), "{result}");
    assert_eq!(json(folder.path(), &["run", "--json"])["warnings"], serde_json::json!([]));
}

/// What reads a pipe gets 80 characters a line, whole words and no lines but of ASCII.
#[test]
fn tables_fit_a_pipe() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("curve.csv"), "stretch,stress [Pa]\n1,0\n0.9,-20000\n0.8,-46000\n0.7,-82000\n")
        .unwrap();
    for arguments in [
        &["run"][..],
        &["run", "--duration", "0.004", "--set", "mesh.element_size=0.05"],
        &["measure", "--energy", "4.9"],
        &["validate"],
        &["sweep", "silicone.poissons_ratio=0.45"],
        &["sweep", "--convergence=0.6,0.8"],
        &["fit", "--uniaxial", "curve.csv", "--law", "mooney_rivlin_2"],
    ] {
        let text = succeed(folder.path(), arguments);
        let table = text.lines().filter(|line| !line.contains("curve.csv"));
        for line in table {
            assert!(line.chars().count() <= 80 && line.is_ascii(), "{arguments:?}: {line}");
        }
    }
    let sweep = succeed(folder.path(), &["sweep", "silicone.thickness=0.01"]);
    assert!(sweep.contains("silicone.thickness") && sweep.contains("restitution"), "{sweep}");
}

#[test]
fn files_that_are_there_are_replaced_only_when_told_to() {
    let folder = tempfile::tempdir().unwrap();
    let mine = |name: &str| std::fs::write(folder.path().join(name), "mine").unwrap();
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    for command in ["run", "measure"] {
        for (option, name) in [("--csv", "trace.csv"), ("--plot", "force.svg")] {
            mine(name);
            let line = fail(folder.path(), &[command, option, name], 2);
            assert_eq!(line, format!("{option} {name} is refused: the file is there; --overwrite replaces it"));
            assert_eq!(read(name), "mine");
            succeed(folder.path(), &[command, option, name, "--overwrite"]);
            assert_ne!(read(name), "mine");
        }
    }
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
    for arguments in
        [&["--help"][..], &["run", "--help"], &["validate", "--help"], &["report", "--help"], &["--version"]]
    {
        assert!(!succeed(folder.path(), arguments).is_empty());
    }
}

#[test]
fn the_long_version_states_kernel_digest_and_target() {
    let folder = tempfile::tempdir().unwrap();
    let version = concat!("softanvil ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(succeed(folder.path(), &["-V"]), version);
    let long = succeed(folder.path(), &["--version"]);
    assert!(long.starts_with(version), "{long}");
    assert!(long.contains(&format!("\nkernel digest {:016x} ", softanvil_kernel::KERNEL_DIGEST)), "{long}");
    assert!(long.contains(&format!("\ntarget {}-{}", std::env::consts::ARCH, std::env::consts::OS)), "{long}");
}

/// What a disk that is full does not take is an error; a reader that has gone away is none.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_is_exit_code_1() {
    use std::process::{Command, Stdio};

    let written_to = |stdout: Stdio| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_softanvil"));
        child.arg("scenario").stdout(stdout).stderr(Stdio::piped()).spawn().unwrap()
    };
    let full = std::fs::File::create("/dev/full").unwrap();
    let output = written_to(full.into()).wait_with_output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    assert!(stderr.starts_with("error: standard output cannot be written: "), "{stderr}");
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    let mut child = written_to(Stdio::piped());
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
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
