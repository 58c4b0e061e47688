//! Nominal stress of the incompressible five-parameter Mooney-Rivlin law against its closed forms, through the element.
//!
//! Source: Rivlin's universal relations, e.g. Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5, with
//! W1 = C10 + 2 C20 (I1-3) + C11 (I2-3), W2 = C01 + 2 C02 (I2-3) + C11 (I1-3):
//! uniaxial 2 (l - l^-2)(W1 + W2/l), planar 2 (l - l^-3)(W1 + W2), equibiaxial 2 (l - l^-5)(W1 + l^2 W2).
//! The element is deformed isochorically, so the pressure is zero and stress differences are compared:
//! sigma_loaded - sigma_free = l P.

use softanvil_kernel::scenario::{Formulation, Material};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::CLOSED_FORM;

const STRETCHES: [f64; 9] = [0.3, 0.4, 0.6, 0.8, 0.95, 1.05, 1.5, 2.0, 3.0];

fn material() -> Material {
    Material { c11: 0.02e6, c20: 0.004e6, c02: 0.003e6, ..elastic(0.1e6, 0.05e6, 1e9) }
}

/// (W1, W2) at the principal stretches.
fn derivatives(m: &Material, stretches: [f64; 3]) -> (f64, f64) {
    let i1: f64 = stretches.iter().map(|l| l * l).sum();
    let i2: f64 = stretches.iter().map(|l| 1.0 / (l * l)).sum();
    let (a, b) = (i1 - 3.0, i2 - 3.0);
    (m.c10 + 2.0 * m.c20 * a + m.c11 * b, m.c01 + 2.0 * m.c02 * b + m.c11 * a)
}

fn compare(what: &str, l: f64, difference: f64, nominal: f64) {
    let reference = l * nominal;
    let error = (difference - reference).abs() / reference.abs();
    assert!(error < CLOSED_FORM, "{what} at stretch {l}: {difference} Pa against {reference} Pa, error {error:e}");
}

#[test]
fn uniaxial() {
    for l in STRETCHES {
        let side = l.powf(-0.5);
        let mut cell = Cell::new(material(), Formulation::Axisymmetric, 1e-6);
        let p = cell.deform([[side, 0.0], [0.0, l]]);
        let (w1, w2) = derivatives(&material(), [l, side, side]);
        let nominal = 2.0 * (l - l.powi(-2)) * (w1 + w2 / l);
        compare("uniaxial", l, l * p[1][1] - side * 0.5 * p[0][0], nominal);
    }
}

#[test]
fn equibiaxial() {
    for l in STRETCHES {
        let through = l.powi(-2);
        let mut cell = Cell::new(material(), Formulation::Axisymmetric, 1e-6);
        let p = cell.deform([[l, 0.0], [0.0, through]]);
        let (w1, w2) = derivatives(&material(), [l, l, through]);
        let nominal = 2.0 * (l - l.powi(-5)) * (w1 + l * l * w2);
        compare("equibiaxial", l, l * 0.5 * p[0][0] - through * p[1][1], nominal);
    }
}

#[test]
fn planar() {
    for l in STRETCHES {
        let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-6);
        let p = cell.deform([[1.0 / l, 0.0], [0.0, l]]);
        let (w1, w2) = derivatives(&material(), [l, 1.0 / l, 1.0]);
        let nominal = 2.0 * (l - l.powi(-3)) * (w1 + w2);
        compare("planar", l, l * p[1][1] - p[0][0] / l, nominal);
    }
}

/// Source: U = K/2 (J-1)^2, so a pure dilatation has the Cauchy stress K (J-1) in every direction.
#[test]
fn dilatation() {
    let bulk = material().bulk_modulus;
    for l in [0.9_f64, 0.99, 1.01, 1.1] {
        let mut cell = Cell::new(material(), Formulation::Axisymmetric, 1e-6);
        let p = cell.deform([[l, 0.0], [0.0, l]]);
        let reference = bulk * (l.powi(3) - 1.0) * l * l;
        let error = (p[1][1] - reference).abs() / reference.abs();
        assert!(error < CLOSED_FORM, "dilatation {l}: {} Pa against {reference} Pa", p[1][1]);
    }
}
