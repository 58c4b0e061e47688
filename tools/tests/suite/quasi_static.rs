//! The example of a slow press against a solution that is not ours.

use std::path::Path;

use crate::common::{column, fail, json, succeed};

/// Deflection, mm, and force of the layer on the length of 50 mm, N.
///
/// Source: biquadratic displacements with bilinear pressures (Taylor and Hood) in scikit-fem 12, 12 elements through the
/// layer and 57 along the half arc, in contact with a rigid frictionless plane at quadrature points; computed once by
/// `tests/verification/reference/layer.py`.
const REFERENCE: [(f64, f64); 5] = [(1.0, 97.82), (2.0, 305.51), (3.0, 620.20), (4.0, 1046.19), (5.0, 1595.27)];

/// The requirement is 1 %.
const AGREEMENT: f64 = 0.01;

fn example() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/quasi-static.toml").to_string_lossy().into_owned()
}

#[test]
fn the_slow_press_agrees_with_an_independent_solution() {
    let folder = tempfile::tempdir().unwrap();
    succeed(folder.path(), &["run", "--scenario", &example(), "--csv", "press.csv"]);
    let path = folder.path().join("press.csv");
    let (depth, force) = (column(&path, "impactor.deformation [m]"), column(&path, "contact.force [N]"));
    for (deflection, reference) in REFERENCE {
        let after = depth.iter().position(|d| *d >= 1e-3 * deflection - 1e-12).unwrap();
        let part = (1e-3 * deflection - depth[after - 1]) / (depth[after] - depth[after - 1]);
        let measured = force[after - 1] + part * (force[after] - force[after - 1]);
        let error = measured / reference - 1.0;
        assert!(error.abs() < AGREEMENT, "{deflection} mm: {measured} N against {reference} N");
    }
    let held: Vec<f64> = depth.iter().zip(&force).filter(|(d, _)| **d == 5e-3).map(|(_, f)| *f).collect();
    let mean = held.iter().sum::<f64>() / held.len() as f64;
    assert!((mean / REFERENCE[4].1 - 1.0).abs() < 0.3 * AGREEMENT, "{mean} N over {} samples of the hold", held.len());
    // Full digits: the face rests at the depth to the last bit, and reads back so.
    assert!(held.len() > 100);
}

/// Half the speed changes nothing that matters: the press is quasi-static.
#[test]
fn the_press_hardly_depends_on_its_speed() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(example()).unwrap().replace("element_size = 0.0015", "element_size = 0.003");
    let force = |speed: &str, rise: &str, duration: &str| {
        let text = text
            .replace("prescribed_speed = 0.05", &format!("prescribed_speed = {speed}"))
            .replace("prescribed_rise = 0.02", &format!("prescribed_rise = {rise}"))
            .replace("duration = 0.13", &format!("duration = {duration}"));
        std::fs::write(folder.path().join("press.toml"), text).unwrap();
        json(folder.path(), &["run", "--scenario", "press.toml", "--json"])["energy_external"].as_f64().unwrap()
    };
    let (fast, slow) = (force("0.1", "0.01", "0.06"), force("0.05", "0.02", "0.12"));
    assert!((fast / slow - 1.0).abs() < 1e-3, "work of {fast} J and {slow} J");
}

#[test]
fn an_energy_for_a_face_that_does_not_fall_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for option in ["--energy", "--height", "--speed"] {
        let line = fail(folder.path(), &["run", "--scenario", &example(), option, "1"], 2);
        assert_eq!(line, format!("{option} is refused: impactor.motion = prescribed does not fall; expected drop"));
    }
}
