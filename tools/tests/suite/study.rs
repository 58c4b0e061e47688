//! `softanvil study`, and the pages of the documentation that it makes.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use serde_json::Value;

use crate::common::{entries, fail, json, read_table, succeed};
use softanvil_tools::measurement::quantity::{COUNT, QUANTITIES};
use softanvil_tools::studies::STUDIES;

/// The folder that `study all` fills; once for all tests.
fn all() -> &'static Path {
    static FOLDER: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, pages) = FOLDER.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        succeed(folder.path(), &["study", "all", "--out", "pages"]);
        let pages = folder.path().join("pages");
        (folder, pages)
    });
    pages
}

/// A simulation of a study: its settings and its four numbers.
struct Row {
    settings: Vec<String>,
    values: Option<[f64; COUNT]>,
    held_force: Option<f64>,
    elements: f64,
}

fn rows(study: &str) -> Vec<Row> {
    let (header, lines) = read_table(&all().join(format!("{study}.csv")));
    let column = |name: &str| header.iter().position(|title| title.starts_with(name)).unwrap();
    let first = column("peak_force");
    let number = |line: &[String], name: &str| line[column(name)].parse::<f64>().ok();
    let row = |line: &Vec<String>| {
        let values: Vec<f64> = QUANTITIES.iter().filter_map(|quantity| number(line, quantity.key)).collect();
        Row {
            settings: line[1..first].to_vec(),
            values: values.try_into().ok(),
            held_force: number(line, "held_force"),
            elements: number(line, "elements").unwrap_or_default(),
        }
    };
    lines.iter().map(row).collect()
}

/// The force of the simulation with these settings.
fn force(rows: &[Row], settings: &[&str]) -> f64 {
    let row = rows.iter().find(|row| row.settings == settings).unwrap_or_else(|| panic!("{settings:?}"));
    row.held_force.unwrap_or_else(|| row.values.unwrap()[0])
}

#[test]
fn the_pages_of_the_documentation_are_what_the_command_writes() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/studies");
    assert_eq!(entries(&docs), entries(all()));
    // The coefficients of fitted laws take the system's powers and logarithms, whose last bits may differ.
    for name in entries(all()).iter().filter(|name| *name != "law.csv") {
        let [made, kept] = [all(), docs.as_path()].map(|folder| fs::read_to_string(folder.join(name)).unwrap());
        assert!(made == kept, "docs/studies/{name}: softanvil study all --out docs/studies makes it anew");
    }
}

#[test]
fn every_study_has_its_page_table_and_picture() {
    let names: Vec<_> = STUDIES.iter().flat_map(|s| ["csv", "md", "svg"].map(|e| format!("{}.{e}", s.name))).collect();
    let found = entries(all());
    assert!(names.iter().all(|name| found.contains(name)), "{found:?}");
    for study in STUDIES {
        assert!(crate::common::svg_texts(&all().join(format!("{}.svg", study.name))).len() > 5);
        assert!(rows(study.name).iter().filter(|row| row.values.is_some()).count() >= 5, "{}", study.name);
    }
}

/// Peaks hardly depend on the default mesh, and the finest is the nearest to the limit.
#[test]
fn the_default_mesh_is_within_a_few_percent() {
    let rows = rows("mesh");
    let values: Vec<[f64; COUNT]> = rows.iter().map(|row| row.values.unwrap()).collect();
    assert!(rows.windows(2).all(|pair| pair[0].elements < pair[1].elements));
    let (finest, own) = (values[values.len() - 1], values[rows.iter().position(|row| row.settings[0] == "5").unwrap()]);
    for (a, b) in own.iter().zip(finest) {
        assert!((a / b - 1.0).abs() < 0.03, "{own:?} {finest:?}");
    }
    let page = fs::read_to_string(all().join("mesh.md")).unwrap();
    assert!(page.contains("refinement by 2"), "{page}");
    // The peak rises and falls on the way to the finest meshes, the deformation settles.
    for (quantity, verdict) in
        [("| peak force (N) ", "none: not monotone"), ("| max deformation (mm) ", "(not asymptotic)")]
    {
        let line = page.lines().find(|line| line.starts_with(quantity)).unwrap_or_default();
        assert!(line.contains(verdict), "{line}");
    }
}

/// Source: mechanics. An elastic layer that keeps its volume must flow sideways, which friction hinders, and the more the
/// less else holds it; a layer that may change its volume, or is stiff in shear while the impact lasts, flows less.
#[test]
fn friction_matters_to_what_flows_and_is_hidden_by_damping() {
    let rows = rows("friction");
    let effect = |settings: [&str; 4]| {
        let at = |friction: &str| force(&rows, &[&settings[..], &[friction]].concat());
        at("0.6") / at("0.2") - 1.0
    };
    let press = effect(["press", "bonded", "off", "0.48"]);
    assert!(press > 0.03, "{press}");
    assert!(effect(["press", "contact", "off", "0.48"]) > press);
    let damped = effect(["impact", "bonded", "on", "0.48"]).abs();
    assert!(damped < 0.5 * press, "{damped}");
    // The preset's core is in contact, where damping hides less.
    let drop = effect(["impact", "as it is", "on", "as it is"]);
    assert!(drop > damped, "{drop}");
}

/// Source: mechanics. A layer that is bonded and wide resists by its bulk modulus, until that is out of reach.
#[test]
fn poissons_ratio_stiffens_a_bonded_layer_but_not_an_incompressible_one() {
    let rows = rows("poisson");
    let peaks = |variant: &str| -> Vec<f64> {
        rows.iter().filter(|row| row.settings[0] == variant).map(|row| row.values.unwrap()[0]).collect()
    };
    let bonded = peaks("core bonded");
    assert!(bonded.len() >= 6 && bonded[bonded.len() - 1] > 1.1 * bonded[0], "{bonded:?}");
    let stiff = peaks("the same, core bonded");
    // From 0.48 to 0.49 the bulk modulus doubles.
    let [soft_rise, stiff_rise] = [&bonded, &stiff].map(|peaks| peaks[peaks.len() - 1] / peaks[peaks.len() - 2] - 1.0);
    assert!(stiff_rise.abs() < 0.5 * soft_rise, "{stiff:?} {bonded:?}");
}

/// Source: the paper's finding that a higher damping modulus gives a higher peak, where the slider does not slip.
#[test]
fn a_higher_damping_modulus_raises_the_peak_of_a_spring_that_does_not_slip() {
    let rows = rows("damping");
    let unlimited: Vec<f64> =
        rows.iter().filter(|row| row.settings[0] == "none").map(|row| row.values.unwrap()[0]).collect();
    assert!(unlimited.is_sorted() && unlimited[unlimited.len() - 1] > 1.5 * unlimited[0], "{unlimited:?}");
}

/// A law with the terms of the scenario's own, fitted to its curve, gives it back.
#[test]
fn laws_that_fit_the_curve_give_the_same_drop() {
    let rows = rows("law");
    let own = rows[0].values.unwrap();
    assert_eq!(rows[0].settings[0], "as it is");
    for row in rows[1..].iter().filter(|row| row.settings[3] == "0") {
        let peak = row.values.unwrap()[0];
        assert!((peak / own[0] - 1.0).abs() < 0.01, "{:?}: {peak} N", row.settings);
    }
    assert!(rows[1..].iter().any(|row| row.settings[3] == "0"));
}

#[test]
fn a_thicker_layer_is_softer() {
    let values: Vec<[f64; COUNT]> = rows("thickness").iter().map(|row| row.values.unwrap()).collect();
    let (thin, thick) = (values[0], values[values.len() - 1]);
    assert!(thin[0] > 1.1 * thick[0] && thin[1] < 0.9 * thick[1], "{values:?}");
    let rows = rows("diameter");
    let own = force(&rows, &["0.105", "as it is"]);
    assert!(
        force(&rows, &["0.115", "layer"]) < 0.95 * own && (force(&rows, &["0.115", "core"]) / own - 1.0).abs() < 0.1
    );
}

#[test]
fn a_study_starts_from_the_drop_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let study = json(folder, &["study", "thickness", "--energy", "4.9", "--values", "14", "--json", "--threads", "1"]);
    assert_eq!(study["drop"]["impactor"]["energy"], 4.9, "{study}");
    let cases = study["cases"].as_array().unwrap();
    let settings: Vec<&str> = cases.iter().map(|case| case["thickness [m]"].as_str().unwrap()).collect();
    assert_eq!(settings, ["0.014", "0.015"]);
    let run = json(folder, &["run", "--energy", "4.9", "--json"]);
    assert_eq!(cases[1]["trace_hash"], run["trace_hash"]);
    assert_eq!(cases[1]["peak_force"], run["peak_force"]);
    // The number of threads changes nothing.
    let two = json(folder, &["study", "thickness", "--energy", "4.9", "--values", "14", "--json", "--threads", "2"]);
    assert_eq!(study, two);
    let text = succeed(folder, &["study", "thickness", "--energy", "4.9", "--values", "14"]);
    assert!(text.contains("per mm of thickness") || text.contains("Impacts"), "{text}");
    assert!(entries(folder).is_empty());
}

#[test]
fn refused_values_say_what_is_legal_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, message) in [
        (&["study", "thickness", "--values", "x"][..], "x is refused: expected a list of numbers"),
        (&["study", "thickness", "--values", "-1"], "layers[0].thickness = -0.001 m is refused"),
        (&["study", "poisson", "--values", "0.5"], "layers[0].poissons_ratio = 0.5"),
        (&["study", "friction", "--values", "-0.1"], "face.friction_coefficient = -0.1"),
        (&["study", "diameter", "--values", "140"], "impactor.face_diameter"),
        (&["study", "mesh", "--values", "2.5"], "2.5 is refused: expected a list of whole numbers of rows"),
        (&["study", "law", "--values", "hooke"], "hooke is refused: expected neo_hookean"),
        (&["study", "all", "--values", "1"], "--values is refused with all"),
        (&["study", "everything"], "everything"),
    ] {
        let line = fail(folder.path(), &[arguments, &["--out", "pages"]].concat(), 2);
        assert!(line.contains(message), "{arguments:?}: {line}");
        assert!(entries(folder.path()).is_empty(), "{arguments:?}");
    }
}

#[test]
fn any_parameter_is_studied_over_values_in_its_unit() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments = ["study", "silicone.c10", "--energy", "4.9", "--values", "1e5,2e5", "--out", "."];
    let text = succeed(folder, &arguments);
    assert!(text.contains("silicone.c10") && text.contains("the scenario's own value"), "{text}");
    let names = ["csv", "md", "svg"].map(|extension| format!("silicone.c10.{extension}"));
    assert_eq!(entries(folder), [&names[..], &["softanvil-files.json".to_string()]].concat());
    let (header, lines) = read_table(&folder.join("silicone.c10.csv"));
    assert_eq!(header[1], "silicone.c10 [Pa]");
    let values: Vec<&str> = lines.iter().map(|line| line[1].as_str()).collect();
    assert_eq!(values, ["100000", "148000", "200000"]);
    let peak = |line: &[String]| line[2].parse::<f64>().unwrap();
    let run = json(folder, &["run", "--energy", "4.9", "--set", "silicone.c10=2e5", "--json"]);
    assert_eq!(peak(&lines[2]), run["peak_force"].as_f64().unwrap());
    assert!(peak(&lines[0]) < peak(&lines[1]) && peak(&lines[1]) < peak(&lines[2]));
    assert!(crate::common::svg_texts(&folder.join("silicone.c10.svg")).iter().any(|text| text == "silicone.c10 (Pa)"));
    // Durations are not waited beyond.
    let durations = json(folder, &["study", "time.duration", "--values", "0.004", "--json"]);
    let endings = durations["cases"].as_array().unwrap().iter().map(|case| case["ending"].as_str().unwrap());
    assert_eq!(endings.collect::<Vec<_>>(), ["in_contact", "complete"]);
    // A choice by its labels, a parameter that decides nothing here, and one that has no effect.
    let layers = json(folder, &["study", "core.interface", "--values", "bonded", "--json"]);
    let labels: Vec<&str> =
        layers["cases"].as_array().unwrap().iter().map(|case| case["core.interface"].as_str().unwrap()).collect();
    assert_eq!(labels, ["bonded", "frictional"]);
    let length = succeed(folder, &["study", "geometry.length", "--values", "10"]);
    assert!(length.contains("geometry.length changes nothing in this scenario"), "{length}");
    let skin = fail(folder, &["study", "skin.c10", "--values", "1e5"], 2);
    assert!(skin.contains("skin.c10 is refused: no layer is called skin: expected layers[1].c10"), "{skin}");
    let skin = fail(folder, &["study", "layers[1].c10", "--values", "1e5"], 2);
    assert!(skin.contains("layers[1].c10 = 100000 Pa has no effect: layers.count is 1"), "{skin}");
    for (arguments, message) in [
        (&["study", "silicone.c10"][..], "without --values is refused: expected a list of values of silicone.c10 (Pa)"),
        (&["study", "silicone.c10", "--values", "-1e20"], "layers[0].c10 = -1e20 Pa is refused"),
        (&["study", "geometry.layers", "--values", "2"], "geometry.layers is refused: expected layers.count = 2"),
        (&["study", "core.interface", "--values", "2"], "expected \"bonded\" or \"frictional\" or \"sliding\""),
        (&["study", "silicone.c1", "--values", "1"], "did you mean silicone.c11?"),
    ] {
        let line = fail(folder, arguments, 2);
        assert!(line.contains(message), "{line}");
    }
}

/// A CSV has no lengths in mm beside lengths in m.
#[test]
fn csv_files_are_in_si() {
    for study in STUDIES {
        let (header, _) = read_table(&all().join(format!("{}.csv", study.name)));
        for unit in ["[mm]", "[ms]", "[kPa]", "[MPa]", "[%]"] {
            assert!(!header.iter().any(|title| title.contains(unit)), "{}: {header:?}", study.name);
        }
        assert!(header.iter().any(|title| title == "ending"), "{header:?}");
    }
}

#[test]
fn a_case_that_is_cut_off_is_marked_in_table_csv_and_page() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments = ["study", "thickness", "--values", "12", "--duration", "0.004", "--out", "."];
    let text = succeed(folder, &arguments);
    let page = fs::read_to_string(folder.join("thickness.md")).unwrap();
    for text in [&text, &page] {
        assert!(text.contains("thickness [mm] 12: Cut off in contact after 4 ms"), "{text}");
    }
    let row = page.lines().find(|line| line.starts_with("| 12 |")).unwrap();
    assert_eq!(row.matches('*').count(), 5, "{row}");
    let (header, lines) = read_table(&folder.join("thickness.csv"));
    let ending = header.iter().position(|title| title == "ending").unwrap();
    assert!(lines.iter().all(|line| line[ending] == "in_contact"), "{lines:?}");
}

/// The paper's figures stand beside its own anvil and impactor only.
#[test]
fn a_model_that_is_not_the_paper_s_has_no_column_of_the_paper() {
    let folder = tempfile::tempdir().unwrap();
    let study = ["study", "thickness", "--values", "14,16"];
    assert!(succeed(folder.path(), &study).contains("The paper beside this model"));
    let own = succeed(folder.path(), &[&study[..], &["--set", "impactor.mass=3"]].concat());
    assert!(own.contains("Findings") && !own.contains("The paper beside this model"), "{own}");
    let result = json(folder.path(), &[&study[..], &["--set", "impactor.mass=3", "--json"]].concat());
    assert!(result["findings"].as_array().unwrap().iter().all(|finding| finding["paper"].is_null()), "{result}");
}

#[test]
fn files_of_others_are_left_alone_and_own_ones_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let study = ["study", "thickness", "--values", "14", "--out", "."];
    for name in ["thickness.md", "thickness.csv", "thickness.svg"] {
        fs::write(folder.join(name), "mine").unwrap();
        let line = fail(folder, &study, 2);
        assert!(line.contains(&format!("{name} is there and not as this program left it")), "{line}");
        assert_eq!(fs::read_to_string(folder.join(name)).unwrap(), "mine");
        assert_eq!(entries(folder), [name]);
        fs::remove_file(folder.join(name)).unwrap();
    }
    fs::write(folder.join("README.md"), "mine").unwrap();
    assert!(fail(folder, &["study", "all", "--out", "."], 2).contains("README.md is there"));
    assert_eq!(fs::read_to_string(folder.join("README.md")).unwrap(), "mine");
    // A study of its own beside it, made twice.
    succeed(folder, &study);
    succeed(folder, &study);
    assert_eq!(fs::read_to_string(folder.join("README.md")).unwrap(), "mine");
}

/// The first Ctrl-C ends a study with what is done.
#[cfg(unix)]
#[test]
fn an_interrupted_study_keeps_what_is_done() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    let folder = tempfile::tempdir().unwrap();
    // The longest simulation is begun first: the other thread does the short ones in the meantime.
    let arguments = ["study", "mesh", "--values", "3,4,40", "--out", "pages", "--threads", "2", "--json"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_softanvil"))
        .args(arguments)
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let csv = folder.path().join("pages/mesh.csv");
    let done = || fs::read_to_string(&csv).map_or(0, |text| text.lines().count());
    while done() < 4 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
    let page: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((page["missing"].as_u64(), page["cases"].as_array().unwrap().len()), (Some(1), 3));
    let text = fs::read_to_string(folder.path().join("pages/mesh.md")).unwrap();
    assert!(text.contains("Interrupted: 1 of 4 simulations are missing."), "{text}");
    assert_eq!(done(), 4);
}
