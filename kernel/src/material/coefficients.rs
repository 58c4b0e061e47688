//! Values of the coefficients of all laws, side by side: which of them act is up to the law that is chosen, so that law
//! and values can be set in any order.

use crate::material::elastic::{COEFFICIENTS, ElasticLaw, ListedLaw, N_COEFFICIENT};
use crate::number::real::Real;

/// A value for each of [`COEFFICIENTS`].
///
/// ```
/// use softanvil_kernel::material::{Coefficients, Yeoh};
///
/// let yeoh = Coefficients::of(&Yeoh { c10: 1e5, c20: -2e3, ..Yeoh::ZERO });
/// assert_eq!((yeoh.get("c20"), yeoh.get("c01"), yeoh.get("c00")), (Some(-2e3), Some(0.0), None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients([Real; N_COEFFICIENT]);

impl Coefficients {
    /// None given: every modulus is 0.
    pub const START: Self = {
        let mut values = [0.0; N_COEFFICIENT];
        let mut i = 0;
        while i < N_COEFFICIENT {
            values[i] = COEFFICIENTS[i].start;
            i += 1;
        }
        Self(values)
    };

    /// Those of `law`; none of the others is given.
    pub fn of<L: ListedLaw>(law: &L) -> Self {
        Self::of_values(L::LAW, law.values().as_ref())
    }

    /// Those of `law` by their `values`, in its order, of which the last may be missing; none of the others is given.
    pub fn of_values(law: ElasticLaw, values: &[Real]) -> Self {
        let mut coefficients = Self::START;
        for (place, own) in law.places().iter().zip(values) {
            coefficients.set_at(*place, *own);
        }
        coefficients
    }

    /// The same with every modulus times `factor`.
    #[must_use]
    pub fn scaled(mut self, factor: Real) -> Self {
        for (coefficient, value) in COEFFICIENTS.iter().zip(&mut self.0) {
            if coefficient.is_modulus() {
                *value *= factor;
            }
        }
        self
    }

    /// The value of the coefficient called `name`; none of a name that no law has.
    pub fn get(&self, name: &str) -> Option<Real> {
        COEFFICIENTS.iter().zip(self.0).find(|(coefficient, _)| coefficient.name == name).map(|(_, value)| value)
    }

    /// The coefficient called `name`, to be changed.
    pub fn get_mut(&mut self, name: &str) -> Option<&mut Real> {
        COEFFICIENTS.iter().zip(&mut self.0).find(|(coefficient, _)| coefficient.name == name).map(|(_, value)| value)
    }

    /// Every value, in the order of [`COEFFICIENTS`].
    pub fn values(&self) -> &[Real; N_COEFFICIENT] {
        &self.0
    }

    /// The value at a place among [`COEFFICIENTS`]; 0 beyond the last.
    pub fn at(&self, place: usize) -> Real {
        self.0.get(place).copied().unwrap_or(0.0)
    }

    /// Sets the value at a place among [`COEFFICIENTS`]; nothing beyond the last.
    pub fn set_at(&mut self, place: usize, value: Real) {
        if let Some(at) = self.0.get_mut(place) {
            *at = value;
        }
    }
}
