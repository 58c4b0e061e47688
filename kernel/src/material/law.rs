//! What an isochoric hyperelastic law has to say and to do. [`crate::material::elastic`] lists the laws.

use crate::material::coefficient::Coefficient;
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// An isochoric hyperelastic law, W of U-bar = J^(-1/3) U, with its coefficients.
///
/// It is handed the whole deformation; that W does not see J is the law's own affair. The pressure is that of
/// [`crate::material::Volumetric`].
pub trait IsochoricLaw: Copy + sealed::Sealed {
    /// Name, the label of the choice `law`.
    const NAME: &'static str;
    /// Name for people.
    const LABEL: &'static str;
    /// W in one line.
    const DESCRIPTION: &'static str;
    /// Its coefficients. The first ones alone make the smaller [`Self::VARIANTS`].
    const COEFFICIENTS: &'static [Coefficient];
    /// How many of the coefficients fits free, from few to all.
    const VARIANTS: &'static [Variant];
    /// What gives the shear modulus at rest, with the verb that belongs to it.
    const MODULUS_AT_REST: &'static str;
    /// A soft rubber, some 0.2 MPa in shear: values of [`Self::COEFFICIENTS`], of which the first ones alone make one too.
    const EXAMPLE: &'static [Real];

    /// An array of a value for each of [`Self::COEFFICIENTS`].
    type Values: Copy + Default + AsRef<[Real]> + AsMut<[Real]>;

    /// The law with these values.
    fn from_values(values: Self::Values) -> Self;

    /// The values again.
    fn values(&self) -> Self::Values;

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3 of reference volume, of neighbouring triangles; without
    /// `axisymmetric`, U33 = 1.
    fn response<S: Simd>(
        &self,
        simd: S,
        kinematics: &Kinematics<S::Vector>,
        axisymmetric: bool,
    ) -> (Deviator<S::Vector>, S::Vector);

    /// Shear modulus at rest, Pa.
    fn shear_modulus(&self) -> Real;

    /// A majorant of the shear tangent at a stretch with the geometric stiffness of the stress, Pa.
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector;

    /// Principal Kirchhoff stresses, Pa, but for a pressure: l dW/dl for each of the isochoric principal `stretches`.
    ///
    /// It is the closed form of the literature, written apart from [`Self::response`], which is tested against it.
    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3];
}

/// A law with some of its coefficients, as fits have it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variant {
    /// Name on the command line.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// How many of the law's coefficients it has, the first ones; the others are as where none is given.
    pub n_coefficient: usize,
}

/// What a law says of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawDescription {
    /// [`IsochoricLaw::NAME`].
    pub name: &'static str,
    /// [`IsochoricLaw::LABEL`].
    pub label: &'static str,
    /// [`IsochoricLaw::DESCRIPTION`].
    pub description: &'static str,
    /// [`IsochoricLaw::COEFFICIENTS`].
    pub coefficients: &'static [Coefficient],
    /// [`IsochoricLaw::VARIANTS`].
    pub variants: &'static [Variant],
    /// [`IsochoricLaw::EXAMPLE`].
    pub example: &'static [Real],
}

impl LawDescription {
    /// Of the law `L`.
    pub const fn of<L: IsochoricLaw>() -> Self {
        Self {
            name: L::NAME,
            label: L::LABEL,
            description: L::DESCRIPTION,
            coefficients: L::COEFFICIENTS,
            variants: L::VARIANTS,
            example: L::EXAMPLE,
        }
    }
}

/// The list of laws is closed: [`crate::material::Elastic`] is an enum of them.
pub(super) mod sealed {
    /// Of the laws in the list.
    pub trait Sealed {}
}
