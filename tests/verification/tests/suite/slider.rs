//! The spring-slider: area of a closed loop, independence of rate, and no stress from rotation.
//!
//! Source: elastic-perfectly plastic cycle of amplitude g in simple shear, area 4 tau_y (g - tau_y / G) with
//! tau_y = SIGF / sqrt 3 (von Mises), e.g. Simo and Hughes, Computational Inelasticity (1998).

use softanvil_verification::problems::slider::{area, cycle, drift};
use softanvil_verification::tolerance::{ROTATION_DRIFT, SLIDER_LOOP, relative_error};

#[test]
fn a_cycle_dissipates_the_area_of_its_loop() {
    let area = area();
    let (work, dissipation) = cycle(40_000);
    assert!(relative_error(work, area) < SLIDER_LOOP, "work {work} J/m3 against {area} J/m3");
    assert!(relative_error(dissipation, area) < SLIDER_LOOP, "dissipation {dissipation} J/m3 against {area} J/m3");
}

#[test]
fn the_loop_does_not_depend_on_the_rate() {
    let (slow, fast) = (cycle(40_000).1, cycle(4_000).1);
    assert!(relative_error(fast, slow) < SLIDER_LOOP, "{fast} J/m3 against {slow} J/m3");
}

/// Ten turns at several speeds, unstressed and with a stress that must turn with the material.
#[test]
fn rotation_leaves_the_stress_alone() {
    for steps_per_turn in [7, 100, 10_000] {
        for shear in [0.0, 0.001] {
            let drift = drift(steps_per_turn, shear);
            assert!(drift < ROTATION_DRIFT, "{steps_per_turn} steps a turn, shear {shear}: drift {drift:e}");
        }
    }
}
