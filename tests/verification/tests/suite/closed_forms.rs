//! Nominal stress of every law against its closed forms for an incompressible body, through the element.
//!
//! Source: Rivlin's universal relations, e.g. Holzapfel, Nonlinear Solid Mechanics (2000), with
//! W1 = C10 + 2 C20 (I1-3) + C11 (I2-3), W2 = C01 + 2 C02 (I2-3) + C11 (I1-3) in Mooney and Rivlin's law, W2 = 0 and
//! W1 = C10 + 2 C20 (I1-3) + 3 C30 (I1-3)^2 in Yeoh's, of which neo-Hooke is the first term:
//! uniaxial 2 (l - l^-2)(W1 + W2/l), planar 2 (l - l^-3)(W1 + W2), equibiaxial 2 (l - l^-5)(W1 + l^2 W2).
//! Ogden (1972): the nominal stress times l is sum mu_k (l^alpha_k - l_free^alpha_k).
//! The element is deformed isochorically, so the pressure is zero and stress differences are compared:
//! sigma_loaded - sigma_free = l P.

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::element::Cell;
use softanvil_verification::problems::closed_forms::{BULK, Mode, STRETCHES, difference};
use softanvil_verification::scenes::{elastic, laws};
use softanvil_verification::tolerance::CLOSED_FORM;

fn compare(mode: Mode) {
    for (name, material) in laws(BULK) {
        for l in STRETCHES {
            let [measured, reference] = difference(mode, &material, l);
            let error = (measured - reference).abs() / reference.abs();
            assert!(
                error < CLOSED_FORM,
                "{name} at stretch {l}: {measured} Pa against {reference} Pa, error {error:e}"
            );
        }
    }
}

#[test]
fn uniaxial() {
    compare(Mode::Uniaxial);
}

#[test]
fn planar() {
    compare(Mode::Planar);
}

#[test]
fn equibiaxial() {
    compare(Mode::Equibiaxial);
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
