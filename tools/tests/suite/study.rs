//! `softanvil study`, and the pages of the documentation that it makes.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use serde_json::Value;

use crate::common::{entries, fail, json, read_table, succeed};
use softanvil_tools::quantity::{COUNT, QUANTITIES};
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
    for row in rows[1..].iter().filter(|row| row.settings[3] == "0.00") {
        let peak = row.values.unwrap()[0];
        assert!((peak / own[0] - 1.0).abs() < 0.01, "{:?}: {peak} N", row.settings);
    }
    assert!(rows[1..].iter().any(|row| row.settings[3] == "0.00"));
}

#[test]
fn a_thicker_layer_is_softer() {
    let values: Vec<[f64; COUNT]> = rows("thickness").iter().map(|row| row.values.unwrap()).collect();
    let (thin, thick) = (values[0], values[values.len() - 1]);
    assert!(thin[0] > 1.1 * thick[0] && thin[1] < 0.9 * thick[1], "{values:?}");
    let rows = rows("diameter");
    let own = force(&rows, &["105", "as it is"]);
    assert!(force(&rows, &["115", "layer"]) < 0.95 * own && (force(&rows, &["115", "core"]) / own - 1.0).abs() < 0.1);
}

#[test]
fn a_study_starts_from_the_drop_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let study = json(folder, &["study", "thickness", "--energy", "4.9", "--values", "13", "--json", "--threads", "1"]);
    assert!(study["subject"].as_str().unwrap().contains("4.9 J"), "{study}");
    let cases = study["cases"].as_array().unwrap();
    let settings: Vec<&str> = cases.iter().map(|case| case["thickness [mm]"].as_str().unwrap()).collect();
    assert_eq!(settings, ["13", "14"]);
    let run = json(folder, &["run", "--energy", "4.9", "--json"]);
    assert_eq!(cases[1]["trace_hash"], run["trace_hash"]);
    assert_eq!(cases[1]["peak_force"], run["peak_force"]);
    // The number of threads changes nothing.
    let two = json(folder, &["study", "thickness", "--energy", "4.9", "--values", "13", "--json", "--threads", "2"]);
    assert_eq!(study, two);
    let text = succeed(folder, &["study", "thickness", "--energy", "4.9", "--values", "13"]);
    assert!(text.contains("per mm of thickness") || text.contains("Impacts"), "{text}");
    assert!(entries(folder).is_empty());
}

#[test]
fn refused_values_say_what_is_legal_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, message) in [
        (&["study", "thickness", "--values", "x"][..], "x is refused: legal is a list of numbers"),
        (&["study", "thickness", "--values", "-1"], "geometry.silicone_thickness = -0.001 m is refused"),
        (&["study", "poisson", "--values", "0.5"], "silicone.poissons_ratio = 0.5"),
        (&["study", "friction", "--values", "-0.1"], "face.friction_coefficient = -0.1"),
        (&["study", "diameter", "--values", "140"], "impactor.face_diameter"),
        (&["study", "mesh", "--values", "2.5"], "2.5 is refused: legal is a list of whole numbers of rows"),
        (&["study", "law", "--values", "hooke"], "hooke is refused: legal is neo_hookean"),
        (&["study", "all", "--values", "1"], "--values is refused with all"),
        (&["study", "everything"], "everything"),
    ] {
        let line = fail(folder.path(), &[arguments, &["--out", "pages"]].concat(), 2);
        assert!(line.contains(message), "{arguments:?}: {line}");
        assert!(entries(folder.path()).is_empty(), "{arguments:?}");
    }
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
