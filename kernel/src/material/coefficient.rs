//! What a law says of its coefficients.

use crate::number::real::Real;

/// A coefficient of one or more laws: everything that tables of parameters, fits and tests need to know of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// Name, which is that of its parameter within the group of a layer. Laws that share a coefficient share its name.
    pub name: &'static str,
    /// SI unit; "1" for a ratio.
    pub unit: &'static str,
    /// Smallest legal value; fits do not go beyond it.
    pub min: Real,
    /// Largest legal value, likewise.
    pub max: Real,
    /// Value where none is given.
    pub start: Real,
    /// What it does to the stress.
    pub role: Role,
    /// Between which values real materials have it: a modulus in parts of half of the shear modulus at rest, a shape as it is.
    /// Random materials of the tests are drawn from here.
    pub plausible: (Real, Real),
    /// Meaning, one line.
    pub description: &'static str,
}

/// What a coefficient does to the stress.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The stress is linear in it: at 0 its term is off.
    Modulus,
    /// The stress is not linear in it.
    Shape {
        /// Name of the modulus whose term it shapes: without it, it has no effect.
        of: &'static str,
    },
}

impl Coefficient {
    /// A modulus, Pa, of either sign and 0 where none is given.
    pub const fn modulus(name: &'static str, plausible: (Real, Real), description: &'static str) -> Self {
        Self { name, unit: "Pa", min: -1e9, max: 1e9, start: 0.0, role: Role::Modulus, plausible, description }
    }

    /// A ratio between `min` and `max` that shapes the term of the modulus called `of`.
    pub const fn shape(
        name: &'static str,
        of: &'static str,
        (min, max): (Real, Real),
        start: Real,
        plausible: (Real, Real),
        description: &'static str,
    ) -> Self {
        Self { name, unit: "1", min, max, start, role: Role::Shape { of }, plausible, description }
    }

    /// Whether the stress is linear in it.
    pub const fn is_modulus(&self) -> bool {
        matches!(self.role, Role::Modulus)
    }
}
