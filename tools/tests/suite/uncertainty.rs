//! `softanvil calibrate --uncertainty` and `softanvil run --uncertainty`, as a user calls them.

mod coverage;

use std::fs;
use std::path::Path;

use serde_json::Value;
use softanvil_kernel::preset::PRESETS;
use softanvil_tools::calibration::uncertainty::posterior::Posterior;
use softanvil_tools::calibration::uncertainty::predict::expect;
use softanvil_tools::calibration::uncertainty::shipped;
use softanvil_tools::measurement::reading::Reading;
use softanvil_tools::run::Until;

use crate::common::{fail, json, succeed};

/// One parameter, on a coarse mesh: a search that converges at once.
const PROBLEM: &str = r#"
[search]
evaluations = 400

[fixed]
"mesh.element_size" = 7.5e-3
"time.duration" = 0.01

[parameters]
"silicone.c10" = { min = 2e4, max = 4e5, scale = "log", start = 3e5 }

[uncertainty]
samples = 60

[[impact]]
energy = 14.7
table_1 = true
"#;

const MESH: [&str; 2] = ["--set", "mesh.element_size=7.5e-3"];

fn calibrate(folder: &Path, out: &str, threads: &str) -> String {
    succeed(folder, &["calibrate", "problem.toml", "--uncertainty", "--out", out, "--threads", threads])
}

fn file(folder: &Path, path: &str) -> String {
    fs::read_to_string(folder.join(path)).unwrap()
}

#[test]
fn a_posterior_is_the_same_for_any_threads_and_after_an_interruption_and_predicts() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM).unwrap();
    let text = calibrate(folder, "one", "1");
    assert!(
        text.contains("posterior of") && text.contains("R-hat") && text.contains("Written: posterior.json"),
        "{text}"
    );
    assert!(text.contains(&file(folder, "one/summary.txt")), "{text}");
    let posterior = file(folder, "one/posterior.json");
    // As an end in the middle leaves it: half of the simulations, the last line cut off.
    let runs = file(folder, "one/uncertainty.csv");
    fs::create_dir(folder.join("three")).unwrap();
    fs::write(folder.join("three/evaluations.csv"), file(folder, "one/evaluations.csv")).unwrap();
    fs::write(folder.join("three/uncertainty.csv"), &runs[..runs.len() / 2]).unwrap();
    calibrate(folder, "three", "3");
    assert_eq!(file(folder, "three/posterior.json"), posterior);
    assert_eq!(file(folder, "three/uncertainty.csv").lines().count(), runs.lines().count());

    let summary: Value = serde_json::from_str(&file(folder, "one/summary.json")).unwrap();
    let c10 = &summary["uncertainty"]["marginals"]["silicone.c10"];
    let [low, best, high] = [&c10["low"], &summary["parameters"]["silicone.c10"]["value"], &c10["high"]];
    let [low, best, high] = [low, best, high].map(|value| value.as_f64().unwrap());
    assert!(low < high && low < 1.5 * best && high > best / 1.5, "{low} {best} {high}");

    // The bands of the impact that the posterior was inferred from are those of the file, and the picture has one.
    let run =
        [&["run", "--uncertainty", "one/posterior.json", "--duration", "0.01", "--json", "--plot", "a.svg"][..], &MESH];
    let run = json(folder, &run.concat());
    let stored = &Posterior::read(&folder.join("one/posterior.json")).unwrap().impacts[0];
    for (key, band) in ["peak_force", "max_deformation"].into_iter().zip(stored.measured) {
        let found = run["bands"]["measured"][key]["median"].as_f64().unwrap();
        assert!((found / band.median - 1.0).abs() < 1e-4, "{key}: {found} {band:?}");
        let inner = &run["bands"]["parameters"][key];
        assert!(inner["low"].as_f64().unwrap() > band.low && inner["high"].as_f64().unwrap() < band.high, "{run}");
    }
    assert!(file(folder, "a.svg").contains("90 % band"));
    let few = [&["run", "--uncertainty", "one/posterior.json", "--samples", "20"][..], &MESH].concat();
    assert!(succeed(folder, &few).contains("By 20 samples of the posterior"));

    for (arguments, message) in [
        (&["run", "--uncertainty", "one/posterior.json"][..], "mesh.element_size is 3.000e-3 m here and 7.500e-3 m"),
        (&["run", "--preset", "elastic", "--uncertainty", "one/posterior.json"], "the posterior is of another drop"),
        (
            &["run", "--uncertainty", "one/posterior.json", "--set", "silicone.c10=5e6"],
            "silicone.c10 = 5000000 Pa here, and ",
        ),
        (
            &["run", "--uncertainty", "one/posterior.json", "--set", "silicone.density=1200", MESH[0], MESH[1]],
            "layers[0].density is 1200 kg/m3 here and 1072 kg/m3 in the posterior",
        ),
    ] {
        let line = fail(folder, arguments, 2);
        assert!(line.contains(message), "{line}");
    }
}

#[test]
fn without_convergence_there_is_no_posterior() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("problem.toml"), PROBLEM.replace("evaluations = 400", "evaluations = 12")).unwrap();
    let text = calibrate(folder, "out", "0");
    assert!(text.contains("! No posterior: the search has not converged"), "{text}");
    assert!(!folder.join("out/posterior.json").exists());
    let summary: Value = serde_json::from_str(&file(folder, "out/summary.json")).unwrap();
    assert!(summary["uncertainty"]["refused"].as_str().unwrap().contains("not converged"), "{summary}");
}

#[test]
fn wrong_input_is_refused_with_what_is_legal() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let text = shipped::of(&PRESETS[0]).unwrap().text();
    let mut short: Value = serde_json::from_str(&text).unwrap();
    short["samples"][3].as_array_mut().unwrap().pop();
    let mut outside: Value = serde_json::from_str(&text).unwrap();
    outside["samples"][0][0] = 1e12.into();
    let mut none: Value = serde_json::from_str(&text).unwrap();
    none["samples"] = Vec::<f64>::new().into();
    for (content, message) in [
        (String::new(), "the file is empty: expected a posterior"),
        ("{}".into(), "this is no posterior: missing field"),
        ("c10,c20\n1,2\n".into(), "this is no posterior"),
        (none.to_string(), "samples is empty"),
        (short.to_string(), "sample 4 has"),
        (outside.to_string(), "is refused: expected"),
        (text.replace("softanvil calibrate --uncertainty", "another program"), "generator = "),
        (text.replace("silicone.prony_tau_1", "silicone.prony_tau_9"), "silicone.prony_tau_9 is unknown"),
    ] {
        fs::write(folder.join("p.json"), &content).unwrap();
        let line = fail(folder, &["run", "--uncertainty", "p.json"], 2);
        assert!(line.contains(message) && line.contains("p.json"), "{message}: {line}");
    }
    for (arguments, message) in [
        (&["run", "--preset", "elastic", "--uncertainty"][..], "preset elastic has no posterior (with one: study)"),
        (&["run", "--uncertainty", "none.json"], "none.json: "),
        (&["run", "--samples", "30"], "--uncertainty"),
        (&["run", "--uncertainty", "--samples", "3"], "3 is not in 20..=2000"),
        (&["run", "--uncertainty", "--set", "impactor.motion=prescribed"], "has no impact; expected drop"),
    ] {
        let line = fail(folder, arguments, 2);
        assert!(line.contains(message), "{message}: {line}");
    }
    for (section, message) in [
        ("samples = 3", "uncertainty.samples = 3 samples is refused: expected 50 to 2000 samples"),
        ("noise = { peak_force = 2.0 }", "uncertainty.noise.peak_force = 2 1 is refused: expected 0.000001 to 1 1"),
        ("discrepancy = { peak = 0.1 }", "uncertainty.discrepancy: peak is unknown; expected peak_force"),
        ("rounding = { impulse = -1.0 }", "uncertainty.rounding.impulse = -1 N.s is refused"),
        ("prior_deviation = 0.0", "uncertainty.prior_deviation = 0 1 is refused"),
    ] {
        fs::write(folder.join("problem.toml"), PROBLEM.replace("samples = 60", section)).unwrap();
        let line = fail(folder, &["calibrate", "problem.toml", "--uncertainty"], 2);
        assert!(line.contains(message), "{message}: {line}");
    }
    // An impact of a trace alone has no number with a stated error.
    fs::write(folder.join("tr.csv"), "time [s],force [N]\n0,0\n0.004,5000\n0.008,0\n").unwrap();
    fs::write(folder.join("problem.toml"), PROBLEM.replace("table_1 = true", "trace = \"tr.csv\"")).unwrap();
    let line = fail(folder, &["calibrate", "problem.toml", "--uncertainty"], 2);
    assert!(line.contains("the impact of 14.7 J has a trace alone: give some of peak_force"), "{line}");
}

/// The shipped posterior is of the preset as it is, and its bands are what its samples give today.
#[test]
fn the_shipped_posterior_belongs_to_its_preset_and_its_bands_follow() {
    let preset = &PRESETS[0];
    let posterior = shipped::of(preset).unwrap();
    let scenario = (preset.scenario)();
    let variables = posterior.check_belongs(&scenario).unwrap();
    let samples = posterior.samples(posterior.count());
    assert_eq!(posterior.impacts.len(), 3);
    for stored in &posterior.impacts {
        let mut scenario = scenario.clone();
        scenario.impactor = scenario.impactor.with_energy(stored.energy);
        let errors = posterior.errors();
        let now = expect(&scenario, Until::Over, Reading::PLAIN, &variables, (&errors, &samples), &|| {}).unwrap();
        let bands = |expected: &softanvil_tools::measurement::band::Expected| {
            let all = expected.parameters.iter().chain(&expected.measured);
            all.flat_map(|band| [band.low, band.median, band.high]).collect::<Vec<_>>()
        };
        for (a, b) in bands(&now).into_iter().zip(bands(stored)) {
            assert!((a / b - 1.0).abs() < 1e-4, "{} J: {a} now, {b} stored", stored.energy);
        }
        assert_eq!(now.force.high.len(), stored.force.high.len());
    }
}

#[test]
fn the_report_has_bands_and_says_what_lies_outside() {
    let folder = tempfile::tempdir().unwrap();
    let text = succeed(folder.path(), &[]);
    assert!(text.contains("90 % band of") && text.contains("with misfit"), "{text}");
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("The restitution that the impulses imply goes from 0.50 at 4.9 J to 0.29 at 14.7 J"),
        "{words}"
    );
    for name in ["force-time.svg", "report.html"] {
        let content = file(folder.path(), &format!("softanvil-report/{name}"));
        assert!(content.contains(if name == "report.html" { "restitution that the" } else { "90 % band" }), "{name}");
    }
    let summary: Value = serde_json::from_str(&file(folder.path(), "softanvil-report/summary.json")).unwrap();
    let bands = &summary["validation"]["cases"][0]["bands"]["measured"]["peak_force"];
    assert!(bands["low"].as_f64() < bands["high"].as_f64(), "{bands}");
}
