//! Patterns of the pressure and of the displacement in a solid: the alternating part of the pressure falls with refinement, no pressure is
//! without a force where a side is free, and no deformation is free of energy.
//!
//! Source: a body has six rigid motions. Inf-sup values and their computation: Chapelle and Bathe, The inf-sup test, Computers and
//! Structures 47 (1993). What is known of the constant pressure of linear hexahedra, that a body held all around has patterns that no
//! displacement feels, and that elsewhere the inf-sup value falls with the size of the cells, is found here too.

use softanvil_verification::order::over_cells;
use softanvil_verification::problems::solid_checkerboard::{
    CELLS, Hold, POISSONS_RATIOS, alternating_part, eigenvalues, inf_sup,
};
use softanvil_verification::tolerance::{
    SMALLEST_STIFFNESS, SOLID_CHECKERBOARD, SOLID_CHECKERBOARD_ORDER, SOLID_INF_SUP, ZERO_ENERGY, ZERO_INF_SUP,
};

#[test]
fn alternating_pressure_falls_with_refinement() {
    for (nu, least) in POISSONS_RATIOS.into_iter().zip(SOLID_CHECKERBOARD_ORDER) {
        let parts = CELLS.map(|n| alternating_part(nu, n));
        assert!(parts[0] < SOLID_CHECKERBOARD, "nu = {nu}: {parts:?}");
        assert!(parts.is_sorted_by(|a, b| a > b), "nu = {nu}: {parts:?}");
        assert!(over_cells(&CELLS, &parts) > least, "nu = {nu}: {parts:?}");
    }
}

#[test]
fn only_rigid_motions_are_free_of_energy() {
    for n in [1, 3] {
        let values = eigenvalues(n);
        let zero = values.iter().filter(|value| value.abs() < ZERO_ENERGY).count();
        assert_eq!(zero, 6, "{n} cells: {values:?}");
        assert!(values[6] > SMALLEST_STIFFNESS, "{n} cells: {:e}", values[6]);
    }
}

/// A layer on its core and a block between plates.
#[test]
fn a_pressure_is_felt_where_a_side_is_free() {
    for hold in [Hold::Base, Hold::Plates] {
        for n in 2..=5 {
            let least = inf_sup(hold, n)[0] * (n * n) as f64;
            assert!(least > SOLID_INF_SUP, "{hold:?}, {n} cells: {least}");
        }
    }
}

/// The limit of what the element can: the uniform pressure, as there must be, and five patterns besides, on any mesh.
#[test]
fn a_body_held_all_around_does_not_feel_five_patterns() {
    for n in 3..=5 {
        let values = inf_sup(Hold::All, n);
        let unfelt = values.iter().filter(|value| value.abs() < ZERO_INF_SUP).count();
        assert_eq!(unfelt, 6, "{n} cells: {values:?}");
    }
}
