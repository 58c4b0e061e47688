//! `softanvil protect` as its users meet it.

use tempfile::tempdir;

use crate::common::{entries, fail, json, run_page, succeed, svg_texts};

const SOFT: &str = "[pad]\nfoam_mu_1 = 5e4\nfoam_mu_2 = 1e3\n";
const STIFF: &str = "[pad]\nfoam_mu_1 = 3e5\nfoam_mu_2 = 5e3\n";

#[test]
fn a_pad_stands_beside_the_bare_anvil_and_takes_force_off() {
    let folder = tempdir().unwrap();
    let protect = ["protect", "--preset", "rugby-soft-anvil", "--out", "out"];
    let text = succeed(folder.path(), &protect);
    for part in ["bare", "padded", "peak transmitted force", "no limit known", "least peak", "largest stretch"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let files = entries(&folder.path().join("out"));
    assert_eq!(files, ["forces.svg", "protect.json", "sections.svg", "softanvil-files.json"]);
    let texts = svg_texts(&folder.path().join("out/forces.svg"));
    assert!(texts.contains(&"bare".into()) && texts.contains(&"pad".into()), "{texts:?}");

    let found = json(folder.path(), &[&protect[..3], &["--json"]].concat());
    let number = |outcome: &serde_json::Value, key: &str| outcome[key].as_f64().unwrap();
    let (bare, pad) = (&found["bare"], &found["pads"][0]);
    // The bare anvil is the study's own drop, on the mesh of the padded one.
    let study = json(folder.path(), &["run", "--set", "mesh.element_size=0.0053", "--json"]);
    assert!(number(pad, "peak_transmitted_force") < number(bare, "peak_transmitted_force"));
    let acceleration = number(bare, "peak_acceleration_g");
    assert!((acceleration - number(&study, "peak_force") / (5.0 * 9.80665)).abs() < 1e-9);
    let (energy, rest) = (number(pad, "impact_energy"), number(pad, "restitution"));
    assert!((number(pad, "absorbed_energy") - energy * (1.0 - rest * rest)).abs() < 1e-9);
    // The stack is pressed by as much as its layers, here in the middle, where the face goes.
    let layers = pad["layers"].as_array().unwrap();
    let pressed: f64 = layers.iter().zip([15e-3, 10e-3]).map(|(layer, t)| t * number(layer, "max_compression")).sum();
    assert!((pressed / number(pad, "max_deformation") - 1.0).abs() < 0.1, "{pressed}");
    assert_eq!(pad["verdict"]["verdict"], "no_limit_known");
}

#[test]
fn foams_and_thicknesses_are_compared_in_one_table_and_a_picture() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("soft.toml"), SOFT).unwrap();
    std::fs::write(folder.path().join("stiff.toml"), STIFF).unwrap();
    let protect = ["protect", "--preset", "rugby-soft-anvil", "--compare", "soft.toml", "stiff.toml"];
    let thicknesses = ["--thickness", "6mm", "10mm", "--out", "out", "--pictures", "svg"];
    let text = succeed(folder.path(), &[&protect[..], &thicknesses].concat());
    let rows = |name: &str| text.lines().filter(|line| line.starts_with(&format!("{name} "))).count();
    assert_eq!((rows("bare"), rows("soft"), rows("stiff")), (1, 2, 2), "{text}");
    let labels = svg_texts(&folder.path().join("out/thickness.svg"));
    assert!(labels.contains(&"soft".into()) && labels.contains(&"pad thickness (mm)".into()), "{labels:?}");
    // A thicker pad takes more force off.
    let found = json(folder.path(), &[&protect[..], &thicknesses[..3], &["--json"]].concat());
    let peaks: Vec<f64> =
        found["pads"].as_array().unwrap().iter().map(|p| p["peak_transmitted_force"].as_f64().unwrap()).collect();
    assert!(peaks.len() == 4 && peaks[0] > peaks[1] && peaks[2] > peaks[3], "{peaks:?}");
    // Without several thicknesses the picture of them goes.
    succeed(folder.path(), &[&protect[..], &["--out", "out"]].concat());
    assert!(!folder.path().join("out/thickness.svg").exists());
}

#[test]
fn limits_of_a_standard_are_met_or_not_and_hold_for_its_test_alone() {
    let folder = tempdir().unwrap();
    let verdict = |more: &[&str]| {
        let found = json(folder.path(), &[&["protect", "--preset", "en1621-1", "--json"], more].concat());
        let pad = found["pads"][0].clone();
        (pad["verdict"]["verdict"].as_str().unwrap().to_string(), pad)
    };
    let (met, pad) = verdict(&[]);
    assert!(met == "pass" && pad["peak_transmitted_force"].as_f64().unwrap() < 20e3, "{pad}");
    assert_eq!(pad["verdict"]["level"], "level 2");
    let (other, pad) = verdict(&["--energy", "60"]);
    assert_eq!((other.as_str(), pad["verdict"]["changed"].as_array().unwrap().len()), ("other_test", 1));
    let (other, pad) = verdict(&["--set", "geometry.core_radius=0.06"]);
    assert_eq!(other, "other_test");
    assert_eq!(pad["verdict"]["changed"][0], "geometry.core_radius = 0.06 instead of 0.05");
    // The mesh is none of the test's.
    assert_eq!(verdict(&["--set", "mesh.element_size=0.004"]).0, "pass");
    let text = succeed(folder.path(), &["protect", "--preset", "en13061"]);
    assert!(text.contains("FAIL") && text.contains("second-hand") && text.contains("Assumed"), "{text}");
}

#[test]
fn what_is_no_comparison_of_pads_is_refused() {
    let folder = tempdir().unwrap();
    std::fs::write(folder.path().join("heavy.toml"), "[impactor]\nmass = 4\n").unwrap();
    let protect = ["protect", "--preset", "rugby-soft-anvil"];
    let line = fail(folder.path(), &[&protect[..], &["--compare", "heavy.toml"]].concat(), 2);
    assert!(line.starts_with("heavy.toml changes the anvil or the impactor"), "{line}");
    let line = fail(folder.path(), &[&protect[..], &["--thickness", "0mm"]].concat(), 2);
    assert!(line.contains("--thickness"), "{line}");
    assert!(fail(folder.path(), &[&protect[..], &["--thickness", "5"]].concat(), 2).contains("mm"));
    std::fs::create_dir(folder.path().join("out")).unwrap();
    std::fs::write(folder.path().join("out/forces.svg"), "mine").unwrap();
    assert!(fail(folder.path(), &[&protect[..], &["--out", "out"]].concat(), 2).contains("forces.svg is there"));
}

#[test]
fn the_walk_through_of_the_documentation_runs() {
    assert!(run_page("pads.md") > 3);
}

#[test]
fn the_drops_of_the_validation_run() {
    assert!(run_page("validation.md") > 1);
}
