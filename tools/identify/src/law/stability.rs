//! Drucker stability: whether more strain always needs more stress.
//!
//! As in Abaqus ("Hyperelastic behavior of rubberlike materials", Analysis User's Guide) the tangent between increments of
//! logarithmic strain and of Kirchhoff stress must be positive definite in uniaxial, planar and equibiaxial deformation.
//! For an incompressible material with strains e1, e2 and e3 = -(e1 + e2) that is the 2 x 2 Hessian of W(e1, e2). The
//! three modes bound all others in the plane of the invariants, but a stable law in them may be unstable between.

use nalgebra::Matrix2;
use softanvil_kernel::material::Elastic;

use super::stress::{kirchhoff, stretches};
use super::{MODES, Mode};

/// The stretches over which stability is looked at, as in Abaqus.
pub const SCAN: (f64, f64) = (0.1, 10.0);

/// Stretches between two neighbours of a scan.
pub const STEP: f64 = 0.01;

/// Half of the difference of logarithmic strains that takes the derivative of the stress: rounding and curvature
/// contribute about 1e-11 and 1e-7 of the tangent.
const DIFFERENCE: f64 = 1e-4;

/// For each of [`MODES`], the stretches around 1 over which the law is stable: (from, to) within [`SCAN`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability(pub [(f64, f64); 3]);

impl Stability {
    /// Of an isochoric law.
    pub fn new(elastic: &Elastic) -> Self {
        Self::of(|mode, stretch| is_positive(&tangent(elastic, stretches(mode, stretch))))
    }

    /// Of a law that is stable in a test at a stretch where `is_stable` says so.
    pub fn of(is_stable: impl Fn(Mode, f64) -> bool) -> Self {
        let reach = |mode, end| reach(|stretch| is_stable(mode, stretch), end);
        Self(MODES.map(|mode| (reach(mode, SCAN.0), reach(mode, SCAN.1))))
    }

    /// Whether the law is stable in all three modes over the stretches `range`.
    pub fn covers(&self, range: (f64, f64)) -> bool {
        self.0.iter().all(|stable| stable.0 <= range.0 && stable.1 >= range.1)
    }
}

/// The farthest stretch towards `end` up to which the law is stable.
fn reach(is_stable: impl Fn(f64) -> bool, end: f64) -> f64 {
    let steps = ((end - 1.0).abs() / STEP).round() as usize;
    let mut stable = 1.0;
    for index in 0..=steps {
        let stretch = 1.0 + (end - 1.0) * index as f64 / steps as f64;
        if !is_stable(stretch) {
            return stable;
        }
        stable = stretch;
    }
    end
}

/// Hessian of W by the first two logarithmic strains, Pa, at isochoric principal `stretches`.
pub fn tangent(elastic: &Elastic, stretches: [f64; 3]) -> Matrix2<f64> {
    let moved = |axis: usize, by: f64| {
        let mut state = stretches;
        state[axis] *= by.exp();
        state[2] *= (-by).exp();
        state
    };
    let states = [moved(0, DIFFERENCE), moved(0, -DIFFERENCE), moved(1, DIFFERENCE), moved(1, -DIFFERENCE)];
    let stress = states.map(|state| kirchhoff(elastic, state));
    let slope = |axis: usize, component: usize| {
        let of = |index: usize| stress[index][component] - stress[index][2];
        (of(2 * axis) - of(2 * axis + 1)) / (2.0 * DIFFERENCE)
    };
    let mixed = 0.5 * (slope(0, 1) + slope(1, 0));
    Matrix2::new(slope(0, 0), mixed, mixed, slope(1, 1))
}

fn is_positive(tangent: &Matrix2<f64>) -> bool {
    tangent.symmetric_eigenvalues().min() > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Law;

    fn stability(law: &str, values: &[f64]) -> Stability {
        Stability::new(&Elastic::new(&Law::find(law).unwrap().material(values)))
    }

    /// Source: linear elasticity of an incompressible solid, W = G (e1^2 + e2^2 + e3^2).
    #[test]
    fn the_tangent_at_rest_is_that_of_linear_elasticity() {
        let elastic = Elastic::new(&Law::find("mooney_rivlin_2").unwrap().material(&[0.3, 0.2]));
        let expected = Matrix2::new(4.0, 2.0, 2.0, 4.0);
        assert!((tangent(&elastic, [1.0; 3]) - expected).abs().max() < 1e-6);
    }

    /// Source: positive mu alpha makes every term of Ogden's W convex in the logarithmic strains.
    #[test]
    fn laws_of_positive_terms_are_stable_everywhere() {
        for (law, values) in [
            ("neo_hookean", &[0.2e6][..]),
            ("mooney_rivlin_2", &[0.2e6, 0.1e6]),
            ("ogden_3", &[0.63e6, 1.3, 0.0012e6, 5.0, -0.01e6, -2.0]),
        ] {
            assert_eq!(stability(law, values), Stability([SCAN; 3]), "{law}");
        }
    }

    /// With C10 > 0 and C20 < 0 the uniaxial Cauchy stress 2 (l^2 - 1/l)(C10 + 2 C20 (I1 - 3)) has its maximum over ln l
    /// where its derivative vanishes; found here by bisection of that closed form.
    #[test]
    fn a_softening_yeoh_law_is_stable_up_to_its_maximum_of_stress() {
        let (c10, c20) = (1.0, -0.05);
        let slope = |l: f64| {
            let i = l * l + 2.0 / l - 3.0;
            (2.0 * l * l + 1.0 / l) * (c10 + 2.0 * c20 * i) + (l * l - 1.0 / l) * 2.0 * c20 * (2.0 * l * l - 2.0 / l)
        };
        let (mut low, mut high) = (1.0, 5.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if slope(middle) > 0.0 { low = middle } else { high = middle }
        }
        let stable = stability("yeoh_2", &[c10, c20]).0[0].1;
        // The other eigenvalue stays positive beyond it.
        assert!(stable <= low && stable > low - 2.0 * STEP, "{stable} {low}");
        assert!(!stability("yeoh_2", &[c10, c20]).covers((0.5, 3.0)));
    }
}
