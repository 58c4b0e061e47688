//! Scenarios that cannot be simulated.

use thiserror::Error;

use super::name::Name;
use super::parameter::{NoEffect, ParameterError};
use crate::number::decimal::Decimal;
use crate::number::real::Real;

/// A scenario that cannot be simulated.
///
/// ```
/// use softanvil_kernel::{ScenarioError, preset};
///
/// let mut scenario = preset::study();
/// scenario.layers[0].material.prony_g = [0.75, 0.5, 0.0, 0.0, 0.0];
/// assert_eq!(scenario.validate(), Err(ScenarioError::PronySum { layer: 0, sum: 1.25 }));
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum ScenarioError {
    /// One value is out of its range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A given value has no effect.
    #[error(transparent)]
    NoEffect(NoEffect),
    /// Two given values state the same thing.
    #[error("{} and {} state the same thing: expected one of them", names[0], names[1])]
    Contradiction {
        /// Names of their parameters.
        names: [Name; 2],
    },
    /// A layer is wider than what it lies on.
    #[error("layers[{layer}].width = {} m is refused: expected at most {} m, the width of what is below it", Decimal(*width), Decimal(*maximum))]
    LayerWidth {
        /// The layer, counted from the core.
        layer: usize,
        /// Its width, m.
        width: Real,
        /// Largest legal width, m.
        maximum: Real,
    },
    /// A layer has next to no thickness.
    #[error("layers[{layer}].thickness = {} m is refused: expected at least {} m", Decimal(*thickness), Decimal(*minimum))]
    LayerThickness {
        /// The layer, counted from the core.
        layer: usize,
        /// Its thickness, m.
        thickness: Real,
        /// Smallest legal thickness, m.
        minimum: Real,
    },
    /// The Prony coefficients leave no long-term stiffness.
    #[error("layers[{layer}].prony_g_1 to _5 sum to {}: expected at least 0 and below 1", Decimal(*sum))]
    PronySum {
        /// The layer, counted from the core.
        layer: usize,
        /// sum g_i.
        sum: Real,
    },
    /// The elastic law has no positive shear modulus at rest.
    #[error("layers[{layer}].{coefficients} a shear modulus of {} Pa: expected above 0 Pa", Decimal(*modulus))]
    ShearModulus {
        /// The layer, counted from the core.
        layer: usize,
        /// Names of the coefficients that give it, and the verb that belongs to them.
        coefficients: &'static str,
        /// Its shear modulus at rest, Pa.
        modulus: Real,
    },
    /// A compressible law has no positive bulk modulus at rest.
    #[error("layers[{layer}]: the coefficients of the law give a bulk modulus of {} Pa: expected above 0 Pa", Decimal(*modulus))]
    BulkModulus {
        /// The layer, counted from the core.
        layer: usize,
        /// Its bulk modulus at rest, Pa.
        modulus: Real,
    },
    /// The material would be torn before the test.
    #[error("layers[{layer}].tear_stretch = {} is refused: expected 0 (off) or at least 1", Decimal(*stretch))]
    TearStretch {
        /// The layer, counted from the core.
        layer: usize,
        /// Stretch at which it begins to tear.
        stretch: Real,
    },
    /// The stress would turn round in softening.
    #[error("layers[{layer}].softening_r = {} is refused: expected 0 (off) or at least 1", Decimal(*r))]
    Softening {
        /// The layer, counted from the core.
        layer: usize,
        /// r of the softening.
        r: Real,
    },
    /// The face is narrower than two cells, of which none may be under it.
    #[error("{name} = {} m is refused: expected at least {} m on this mesh, or a smaller mesh.element_size", Decimal(*width), Decimal(*minimum))]
    FaceTooSmall {
        /// Name of the parameter that says how wide it is.
        name: &'static str,
        /// What that says, m.
        width: Real,
        /// Smallest legal value, m.
        minimum: Real,
    },
    /// A face that the formulation cannot have.
    #[error("impactor.shape = {shape} is refused: expected {expected} with geometry.formulation = {formulation}")]
    FaceOfFormulation {
        /// Label of the face's shape.
        shape: &'static str,
        /// What the formulation can have instead.
        expected: &'static str,
        /// Label of the formulation.
        formulation: &'static str,
    },
    /// A pad, or a face, that the kernel was built without.
    #[error("{name} is refused: expected a kernel that was built with its feature pads")]
    WithoutPads {
        /// What asks for it.
        name: Name,
    },
    /// What a solid does not have.
    #[error("{name} is refused: expected {expected} with geometry.formulation = solid")]
    NotInSolid {
        /// What asks for it.
        name: Name,
        /// What it has instead.
        expected: &'static str,
    },
    /// A full section of a body of revolution.
    #[error("geometry.section = full is refused: expected half with an axisymmetric formulation")]
    FullAxisymmetric,
    /// An impactor beside the centre line of a half section.
    #[error("impactor.offset = {} m is refused: expected 0 m with geometry.section = half", Decimal(*offset))]
    OffsetOfHalf {
        /// Distance from the centre line, m.
        offset: Real,
    },
}
