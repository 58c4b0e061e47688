//! Swinging plate: a square on rollers swings in u = U cos(pi c t / sqrt 2) (-sin(pi X/2) cos(pi Y/2),
//! cos(pi X/2) sin(pi Y/2)), c = sqrt(mu/rho), which is exact in linear elasticity for any Poisson's ratio.
//!
//! Source: e.g. Aguirre, Gil, Bonet and Lee, Journal of Computational Physics 300 (2015); the field is free of divergence
//! and of traction on the free sides, as can be checked by substitution. Linear elements and central differences are of
//! second order.

use softanvil_verification::order::over_cells;
use softanvil_verification::problems::swinging_plate::{CELLS, PERIODS, POISSONS_RATIOS, error};
use softanvil_verification::tolerance::{SECOND_ORDER, SWINGING_PLATE};

#[test]
fn displacement_converges_at_second_order() {
    for nu in POISSONS_RATIOS {
        let errors = CELLS.map(|n| error(nu, n, PERIODS));
        let order = over_cells(&CELLS, &errors);
        assert!(order > SECOND_ORDER, "nu = {nu}: order {order}, errors {errors:?}");
        assert!(errors[CELLS.len() - 1] < SWINGING_PLATE, "nu = {nu}: errors {errors:?}");
    }
}
