//! Faces that are narrower than a deep elastic block, against closed forms for the half space.
//!
//! Source: Johnson, Contact Mechanics (1985), sections 3.4, 3.8 and 4.2.

use softanvil_kernel::scenario::FaceShape;
use softanvil_verification::order::{extrapolate, over_cells};
use softanvil_verification::problems::indentation::{CELLS, indent};
use softanvil_verification::tolerance::{BALL, BAR_PRESSURE, INDENTATION_WIDTH, PUNCH};

const LAST: usize = CELLS.len() - 1;

#[test]
fn the_force_on_a_flat_punch_converges() {
    let found = CELLS.map(|n| indent(FaceShape::Round, n));
    let errors = found.map(|found| found.ratio - 1.0);
    assert!(errors[LAST].abs() < PUNCH, "{errors:?}");
    assert!(over_cells(&CELLS, &errors) > 1.0, "{errors:?}");
    assert!((found[LAST].half_width - 1.0).abs() < INDENTATION_WIDTH, "{found:?}");
}

#[test]
fn the_force_on_a_ball_is_that_of_hertz() {
    let found = CELLS.map(|n| indent(FaceShape::Sphere, n));
    let (limit, order) = extrapolate(CELLS.map(|n| 1.0 / n as f64), found.map(|found| found.ratio));
    assert!((limit - 1.0).abs() < BALL && order > 1.5, "{found:?}: {limit}, order {order}");
    assert!((found[LAST].half_width - 1.0) < 1.0 / CELLS[LAST] as f64, "{found:?}");
}

#[test]
fn the_pressure_under_a_bar_is_that_of_hertz() {
    let found = CELLS.map(|n| indent(FaceShape::Bar, n));
    assert!((found[LAST].ratio - 1.0).abs() < BAR_PRESSURE, "{found:?}");
    assert!((found[LAST].half_width - 1.0).abs() < 2.0 / CELLS[LAST] as f64, "{found:?}");
}
