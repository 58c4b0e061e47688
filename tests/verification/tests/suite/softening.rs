//! Softening after the first load.
//!
//! Source: the closed forms are in `problems/softening.rs`; conservation of energy.

use softanvil_kernel::preset;
use softanvil_verification::problems::softening::{CASES, cycle_errors, rows, stress_error};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_RESIDUAL};

#[test]
fn stress_and_dissipation_are_those_of_the_closed_form() {
    for (case, name) in CASES {
        let (stress, [dissipation, _]) = (stress_error(case), cycle_errors(case, 7));
        assert!(stress < CLOSED_FORM && dissipation < CLOSED_FORM, "{name}: {stress:e} {dissipation:e}");
    }
}

#[test]
fn the_work_of_a_cycle_tends_to_what_it_loses() {
    for row in rows() {
        let order = row.order.expect("an order");
        assert!((order - 2.0).abs() < 0.1 && row.errors[3] < 1e-4, "{}: {order}, {:?}", row.quantity, row.errors);
    }
}

/// A silicone that softens with every mechanism at once.
#[test]
fn energy_closes_in_a_drop_that_softens() {
    let mut scenario = preset::study();
    let silicone = &mut scenario.layers[0].material;
    (silicone.softening_r, silicone.softening_m, silicone.softening_beta) = (1.5, 5e3, 0.2);
    (silicone.maxwell_g[0], silicone.slider_stiffness, silicone.slider_yield_stress) = (5e4, 1e6, 10e3);
    (silicone.tear_stretch, silicone.tear_width, silicone.tear_residual) = (1.1, 0.2, 0.6);
    let energy = run(&scenario).scalars().energy;
    assert!(energy.residual().abs() < ENERGY_RESIDUAL * energy.external, "{energy:?}");
    assert!(energy.softening > 0.01 && energy.tear > 0.0, "{energy:?}");
}
