//! Packaging, with the head of a library and names of functions in place of one: the packager looks at no more.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use softanvil_fmu::{Options, Version, is_ours, package};

/// A file that begins as a Linux library for x86-64 does.
fn library(folder: &Path, name: &str) -> PathBuf {
    let mut head = b"\x7fELF\x02\x01\x01".to_vec();
    head.resize(4096, 7);
    head[18..20].copy_from_slice(&62u16.to_le_bytes());
    head.extend_from_slice(b"fmi2Instantiate\0fmi3InstantiateCoSimulation\0");
    let path = folder.join(name);
    fs::write(&path, head).unwrap();
    path
}

fn options(folder: &Path) -> Options {
    let libraries = vec![library(folder, "a.so")];
    Options { version: Version::Fmi2, libraries, out: folder.join("made/on demand") }
}

#[test]
fn two_builds_give_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    for version in [Version::Fmi2, Version::Fmi3] {
        let options = Options { version, ..options(folder.path()) };
        let first = fs::read(package(&options).unwrap()).unwrap();
        let second = fs::read(package(&options).unwrap()).unwrap();
        assert!(first == second);
    }
}

#[test]
fn an_fmu_of_ours_is_told_from_anything_else() {
    let folder = tempfile::tempdir().unwrap();
    for version in [Version::Fmi2, Version::Fmi3] {
        let options = Options { version, ..options(folder.path()) };
        assert!(!is_ours(&options.path()));
        assert_eq!(package(&options).unwrap(), options.path());
        assert!(is_ours(&options.path()));
        fs::write(options.path(), "mine").unwrap();
        assert!(!is_ours(&options.path()));
    }
}

#[test]
fn everything_is_in_its_place_and_nothing_is_left_over() {
    let folder = tempfile::tempdir().unwrap();
    let options = options(folder.path());
    let path = package(&options).unwrap();
    assert_eq!(fs::read_dir(&options.out).unwrap().count(), 1);
    let mut archive = zip::ZipArchive::new(fs::File::open(path).unwrap()).unwrap();
    for name in ["model.png", "documentation/index.html", "documentation/licenses/license.txt"] {
        assert!(archive.by_name(name).unwrap().size() > 0, "{name}");
    }
    let mut packed = Vec::new();
    archive.by_name("binaries/linux64/softanvil.so").unwrap().read_to_end(&mut packed).unwrap();
    assert!(packed == fs::read(&options.libraries[0]).unwrap());
}

#[test]
fn what_is_no_library_is_refused_and_the_old_fmu_stays() {
    let folder = tempfile::tempdir().unwrap();
    let good = options(folder.path());
    let before = fs::read(package(&good).unwrap()).unwrap();
    let script = folder.path().join("script.so");
    fs::write(&script, "#!/bin/sh\n").unwrap();
    let twice = vec![good.libraries[0].clone(), library(folder.path(), "b.so")];
    for libraries in [vec![script], vec![folder.path().join("missing.so")], vec![], twice] {
        assert!(package(&Options { libraries, ..good.clone() }).is_err());
    }
    assert!(fs::read(good.out.join("softanvil-fmi2.fmu")).unwrap() == before);
    assert_eq!(fs::read_dir(&good.out).unwrap().count(), 1);
}

#[test]
fn a_folder_that_cannot_be_written_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let error = package(&Options { out: file.join("under a file"), ..options(folder.path()) }).unwrap_err();
    assert!(error.to_string().contains("under a file") && error.to_string().contains("cannot be written"), "{error}");
}

#[test]
fn fmi_3_has_its_own_folders_and_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = package(&Options { version: Version::Fmi3, ..options(folder.path()) }).unwrap();
    let mut archive = zip::ZipArchive::new(fs::File::open(path).unwrap()).unwrap();
    for name in [
        "binaries/x86_64-linux/softanvil.so",
        "terminalsAndIcons/icon.png",
        "terminalsAndIcons/terminalsAndIcons.xml",
        "extra/org.fmi-standard.fmi-ls-ref/fmi-ls-manifest.xml",
    ] {
        assert!(archive.by_name(name).unwrap().size() > 0, "{name}");
    }
    let mut page = String::new();
    archive.by_name("documentation/index.html").unwrap().read_to_string(&mut page).unwrap();
    assert!(page.contains("surface.contact_pressure") && !page.contains("<!--"));
}

#[test]
fn terminals_name_variables_that_there_are() {
    let names: Vec<_> = softanvil::variables::Table::new().rows().iter().map(|v| v.name.to_string()).collect();
    let members = softanvil_fmu::terminals::xml();
    let named: Vec<_> = members.split("variableName=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert_eq!(named.len(), 3);
    assert!(named.iter().all(|name| names.iter().any(|known| known == name)), "{named:?}");
}

#[test]
fn reference_results_are_a_row_per_step_with_all_digits() {
    let results = String::from_utf8(softanvil_fmu::reference::results().unwrap()).unwrap();
    let rows: Vec<_> = results.lines().collect();
    assert_eq!(rows.len(), 1 + 301);
    let column = rows[0].split(',').position(|name| name == "result.peak_force").unwrap();
    let peak: f64 = rows[301].split(',').nth(column).unwrap().parse().unwrap();
    let mut simulation = softanvil_kernel::Simulation::new(&softanvil_kernel::preset::study()).unwrap();
    let steps = simulation.constants().steps_in(0.015);
    simulation.step(steps, &softanvil_kernel::StepInput::default()).unwrap();
    assert_eq!(peak.to_bits(), simulation.scalars().metrics.peak_force.to_bits());
}

#[test]
fn a_library_without_fmi_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let options = options(folder.path());
    let mut head = fs::read(&options.libraries[0]).unwrap();
    head.truncate(4096);
    head.extend_from_slice(b"fmi2InstantiatefmtfmI3, words of a program");
    fs::write(&options.libraries[0], head).unwrap();
    let refused = package(&options).unwrap_err().to_string();
    assert!(
        refused.ends_with("a.so is refused: expected a library of Softanvil, and it has no fmi2Instantiate"),
        "{refused}"
    );
    assert!(!options.path().exists());
}
