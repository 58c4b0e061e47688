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

/// Not one more, not one less, whatever the population.
#[test]
fn the_evaluations_asked_for_are_spent() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let whole = search(folder, "whole", "15", "3");
    assert_eq!(whole.lines().count(), 16);
    assert_eq!(search(folder, "cut", "4", "3").lines().count(), 5);
    assert_eq!(search(folder, "cut", "15", "3"), whole);
}

#[test]
fn a_log_of_another_problem_is_refused_and_says_what_differs() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let problem = |text: &str| fs::write(folder.join("problem.toml"), text).unwrap();
    problem(&(PROBLEM.to_string() + "peak_force = 5400\n"));
    let log = search(folder, "out", "6", "1");
    let continued = ["calibrate", "problem.toml", "--out", "out", "--evaluations", "6", "--seed", "1"];
    for (text, difference) in [
        (PROBLEM.to_string() + "peak_force = 3000\n", "impacts[0].peak_force.measured was 5400.0 and is 3000.0"),
        (PROBLEM.to_string() + "peak_force = 5400\nimpulse = 15\n", "impacts[0].impulse.measured was 16.0 and is 15.0"),
        (
            PROBLEM.replace("7.5e-3", "7.6e-3") + "peak_force = 5400\n",
            "scenario.mesh.element_size was 0.0075 and is 0.0076",
        ),
        (
            PROBLEM.replace("max = 0.15", "max = 0.16") + "peak_force = 5400\n",
            "parameters.geometry.length.max was 0.15",
        ),
        (
            PROBLEM.to_string() + "peak_force = 5400\n[objective]\nroot_mean_square = 0.5\n",
            "objective.root_mean_square",
        ),
        (PROBLEM.to_string() + "peak_force = 5400\n[objective]\nforce = \"core\"\n", "objective.force was \"contact\""),
        (PROBLEM.to_string() + "peak_force = 5400\n[prior]\nweight = 1\nyoungs_modulus = 1e6\n", "prior is another"),
    ] {
        problem(&text);
        let line = fail(folder, &continued, 2);
        assert!(line.contains("this is the log of another problem") && line.contains(difference), "{line}");
        assert!(line.contains("choose another folder by --out"), "{line}");
        assert_eq!(fs::read_to_string(folder.join("out/evaluations.csv")).unwrap(), log);
    }
    // The digest in the log stands for itself, without the file beside it.
    fs::remove_file(folder.join("out/problem.json")).unwrap();
    assert!(fail(folder, &continued, 2).contains("this is the log of another problem"));
    // Told to, the search starts anew.
    succeed(folder, &[&continued[..], &["--overwrite"]].concat());
    assert_ne!(fs::read_to_string(folder.join("out/evaluations.csv")).unwrap(), log);
}

/// A trace that was measured anew is another problem; a log that this program would not write is another program's.
#[test]
fn a_log_of_another_trace_or_program_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let text = PROBLEM.replace("table_1 = true", "trace = \"measured.csv\"");
    fs::write(folder.join("problem.toml"), text).unwrap();
    let measured = |force: u32| {
        fs::write(folder.join("measured.csv"), format!("time [s],force [N]\n0,0\n0.004,{force}\n0.008,0\n")).unwrap()
    };
    measured(5000);
    let log = search(folder, "out", "6", "1");
    let continued = ["calibrate", "problem.toml", "--out", "out", "--evaluations", "6", "--seed", "1"];
    measured(5001);
    assert!(fail(folder, &continued, 2).contains("impacts[0].trace was"));
    measured(5000);
    succeed(folder, &continued);
    let score = log.lines().nth(1).unwrap().split(',').nth(2).unwrap();
    fs::write(folder.join("out/evaluations.csv"), log.replacen(score, "1.25", 1)).unwrap();
    assert!(fail(folder, &continued, 2).contains("the log one of 1.25: it is of another version"));
}

#[test]
fn a_search_that_has_not_converged_says_so_and_tells_no_spread() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let summary = |out: &str| -> serde_json::Value {
        serde_json::from_str(&fs::read_to_string(folder.join(out).join("summary.json")).unwrap()).unwrap()
    };
    let text = succeed(folder, &["calibrate", "problem.toml", "--evaluations", "18", "--out", "short"]);
    assert!(text.contains("! Not converged: no descent ended") && text.contains("120 evaluations"), "{text}");
    assert!(text.contains("Spread: untold"), "{text}");
    let short = summary("short");
    assert_eq!(short["convergence"]["converged"], false);
    assert!(short["parameters"]["silicone.c10"]["spread"]["part"].is_null(), "{short}");
    let best = fs::read_to_string(folder.join("short/best.toml")).unwrap();
    assert!(best.starts_with("# The best of 18 evaluations") && best.contains("# ! Not converged"), "{best}");
    // One parameter is soon found, and found again.
    let one = PROBLEM.replace("\"geometry.length\" = { min = 0.06, max = 0.15 }\n", "");
    fs::write(folder.join("problem.toml"), one).unwrap();
    let text = succeed(folder, &["calibrate", "problem.toml", "--evaluations", "600", "--out", "long"]);
    assert!(text.contains("Converged: "), "{text}");
    let long = summary("long");
    assert_eq!(long["convergence"]["converged"], true);
    assert!(long["parameters"]["silicone.c10"]["spread"]["part"].as_f64().unwrap() > 0.0, "{long}");
}

/// The impact alone asks for a softer layer; a test of the material that counts enough decides, and the results say so.
#[test]
fn a_material_test_counts_beside_the_impacts() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let one = PROBLEM.replace("\"geometry.length\" = { min = 0.06, max = 0.15 }\n", "");
    let test = "[[material_test]]\nname = \"slow press\"\nquantity = \"shear_modulus\"\nstrain = 0.01\nvalue = 4.8e5\n\
                standard_deviation = 2e4\n";
    let problem = |weight: u32| {
        let text = format!("{one}{test}[objective]\nmaterial_weight = {weight}\n");
        fs::write(folder.join("problem.toml"), text).unwrap();
        let out = format!("out{weight}");
        let text = succeed(folder, &["calibrate", "problem.toml", "--evaluations", "120", "--out", &out]);
        let read = |name: &str| fs::read_to_string(folder.join(&out).join(name)).unwrap();
        let summary: serde_json::Value = serde_json::from_str(&read("summary.json")).unwrap();
        (text, read("best.toml"), summary)
    };
    let [free, bound] = [0, 1000].map(problem);
    let distance = |found: &(String, String, serde_json::Value)| {
        let test = &found.2["material_tests"][0];
        let (model, measured) = (test["model"].as_f64().unwrap(), test["measured"].as_f64().unwrap());
        let distance = test["distance"].as_f64().unwrap();
        assert!((distance - (model / measured).ln() * 24.0).abs() < 1e-9, "{test}");
        distance
    };
    assert!(distance(&free).abs() > 3.0 && distance(&bound).abs() < 0.3, "{} {}", distance(&free), distance(&bound));
    assert!(bound.0.contains("slow press") && bound.0.contains("0.480 +- 0.020"), "{}", bound.0);
    assert!(bound.1.contains("# slow press: 0.4") && bound.1.contains("measured 0.480 +- 0.020 MPa"), "{}", bound.1);
    // Another test is another problem.
    fs::write(folder.join("problem.toml"), one + &test.replace("0.01", "0.02")).unwrap();
    let line = fail(folder, &["calibrate", "problem.toml", "--out", "out0", "--evaluations", "120"], 2);
    assert!(line.contains("this is the log of another problem"), "{line}");
}

/// A search in a folder of its own for each weight, each as it would be alone.
#[test]
fn weights_of_the_material_tests_make_a_front() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let test = "[[material_test]]\nname = \"a\"\nquantity = \"shear_modulus\"\nstrain = 0.5\nvalue = 9e5\n\
                standard_deviation = 1e5\n";
    fs::write(folder.join("problem.toml"), format!("{PROBLEM}{test}")).unwrap();
    let search = ["calibrate", "problem.toml", "--evaluations", "12", "--out"];
    let text = succeed(folder, &[&search[..], &["front", "--material-weights", "0", "100"]].concat());
    assert!(text.contains("on the front"), "{text}");
    let csv = fs::read_to_string(folder.join("front/front.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(1).map(|line| line.split(',').map_while(|cell| cell.parse().ok()).collect()).collect();
    assert_eq!((rows.len(), rows[0][0], rows[1][0]), (2, 0.0, 100.0));
    // More weight leads nearer to the test.
    assert!(rows[1][3] < rows[0][3], "{csv}");
    assert!(fs::read_to_string(folder.join("front/front.svg")).unwrap().contains("distance from the material tests"));
    succeed(folder, &[&search[..], &["alone"]].concat());
    let alone = |path: &str| fs::read_to_string(folder.join(path)).unwrap();
    succeed(folder, &[&search[..], &["front", "--material-weights", "1"]].concat());
    assert_eq!(alone("alone/evaluations.csv"), alone("front/weight-1/evaluations.csv"));
    // Without a test there is nothing to weigh.
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let line = fail(folder, &[&search[..], &["none", "--material-weights", "1"]].concat(), 2);
    assert!(line.contains("no effect: no [[material_test]] counts"), "{line}");
}

#[test]
fn values_that_give_way_too_much_at_once_are_refused() {
    use softanvil_tools::calibration::{objective::evaluate, problem::Problem};
    let refusal = |least: &str| {
        let text = format!("{PROBLEM}[objective]\npoissons_ratio_at_once = {least}\n");
        Problem::parse(&text, Path::new(".")).map(|problem| evaluate(&problem, &[0.1, 2e5]).refusal)
    };
    // The preset's Prony term makes it 0.25.
    assert_eq!(refusal("0.1"), Ok(None));
    let told = refusal("0.3").unwrap().unwrap();
    assert!(told.contains("Poisson's ratio is 0.2") && told.contains("at least 0.3 is allowed"), "{told}");
    assert!(refusal("0.6").unwrap_err().contains("expected -1 to less than 0.5"));
}

/// What a printed number may have been rounded from costs nothing; the error that is reported stays.
#[test]
fn an_error_within_the_rounding_does_not_count() {
    use softanvil_tools::calibration::{objective::evaluate, problem::Problem};
    let impact = |rounding: bool, half: f64, objective: &str| {
        let text = PROBLEM.replace("table_1 = true", &format!("impulse = 15.0\nhalf_unit = {{ impulse = {half} }}"));
        let text = format!("{text}[objective]\nrounding = {rounding}\n{objective}");
        let problem = Problem::parse(&text, Path::new(".")).unwrap();
        let evaluation = evaluate(&problem, &[0.1, 1e5]);
        let error = evaluation.impacts[0].values[3] / 15.0 - 1.0;
        assert!((evaluation.mean_error - 100.0 * error.abs()).abs() < 1e-9);
        (evaluation.score, 100.0 * error.abs())
    };
    let (score, error) = impact(false, 0.5, "");
    assert!((score - error).abs() < 1e-9 && error > 1.0, "{error}");
    let beyond = 0.5 * error / 100.0 * 15.0;
    assert!((impact(true, beyond, "").0 - 0.5 * error).abs() < 1e-9);
    assert_eq!(impact(true, 2.0 * beyond + 1e-9, "").0, 0.0);
}

#[test]
fn a_best_value_on_a_bound_of_its_range_is_marked() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    // The impact asks for a softer layer than the range has.
    let bounded = PROBLEM
        .replace("min = 2e4, max = 4e5, scale = \"log\", start = 3e5", "min = 4e5, max = 8e5")
        .replace("\"geometry.length\" = { min = 0.06, max = 0.15 }\n", "");
    fs::write(folder.join("problem.toml"), bounded).unwrap();
    let text = succeed(folder, &["calibrate", "problem.toml", "--evaluations", "90", "--out", "out"]);
    assert!(
        text.contains("(lower bound)") && text.contains("! silicone.c10 = 400000 Pa lies on the lower bound"),
        "{text}"
    );
    let best = fs::read_to_string(folder.join("out/best.toml")).unwrap();
    assert!(best.contains("# ! silicone.c10 = 400000 Pa lies on the lower bound of its range"), "{best}");
    succeed(folder, &["run", "--scenario", "out/best.toml", "--json"]);
}

#[test]
fn files_of_others_are_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    for name in ["best.toml", "summary.json", "summary.txt", "problem.json", "evaluations.csv"] {
        fs::create_dir(folder.join("out")).unwrap();
        fs::write(folder.join("out").join(name), "mine\n").unwrap();
        let line = fail(folder, &["calibrate", "problem.toml", "--out", "out", "--evaluations", "6"], 2);
        assert!(line.contains(name), "{line}");
        assert_eq!(crate::common::entries(&folder.join("out")), [name]);
        assert_eq!(fs::read_to_string(folder.join("out").join(name)).unwrap(), "mine\n");
        fs::remove_dir_all(folder.join("out")).unwrap();
    }
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
    assert_eq!(count, 8);
}

/// The page is of the presets as they are: `calibration/run.sh` writes it anew.
#[test]
fn the_page_of_the_protocols_has_the_errors_of_the_presets() {
    let folder = tempfile::tempdir().unwrap();
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/protocols.md");
    let page = fs::read_to_string(page).unwrap();
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    let readme = fs::read_to_string(readme).unwrap().replace('\n', " ");
    for preset in ["study", "study-14.7", "study-incompressible"] {
        let found = crate::common::json(folder.path(), &["validate", "--preset", preset, "--json"]);
        let mean = found["mean_error_percent"].as_f64().unwrap();
        let row = page.lines().find(|line| line.starts_with(&format!("| preset `{preset}`"))).unwrap();
        assert_eq!(row.split('|').nth(3).unwrap().trim(), format!("{mean:.1}"), "{row}");
        let fitted = &found["fitted"];
        let fitted = format!("{} / {}", fitted["parameters"], fitted["numbers"]);
        assert_eq!(row.split('|').nth(2).unwrap().trim(), fitted, "{row}");
        match preset {
            "study" => assert!(readme.contains(&format!("the mean error of {mean:.1} %")), "{mean}"),
            "study-14.7" => assert!(readme.contains(&format!("a mean error of the twelve of {mean:.1} %")), "{mean}"),
            _ => {}
        }
    }
}

/// Ctrl-C: what was found is written and shown, and the exit code says that it is not all.
#[cfg(unix)]
#[test]
fn an_interrupted_search_shows_what_it_found_and_says_so_by_its_exit_code() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_softanvil"))
        .args(["calibrate", "problem.toml", "--out", "out", "--evaluations", "100000"])
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let done = || fs::read_to_string(folder.join("out/evaluations.csv")).map_or(0, |text| text.lines().count());
    while done() < 7 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(130), 0), "{text}");
    assert!(text.contains("Interrupted: the same command continues."), "{text}");
    assert!(folder.join("out/best.toml").exists());
}
