//! Prony series: relaxation after a step and response to a ramp, against closed forms, through the element.
//!
//! Source: the relaxation function G(t)/G_inf = 1 + sum (g_k/g_inf) e^(-t/tau_k) and its convolution with a ramp,
//! sigma = 2 edot (G_inf t + sum G_k tau_k (1 - e^(-t/tau_k))), e.g. Simo and Hughes, Computational Inelasticity (1998).

use softanvil_kernel::scenario::{Formulation, Material};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, PRONY_RAMP};

const DT: f64 = 2e-6;

fn material() -> Material {
    Material {
        prony_g: [0.5, 0.3, 0.0, 0.0, 0.0],
        prony_tau: [0.4e-3, 20e-3, 1.0, 1.0, 1.0],
        ..elastic(0.1e6, 0.05e6, 1e9)
    }
}

/// (g_k / g_inf, tau_k) of the active terms.
fn terms() -> [(f64, f64); 2] {
    let m = material();
    let g_inf = 1.0 - m.prony_g[0] - m.prony_g[1];
    [(m.prony_g[0] / g_inf, m.prony_tau[0]), (m.prony_g[1] / g_inf, m.prony_tau[1])]
}

/// After a finite step the stress is the elastic one times the relaxation function; the step itself is a ramp over dt,
/// which leaves each term at the mean of its decay over the step.
#[test]
fn relaxation_after_a_finite_step() {
    let gradient = [[1.0 / 1.6, 0.0], [0.0, 1.6]];
    let elastic_stress = Cell::new(elastic(0.1e6, 0.05e6, 1e9), Formulation::PlaneStrain, DT).deform(gradient)[1][1];
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, DT);
    for n in 0..5000 {
        let stress = cell.deform(gradient)[1][1];
        let overstress: f64 = terms()
            .iter()
            .map(|(ratio, tau)| ratio * (1.0 - (-DT / tau).exp()) / (DT / tau) * (-f64::from(n) * DT / tau).exp())
            .sum();
        let reference = elastic_stress * (1.0 + overstress);
        let error = (stress - reference).abs() / reference;
        assert!(error < CLOSED_FORM, "step {n}: {stress} Pa against {reference} Pa");
    }
}

#[test]
fn ramp_in_simple_shear() {
    let rate = 0.01;
    let shear_modulus = material().shear_modulus_inf();
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, DT);
    let mut largest: (f64, f64) = (0.0, 0.0);
    for n in 1..=5000 {
        let t = f64::from(n) * DT;
        let stress = cell.deform([[1.0, rate * t], [0.0, 1.0]])[0][1];
        let viscous: f64 = terms().iter().map(|(ratio, tau)| ratio * tau * (1.0 - (-t / tau).exp())).sum();
        let reference = shear_modulus * rate * (t + viscous);
        largest = (largest.0.max((stress - reference).abs()), largest.1.max(reference));
    }
    assert!(largest.0 < PRONY_RAMP * largest.1, "{} Pa off of {} Pa", largest.0, largest.1);
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
