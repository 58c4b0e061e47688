//! `softanvil reduction`: the section against the solid.

use serde_json::Value;
use tempfile::tempdir;

use crate::common::{fail, json, succeed};

/// Numbers that `docs/studies.md` states for the drop of 14.7 J, and that the parts of the comparison are what `run` gives.
#[test]
fn the_page_s_comparison_is_what_the_command_finds() {
    let folder = tempdir().unwrap();
    let found = json(folder.path(), &["reduction", "--json"]);
    let [case] = &found["cases"].as_array().unwrap()[..] else { panic!("one scenario, one case: {found}") };
    let alone = |set: &[&str]| json(folder.path(), &[&["run", "--json"], set].concat());
    assert_eq!(alone(&[])["trace_hash"], case["section"]["trace_hash"]);
    assert_eq!(alone(&["--set", "geometry.formulation=solid"])["trace_hash"], case["solid"]["trace_hash"]);
    let number = |value: &Value| value.as_f64().unwrap();
    let length = number(&case["effective_length"]);
    let shorter = alone(&["--set", &format!("geometry.length={length}")]);
    let peak = |of: &Value| number(&of["peak_force"]);
    assert!((peak(&shorter) / peak(&case["solid"]) - 1.0).abs() <= 1e-4, "{shorter}");
    let row = format!(
        "| energy (J) | 14.7 | {:.0} | {:.0} ({:+.1} %) |",
        peak(&case["solid"]),
        peak(&case["section"]),
        number(&case["section_difference_percent"]),
    );
    let page = include_str!("../../../docs/studies.md");
    let line =
        page.lines().find(|line| line.starts_with(&row)).unwrap_or_else(|| panic!("docs/studies.md lacks {row}"));
    assert!(line.ends_with(&format!("| {:.1} |", 1e3 * length)), "{line}: {length}");
}

#[test]
fn pictures_are_drawn_over_a_parameter_or_over_time() {
    let folder = tempdir().unwrap();
    let drawn = |arguments: &[&str], name: &str| {
        let coarse = ["--set", "mesh.element_size=0.0075", "--plot", name];
        let text = succeed(folder.path(), &[&["reduction"], arguments, &coarse].concat());
        assert!(text.ends_with(&format!("written: {name}\n")), "{text}");
        std::fs::read_to_string(folder.path().join(name)).unwrap()
    };
    let over_energy = drawn(&["impactor.drop_energy=12"], "energy.svg");
    assert!(over_energy.contains("impactor.drop_energy (J)") && over_energy.contains("max deformation"));
    let over_time = drawn(&[], "time.svg");
    assert!(over_time.contains("section") && over_time.contains("time since"));
    let there = fail(folder.path(), &["reduction", "--plot", "time.svg"], 2);
    assert!(there.contains("--overwrite"), "{there}");
}

/// A loose pad beside the middle, under a bar: the solid has half of it, as the section has both sides.
#[test]
fn a_full_section_with_a_loose_pad_is_half_a_solid() {
    let folder = tempdir().unwrap();
    let pad = "[geometry]\nsection = 'full'\n[impactor]\nshape = 'bar'\nface_diameter = 0.1\noffset = 0.005\n[mesh]\n\
               element_size = 0.0075\n[[layers]]\n[[layers]]\nname = 'pad'\nthickness = 0.008\nwidth = 0.1\n\
               interface = 'frictional'\n";
    std::fs::write(folder.path().join("pad.toml"), pad).unwrap();
    let of_section = succeed(folder.path(), &["reduction", "--scenario", "pad.toml"]);
    let solid = pad.replace("section = 'full'", "formulation = 'solid'\nsymmetry = 'half'");
    std::fs::write(folder.path().join("solid.toml"), solid).unwrap();
    let of_solid = succeed(folder.path(), &["reduction", "--scenario", "solid.toml"]);
    assert!(of_section.contains("peak force") && of_section == of_solid, "{of_section}\n{of_solid}");
}

/// A dome has no length; a coarse mesh is quick.
#[test]
fn several_cases_have_one_length_in_common_and_a_dome_has_none() {
    let folder = tempdir().unwrap();
    let coarse = |arguments: &[&str]| {
        succeed(folder.path(), &[&["reduction"], arguments, &["--set", "mesh.element_size=0.0075"]].concat())
    };
    let table = coarse(&["impactor.drop_energy=12"]);
    assert!(table.contains("impactor.drop_energy") && table.contains("the mean, brings the forces"), "{table}");
    let dome = coarse(&["--set", "geometry.formulation=axisymmetric"]);
    assert!(!dome.contains("geometry.length"), "{dome}");
}

#[test]
fn what_a_solid_does_not_have_is_refused_before_anything_is_simulated() {
    let folder = tempdir().unwrap();
    let beside = ["reduction", "--set", "geometry.formulation=solid", "--set", "impactor.offset=0.01"];
    let refused = fail(folder.path(), &beside, 2);
    assert!(refused.contains("expected 0 m with geometry.symmetry = quarter"), "{refused}");
    assert!(fail(folder.path(), &["reduction", "silicone.c10"], 2).contains("silicone.c10"));
}
