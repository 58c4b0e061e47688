//! The golden traces: current, reproduced, and able to fail.

use std::path::Path;

use softanvil_golden::{Checker, Memory, Run, SCENES, Scene};
use tempfile::TempDir;

use crate::common::{fail, succeed};

/// What is built here, with another profile than the traces were written with, gives their bits.
#[test]
fn every_scene_gives_the_bits_of_its_trace() {
    let text = succeed(Path::new("."), &["golden", "check"]);
    for scene in SCENES {
        assert!(text.contains(scene.name), "{text}");
    }
    let count = SCENES.len();
    assert!(text.contains(&format!("\nkernel digest {:016x}\n", softanvil_kernel::KERNEL_DIGEST)), "{text}");
    assert!(text.ends_with(&format!("{count} of {count} scenes have the bits of their golden trace\n")), "{text}");
}

/// The files are what the command writes, comments included, and there is none beside them.
#[test]
fn the_files_are_what_the_command_writes() {
    let folder = TempDir::new().unwrap();
    succeed(folder.path(), &["golden", "write", "."]);
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/golden/traces");
    for scene in SCENES {
        let name = format!("{}.txt", scene.name);
        let [written, kept] = [folder.path(), &kept].map(|folder| std::fs::read_to_string(folder.join(&name)).unwrap());
        assert_eq!(written, kept, "{name}; `softanvil golden write tests/golden/traces` renews it");
    }
    // And the folder of the traces in single precision.
    assert_eq!(std::fs::read_dir(kept).unwrap().count(), SCENES.len() + 1);
}

/// Traces are written over traces, and over nothing else.
#[test]
fn a_file_that_is_no_trace_is_left_alone() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("yeoh.txt");
    succeed(folder.path(), &["golden", "write", ".", "yeoh"]);
    succeed(folder.path(), &["golden", "write", ".", "yeoh"]);
    std::fs::write(&path, "mine").unwrap();
    assert!(fail(folder.path(), &["golden", "write", ".", "yeoh"], 2).contains("yeoh.txt is refused"));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    succeed(folder.path(), &["golden", "write", ".", "yeoh", "--overwrite"]);
    assert_ne!(std::fs::read_to_string(&path).unwrap(), "mine");
}

#[test]
fn an_unknown_scene_is_refused() {
    let error = fail(Path::new("."), &["golden", "check", "drop"], 2);
    assert!(error.starts_with("scene drop is unknown: expected drop-14.7-J, "), "{error}");
}

/// A single bit in a single number of the state is found at the next record.
#[test]
fn one_changed_bit_is_found() {
    let scene = Scene::find("yeoh").unwrap();
    let mut memory = Box::new(Memory::new());
    let mut run = Run::new(scene, &mut memory).unwrap();
    let mut checker = Checker::new(scene.trace);
    assert_eq!(checker.check(&run.record()), Ok(()));
    for _ in 0..8 {
        let record = run.advance().unwrap().unwrap();
        assert_eq!(checker.check(&record), Ok(()));
    }
    let middle = run.state.displacement()[0].len() / 2;
    let [x, _] = run.state.displacement_mut();
    x[middle] = f64::from_bits(x[middle].to_bits() ^ 1);
    let record = run.advance().unwrap().unwrap();
    let difference = checker.check(&record).unwrap_err();
    assert_eq!(difference.found.step, record.step);
    assert_ne!(difference.quantity, "step");
}

/// Each scene does what it is there for, so that its bits depend on it.
#[test]
fn scenes_reach_what_they_are_there_for() {
    let mut memory = Box::new(Memory::new());
    for scene in SCENES {
        let mut run = Run::new(scene, &mut memory).unwrap();
        let mut contact = 0.0_f64;
        while let Some(record) = run.advance().unwrap() {
            contact = contact.max(record.force);
        }
        // The solid is a small one.
        let least = if scene.name == "solid" { 50.0 } else { 100.0 };
        assert!(contact > least, "{}: contact {contact} N", scene.name);
        let energy = &run.state.scalars.energy;
        assert!(energy.friction > 0.0, "{}: friction", scene.name);
        let material = &run.model.constants.scenario.layers[0].material;
        let viscous = run.model.constants.n_history_entry() > 0;
        assert_eq!(energy.viscous > 0.0, viscous, "{}: viscous", scene.name);
        assert_eq!(energy.slider_dissipation > 0.0, material.slider_stiffness > 0.0, "{}: slider", scene.name);
        assert_eq!(energy.tear > 0.0, scene.name == "two-layers", "{}: tear", scene.name);
    }
}

/// The code of the kernel, without comments and unit tests, has nothing of the standard library, and `libm` in two files alone.
/// Which functions it may not call is said by type, in `kernel/clippy.toml`.
#[test]
fn the_kernel_keeps_to_the_rules() {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../kernel/src")];
    let mut files = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if name != "tests.rs" {
                let text = std::fs::read_to_string(&path).unwrap();
                let code = text.lines().take_while(|line| !line.starts_with("#[cfg(test)]"));
                for line in code.filter(|line| !line.trim_start().starts_with("//")) {
                    assert!(!line.contains(" std::"), "{name}: {line}");
                    let transcendental = line.contains("libm::") && !["math.rs", "real.rs"].contains(&name.as_str());
                    assert!(!transcendental, "{name}: {line}");
                }
                files += 1;
            }
        }
    }
    assert!(files > 40, "{files}");
}

/// Files and tests that the contract names in code type exist; a test follows the file that holds it.
#[test]
fn the_contract_names_what_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = std::fs::read_to_string(root.join("DETERMINISM.md")).unwrap();
    let names: Vec<&str> = text.split('`').skip(1).step_by(2).collect();
    let mut file = String::new();
    let mut tests = 0;
    for name in &names {
        let is_path = name.contains('/') || name.ends_with(".sh") || name.ends_with(".md") || name.ends_with(".toml");
        if is_path {
            let path = root.join(name);
            assert!(path.exists(), "{name}");
            file = std::fs::read_to_string(path).unwrap_or_default();
        } else if name.contains('_') && !name.contains(' ') {
            assert!(file.contains(&format!("fn {name}()")), "{name}");
            tests += 1;
        }
    }
    assert!(tests > 0 && names.contains(&"softanvil golden check"), "{names:?}");
    let script = std::fs::read_to_string(root.join("tests/targets/run.sh")).unwrap();
    for row in ["aarch64", "riscv64", "s390x", "Windows", "wasm32", "x87 is refused", "Cortex-M7"] {
        assert!(text.contains(row) && script.contains(row), "{row}");
    }
}
