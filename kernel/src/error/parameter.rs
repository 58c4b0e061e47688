//! Refused values of parameters.

use core::fmt;

use thiserror::Error;

use super::name::Name;
use crate::number::decimal::Decimal;
use crate::number::real::Real;

/// A parameter value that is not legal.
///
/// ```
/// use softanvil_kernel::{Parameter, preset};
///
/// let mut scenario = preset::study();
/// let refused = Parameter::find("impactor.mass").unwrap().set(&mut scenario, -1.0).unwrap_err();
/// assert_eq!(refused.to_string(), "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg");
/// assert_eq!(scenario, preset::study());
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("{name} = {} is refused: expected {} to {}", Quantity(*value, unit), Decimal(*min), Quantity(*max, unit))]
pub struct ParameterError {
    /// Name of the parameter.
    pub name: Name,
    /// The refused value.
    pub value: Real,
    /// Unit of the value.
    pub unit: &'static str,
    /// Smallest legal value.
    pub min: Real,
    /// Largest legal value.
    pub max: Real,
}

/// Shows a quantity with its unit; "1" is not shown.
struct Quantity(Real, &'static str);

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.1 {
            "1" => write!(f, "{}", Decimal(self.0)),
            unit => write!(f, "{} {unit}", Decimal(self.0)),
        }
    }
}

/// A value that has no effect in its scenario.
///
/// ```
/// use softanvil_kernel::error::{NoEffect, Says};
/// use softanvil_kernel::{Changes, Parameter, ScenarioError, preset};
///
/// let mut changes = Changes::of(&preset::study());
/// let density = Parameter::find("layers[1].density").unwrap();
/// changes.set(density, 900.0)?;
/// let (by, says) = ("layers.count".into(), Says::Number(1.0));
/// let no_effect = NoEffect { name: density.name(), value: 900.0, unit: "kg/m3", by, says };
/// assert_eq!(changes.apply(), Err(ScenarioError::NoEffect(no_effect)));
/// assert_eq!(no_effect.to_string(), "layers[1].density = 900 kg/m3 has no effect: layers.count is 1");
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("{name} = {} has no effect: {by} is {says}", Quantity(*value, unit))]
pub struct NoEffect {
    /// Name of the parameter.
    pub name: Name,
    /// Its value.
    pub value: Real,
    /// Unit of the value.
    pub unit: &'static str,
    /// Name of the parameter that leaves it without effect.
    pub by: Name,
    /// What that says.
    pub says: Says,
}

/// What a parameter says: a choice or a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Says {
    /// Label of a choice.
    Label(&'static str),
    /// Value in the parameter's unit.
    Number(Real),
}

impl fmt::Display for Says {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Label(label) => f.write_str(label),
            Self::Number(number) => write!(f, "{}", Decimal(*number)),
        }
    }
}
