//! The table of the verification problems, `docs/verification.md`.

use std::fmt::Write;

use crate::problems::{
    bar_wave, bonded_strip, checkerboard, closed_forms, contact_convergence, cook, coulomb_block, cylinder, foam,
    harmonic, hertz, impactor, indentation, interface, lame, maxwell, patch, patch_distorted, slider, softening,
    solid_block, solid_checkerboard, solid_cook, solid_lame, solid_press, solid_section, solid_swing, swinging_plate,
    tear, viscoelastic, volumetric,
};
use crate::row::{Check, Row};

/// Lines of the problems without a mesh to refine.
pub fn single_checks() -> Vec<Check> {
    [
        closed_forms::checks(),
        foam::checks(),
        volumetric::checks(),
        viscoelastic::checks(),
        maxwell::checks(),
        harmonic::checks(),
        slider::checks(),
        tear::checks(),
        softening::checks(),
        patch::checks(),
        impactor::checks(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The lines as a table in Markdown.
pub fn markdown_checks(checks: &[Check]) -> String {
    let mut text = String::from("| problem | quantity | reference | largest error |\n|---|---|---|---|\n");
    for Check { problem, quantity, reference, error } in checks {
        let _ = writeln!(text, "| {problem} | {quantity} | {reference} | {} |", percent(*error));
    }
    text
}

/// Rows of the problems on their regular meshes, which the tests judge.
pub fn regular_rows() -> Vec<Row> {
    [
        contact_convergence::rows(),
        patch_distorted::rows(),
        swinging_plate::rows(&swinging_plate::CELLS),
        cook::rows(&cook::CELLS),
        bar_wave::rows(&bar_wave::CELLS),
        bonded_strip::rows(),
        hertz::rows(&hertz::CELLS),
        indentation::rows(&indentation::CELLS),
        interface::rows(&interface::CELLS),
        coulomb_block::rows(),
        cylinder::rows(),
        lame::rows(&lame::CELLS),
        checkerboard::rows(),
        softening::rows(),
        solid_section::rows(),
        solid_press::rows(),
        solid_cook::rows(),
        solid_block::rows(),
        solid_lame::rows(),
        solid_swing::rows(),
        solid_checkerboard::rows(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Rows of the long convergence studies, on finer meshes.
pub fn long_rows() -> Vec<Row> {
    [swinging_plate::rows(&[8, 16, 32, 64]), cook::rows(&[8, 16, 32, 64]), lame::rows(&[8, 16, 32, 64])]
        .into_iter()
        .flatten()
        .collect()
}

/// The rows as lines of a table in Markdown.
///
/// Errors have two digits and orders one, which is less than compilers and mathematics libraries can differ by; errors
/// at the level of round-off, which they do change, are only said to be there.
pub fn markdown(rows: &[Row]) -> String {
    let mut text =
        String::from("| problem | quantity | reference | coarsest mesh | error | finest mesh | error | order |\n");
    text.push_str("|---|---|---|---|---|---|---|---|\n");
    for row in rows {
        let last = row.errors.len() - 1;
        let order = row.order.map_or("-".into(), |order| format!("{order:.1}"));
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} | {order} |",
            row.problem,
            row.quantity,
            row.reference,
            row.meshes[0],
            percent(row.errors[0]),
            row.meshes[last],
            percent(row.errors[last]),
        );
    }
    text
}

fn percent(error: f64) -> String {
    if error.abs() < 1e-9 { "round-off".into() } else { format!("{:.1e}", error) }
}
