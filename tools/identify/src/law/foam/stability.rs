//! Whether more strain always needs more stress: the tangent of a law that changes its volume.
//!
//! Between the three logarithmic strains and the Kirchhoff stresses it is sum 2 mu l_i^alpha on the diagonal and
//! sum 2 mu beta J^(-alpha beta) everywhere, so it is positive definite if every mu is positive, which is more than needed.

use nalgebra::Matrix3;

use super::stress::{State, Term};
use crate::law::stability::Stability;

/// Of the law of `terms`: over stretches at which a free stretch is found and the tangent there is positive definite.
pub fn of(terms: &[Term]) -> Stability {
    Stability::of(|mode, stretch| {
        let strains = State::new(mode, stretch).strains(terms);
        strains.is_some_and(|strains| tangent(terms, strains).symmetric_eigenvalues().min() > 0.0)
    })
}

/// Hessian of W by the logarithmic `strains`, Pa.
fn tangent(terms: &[Term], strains: [f64; 3]) -> Matrix3<f64> {
    let volume: f64 = strains.iter().sum();
    terms.iter().fold(Matrix3::zeros(), |sum, term| {
        let slopes = strains.map(|strain| term.tangent(strain, volume));
        let own = Matrix3::from_diagonal(&slopes.map(|(own, _)| own).into());
        sum + own + Matrix3::from_element(slopes[0].1)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::stability::SCAN;

    /// Linear elasticity: 2 G + lambda on the diagonal, lambda beside it, with lambda = 2 G nu / (1 - 2 nu).
    #[test]
    fn the_tangent_at_rest_is_that_of_linear_elasticity() {
        let found = tangent(&Term::list(&[3e4, 7.0, 0.25]), [0.0; 3]);
        let (g, lambda) = (3e4, 2.0 * 3e4 * 0.25 / 0.5);
        let expected = Matrix3::from_diagonal_element(2.0 * g) + Matrix3::from_element(lambda);
        assert!((found - expected).abs().max() < 1e-9);
    }

    #[test]
    fn positive_moduli_are_stable_everywhere_and_a_negative_one_up_to_the_maximum_of_stress() {
        assert_eq!(of(&Term::list(&[3e4, 7.0, 0.1, 2e4, -4.0, 0.3])), Stability([SCAN; 3]));
        // Without lateral strain in tension, P l = tau = 2 mu / alpha (l^alpha - 1) of each term, whose maximum over ln l is where
        // 3e4 l^4 = 2e4 l^6.
        let stable = of(&Term::list(&[3e4, 4.0, 0.0, -2e4, 6.0, 0.0])).0[0].1;
        assert!((stable - 1.5_f64.sqrt()).abs() < 0.02, "{stable}");
    }
}
