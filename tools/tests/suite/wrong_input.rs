//! Wrong input: one clear line, exit code 2, nothing written.

use crate::common::{entries, fail};

/// Arguments, and what the line must tell.
const REFUSED: &[(&[&str], &[&str])] = &[
    (&["run", "--energy", "-1"], &["impactor.drop_energy = -1 J", "0 to 100000 J"]),
    (&["run", "--energy", "NaN"], &["impactor.drop_energy = NaN J", "0 to 100000 J"]),
    (&["run", "--energy", "inf"], &["impactor.drop_energy = inf J"]),
    (&["run", "--energy", "high"], &["high", "--energy <J>"]),
    (&["run", "--height", "-0.1"], &["impactor.drop_height = -0.1 m", "0 to 100 m"]),
    (&["run", "--speed", "101"], &["impactor.drop_speed = 101 m/s", "0 to 100 m/s"]),
    (&["run", "--duration", "0"], &["time.duration = 0 s", "0.00005 to 100 s"]),
    (&["run", "--energy", "1", "--height", "1"], &["--energy <J>", "--height <M>"]),
    (&["run", "--speed", "1", "--height", "1"], &["--speed <M_PER_S>", "--height <M>"]),
    (&["run", "--preset", "studdy"], &["studdy", "study"]),
    (&["validate", "--preset", "none"], &["none", "study"]),
    (&["scenario", "--preset", ""], &["--preset <NAME>", "study"]),
    (
        &["run", "--set", "silicone.thickness=0.01", "--set", "layers[0].thickness=0.02"],
        &["--set layers[0].thickness=0.02: silicone.thickness and layers[0].thickness state the same thing"],
    ),
    (&["run", "--set", "silicone.c10=1e5", "--set", "silicone.c10=2e5"], &["silicone.c10 is given twice"]),
    (
        &["run", "--set", "impactor.drop_energy=5", "--energy", "9.8"],
        &["impactor.drop_energy and --energy state the same thing: expected one of them"],
    ),
    (&["run", "--scenario", "missing.toml"], &["missing.toml"]),
    (&["run", "--scenario", "."], &["."]),
    (&["run", "--plot", "force.jpg"], &["force.jpg", ".svg or .png"]),
    (&["run", "--csv", "a.svg", "--plot", "a.svg"], &["a.svg", "--csv"]),
    (&["--out", "a", "validate"], &["--out <DIR>"]),
    (&["run", "--unknown"], &["--unknown"]),
    (&["drop"], &["drop"]),
    (&["run", "--impacts", "2", "--rest", "-1"], &["'-1'", "--rest <S>", "expected 0 to 1000000000 s"]),
    (&["run", "--impacts", "2", "--rest", "NaN"], &["'NaN'", "--rest <S>", "expected 0 to 1000000000 s"]),
    (&["golden"], &["golden", "check, write"]),
    (&["--out"], &["--out <DIR>"]),
    (&["--out", ".."], &["..", "name of a folder"]),
    (&["--out", "missing/report"], &["missing/report", "there is no folder missing"]),
];

#[test]
fn refused_arguments_name_themselves_and_what_is_legal() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, wanted) in REFUSED {
        let line = fail(folder.path(), arguments, 2);
        for part in *wanted {
            assert!(line.contains(part), "{arguments:?}: {line}");
        }
        assert!(entries(folder.path()).is_empty(), "{arguments:?}");
    }
}

#[test]
fn refused_files_name_file_and_line_and_leave_no_output() {
    let folder = tempfile::tempdir().unwrap();
    for (content, wanted) in [
        ("[impactor]\nmas = 5", "bad.toml: line 2: impactor.mas is unknown (did you mean impactor.mass?)"),
        (
            "[mesh]\nelement_size = nan",
            "bad.toml: line 2: mesh.element_size = NaN m is refused: expected 0.00001 to 0.1 m",
        ),
        ("[mesh]\nelement_size = 1e-5", "mesh.element_size"),
        ("[impactor]\nmotion = \"driven\"", "impactor.motion = driven"),
        (
            "[impactor]\nprescribed_speed = 0",
            "impactor.prescribed_speed = 0 m/s is refused: expected 0.000001 to 100 m/s",
        ),
        ("[silicone]\nprony_g_1 = 0.9\nprony_g_2 = 0.9", "bad.toml: layers[0].prony_g_1"),
        ("[time]\nstep_by = \"given\"\nstep = 4.9e-5", "time.step"),
        ("not TOML", "bad.toml: line 1: "),
    ] {
        std::fs::write(folder.path().join("bad.toml"), content).unwrap();
        let line = fail(folder.path(), &["run", "--scenario", "bad.toml", "--csv", "a.csv", "--plot", "a.svg"], 2);
        assert!(line.contains(wanted), "{content}: {line}");
        assert_eq!(entries(folder.path()), ["bad.toml"]);
    }
}

/// Refused before anything is built.
#[test]
fn an_fmu_does_not_replace_what_is_none() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("softanvil-fmi2.fmu"), "mine").unwrap();
    let line = fail(folder.path(), &["fmu", "--fmi", "2"], 2);
    assert!(line.contains("softanvil-fmi2.fmu is refused: the file is there; --overwrite replaces it"), "{line}");
    assert_eq!(std::fs::read_to_string(folder.path().join("softanvil-fmi2.fmu")).unwrap(), "mine");
}

#[test]
fn a_file_that_cannot_be_written_keeps_the_others_back() {
    let folder = tempfile::tempdir().unwrap();
    for picture in ["missing/drop.svg", "folder.svg"] {
        let _ = std::fs::create_dir(folder.path().join("folder.svg"));
        let arguments = ["run", "--duration", "0.001", "--csv", "trace.csv", "--plot", picture];
        let line = fail(folder.path(), &arguments, 1);
        assert!(line.starts_with(&format!("{picture} cannot be written: ")), "{line}");
        assert!(!line.contains(".softanvil-"), "{line}");
        assert_eq!(line.ends_with(": there is no folder missing"), picture.starts_with("missing/"), "{line}");
        assert_eq!(entries(folder.path()), ["folder.svg"]);
    }
}
