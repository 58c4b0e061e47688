//! The tutorial, whose data are made by commands that stand in it.

use std::path::Path;

use crate::common::{read_csv, run_page, succeed};

#[test]
fn the_tutorial_runs() {
    assert_eq!(run_page("tutorial.md"), 10);
}

/// The drops in the repository are those that the last commands of the page make, but for a line that says so.
#[test]
fn the_drops_of_the_tutorial_are_what_its_commands_make() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let page = std::fs::read_to_string(root.join("docs/tutorial.md")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let data = |name: &str| root.join(format!("data/treloar/{name}.csv")).to_string_lossy().into_owned();
    let [uniaxial, planar, equibiaxial] = ["uniaxial", "planar", "equibiaxial"].map(data);
    let tests = ["--uniaxial", &uniaxial, "--planar", &planar, "--equibiaxial", &equibiaxial];
    succeed(folder.path(), &[&["fit"][..], &tests, &["--density", "930", "--out", "rubber"]].concat());
    let (_, made) = page.split_once("## How the drops were made").unwrap();
    let (_, commands) = made.split_once("```sh\n").unwrap();
    let (commands, _) = commands.split_once("\n```").unwrap();
    for command in commands.replace("\\\n", " ").lines() {
        let words: Vec<&str> = command.split_whitespace().skip(1).collect();
        succeed(folder.path(), &words);
        let name = words.last().unwrap();
        let kept = std::fs::read_to_string(root.join("data/tutorial").join(name)).unwrap();
        let (about, kept) = kept.split_once('\n').unwrap();
        assert!(about.starts_with("# ") && about.contains("docs/tutorial.md"), "{about}");
        let copy = folder.path().join("kept.csv");
        std::fs::write(&copy, kept).unwrap();
        let (made, kept) = (read_csv(&folder.path().join(name)), read_csv(&copy));
        assert_eq!(made.0, kept.0);
        for (made, kept) in made.1.iter().flatten().zip(kept.1.iter().flatten()) {
            // The errors of the load cell are not of the kernel: their last bits may be others elsewhere.
            assert!((made - kept).abs() <= 1e-9 * made.abs().max(1.0), "{name}: {made} and {kept}");
        }
    }
}
