//! Apparent modulus of a bonded strip, (4/3) E (1 + S^2), and disc, E (1 + 2 S^2), with 1/E_a = 1/E_S + 1/K.
//!
//! Source: Gent and Lindley, Proceedings of the Institution of Mechanical Engineers 173 (1959). The formulas add a
//! homogeneous and a parabolic field and are approximations; the limits found here are 6 % above to 3 % below them.

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::problems::bonded_strip::{SHAPE_FACTORS, converged, reference, stuck_and_bonded};
use softanvil_verification::tolerance::{GENT_LINDLEY, GENT_LINDLEY_SLENDER, STICKING, relative_error};

#[test]
fn apparent_modulus() {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for shape_factor in SHAPE_FACTORS {
            let (moduli, limit, _) = converged(formulation, shape_factor);
            let tolerance = if shape_factor < 1.0 { GENT_LINDLEY_SLENDER } else { GENT_LINDLEY };
            let gent = reference(formulation, shape_factor);
            assert!(
                relative_error(limit, gent) < tolerance,
                "{formulation:?} S = {shape_factor}: {moduli:?}, limit {limit}, Gent-Lindley {gent}"
            );
        }
    }
}

/// Under the kernel's own face and steps, friction that never slips is a bond.
#[test]
fn a_face_with_high_friction_sticks() {
    let [stuck, bonded] = stuck_and_bonded(8);
    assert!(relative_error(stuck, bonded) < STICKING, "{stuck} N against {bonded} N");
}
