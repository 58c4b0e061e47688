//! Patch test on a distorted mesh: inner nodes that are free find the homogeneous deformation of the boundary, and every
//! cell the same stress.
//!
//! Source: Irons and Razzaque (1972); exact but for round-off.

use softanvil_verification::problems::patch_distorted::{CASES, errors};
use softanvil_verification::tolerance::PATCH_DISTORTED;

#[test]
fn distorted_patch() {
    for (formulation, gradient) in CASES {
        let errors = errors(formulation, gradient);
        let largest = errors.displacement.max(errors.stress);
        assert!(largest < PATCH_DISTORTED, "{formulation:?} {gradient:?}: {errors:?}");
    }
}
