//! Nominal stress of the kernel's laws in the tests.
//!
//! Of a law of constant volume the free direction carries no stress, so the loaded one carries P = (tau_loaded - tau_free) / l, in which the
//! pressure of the incompressible specimen drops out.

use softanvil_kernel::material::Elastic;
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::tensor::kinematics::Kinematics;

use super::{DataSet, Law, Mode};

/// Stretches (x, y, z) of a test at the stretch `l`, or amount of shear, the loaded direction first.
pub fn stretches(mode: Mode, l: f64) -> [f64; 3] {
    match mode {
        Mode::Uniaxial => [l, l.powf(-0.5), l.powf(-0.5)],
        Mode::Planar => [l, 1.0 / l, 1.0],
        Mode::Equibiaxial => [l, 1.0 / (l * l), l],
        Mode::SimpleShear => {
            let long = 0.5 * l + (1.0 + 0.25 * l * l).sqrt();
            [long, 1.0 / long, 1.0]
        }
    }
}

/// What the difference of the first two principal Kirchhoff stresses is divided by to make the nominal stress at `l`.
pub fn divisor(mode: Mode, l: f64) -> f64 {
    match mode {
        Mode::Uniaxial | Mode::Planar | Mode::Equibiaxial => l,
        // The shear stress is dW/dg, of dW = (tau_1 - tau_2) d ln l and g = l - 1/l.
        Mode::SimpleShear => {
            let [long, short, _] = stretches(mode, l);
            long + short
        }
    }
}

/// Deviatoric Kirchhoff stress (x, y, z), Pa, at isochoric principal stretches.
pub fn kirchhoff(elastic: &Elastic, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let kinematics = Kinematics { mean: 0.5 * (x + y), difference: 0.5 * (x - y), hoop: z, ..Kinematics::REST };
    let [(stress, _)] = elastic.stress(Scalar, &[kinematics], true);
    let [x, y, _] = stress.section();
    [x, y, -(x + y)]
}

/// Nominal stress, Pa, at each of `points` (stretches of the loaded direction, or amounts of shear).
pub fn nominal(elastic: &Elastic, mode: Mode, points: &[f64]) -> Vec<f64> {
    if elastic.is_compressible() {
        return points.iter().map(|l| whole(elastic, mode, *l)).collect();
    }
    // The free direction, or the short one of a shear, is the second in all tests.
    let at = |&l: &f64| {
        let tau = kirchhoff(elastic, stretches(mode, l));
        (tau[0] - tau[1]) / divisor(mode, l)
    };
    points.iter().map(at).collect()
}

/// Nominal stress, Pa, of a law that says how the volume changes; NaN where no free stretch is found.
fn whole(elastic: &Elastic, mode: Mode, l: f64) -> f64 {
    let Some(stretches) = free_stretches(elastic, mode, l) else { return f64::NAN };
    let tau = elastic.principal_stress(stretches);
    (tau[0] - tau[1]) / divisor(mode, l)
}

/// Halvings of the strains between which a free one is looked for: to the last digit.
const HALVINGS: usize = 64;
/// By how much these strains reach further than those of any isotropic solid.
const BEYOND: f64 = 0.01;

/// The principal stretches of the test at `l`, the free ones such that they carry no stress.
///
/// A free strain is between that of a constant volume and, with a negative Poisson's ratio, that of an alike direction.
fn free_stretches(elastic: &Elastic, mode: Mode, l: f64) -> Option<[f64; 3]> {
    let incompressible = stretches(mode, l);
    if mode == Mode::SimpleShear {
        return Some(incompressible);
    }
    let at = |strain: f64| {
        let free = strain.exp();
        [l, free, if mode == Mode::Uniaxial { free } else { incompressible[2] }]
    };
    let stress = |strain: f64| elastic.principal_stress(at(strain))[1];
    let ends = [incompressible[1].ln(), l.ln()];
    let [mut low, mut high] = [ends[0].min(ends[1]) - BEYOND, ends[0].max(ends[1]) + BEYOND];
    if !(stress(low) < 0.0 && stress(high) > 0.0) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if stress(middle) < 0.0 { low = middle } else { high = middle }
    }
    Some(at(0.5 * (low + high)))
}

/// Nominal stress of the law at every point of `data`, Pa.
pub fn predict(law: &Law, values: &[f64], data: &[DataSet]) -> Vec<f64> {
    let elastic = law.elastic(values);
    let of_set = |set: &DataSet| {
        let stretches: Vec<f64> = set.points.iter().map(|point| point.0).collect();
        nominal(&elastic, set.mode, &stretches)
    };
    data.iter().flat_map(of_set).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{LAWS, Law, MODES};

    /// Source: Ogden, Non-linear Elastic Deformations (1984): W of the invariants in uniaxial, planar and equibiaxial
    /// extension; written here with the derivatives of W, not with the kernel's.
    #[test]
    fn the_closed_forms_of_the_three_tests() {
        let (c10, c01, c11, c20, c02) = (0.11e6, 0.07e6, 0.02e6, 0.003e6, 0.005e6);
        let elastic = Elastic::new(&Law::find("mooney_rivlin_5").unwrap().material(&[c10, c01, c11, c20, c02]));
        for mode in [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial, Mode::SimpleShear] {
            for l in [0.3_f64, 0.7, 0.999, 1.001, 1.5, 3.0] {
                let s = stretches(mode, l);
                let (i1, i2) =
                    (s.iter().map(|l| l * l).sum::<f64>() - 3.0, s.iter().map(|l| 1.0 / (l * l)).sum::<f64>() - 3.0);
                let (w1, w2) = (c10 + 2.0 * c20 * i1 + c11 * i2, c01 + 2.0 * c02 * i2 + c11 * i1);
                let expected = match mode {
                    Mode::Uniaxial => 2.0 * (l - l.powi(-2)) * (w1 + w2 / l),
                    Mode::Planar => 2.0 * (l - l.powi(-3)) * (w1 + w2),
                    Mode::Equibiaxial => 2.0 * (l - l.powi(-5)) * (w1 + l * l * w2),
                    // l is the amount of shear.
                    Mode::SimpleShear => 2.0 * l * (w1 + w2),
                };
                let found = nominal(&elastic, mode, &[l])[0];
                assert!((found - expected).abs() < 1e-11 * c10.max(expected.abs()), "{mode:?} {l}: {found} {expected}");
            }
        }
    }

    /// Source: Ogden (1972): P = sum mu_k (l^(alpha_k - 1) - l_free^alpha_k / l).
    #[test]
    fn the_closed_form_of_ogden() {
        let values = [0.63e6, 1.3, 0.0012e6, 5.0, -0.01e6, -2.0];
        let elastic = Elastic::new(&Law::find("ogden_3").unwrap().material(&values));
        for mode in MODES {
            for l in [0.4_f64, 0.9, 1.1, 2.0, 6.0] {
                let free = stretches(mode, l)[1];
                let expected: f64 =
                    values.chunks(2).map(|term| term[0] * (l.powf(term[1]) - free.powf(term[1])) / l).sum();
                let found = nominal(&elastic, mode, &[l])[0];
                assert!((found - expected).abs() < 1e-11 * expected.abs(), "{mode:?} {l}: {found} {expected}");
            }
        }
    }

    #[test]
    fn many_points_give_what_one_gives() {
        let elastic = Elastic::new(&LAWS[3].material(&[1.0, 2.0, 3.0, 4.0, 5.0]));
        let points: Vec<f64> = (1..30).map(|k| 0.5 + 0.1 * f64::from(k)).collect();
        let together = nominal(&elastic, Mode::Uniaxial, &points);
        for (l, stress) in points.iter().zip(together) {
            assert_eq!(nominal(&elastic, Mode::Uniaxial, &[*l])[0], stress);
        }
    }
}
