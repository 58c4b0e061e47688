//! The Ogden law where its principal stretches coincide, or almost do.
//!
//! Source: Ogden (1972): alpha = 2 with mu is neo-Hooke with C10 = mu/2, and alpha = -2 with -mu adds the Mooney-Rivlin
//! term C01 = mu/2. These laws are polynomials of the stretch and know nothing of principal directions.

use softanvil_kernel::material::Elastic;
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::tensor::kinematics::Kinematics;
use softanvil_kernel::tensor::stretch::IsochoricStretch;
use softanvil_verification::scenes::{self, elastic};
use softanvil_verification::tolerance::{COINCIDENCE, relative_error};

fn ogden(mu: [f64; 3], alpha: [f64; 3]) -> Elastic {
    Elastic::new(&scenes::ogden(1e6, mu, alpha))
}

/// An isochoric stretch: half difference `d` and shear `s` of a section with determinant 1/`out`.
fn stretch(d: f64, s: f64, out: f64) -> Kinematics<f64> {
    Kinematics { mean: (1.0 / out + d * d + s * s).sqrt(), difference: d, shear: s, hoop: out, ..Kinematics::REST }
}

fn components(stress: &Deviator<f64>) -> [f64; 3] {
    [stress.mean, stress.difference, stress.shear]
}

/// Sizes of the in-plane deviation, from none over the smallest numbers to a large strain.
fn sizes() -> impl Iterator<Item = f64> {
    [0.0, 1e-300, 1e-200, 1e-160, 1e-154, 1e-100, 1e-30, 1e-17, 1e-16, 1e-15]
        .into_iter()
        .chain((-56..1).map(|k| 2.0_f64.powf(f64::from(k) / 4.0)))
}

#[test]
fn equals_mooney_rivlin_at_every_distance_of_the_stretches() {
    let law = ogden([0.2e6, -0.1e6, 0.0], [2.0, -2.0, 1.0]);
    let reference = Elastic::new(&elastic(0.1e6, 0.05e6, 1e6));
    for size in sizes() {
        // Powers of two keep the half difference exact in the stretch.
        for (d, s) in [(size, 0.0), (0.0, size), (0.6 * size, -0.8 * size)] {
            for out in [1.0, 1.3, 0.6] {
                let kinematics = stretch(d, s, out);
                let [(stress, energy)] = law.stress(Scalar, &[kinematics], true);
                let [(expected, expected_energy)] = reference.stress(Scalar, &[kinematics], true);
                let ([a, b, c], [p, q, r]) = (components(&stress), components(&expected));
                let total = p.abs().max(q.abs()).max(r.abs()).max(1.0);
                assert!((a - p).abs() < COINCIDENCE * 0.2e6 * (1.0 + total / 0.2e6), "d {d} s {s}: {a} against {p}");
                assert!((b - q).abs() < COINCIDENCE * 0.2e6 * (1.0 + total / 0.2e6), "d {d} s {s}: {b} against {q}");
                // The shear stress has no subtraction in it, so it must hold relative to itself however small it is.
                let holds = r == 0.0 && c == 0.0 || relative_error(c, r) < COINCIDENCE;
                assert!(holds, "shear {s}: {c} against {r}");
                let error = (energy - expected_energy).abs();
                assert!(error < COINCIDENCE * (0.2e6 + expected_energy), "energy at {d} {s}");
            }
        }
    }
}

/// Source: the limit l1 -> l2 = g of (tau_1 - tau_2) / (l1 - l2): tau_xy = mu alpha g^(alpha - 1) u12 at l1 = l2 = g.
#[test]
fn shear_stress_tends_to_its_limit_for_any_exponent() {
    for alpha in [-7.3, -2.0, -0.4, 1e-6, 0.9, 3.0, 11.0] {
        for out in [1.0, 1.7, 0.5_f64] {
            let g = out.powf(-0.5);
            for s in sizes().filter(|s| *s > 0.0 && *s < 1e-8) {
                let law = ogden([0.1e6, 0.0, 0.0], [alpha, 0.0, 0.0]);
                let [(stress, _)] = law.stress(Scalar, &[stretch(0.0, s, out)], true);
                let limit = 0.1e6 * alpha * g.powf(alpha - 1.0) * s;
                assert!(relative_error(stress.shear, limit) < COINCIDENCE, "alpha {alpha}: {} {limit}", stress.shear);
            }
        }
    }
}

/// Source: linear elasticity: W = G e^2 for the pure shear diag(e, -e), to the next order in e.
#[test]
fn energy_of_small_strains_keeps_its_accuracy() {
    let law = ogden([0.63e6, 0.0012e6, -0.01e6], [1.3, 5.0, -2.0]);
    let modulus = law.shear_modulus();
    for k in 10..40 {
        let strain = 2.0_f64.powi(-k);
        let [(_, energy)] = law.stress(Scalar, &[stretch(0.0, strain, 1.0)], true);
        let linear = 2.0 * modulus * strain * strain;
        assert!(relative_error(energy, linear) < 10.0 * strain * strain + COINCIDENCE, "{strain}: {energy} {linear}");
    }
}

/// Stress and energy grow with the stretch while rounding leaves the smaller one in the section, and stay as large, or are no
/// numbers, for stretches that no step survives.
#[test]
fn extreme_stretches_are_not_taken_for_small_ones() {
    for alpha in [-30.0, -1.3, 0.01, 5.0, 30.0] {
        let law = ogden([0.1e6_f64.copysign(alpha), 0.0, 0.0], [alpha, 0.0, 0.0]);
        let families: [fn(f64) -> Kinematics<f64>; 3] = [
            |size| stretch(size, 0.0, 1.0),
            |size| stretch(0.0, size, size),
            |size| stretch(0.0, 0.6 * size, 1.0 / size),
        ];
        for family in families {
            let mut before = 0.0;
            for k in 1..500 {
                let [(stress, energy)] = law.stress(Scalar, &[family(2.0_f64.powi(k))], true);
                let magnitude = components(&stress).iter().fold(energy, |sum, part| sum + part.abs());
                assert!(
                    magnitude.is_nan() || magnitude >= 0.999 * before,
                    "alpha {alpha}, 2^{k}: {magnitude} after {before}"
                );
                before = if k < 14 { magnitude } else { before };
            }
        }
    }
}

/// What is not a number stays so, for the check of the next Jacobian.
#[test]
fn a_stretch_that_is_not_a_number_has_no_stress() {
    let law = ogden([0.63e6, 0.0012e6, -0.01e6], [1.3, 5.0, -2.0]);
    for broken in [
        Kinematics { mean: f64::NAN, ..stretch(0.1, 0.1, 1.1) },
        Kinematics { shear: f64::NAN, ..stretch(0.1, 0.1, 1.1) },
        Kinematics { difference: f64::INFINITY, ..stretch(0.1, 0.1, 1.1) },
        Kinematics { inverse_cbrt_j: f64::NAN, ..stretch(0.1, 0.1, 1.1) },
    ] {
        let [(stress, _)] = law.stress(Scalar, &[broken], true);
        assert!(components(&stress).iter().all(|part| part.is_nan()), "{broken:?}: {stress:?}");
    }
}

/// Turning the principal directions of a term with a small exponent meets more than strain along them: the tangent covers it.
///
/// Source: the stiffness against turning of isotropic materials, (tau_i - tau_j)(l_i^2 + l_j^2) / (2 (l_i^2 - l_j^2)), with
/// tau_i = mu l_i^alpha (Ogden, Non-linear elastic deformations, 1984).
#[test]
fn the_tangent_covers_a_turn_of_the_principal_directions() {
    for alpha in [0.1_f64, 0.3, 1.0, 1.7, -0.3, -1.5] {
        let law = ogden([1e5 * alpha.signum(), 0.0, 0.0], [alpha, 2.0, 2.0]);
        for h in [0.2_f64, 1.0, 2.0, 3.0] {
            let (long, short) = ((0.5 * h).exp(), (-0.5 * h).exp());
            let stress = |stretch: f64| 1e5 * alpha.signum() * stretch.powf(alpha);
            let squares = [long * long, short * short];
            let turning =
                (stress(long) - stress(short)) * (squares[0] + squares[1]) / (2.0 * (squares[0] - squares[1]));
            let stretch = IsochoricStretch { u11: long, u22: short, u12: 0.0, u33: 1.0 };
            let tangent = law.shear_tangent(Scalar, &stretch);
            assert!(tangent >= turning * (1.0 - 1e-12), "alpha = {alpha}, h = {h}: {tangent} Pa below {turning} Pa");
        }
    }
}
