//! Thick cylinder in plane strain and thick sphere, axisymmetric, under internal pressure.
//!
//! Source: Lame's solutions, Timoshenko and Goodier, Theory of Elasticity (1970).

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::order::over_cells;
use softanvil_verification::problems::lame::{CASES, CELLS, errors};
use softanvil_verification::tolerance::{LAME_DISPLACEMENT, LAME_SPHERE_STRESS_ORDER, LAME_STRESS, SECOND_ORDER};

#[test]
fn displacement_and_stress() {
    for (formulation, nu) in CASES {
        let errors = CELLS.map(|n| errors(formulation, nu, n));
        let least = match formulation {
            Formulation::PlaneStrain | Formulation::Solid => SECOND_ORDER,
            Formulation::Axisymmetric => LAME_SPHERE_STRESS_ORDER,
        };
        let finest = errors[CELLS.len() - 1];
        let displacement = over_cells(&CELLS, &errors.map(|e| e.displacement));
        let stress = over_cells(&CELLS, &errors.map(|e| e.stress));
        assert!(displacement > SECOND_ORDER - 0.1, "{formulation:?} nu = {nu}: order {displacement}, {errors:?}");
        assert!(stress > least, "{formulation:?} nu = {nu}: order {stress}, {errors:?}");
        assert!(finest.displacement < LAME_DISPLACEMENT, "{formulation:?} nu = {nu}: {finest:?}");
        assert!(finest.stress < LAME_STRESS, "{formulation:?} nu = {nu}: {finest:?}");
    }
}
