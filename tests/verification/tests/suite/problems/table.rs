//! The committed table is current: `docs/verification.md` holds the rows as they come out now.

use softanvil_verification::table::{long_rows, markdown, markdown_checks, regular_rows, single_checks};

/// Every line of `current` stands under `heading` of the page, and no other line of a table does.
fn check(heading: &str, current: &str) {
    let page = include_str!("../../../../../docs/verification.md");
    let section = page.split("\n## ").find(|section| section.starts_with(heading)).expect("the heading");
    let committed: Vec<&str> = section.lines().filter(|line| line.starts_with('|')).collect();
    let current: Vec<&str> = current.lines().collect();
    assert_eq!(committed, current, "docs/verification.md, {heading}");
}

#[test]
fn materials_patch_test_and_impactor_are_current() {
    check("Materials through one element", &markdown_checks(&single_checks()));
}

#[test]
fn regular_meshes_are_current() {
    check("Regular meshes", &markdown(&regular_rows()));
}

#[test]
fn long_studies_are_current() {
    check("Long studies", &markdown(&long_rows()));
}
