//! The main job: `softanvil` without a command, and `softanvil validate`.

use std::fs;

use crate::common::{column, entries, fail, json, succeed, svg_texts};
use serde_json::Value;
use softanvil_tools::measurement::quantity::QUANTITIES;
use softanvil_tools::paper::TABLE_1;

const FILES: [&str; 14] = [
    "deformed-mesh.svg",
    "energy.svg",
    "force-deformation.svg",
    "force-time.svg",
    "maximum-compression.svg",
    "pressure.svg",
    "report.html",
    "scenario.toml",
    "summary.json",
    "table.txt",
    "trace-14.7J.csv",
    "trace-4.9J.csv",
    "trace-9.8J.csv",
    "von-mises.svg",
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
fn the_pictures_of_the_section_say_what_they_show() {
    let folder = tempfile::tempdir().unwrap();
    succeed(folder.path(), &["--out", "out"]);
    let texts = |name: &str| svg_texts(&folder.path().join("out").join(name));
    let has = |name: &str, wanted: &str| {
        assert!(texts(name).iter().any(|text| text.contains(wanted)), "{wanted} in {:?}", texts(name));
    };
    for (name, quantity) in [("von-mises.svg", "von Mises stress ("), ("pressure.svg", "pressure (")] {
        has(name, quantity);
        for moment in ["0.5 ms after contact", "peak force", "maximum compression", "force down to a tenth"] {
            has(name, moment);
        }
    }
    for energy in ["14.7 J", "9.8 J", "4.9 J"] {
        has("maximum-compression.svg", energy);
        has("deformed-mesh.svg", energy);
        has("energy.svg", energy);
    }
    for wanted in ["energy (J)", "time since contact (ms)", "viscous", "elastic", "impactor, kinetic", "brought in"] {
        has("energy.svg", wanted);
    }
    // Numbers of a picture are those of the run.
    let peak = json(folder.path(), &["run", "--energy", "14.7", "--json"])["peak_force"].as_f64().unwrap();
    has("von-mises.svg", &format!("{peak:.0} N"));
}

/// What a page that is one file may not have.
fn assert_alone(page: &str) {
    for outside in [" src=", "@import", "url(", "fetch(", "XMLHttpRequest", "{{", "importScripts"] {
        assert!(!page.contains(outside), "{outside}");
    }
    assert_eq!(page.matches(" href=").count(), page.matches(" href=\"data:").count());
    assert!(page.len() < 1_500_000, "{} bytes", page.len());
}

/// The drops that a page begins with.
fn drops_of(page: &str) -> Vec<Value> {
    let start = page.find("id=\"start\">").unwrap() + "id=\"start\">".len();
    let data = &page[start..start + page[start..].find("</script>").unwrap()];
    serde_json::from_str(data).unwrap()
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let folder = tempfile::tempdir().unwrap();
    succeed(folder.path(), &["--out", "out"]);
    let page = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert_alone(&page);
    let drops = drops_of(&page);
    assert_eq!(drops.len(), TABLE_1.len());
    for (drop, case) in drops.iter().zip(&TABLE_1) {
        let (data, section) = (&drop["data"], &drop["data"]["section"]);
        let run = json(folder.path(), &["run", "--energy", &case.energy.to_string(), "--json"]);
        assert_eq!(data["hash"], run["trace_hash"]);
        assert_eq!(data["numbers"][0]["value"], run["peak_force"]);
        let frames = section["time"].as_array().unwrap().len();
        // Two bytes a number, four characters for three bytes.
        let numbers = 2 * frames * section["mesh"]["x"].as_array().unwrap().len();
        assert_eq!(section["displacement"]["values"].as_str().unwrap().len(), (2 * numbers).div_ceil(3) * 4);
        let last =
            data["energy"]["terms"].as_array().unwrap().iter().map(|term| term[1].as_array().unwrap().last().unwrap());
        let sum: f64 = last.map(|energy| energy.as_f64().unwrap()).sum();
        let brought_in = data["energy"]["external"].as_array().unwrap().last().unwrap().as_f64().unwrap();
        assert!((sum - brought_in).abs() < 1e-3 * brought_in, "{sum} of {brought_in} J");
    }
}

#[test]
fn the_page_of_its_own_is_one_file_with_the_study_s_table() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(succeed(folder.path(), &["page", "--out", "page.html"]), "written: page.html\n");
    let page = fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert_alone(&page);
    assert!(page.contains("LS-DYNA") && drops_of(&page).len() == 1);
    assert!(fail(folder.path(), &["page", "--out", "page.html"], 2).contains("--overwrite replaces it"));
    succeed(folder.path(), &["page", "--out", "page.html", "--overwrite"]);
    assert_eq!(entries(folder.path()), ["page.html"]);
}

#[test]
fn a_report_is_replaced_and_anything_else_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let report = folder.path().join("out");
    fs::create_dir(&report).unwrap();
    succeed(folder.path(), &["--out", "out"]);
    let first = fs::read(report.join("summary.json")).unwrap();
    succeed(folder.path(), &["--out", "out"]);
    // A file that was changed since is no longer the program's.
    fs::write(report.join("scenario.toml"), "mine").unwrap();
    let line = fail(folder.path(), &["--out", "out"], 2);
    assert!(line.contains("scenario.toml in it was changed since it was written; --overwrite replaces it"), "{line}");
    assert_eq!(fs::read_to_string(report.join("scenario.toml")).unwrap(), "mine");
    succeed(folder.path(), &["--out", "out", "--overwrite"]);
    assert_eq!(fs::read(report.join("summary.json")).unwrap(), first);
    assert_ne!(fs::read_to_string(report.join("scenario.toml")).unwrap(), "mine");
    assert_eq!(entries(folder.path()), ["out"]);

    fs::write(report.join("notes.txt"), "mine").unwrap();
    let line = fail(folder.path(), &["--out", "out", "--overwrite"], 2);
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
fn the_presets_are_nearer_to_the_experiment_than_the_study_s_own_model() {
    let folder = tempfile::tempdir().unwrap();
    for (preset, largest_mean) in [("study", 5.85), ("study-incompressible", 6.0), ("study-14.7", 7.0)] {
        let result = json(folder.path(), &["validate", "--preset", preset, "--json"]);
        let mean = result["mean_error_percent"].as_f64().unwrap();
        assert!(mean <= largest_mean, "{preset}: {mean} %");
        assert!(mean < result["ls_dyna"]["mean_error_percent"].as_f64().unwrap());
        for case in result["cases"].as_array().unwrap() {
            assert!(case["error_percent"]["peak_force"].as_f64().unwrap().abs() <= 3.0, "{preset}: {case}");
        }
    }
}

#[test]
fn a_drop_of_ones_own_has_every_picture_and_no_figure_of_the_paper() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("mine.toml"), "[impactor]\nmass = 3\n").unwrap();
    let arguments = ["report", "--scenario", "mine.toml", "--energy", "6", "--set", "silicone.c10=2e5", "--out", "own"];
    let text = succeed(folder.path(), &arguments);
    assert!(text.starts_with("Scenario: preset study, mine.toml, silicone.c10=2e5.\nDrop: 3 kg with 6 J"), "{text}");
    let own = folder.path().join("own");
    let mut expected: Vec<&str> = FILES.into_iter().filter(|name| !name.starts_with("trace-")).collect();
    expected.push("trace.csv");
    expected.sort();
    assert_eq!(entries(&own), expected);
    for picture in expected.iter().filter(|name| name.ends_with(".svg")) {
        let texts = svg_texts(&own.join(picture));
        assert!(texts.iter().any(|text| text.contains("6 J")), "{picture}: {texts:?}");
        assert!(!texts.iter().any(|text| text.contains("experiment")), "{picture}: {texts:?}");
    }
    let page = fs::read_to_string(own.join("report.html")).unwrap();
    assert!(page.contains("preset study, mine.toml") && !page.contains("LS-DYNA"), "the page of another drop");
    let run = json(folder.path(), &["run", "--scenario", "own/scenario.toml", "--json"]);
    let summary: Value = serde_json::from_str(&fs::read_to_string(own.join("summary.json")).unwrap()).unwrap();
    assert_eq!(summary["run"]["trace_hash"], run["trace_hash"]);
    assert!(fail(folder.path(), &["report", "--set", "impactor.mass=-1", "--out", "own"], 2).contains("impactor.mass"));
}

/// The number of fitted parameters stands beside every mean error, and is the preset's.
#[test]
fn errors_stand_beside_how_many_parameters_were_fitted_to_how_many_numbers() {
    let folder = tempfile::tempdir().unwrap();
    for preset in softanvil_kernel::preset::PRESETS {
        let (parameters, numbers) = (preset.fitted.parameters, preset.fitted.numbers);
        let text = succeed(folder.path(), &["validate", "--preset", preset.name]);
        assert!(text.contains(&format!("{parameters} / {numbers}")), "{text}");
        // Every quantity stands on the line of its numbers.
        for quantity in ["peak force (N)", "max deformation (mm)", "impact duration (ms)", "impulse (N s)"] {
            // Bands, where there are any, stand in a table of their own.
            let comparison = text.split("90 % band of").next().unwrap();
            let lines: Vec<&str> = comparison.lines().filter(|line| line.contains(quantity)).collect();
            assert!(lines.len() == 3 && lines.iter().all(|line| line.ends_with(" %")), "{text}");
        }
        assert!(text.replace('\n', " ").contains(&preset.fitted.to_string()), "{text}");
        let result = json(folder.path(), &["validate", "--preset", preset.name, "--json"]);
        assert_eq!(result["fitted"], serde_json::json!({ "parameters": parameters, "numbers": numbers }));
        let formulation = softanvil_kernel::Parameter::find("geometry.formulation").unwrap();
        let own = formulation.get(&(preset.scenario)()) as usize;
        assert_eq!(result["formulation"], formulation.labels()[own], "{}", preset.name);
    }
    succeed(folder.path(), &["--out", "out"]);
    let page = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    let fitted = softanvil_kernel::preset::PRESETS[0].fitted.to_string();
    let beside = page.find("Mean deviation from the experiment").unwrap();
    assert!(page[beside..beside + 300].contains(&fitted), "{}", &page[beside..beside + 300]);
}
