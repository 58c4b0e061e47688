//! What a hyperelastic law has to say and to do. [`crate::material::elastic`] lists the laws.

use crate::material::coefficient::Coefficient;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, Deviatoric};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::IsochoricState;

/// A hyperelastic law with its coefficients. It is an [`IsochoricLaw`] or a [`CompressibleLaw`].
pub trait HyperelasticLaw: Copy + sealed::Sealed {
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
    /// A soft rubber, some 0.2 MPa in shear, or a foam: values of [`Self::COEFFICIENTS`], of which the first ones alone make
    /// one too.
    const EXAMPLE: &'static [Real];

    /// An array of a value for each of [`Self::COEFFICIENTS`].
    type Values: Copy + Default + AsRef<[Real]> + AsMut<[Real]>;

    /// The law with these values.
    fn from_values(values: Self::Values) -> Self;

    /// The values again.
    fn values(&self) -> Self::Values;

    /// Shear modulus at rest, Pa.
    fn shear_modulus(&self) -> Real;

    /// Principal Kirchhoff stresses, Pa, l dW/dl for each of the principal `stretches`: of an isochoric law but for a
    /// pressure, from the isochoric stretches l = J^(-1/3) times the stretch; of a compressible law whole, from the stretches
    /// themselves.
    ///
    /// It is the closed form of the literature, written apart from the response to [`Kinematics`], which is tested against it.
    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3];
}

/// A law W of U-bar = J^(-1/3) U.
///
/// It is handed the whole deformation; that W does not see J is the law's own affair. The pressure is that of
/// [`crate::material::Volumetric`].
pub trait IsochoricLaw: HyperelasticLaw {
    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3 of reference volume, of neighbouring triangles; without
    /// `axisymmetric`, U33 = 1.
    fn response<S: Simd>(
        &self,
        simd: S,
        kinematics: &Kinematics<S::Vector>,
        axisymmetric: bool,
    ) -> (Deviator<S::Vector>, S::Vector);

    /// The same of neighbouring tetrahedra.
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector);

    /// A majorant of the shear tangent at a stretch with the geometric stiffness of the stress, Pa.
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector;
}

/// A law W of the whole U, which says the mean stress as well: there is no other volumetric law beside it.
pub trait CompressibleLaw: HyperelasticLaw {
    /// Bulk modulus at rest, Pa.
    fn bulk_modulus(&self) -> Real;

    /// Stress and W of `N` neighbouring triangles each; without `axisymmetric`, U33 = 1.
    fn response<S: Simd, const N: usize>(
        &self,
        simd: S,
        kinematics: &[Kinematics<S::Vector>; N],
        axisymmetric: bool,
    ) -> [WholeStress<S::Vector>; N];

    /// Stress and W of neighbouring tetrahedra.
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> WholeStress<S::Vector, SolidDeviator<S::Vector>>;

    /// A majorant of the moduli of shear and of volume strain of neighbouring tetrahedra with the geometric stiffness of the
    /// stress, Pa.
    fn solid_tangent<S: Simd>(&self, simd: S, stretches: [S::Vector; 3]) -> [S::Vector; 2];

    /// Stress and tangent along the principal directions of U of neighbouring triangles.
    fn principal_tangent<S: Simd>(&self, simd: S, kinematics: &Kinematics<S::Vector>) -> PrincipalTangent<S::Vector>;
}

/// Kirchhoff stresses along the principal directions of U, and how they grow with the principal stretches l_j:
/// l_j d tau_i / d l_j is `own` of i where i = j, and `common` besides. The larger stretch of the section comes first, then the
/// smaller one and the one out of it.
#[derive(Clone, Copy, Debug)]
pub struct PrincipalTangent<V> {
    /// tau_i, Pa.
    pub stress: [V; 3],
    /// (tau_1 - tau_2) / (l_1^2 - l_2^2), Pa, or the limit of that.
    pub turning: V,
    /// Pa.
    pub own: [V; 3],
    /// Pa.
    pub common: V,
    /// W, J/m3.
    pub energy: V,
}

/// Stress and energy of a compressible law, of neighbouring elements.
#[derive(Clone, Copy, Debug)]
pub struct WholeStress<V, D = Deviator<V>> {
    /// Deviator of the Kirchhoff stress in the unrotated frame, Pa.
    pub deviator: D,
    /// Mean of the Kirchhoff stress, Pa, positive in tension.
    pub mean: V,
    /// W, J/m3 of reference volume.
    pub energy: V,
}

impl<V: Vector> PrincipalTangent<V> {
    /// No stress, no tangent.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        let zero = simd.splat(0.0);
        Self { stress: [zero; 3], turning: zero, own: [zero; 3], common: zero, energy: zero }
    }
}

impl<V: Vector, D: Deviatoric<V>> WholeStress<V, D> {
    /// No stress, no energy.
    #[inline(always)]
    pub fn none<S: Simd<Vector = V>>(simd: S) -> Self {
        let zero = simd.splat(0.0);
        Self { deviator: D::uniform(zero), mean: zero, energy: zero }
    }
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
    /// [`HyperelasticLaw::NAME`].
    pub name: &'static str,
    /// [`HyperelasticLaw::LABEL`].
    pub label: &'static str,
    /// [`HyperelasticLaw::DESCRIPTION`].
    pub description: &'static str,
    /// Whether it is a [`CompressibleLaw`].
    pub compressible: bool,
    /// [`HyperelasticLaw::COEFFICIENTS`].
    pub coefficients: &'static [Coefficient],
    /// [`HyperelasticLaw::VARIANTS`].
    pub variants: &'static [Variant],
    /// [`HyperelasticLaw::EXAMPLE`].
    pub example: &'static [Real],
}

impl LawDescription {
    /// Of the law `L`.
    pub const fn of<L: HyperelasticLaw>(compressible: bool) -> Self {
        Self {
            name: L::NAME,
            label: L::LABEL,
            description: L::DESCRIPTION,
            compressible,
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
