//! Swinging cube: a cube on rollers at x, y, z = 0, whose other faces move along their normals alone, swings in u = U cos(omega t)
//! (A sin x cos y cos z, B cos x sin y cos z, C cos x cos y sin z) with x, y, z in quarters of a turn a side, A + B + C = 0 and
//! omega = sqrt(3) pi / 2 c / side, c = sqrt(mu / rho), which is exact in linear elasticity for any Poisson's ratio.
//!
//! Source: the field is free of divergence and of normal traction on those faces, as can be checked by substitution; a like cube e.g. in
//! Aguirre, Gil, Bonet and Lee, Journal of Computational Physics 300 (2015).

use softanvil_verification::order::over_cells;
use softanvil_verification::problems::solid_swing::{CELLS, POISSONS_RATIOS, error};
use softanvil_verification::tolerance::{SECOND_ORDER, SOLID_SWING};

#[test]
fn displacement_converges_at_second_order() {
    for nu in POISSONS_RATIOS {
        let errors = CELLS.map(|n| error(nu, n));
        let order = over_cells(&CELLS, &errors);
        assert!(order > SECOND_ORDER, "nu = {nu}: order {order}, errors {errors:?}");
        assert!(errors[CELLS.len() - 1] < SOLID_SWING, "nu = {nu}: errors {errors:?}");
    }
}
