//! Refused values of parameters.

use core::fmt;

use crate::number::decimal::Decimal;
use crate::number::real::Real;

/// A parameter value that is not legal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterError {
    /// Name of the parameter.
    pub name: &'static str,
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

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let legal = Quantity(self.max, self.unit);
        let (value, min) = (Quantity(self.value, self.unit), Decimal(self.min));
        write!(f, "{} = {value} is refused: legal is {min} to {legal}", self.name)
    }
}

impl core::error::Error for ParameterError {}

/// A value that has no effect in its scenario.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoEffect {
    /// Name of the parameter.
    pub name: &'static str,
    /// Its value.
    pub value: Real,
    /// Unit of the value.
    pub unit: &'static str,
    /// Name of the parameter that leaves it without effect.
    pub by: &'static str,
    /// What that says: the label of its choice, or nothing where it is 0.
    pub says: &'static str,
}

impl fmt::Display for NoEffect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, says) = (Quantity(self.value, self.unit), if self.says.is_empty() { "0" } else { self.says });
        write!(f, "{} = {value} has no effect: {} is {says}", self.name, self.by)
    }
}

impl core::error::Error for NoEffect {}
