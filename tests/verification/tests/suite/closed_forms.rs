//! Nominal stress of every law against its closed forms for an incompressible body, through the element.
//!
//! Source: Rivlin's universal relations, e.g. Holzapfel, Nonlinear Solid Mechanics (2000), with
//! W1 = C10 + 2 C20 (I1-3) + C11 (I2-3), W2 = C01 + 2 C02 (I2-3) + C11 (I1-3) in Mooney and Rivlin's law, W2 = 0 and
//! W1 = C10 + 2 C20 (I1-3) + 3 C30 (I1-3)^2 in Yeoh's, of which neo-Hooke is the first term:
//! uniaxial 2 (l - l^-2)(W1 + W2/l), planar 2 (l - l^-3)(W1 + W2), equibiaxial 2 (l - l^-5)(W1 + l^2 W2).
//! Ogden (1972): the nominal stress times l is sum mu_k (l^alpha_k - l_free^alpha_k).
//! The element is deformed isochorically, so the pressure is zero and stress differences are compared:
//! sigma_loaded - sigma_free = l P.

use softanvil_kernel::scenario::{ElasticLaw, Formulation, Material};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::{elastic, laws};
use softanvil_verification::tolerance::CLOSED_FORM;

const STRETCHES: [f64; 9] = [0.3, 0.4, 0.6, 0.8, 0.95, 1.05, 1.5, 2.0, 3.0];

const BULK: f64 = 1e9;

/// l P of the loaded direction, whose stretch is `loaded`, for a free direction of stretch `free`, given l P / (2 (W1 + f
/// W2)) = l^2 - free^2 and f.
fn reference(m: &Material, stretches: [f64; 3], loaded: f64, free: f64, factor: f64) -> f64 {
    let i1: f64 = stretches.iter().map(|l| l * l).sum();
    let i2: f64 = stretches.iter().map(|l| 1.0 / (l * l)).sum();
    let (a, b) = (i1 - 3.0, i2 - 3.0);
    let (w1, w2) = match m.law {
        ElasticLaw::NeoHookean => (m.c10, 0.0),
        ElasticLaw::MooneyRivlin => (m.c10 + 2.0 * m.c20 * a + m.c11 * b, m.c01 + 2.0 * m.c02 * b + m.c11 * a),
        ElasticLaw::Yeoh => (m.c10 + 2.0 * m.c20 * a + 3.0 * m.c30 * a * a, 0.0),
        ElasticLaw::Ogden => {
            let powers = m.ogden_mu.iter().zip(m.ogden_alpha).map(|(mu, k)| mu * (loaded.powf(k) - free.powf(k)));
            return powers.sum();
        }
    };
    2.0 * (loaded * loaded - free * free) * (w1 + factor * w2)
}

fn compare(what: &str, l: f64, difference: f64, reference: f64) {
    let error = (difference - reference).abs() / reference.abs();
    assert!(error < CLOSED_FORM, "{what} at stretch {l}: {difference} Pa against {reference} Pa, error {error:e}");
}

#[test]
fn uniaxial() {
    for (name, material) in laws(BULK) {
        for l in STRETCHES {
            let side = l.powf(-0.5);
            let p = Cell::new(material, Formulation::Axisymmetric, 1e-6).deform([[side, 0.0], [0.0, l]]);
            let reference = reference(&material, [l, side, side], l, side, 1.0 / l);
            compare(name, l, l * p[1][1] - side * 0.5 * p[0][0], reference);
        }
    }
}

#[test]
fn equibiaxial() {
    for (name, material) in laws(BULK) {
        for l in STRETCHES {
            let through = l.powi(-2);
            let p = Cell::new(material, Formulation::Axisymmetric, 1e-6).deform([[l, 0.0], [0.0, through]]);
            let reference = reference(&material, [l, l, through], l, through, l * l);
            compare(name, l, l * 0.5 * p[0][0] - through * p[1][1], reference);
        }
    }
}

/// The free direction is the one across; the one out of the section is held.
#[test]
fn planar() {
    for (name, material) in laws(BULK) {
        for l in STRETCHES {
            let p = Cell::new(material, Formulation::PlaneStrain, 1e-6).deform([[1.0 / l, 0.0], [0.0, l]]);
            let reference = reference(&material, [l, 1.0 / l, 1.0], l, 1.0 / l, 1.0);
            compare(name, l, l * p[1][1] - p[0][0] / l, reference);
        }
    }
}

/// Source: U = K/2 (J-1)^2, so a pure dilatation has the Cauchy stress K (J-1) in every direction.
#[test]
fn dilatation() {
    let bulk = BULK;
    for l in [0.9_f64, 0.99, 1.01, 1.1] {
        let mut cell = Cell::new(elastic(0.1e6, 0.05e6, bulk), Formulation::Axisymmetric, 1e-6);
        let p = cell.deform([[l, 0.0], [0.0, l]]);
        let reference = bulk * (l.powi(3) - 1.0) * l * l;
        let error = (p[1][1] - reference).abs() / reference.abs();
        assert!(error < CLOSED_FORM, "dilatation {l}: {} Pa against {reference} Pa", p[1][1]);
    }
}
