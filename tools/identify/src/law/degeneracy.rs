//! Fits whose coefficients mean nothing: terms that cancel, or that the data do not determine at all.

use std::fmt;

use nalgebra::DMatrix;

use super::Law;

/// Why the coefficients of a fit are not to be used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Degeneracy {
    /// The terms are so many times larger than the stress that they make: they cancel.
    Cancelling(f64),
    /// More than one set of coefficients gives the same stresses: the condition is infinite.
    Undetermined,
}

/// Sum of the sizes of all terms over that of the stresses, from which on terms count as cancelling: two digits of every
/// coefficient are then lost in the stress, and a slightly other stretch or state of strain brings them back.
const CANCELLING: f64 = 100.0;

impl Degeneracy {
    /// Of `law` with `values`, whose derivatives at the points are `jacobian`; none of a sound fit.
    pub fn of(law: &Law, values: &[f64], jacobian: &DMatrix<f64>, condition: f64) -> Option<Self> {
        // Every law is linear in its moduli, each of which makes a term.
        let moduli = (0..values.len()).filter(|k| law.parameters[*k].is_modulus());
        let terms: Vec<_> = moduli.map(|k| jacobian.column(k) * values[k]).collect();
        let sizes: f64 = terms.iter().map(|term| term.iter().map(|stress| stress.abs()).sum::<f64>()).sum();
        let stress = terms.iter().fold(jacobian.column(0) * 0.0, |sum, term| sum + term);
        let factor = sizes / stress.iter().map(|stress| stress.abs()).sum::<f64>();
        if factor > CANCELLING {
            return Some(Self::Cancelling(factor));
        }
        (!condition.is_finite()).then_some(Self::Undetermined)
    }
}

impl fmt::Display for Degeneracy {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Cancelling(factor) => write!(f, "its terms cancel, {factor:.0} times as large as the stress"),
            Self::Undetermined => write!(f, "other coefficients give the same stresses (condition infinite)"),
        }
    }
}
