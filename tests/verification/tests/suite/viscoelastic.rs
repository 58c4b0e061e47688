//! Prony series: relaxation after a step and response to a ramp, against closed forms, through the element.
//!
//! Source: the relaxation function G(t)/G_inf = 1 + sum (g_k/g_inf) e^(-t/tau_k) and its convolution with a ramp,
//! sigma = 2 edot (G_inf t + sum G_k tau_k (1 - e^(-t/tau_k))), e.g. Simo and Hughes, Computational Inelasticity (1998).

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::element::Cell;
use softanvil_verification::problems::viscoelastic::{DT, material, ramp_error, step_error};
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, PRONY_RAMP};

#[test]
fn relaxation_after_a_finite_step() {
    let error = step_error();
    assert!(error < CLOSED_FORM, "{error:e}");
}

#[test]
fn ramp_in_simple_shear() {
    let error = ramp_error();
    assert!(error < PRONY_RAMP, "{error:e}");
}

/// A deformation held for long leaves the long-term stress, and all the viscous work is the sum of stress times strain.
#[test]
fn full_relaxation_leaves_the_long_term_law() {
    let gradient = [[1.0, 0.4], [0.0, 1.0]];
    let long_term = Cell::new(elastic(0.1e6, 0.05e6, 1e9), Formulation::PlaneStrain, DT).deform(gradient);
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-3);
    let mut stress = cell.deform(gradient);
    for _ in 0..2000 {
        stress = cell.deform(gradient);
    }
    let error = (stress[0][1] - long_term[0][1]).abs() / long_term[0][1];
    assert!(error < CLOSED_FORM, "{} Pa against {} Pa", stress[0][1], long_term[0][1]);
    assert!(cell.viscous_work > 0.0);
}
