//! Longitudinal waves: speed sqrt(M / rho) between fixed sides, sqrt(E / (1 - nu^2) / rho) with free sides in plane
//! strain; stress rho c v behind a front; period 4 L / c with one end free and one on rollers.
//!
//! Source: Graff, Wave Motion in Elastic Solids (1975), sections 2.1 to 2.4.

use softanvil_verification::problems::bar_wave::{CELLS, Sides, front, period};
use softanvil_verification::tolerance::{BAR_PERIOD, BAR_SPEED, BAR_STRESS};

const FINEST: usize = CELLS[CELLS.len() - 1];

#[test]
fn period_of_free_vibration() {
    for sides in [Sides::Fixed, Sides::Free] {
        let error = period(sides, FINEST) - 1.0;
        assert!(error.abs() < BAR_PERIOD, "{sides:?}: {error:e}");
    }
}

#[test]
fn speed_and_stress_of_a_front() {
    for sides in [Sides::Fixed, Sides::Free] {
        let front = front(sides, FINEST);
        assert!((front.speed - 1.0).abs() < BAR_SPEED, "{sides:?}: {front:?}");
        assert!((front.stress - 1.0).abs() < BAR_STRESS, "{sides:?}: {front:?}");
    }
}
