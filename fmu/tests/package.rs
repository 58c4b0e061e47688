//! Packaging, with the head of a library in place of one: the packager looks at no more.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use softanvil_fmu::{Error, Options, find_library, package};

/// A file that begins as a Linux library for x86-64 does.
fn library(folder: &Path, name: &str) -> PathBuf {
    let mut head = b"\x7fELF\x02\x01\x01".to_vec();
    head.resize(4096, 7);
    head[18..20].copy_from_slice(&62u16.to_le_bytes());
    let path = folder.join(name);
    fs::write(&path, head).unwrap();
    path
}

fn options(folder: &Path) -> Options {
    Options { libraries: vec![library(folder, "a.so")], out: folder.join("made/on demand") }
}

#[test]
fn two_builds_give_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let first = fs::read(package(&options(folder.path())).unwrap()).unwrap();
    let second = fs::read(package(&options(folder.path())).unwrap()).unwrap();
    assert!(first == second);
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
fn the_library_is_found_beside_the_program_or_the_error_says_how_to_get_it() {
    match find_library() {
        Ok(path) => assert!(path.is_file()),
        Err(error @ Error::LibraryNotFound { .. }) => assert!(error.to_string().contains("--library FILE"), "{error}"),
        Err(other) => panic!("{other}"),
    }
}
