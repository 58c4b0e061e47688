//! Patch test: a homogeneous deformation of the round mesh, whose cells are neither square nor equal, leaves no force on
//! any interior node.
//!
//! Source: Irons and Razzaque (1972); necessary for convergence, exact but for round-off.

use softanvil_verification::problems::patch;
use softanvil_verification::tolerance::PATCH;

#[test]
fn plane_strain() {
    for (scenario, gradient) in patch::plane_strain() {
        let residual = patch::residual(scenario, gradient);
        assert!(residual < PATCH, "{gradient:?}: {residual:e}");
    }
}

#[test]
fn axisymmetric() {
    for (scenario, gradient) in patch::axisymmetric() {
        let residual = patch::residual(scenario, gradient);
        assert!(residual < PATCH, "{gradient:?}: {residual:e}");
    }
}
