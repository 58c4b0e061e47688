//! `docs/studies.md` is current: a line of it comes out as it stands there, to the depths that cost little.

use softanvil_verification::problems::reduction::{BULK_MODULI, DEPTHS, SIZES, label, line, ratios};

#[test]
fn a_line_of_the_studies_is_current() {
    let page = include_str!("../../../../../docs/studies.md");
    let (bulk_modulus, size) = (BULK_MODULI[1], SIZES[0]);
    let current = line(&label(bulk_modulus, size), &ratios(bulk_modulus, size, &DEPTHS[..2]));
    let stands = page.lines().any(|line| line.starts_with(&current));
    assert!(stands, "docs/studies.md lacks a line that begins with {current}");
}
