//! No pressure checkerboard and no hourglass: the alternating part of the pressure falls with refinement, and no
//! deformation is free of energy.
//!
//! Source: a cell has eight freedoms, of which two translations and a rotation are rigid (Hughes, The Finite Element
//! Method (1987)). When axisymmetric only the vertical translation is.

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::order::over_cells;
use softanvil_verification::problems::checkerboard::{CELLS, POISSONS_RATIOS, alternating_part, eigenvalues};
use softanvil_verification::tolerance::{CHECKERBOARD, SMALLEST_STIFFNESS, ZERO_ENERGY};

#[test]
fn alternating_pressure_falls_with_refinement() {
    for nu in POISSONS_RATIOS {
        let parts = CELLS.map(|n| alternating_part(nu, n));
        assert!(parts[0] < CHECKERBOARD, "nu = {nu}: {parts:?}");
        assert!(parts.is_sorted_by(|a, b| a > b), "nu = {nu}: {parts:?}");
        assert!(over_cells(&CELLS, &parts) > 0.5, "nu = {nu}: {parts:?}");
    }
}

#[test]
fn only_rigid_motions_are_free_of_energy() {
    for n in [1, 4] {
        for (formulation, rigid) in [(Formulation::PlaneStrain, 3), (Formulation::Axisymmetric, 1)] {
            let values = eigenvalues(formulation, n);
            let zero = values.iter().filter(|value| value.abs() < ZERO_ENERGY).count();
            assert_eq!(zero, rigid, "{formulation:?} {n}: {values:?}");
        }
        // Beyond rotation and radial translation, which an axisymmetric body far from its axis hardly resists.
        for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
            let stiff = eigenvalues(formulation, n)[3];
            assert!(stiff > SMALLEST_STIFFNESS, "{formulation:?} {n}: {stiff:e}");
        }
    }
}
