//! Additive Maxwell terms: ramp at a constant true strain rate up to a finite strain, and the relaxation after it.
//!
//! Source: a Maxwell element of spring G and decay beta, s' = -beta s + 2 G e': under a ramp s = 2 (G/beta) e' (1 -
//! e^(-beta t)), afterwards s e^(-beta t); LS-DYNA, Keyword User's Manual II, MAT_077_H (absolute G_i, beta_i). Plane
//! extension diag(1/l, l) with l = e^(rate t) has the true strain rate diag(-rate, rate) without rotation.

use softanvil_kernel::scenario::{Formulation, Material};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, MAXWELL_RAMP};

const DT: f64 = 1e-5;
const RATE: f64 = 100.0;
const TERMS: [(f64, f64); 2] = [(0.4e6, 2000.0), (0.1e6, 50.0)];

fn material() -> Material {
    let mut material = elastic(0.1e6, 0.0, 1e6);
    for (i, (g, beta)) in TERMS.into_iter().enumerate() {
        material.maxwell_g[2 * i] = g;
        material.maxwell_beta[2 * i] = beta;
    }
    material
}

/// Difference of the Kirchhoff stresses along and across, with and without the terms.
fn overstress(with: &mut Cell, without: &mut Cell, l: f64) -> f64 {
    let gradient = [[1.0 / l, 0.0], [0.0, l]];
    let difference = |p: [[f64; 2]; 2]| l * p[1][1] - p[0][0] / l;
    difference(with.deform(gradient)) - difference(without.deform(gradient))
}

#[test]
fn ramp_and_relaxation_at_finite_strain() {
    let mut with = Cell::new(material(), Formulation::PlaneStrain, DT);
    let mut without = Cell::new(elastic(0.1e6, 0.0, 1e6), Formulation::PlaneStrain, DT);
    let ramp = 700;
    let end = f64::from(ramp) * DT;
    let peak: f64 = TERMS.iter().map(|(g, beta)| 4.0 * g / beta * RATE * (1.0 - (-beta * end).exp())).sum();
    for n in 1..=3 * ramp {
        let t = f64::from(n) * DT;
        let stress = overstress(&mut with, &mut without, (RATE * t.min(end)).exp());
        let reference: f64 = TERMS
            .iter()
            .map(|(g, beta)| {
                4.0 * g / beta * RATE * (1.0 - (-beta * t.min(end)).exp()) * (-beta * (t - end).max(0.0)).exp()
            })
            .sum();
        assert!((stress - reference).abs() < MAXWELL_RAMP * peak, "step {n}: {stress} Pa against {reference} Pa");
    }
    assert!(with.viscous_dissipation > 0.0 && with.viscous_dissipation < with.viscous_work);
}

/// A strain step within one time step leaves each term at the mean of its decay over the step.
#[test]
fn relaxation_after_a_step() {
    let l = 1.2_f64;
    let mut with = Cell::new(material(), Formulation::PlaneStrain, DT);
    let mut without = Cell::new(elastic(0.1e6, 0.0, 1e6), Formulation::PlaneStrain, DT);
    // The increment at the mean of the stretches before and after.
    let (along, across) = (2.0 * (l - 1.0) / (l + 1.0), 2.0 * (1.0 / l - 1.0) / (1.0 / l + 1.0));
    for n in 0..2000 {
        let stress = overstress(&mut with, &mut without, l);
        let reference: f64 = TERMS
            .iter()
            .map(|(g, beta)| {
                let mean = (1.0 - (-beta * DT).exp()) / (beta * DT);
                2.0 * g * (along - across) * mean * (-f64::from(n) * beta * DT).exp()
            })
            .sum();
        assert!((stress - reference).abs() < CLOSED_FORM * 1e6, "step {n}: {stress} Pa against {reference} Pa");
    }
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
