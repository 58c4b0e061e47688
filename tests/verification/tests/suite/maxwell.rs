//! Additive Maxwell terms: ramp at a constant true strain rate up to a finite strain, and the relaxation after it.
//!
//! Source: a Maxwell element of spring G and decay beta, s' = -beta s + 2 G e': under a ramp s = 2 (G/beta) e' (1 -
//! e^(-beta t)), afterwards s e^(-beta t); LS-DYNA, Keyword User's Manual II, MAT_077_H (absolute G_i, beta_i). Plane
//! extension diag(1/l, l) with l = e^(rate t) has the true strain rate diag(-rate, rate) without rotation.

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::element::Cell;
use softanvil_verification::problems::maxwell::{DT, material, ramp, step_error};
use softanvil_verification::tolerance::{CLOSED_FORM, MAXWELL_RAMP, MAXWELL_WORK};

#[test]
fn ramp_and_relaxation_at_finite_strain() {
    let ramp = ramp();
    assert!(ramp.error < MAXWELL_RAMP, "{:e}", ramp.error);
    assert!(ramp.work_error < MAXWELL_WORK, "{:e}", ramp.work_error);
}

#[test]
fn relaxation_after_a_step() {
    let error = step_error();
    assert!(error < CLOSED_FORM, "{error:e}");
}

/// Ten turns at a finite stretch: the overstress relaxes as it does without them.
#[test]
fn rotation_leaves_the_overstress_alone() {
    let mut still = Cell::new(material(), Formulation::PlaneStrain, DT);
    let mut turning = Cell::new(material(), Formulation::PlaneStrain, DT);
    for n in 0..=1000_i32 {
        let angle = 2.0 * std::f64::consts::PI * f64::from(n % 100) / 100.0;
        let (s, c) = angle.sin_cos();
        let a = still.deform([[1.2, 0.3], [0.0, 0.9]]);
        let b = turning.deform([[1.2 * c, 0.3 * c - 0.9 * s], [1.2 * s, 0.3 * s + 0.9 * c]]);
        for j in 0..2 {
            let turned = [c * a[0][j] - s * a[1][j], s * a[0][j] + c * a[1][j]];
            assert!((turned[0] - b[0][j]).abs() + (turned[1] - b[1][j]).abs() < CLOSED_FORM * 1e6, "step {n}");
        }
    }
}
