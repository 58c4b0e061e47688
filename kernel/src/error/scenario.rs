//! Scenarios that cannot be simulated.

use core::fmt;

use super::parameter::{NoEffect, ParameterError};
use crate::number::decimal::Decimal;
use crate::number::real::Real;

/// A scenario that cannot be simulated.
///
/// ```
/// use softanvil_kernel::{ScenarioError, preset};
///
/// let mut scenario = preset::study();
/// scenario.silicone.prony_g = [0.75, 0.5, 0.0, 0.0, 0.0];
/// assert_eq!(scenario.validate(), Err(ScenarioError::PronySum { layer: "silicone", sum: 1.25 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScenarioError {
    /// One value is out of its range.
    Parameter(ParameterError),
    /// A given value has no effect.
    NoEffect(NoEffect),
    /// Two given values state the same thing.
    Contradiction {
        /// Names of their parameters.
        names: [&'static str; 2],
    },
    /// Another number of layers than in the base is given, but not how thick the silicone then is.
    LayerThickness {
        /// Whether two layers are given, or one.
        two: bool,
        /// Thickness of the silicone in the base, m.
        thickness: Real,
    },
    /// The Prony coefficients leave no long-term stiffness.
    PronySum {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// sum g_i.
        sum: Real,
    },
    /// The elastic law has no positive shear modulus at rest.
    ShearModulus {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// Names of the coefficients that give it, and the verb that belongs to them.
        coefficients: &'static str,
        /// Its shear modulus at rest, Pa.
        modulus: Real,
    },
    /// The material would be torn before the test.
    TearStretch {
        /// Group of the layer's parameters.
        layer: &'static str,
        /// Stretch at which it begins to tear.
        stretch: Real,
    },
    /// A skin with a material of its own has next to no thickness.
    SkinTooThin {
        /// Thickness of the skin, m.
        thickness: Real,
        /// Smallest legal thickness, m.
        minimum: Real,
    },
    /// The face does not cover the anvil, so the chord thickness ends inside the section.
    FaceTooSmall {
        /// Diameter of the face, m.
        diameter: Real,
        /// Smallest legal diameter for this anvil, m.
        minimum: Real,
    },
    /// A full section of a body of revolution.
    FullAxisymmetric,
    /// An impactor beside the centre line of a half section.
    OffsetOfHalf {
        /// Distance from the centre line, m.
        offset: Real,
    },
}

impl From<ParameterError> for ScenarioError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(error) => error.fmt(f),
            Self::NoEffect(no_effect) => no_effect.fmt(f),
            Self::Contradiction { names: [one, other] } => {
                write!(f, "{one} and {other} state the same thing: legal is one of them")
            }
            Self::LayerThickness { two, thickness } => {
                let (layers, of) = if *two { ("two", "the whole layer") } else { ("one", "the silicone alone") };
                let thickness = Decimal(*thickness);
                write!(
                    f,
                    "geometry.layers = {layers} needs geometry.silicone_thickness as well: {thickness} m is that of {of}"
                )
            }
            Self::PronySum { layer, sum } => {
                let sum = Decimal(*sum);
                write!(f, "{layer}.prony_g_1 to _5 sum to {sum}: legal is a sum of at least 0 and below 1")
            }
            Self::ShearModulus { layer, coefficients, modulus } => {
                let modulus = Decimal(*modulus);
                write!(f, "{layer}.{coefficients} a shear modulus of {modulus} Pa: legal is above 0 Pa")
            }
            Self::TearStretch { layer, stretch } => {
                let stretch = Decimal(*stretch);
                write!(f, "{layer}.tear_stretch = {stretch} is refused: legal is 0 (off) or at least 1")
            }
            Self::SkinTooThin { thickness, minimum } => {
                let (thickness, minimum) = (Decimal(*thickness), Decimal(*minimum));
                write!(
                    f,
                    "geometry.skin_thickness = {thickness} m is refused: with two layers legal is at least {minimum} m"
                )
            }
            Self::FullAxisymmetric => {
                f.write_str("geometry.section = full is refused: legal with an axisymmetric formulation is half")
            }
            Self::OffsetOfHalf { offset } => {
                let offset = Decimal(*offset);
                write!(f, "impactor.offset = {offset} m is refused: legal with geometry.section = half is 0 m")
            }
            Self::FaceTooSmall { diameter, minimum } => {
                let (diameter, minimum) = (Decimal(*diameter), Decimal(*minimum));
                write!(
                    f,
                    "impactor.face_diameter = {diameter} m is refused: over this anvil legal is at least {minimum} m"
                )
            }
        }
    }
}

impl core::error::Error for ScenarioError {}
