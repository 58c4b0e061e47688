//! `softanvil sweep`, and the pages of the documentation that it makes.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use serde_json::Value;

use crate::common::{entries, fail, json, read_table, succeed};
use softanvil_tools::measurement::quantity::{COUNT, QUANTITIES};

/// The folder of the files that say what the paper changed.
const SWEEPS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../sweeps");

/// Names of those files, without the extension.
fn names() -> Vec<String> {
    entries(Path::new(SWEEPS)).iter().map(|name| name.strip_suffix(".toml").unwrap().to_string()).collect()
}

/// The folder that all of them fill, from the folder above theirs; once for all tests.
fn all() -> &'static Path {
    static FOLDER: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, pages) = FOLDER.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let pages = folder.path().join("pages");
        let files: Vec<String> = names().iter().map(|name| format!("sweeps/{name}.toml")).collect();
        let files = files.iter().map(String::as_str);
        let arguments: Vec<&str> =
            ["sweep"].into_iter().chain(files).chain(["--out", pages.to_str().unwrap()]).collect();
        succeed(&Path::new(SWEEPS).join(".."), &arguments);
        (folder, pages)
    });
    pages
}

/// A simulation of a sweep: its settings and its four numbers.
struct Row {
    settings: Vec<String>,
    values: Option<[f64; COUNT]>,
    held_force: Option<f64>,
    elements: f64,
}

fn rows(sweep: &str) -> Vec<Row> {
    let (header, lines) = read_table(&all().join(format!("{sweep}.csv")));
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
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/sweeps");
    assert_eq!(entries(&docs), entries(all()));
    for name in entries(all()) {
        let [made, kept] = [all(), docs.as_path()].map(|folder| fs::read_to_string(folder.join(&name)).unwrap());
        assert!(made == kept, "docs/sweeps/{name}: softanvil sweep sweeps/*.toml --out docs/sweeps makes it anew");
    }
}

#[test]
fn every_file_has_its_page_table_and_picture() {
    let found = entries(all());
    for name in names() {
        assert!(
            ["csv", "md", "svg"].map(|e| format!("{name}.{e}")).iter().all(|file| found.contains(file)),
            "{found:?}"
        );
        assert!(crate::common::svg_texts(&all().join(format!("{name}.svg"))).len() > 5);
        assert!(rows(&name).iter().filter(|row| row.values.is_some()).count() >= 5, "{name}");
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
    let mechanisms = rows("friction-mechanisms");
    let effect = |rows: &[Row], settings: &[&str]| {
        let at = |friction: &str| force(rows, &[settings, &[friction]].concat());
        at("0.6") / at("0.2") - 1.0
    };
    let press = effect(&mechanisms, &["0.48", "off", "bonded", "press"]);
    assert!(press > 0.03, "{press}");
    assert!(effect(&mechanisms, &["0.48", "off", "contact", "press"]) > press);
    let damped = effect(&mechanisms, &["0.48", "Prony", "bonded", "impact"]).abs();
    assert!(damped < 0.5 * press, "{damped}");
    // The preset's core is in contact, where damping hides less.
    let drop = effect(&rows("friction"), &[]);
    assert!(drop > damped, "{drop}");
    assert_eq!(drop, effect(&mechanisms, &["0.49", "Prony", "contact", "impact"]));
}

/// Source: mechanics. A layer that is bonded and wide resists by its bulk modulus, until that is out of reach.
#[test]
fn poissons_ratio_stiffens_a_bonded_layer_but_not_an_incompressible_one() {
    let peaks = |sweep: &str| -> Vec<f64> {
        rows(sweep).iter().filter(|row| row.settings[0] == "bonded").map(|row| row.values.unwrap()[0]).collect()
    };
    let bonded = peaks("poisson");
    assert!(bonded.len() >= 6 && bonded[bonded.len() - 1] > 1.1 * bonded[0], "{bonded:?}");
    let stiff = peaks("bulk-modulus");
    // From 0.48 to 0.49 the bulk modulus doubles.
    let [soft_rise, stiff_rise] = [&bonded, &stiff].map(|peaks| peaks[peaks.len() - 1] / peaks[peaks.len() - 2] - 1.0);
    assert!(stiff_rise.abs() < 0.5 * soft_rise, "{stiff:?} {bonded:?}");
}

/// Source: the paper's finding that a higher damping modulus gives a higher peak, where the slider does not slip.
#[test]
fn a_higher_damping_modulus_raises_the_peak_of_a_spring_that_does_not_slip() {
    let rows = rows("damping");
    let unlimited: Vec<f64> =
        rows.iter().filter(|row| row.settings[0] == "10000000000").map(|row| row.values.unwrap()[0]).collect();
    assert!(
        unlimited.len() == 6 && unlimited.is_sorted() && unlimited[unlimited.len() - 1] > 1.5 * unlimited[0],
        "{unlimited:?}"
    );
}

/// A law with the terms of the scenario's own, fitted to its curve, gives it back.
#[test]
fn laws_that_fit_the_curve_give_the_same_drop() {
    let rows = rows("law");
    let own = rows[0].values.unwrap();
    assert_eq!(rows[0].settings[0], "as it is");
    for law in ["Mooney-Rivlin 5 to 50 %", "Ogden 3 to 50 %", "Mooney-Rivlin 5 to 70 %", "Ogden 3 to 70 %"] {
        let peak = force(&rows, &[law]);
        assert!((peak / own[0] - 1.0).abs() < 0.01, "{law}: {peak} N");
    }
}

#[test]
fn a_thicker_layer_is_softer() {
    let values: Vec<[f64; COUNT]> = rows("thickness").iter().map(|row| row.values.unwrap()).collect();
    let (thin, thick) = (values[0], values[values.len() - 1]);
    assert!(thin[0] > 1.1 * thick[0] && thin[1] < 0.9 * thick[1], "{values:?}");
    let rows = rows("diameter");
    let own = force(&rows, &["105 mm, as it is"]);
    assert!(
        force(&rows, &["115 mm by the layer"]) < 0.95 * own
            && (force(&rows, &["115 mm by the core"]) / own - 1.0).abs() < 0.1
    );
}

/// Source: the files that they name are those of the laws' fits: the curve is the preset's own law, by its closed form.
#[test]
fn coefficients_of_the_laws_are_near_those_of_a_fit() {
    // Nominal stress in uniaxial compression of Mooney-Rivlin: 2 (l - l^-2) (W1 + W2 / l).
    let curve = |terms: &dyn Fn(f64, f64) -> [f64; 2], stretch: f64| {
        let (i1, i2) = (stretch * stretch + 2.0 / stretch, 2.0 * stretch + stretch.powi(-2));
        let [w1, w2] = terms(i1 - 3.0, i2 - 3.0);
        2.0 * (stretch - stretch.powi(-2)) * (w1 + w2 / stretch)
    };
    let own = softanvil_kernel::preset::study().layers[0].material;
    let [c10_own, c01_own, c20_own] = ["c10", "c01", "c20"].map(|name| own.coefficient(name).unwrap());
    let text = fs::read_to_string(Path::new(SWEEPS).join("law.toml")).unwrap();
    let line = text.lines().find(|line| line.contains("\"Yeoh 3 to 50 %\"")).unwrap();
    let value = |name: &str| -> f64 {
        let rest = line.split(&format!("\"silicone.{name}\" = ")).nth(1).unwrap();
        rest.split([',', ' ']).next().unwrap().parse().unwrap()
    };
    let [c10, c20, c30] = ["c10", "c20", "c30"].map(value);
    let (mut squares, mut largest) = (0.0, 0.0_f64);
    for stretch in (1..=100).map(|i| 1.0 - 0.005 * f64::from(i)) {
        let target = curve(&|i1, _| [c10_own + 2.0 * c20_own * i1, c01_own], stretch);
        let fitted = curve(&|i1, _| [c10 + 2.0 * c20 * i1 + 3.0 * c30 * i1 * i1, 0.0], stretch);
        squares += (fitted - target).powi(2);
        largest = largest.max(target.abs());
    }
    // The residual that stands beside it, 0.05 %.
    let residual = (squares / 100.0).sqrt() / largest;
    assert!((residual - 0.0005).abs() < 0.00005, "{residual}");
}

#[test]
fn a_sweep_starts_from_the_drop_it_is_given() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments = ["sweep", "silicone.thickness=0.014", "--energy", "4.9", "--json", "--threads"];
    let sweep = json(folder, &[&arguments[..], &["1"]].concat());
    assert_eq!(sweep["drop"]["impactor"]["energy"], 4.9, "{sweep}");
    let cases = sweep["cases"].as_array().unwrap();
    let settings: Vec<&str> = cases.iter().map(|case| case["silicone.thickness [m]"].as_str().unwrap()).collect();
    assert_eq!(settings, ["0.014", "0.015"]);
    let run = json(folder, &["run", "--energy", "4.9", "--json"]);
    assert_eq!(cases[1]["trace_hash"], run["trace_hash"]);
    assert_eq!(cases[1]["peak_force"], run["peak_force"]);
    // The number of threads changes nothing.
    assert_eq!(sweep, json(folder, &[&arguments[..], &["2"]].concat()));
    let text = succeed(folder, &["sweep", "silicone.thickness=0.014", "--energy", "4.9"]);
    assert!(text.contains("Simulations") && text.contains("the scenario's own"), "{text}");
    assert!(entries(folder).is_empty());
}

#[test]
fn refused_values_say_what_is_legal_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let outside = |name: &str| format!("{SWEEPS}/{name}.toml");
    let (friction, again) = (outside("friction"), format!("{SWEEPS}/../sweeps/friction.toml"));
    for (arguments, message) in [
        (&["silicone.thickness=x"][..], "silicone.thickness = x is refused: expected a number"),
        (&["silicone.thickness=-1"], "layers[0].thickness = -1 m is refused"),
        (&["silicone.poissons_ratio=0.5"], "layers[0].poissons_ratio = 0.5"),
        (&["face.friction_coefficient=-0.1"], "face.friction_coefficient = -0.1"),
        (&["impactor.face_diameter=0.005"], "impactor.face_diameter"),
        (&["--convergence=0"], "--convergence: 0 is refused: expected factors from 0.01 to 100"),
        (&["silicone.law=hooke"], "silicone.law = hooke is refused: expected \"neo_hookean\""),
        (&["silicone.c10="], "silicone.c10 =  is refused: expected a number"),
        (&["silicone.c10=1e5", "silicone.c10=2e5"], "silicone.c10 is set by two of the levels"),
        (&["silicone.c10=1e5", &friction], "is refused beside files"),
        (&[&friction, &again], "two files are called friction"),
        (&["silicone.c1"], "silicone.c1 is refused: expected PARAMETER=LIST"),
        (&["silicone.c1=1"], "did you mean silicone.c11?"),
        (&["none.toml"], "none.toml: "),
        (&[], "nothing is changed: expected PARAMETER=LIST"),
    ] {
        let line = fail(folder.path(), &[&["sweep"], arguments, &["--out", "pages"]].concat(), 2);
        assert!(line.contains(message), "{arguments:?}: {line}");
        assert!(entries(folder.path()).is_empty(), "{arguments:?}");
    }
    // What the command was called before.
    let line = fail(folder.path(), &["study", "silicone.c10", "--values", "1e5,2e5"], 2);
    assert!(line.contains("study is `sweep` now"), "{line}");
}

#[test]
fn any_parameter_is_swept_over_values_in_its_unit() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments = ["sweep", "silicone.c10=1e5,2e5", "--energy", "4.9", "--out", "."];
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
    let durations = json(folder, &["sweep", "time.duration=0.004", "--json"]);
    let endings = durations["cases"].as_array().unwrap().iter().map(|case| case["ending"].as_str().unwrap());
    assert_eq!(endings.collect::<Vec<_>>(), ["in_contact", "complete"]);
    // A choice by its labels, a parameter that decides nothing here, and one that has no effect.
    let layers = json(folder, &["sweep", "core.interface=bonded", "--json"]);
    let labels: Vec<&str> =
        layers["cases"].as_array().unwrap().iter().map(|case| case["core.interface"].as_str().unwrap()).collect();
    assert_eq!(labels, ["bonded", "frictional"]);
    let length = succeed(folder, &["sweep", "geometry.length=10"]);
    assert!(length.contains("geometry.length changes nothing in this scenario"), "{length}");
    // The same trace, of which another threshold takes another duration.
    let threshold = json(folder, &["sweep", "measurement.force_threshold=30", "--json"]);
    assert!(!threshold["notes"].to_string().contains("changes nothing"), "{threshold}");
    // A value of more digits than a table shows.
    let digits = json(folder, &["sweep", "silicone.c10=123456.7890123456", "--json"]);
    let run = json(folder, &["run", "--set", "silicone.c10=123456.7890123456", "--json"]);
    assert_eq!(digits["cases"][0]["trace_hash"], run["trace_hash"]);
    let skin = fail(folder, &["sweep", "layers[1].c10=2e5"], 2);
    assert!(skin.contains("layers[1].c10 = 200000 Pa has no effect: layers.count is 1"), "{skin}");
    for (argument, message) in [
        ("silicone.c10=-1e20", "layers[0].c10 = -1e20 Pa is refused"),
        ("geometry.layers=2", "expected layers.count = 2"),
    ] {
        let line = fail(folder, &["sweep", argument], 2);
        assert!(line.contains(message), "{line}");
    }
}

/// All combinations, but for those in which a value has no effect: friction at a core that is bonded.
#[test]
fn several_parameters_are_swept_in_all_combinations() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axes = ["core.interface=bonded", "core.friction_coefficient=0,0.6"];
    let sweep = json(folder, &[&["sweep"], &axes[..], &["--json"]].concat());
    let settings = |case: &Value| {
        ["core.interface", "core.friction_coefficient"].map(|name| case[name].as_str().unwrap().to_string())
    };
    let found: Vec<[String; 2]> = sweep["cases"].as_array().unwrap().iter().map(settings).collect();
    let expected = [("bonded", "0.3"), ("frictional", "0"), ("frictional", "0.3"), ("frictional", "0.6")];
    assert_eq!(found, expected.map(|(interface, friction)| [interface.to_string(), friction.to_string()]));
    let text = succeed(folder, &[&["sweep"], &axes[..], &["--out", "."]].concat());
    assert!(text.contains("Force (N) by core.friction_coefficient"), "{text}");
    let name = "core.interface-core.friction_coefficient";
    assert!(entries(folder).contains(&format!("{name}.csv")));
    let single = json(folder, &["run", "--set", "core.friction_coefficient=0.6", "--json"]);
    assert_eq!(sweep["cases"][3]["trace_hash"], single["trace_hash"]);
    // Changes are from the same core with its own friction.
    let page = fs::read_to_string(folder.join(format!("{name}.md"))).unwrap();
    let row = |start: &str| page.lines().find(|line| line.starts_with(start)).unwrap().to_string();
    assert!(!row("| bonded | 0.3 |").contains('%') && row("| frictional | 0 |").contains("-"), "{page}");
}

/// Every combination on its own meshes, with an order each.
#[test]
fn convergence_is_judged_for_every_combination() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments =
        ["sweep", "core.interface=bonded", "--convergence=1,2,4", "--out", ".", "--set", "mesh.element_size=0.005"];
    let text = succeed(folder, &arguments);
    for core in ["bonded", "frictional"] {
        assert!(text.contains(&format!("Order of convergence and discretisation error: {core},")), "{text}");
    }
    let (header, lines) = read_table(&folder.join("core.interface.csv"));
    assert_eq!(header[1..4], ["core.interface", "rows", "columns"]);
    let rows: Vec<&str> = lines.iter().map(|line| line[2].as_str()).collect();
    assert_eq!(rows.len(), 6, "{rows:?}");
    assert_eq!(rows[..3], rows[3..]);
    let counts: Vec<usize> = rows[..3].iter().map(|rows| rows.parse().unwrap()).collect();
    assert_eq!([2 * counts[0], 2 * counts[1]], [counts[1], counts[2]]);
}

/// A CSV has no lengths in mm beside lengths in m.
#[test]
fn csv_files_are_in_si() {
    for name in names() {
        let (header, _) = read_table(&all().join(format!("{name}.csv")));
        for unit in ["[mm]", "[ms]", "[kPa]", "[MPa]", "[%]"] {
            assert!(!header.iter().any(|title| title.contains(unit)), "{name}: {header:?}");
        }
        assert!(header.iter().any(|title| title == "ending"), "{header:?}");
    }
}

#[test]
fn a_case_that_is_cut_off_is_marked_in_table_csv_and_page() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let arguments = ["sweep", "silicone.thickness=0.012", "--duration", "0.004", "--out", "."];
    let text = succeed(folder, &arguments);
    let page = fs::read_to_string(folder.join("silicone.thickness.md")).unwrap();
    for text in [&text, &page] {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("silicone.thickness [m] 0.012: Cut off in contact after 4 ms"), "{text}");
    }
    let row = page.lines().find(|line| line.starts_with("| 0.012 |")).unwrap();
    assert_eq!(row.matches('*').count(), 5, "{row}");
    let (header, lines) = read_table(&folder.join("silicone.thickness.csv"));
    let ending = header.iter().position(|title| title == "ending").unwrap();
    assert!(lines.iter().all(|line| line[ending] == "in_contact"), "{lines:?}");
}

/// The paper's figures stand beside its own anvil and impactor only.
#[test]
fn a_model_that_is_not_the_paper_s_has_no_column_of_the_paper() {
    let folder = tempfile::tempdir().unwrap();
    let friction = format!("{SWEEPS}/friction.toml");
    let sweep = ["sweep", &friction];
    assert!(succeed(folder.path(), &sweep).contains("The paper beside this model"));
    let own = succeed(folder.path(), &[&sweep[..], &["--set", "impactor.mass=3"]].concat());
    assert!(own.contains("\nChanges\n") && !own.contains("The paper beside this model"), "{own}");
    let result = json(folder.path(), &[&sweep[..], &["--set", "impactor.mass=3", "--json"]].concat());
    let contrasts = result["contrasts"].as_array().unwrap();
    assert!(contrasts.len() == 1 && contrasts[0]["paper"].is_null(), "{result}");
    assert!(contrasts[0]["change_percent"]["peak_force"].as_f64().unwrap() > 10.0, "{result}");
}

#[test]
fn files_of_others_are_left_alone_and_own_ones_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let sweep = ["sweep", "silicone.thickness=0.014", "--out", "."];
    for name in ["md", "csv", "svg"].map(|extension| format!("silicone.thickness.{extension}")) {
        fs::write(folder.join(&name), "mine").unwrap();
        let line = fail(folder, &sweep, 2);
        assert!(line.contains(&format!("{name} is there and not as this program left it")), "{line}");
        assert_eq!(fs::read_to_string(folder.join(&name)).unwrap(), "mine");
        assert_eq!(entries(folder), [name.as_str()]);
        fs::remove_file(folder.join(&name)).unwrap();
    }
    fs::write(folder.join("README.md"), "mine").unwrap();
    let files = ["friction", "thickness"].map(|name| format!("{SWEEPS}/{name}.toml"));
    let several = ["sweep", &files[0], &files[1], "--out", "."];
    assert!(fail(folder, &several, 2).contains("README.md is there"));
    assert_eq!(fs::read_to_string(folder.join("README.md")).unwrap(), "mine");
    // A sweep of its own beside it, made twice.
    succeed(folder, &sweep);
    succeed(folder, &sweep);
    assert_eq!(fs::read_to_string(folder.join("README.md")).unwrap(), "mine");
}

/// The first Ctrl-C ends a sweep with what is done.
#[cfg(unix)]
#[test]
fn an_interrupted_sweep_keeps_what_is_done() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    let folder = tempfile::tempdir().unwrap();
    // The longest simulation is begun first: the other thread does the short ones in the meantime.
    let arguments = ["sweep", "--convergence=0.6,0.8,8", "--out", "pages", "--threads", "2", "--json"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_softanvil"))
        .args(arguments)
        .current_dir(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let csv = folder.path().join("pages/convergence.csv");
    let done = || fs::read_to_string(&csv).map_or(0, |text| text.lines().count());
    while done() < 4 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(130), 0));
    let page: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((page["missing"].as_u64(), page["cases"].as_array().unwrap().len()), (Some(1), 3));
    let text = fs::read_to_string(folder.path().join("pages/convergence.md")).unwrap();
    assert!(text.contains("Interrupted: 1 of 4 simulations are missing."), "{text}");
    assert_eq!(done(), 4);
}
