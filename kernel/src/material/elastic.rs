//! The hyperelastic laws, one a line of `laws!`, from whose descriptions everything else follows: the choice
//! of a user, the coefficients of all laws together, and the dispatch, which is made once per block of triangles and
//! outside the loop over lanes.

use strum::{FromRepr, VariantNames};

#[cfg(feature = "pads")]
use crate::material::Hyperfoam;
use crate::material::coefficient::Coefficient;
#[cfg(feature = "pads")]
use crate::material::law::CompressibleLaw;
use crate::material::law::{HyperelasticLaw, IsochoricLaw, LawDescription, PrincipalTangent, WholeStress, sealed};
use crate::material::union::{distinct, n_distinct, places};
use crate::material::{ArrudaBoyce, Gent, MooneyRivlin, NeoHookean, Ogden, Yeoh};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricState, IsochoricStretch};

/// An expression for laws of one kind, another one for those of the other.
macro_rules! by_kind {
    (isochoric, $isochoric:expr, $compressible:expr) => {
        $isochoric
    };
    (compressible, $isochoric:expr, $compressible:expr) => {
        $compressible
    };
}

/// Makes of the laws the choice among them and their dispatch.
macro_rules! laws {
    ($($law:ident: $kind:ident),+ $(,)?) => {
        /// The hyperelastic law.
        #[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq)]
        pub enum ElasticLaw {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law,)+
        }

        /// Long-term elasticity.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Elastic {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law($law),)+
        }

        $(
            impl sealed::Sealed for $law {}

            impl ListedLaw for $law {
                const LAW: ElasticLaw = ElasticLaw::$law;
            }
        )+

        impl VariantNames for ElasticLaw {
            const VARIANTS: &'static [&'static str] = &[$($law::NAME),+];
        }

        impl ElasticLaw {
            /// Every law, in the order of its number.
            pub const ALL: &'static [Self] = &[$(Self::$law),+];

            /// Whether it says the mean stress as well: [`LawDescription::compressible`] without the rest of the description.
            pub fn is_compressible(self) -> bool {
                match self {
                    $(Self::$law => by_kind!($kind, false, true),)+
                }
            }

            /// What the law says of itself.
            pub fn description(self) -> &'static LawDescription {
                match self {
                    $(Self::$law => &const {
                        LawDescription::of::<$law>(by_kind!($kind, false, true))
                    },)+
                }
            }

            /// What gives the shear modulus at rest, with the verb that belongs to it.
            pub(crate) fn modulus_at_rest(self) -> &'static str {
                match self {
                    $(Self::$law => $law::MODULUS_AT_REST,)+
                }
            }

            /// Places of its coefficients in [`COEFFICIENTS`].
            pub(crate) fn places(self) -> &'static [usize] {
                match self {
                    $(Self::$law => &const { places::<{ $law::COEFFICIENTS.len() }>($law::COEFFICIENTS, LISTS) },)+
                }
            }
        }

        /// The coefficients of each law.
        const LISTS: &[&[Coefficient]] = &[$($law::COEFFICIENTS),+];

        impl Elastic {
            /// The law `choice` with its values among those of [`COEFFICIENTS`], the moduli times `scale`.
            pub(crate) fn of(choice: ElasticLaw, values: &[Real; N_COEFFICIENT], scale: Real) -> Self {
                match choice {
                    $(ElasticLaw::$law => Self::$law(select(choice.places(), values, scale)),)+
                }
            }

            /// Kirchhoff stress of an isochoric law in the unrotated frame, Pa, and W, J/m3, of `N` neighbouring triangles each;
            /// without `axisymmetric`, U33 = 1. Nothing of a compressible law.
            #[inline(always)]
            pub fn stress<S: Simd, const N: usize>(
                &self,
                simd: S,
                kinematics: &[Kinematics<S::Vector>; N],
                axisymmetric: bool,
            ) -> [(Deviator<S::Vector>, S::Vector); N] {
                let zero = simd.splat(0.0);
                let mut response = [(Deviator { mean: zero, difference: zero, shear: zero }, zero); N];
                // The law is chosen outside the loop, so that the triangles go through it side by side.
                match self {
                    $(Self::$law(law) => {
                        let kinematics = *kinematics;
                        for i in 0..N {
                            by_kind!(
                                $kind,
                                response[i] = law.response(simd, &kinematics[i], axisymmetric),
                                { let _ = (law, &kinematics[i]); }
                            )
                        }
                    })+
                }
                response
            }

            /// Stress and energy of a compressible law of `N` neighbouring triangles each; without `axisymmetric`, U33 = 1.
            /// Nothing of an isochoric law.
            #[inline(always)]
            pub fn whole_stress<S: Simd, const N: usize>(
                &self,
                simd: S,
                kinematics: &[Kinematics<S::Vector>; N],
                axisymmetric: bool,
            ) -> [WholeStress<S::Vector>; N] {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        { let _ = (law, kinematics, axisymmetric); [WholeStress::none(simd); N] },
                        law.response(simd, kinematics, axisymmetric)
                    ),)+
                }
            }

            /// Kirchhoff stress of an isochoric law in the unrotated frame, Pa, and W, J/m3, of neighbouring tetrahedra. Nothing of a
            /// compressible law.
            #[inline(always)]
            pub(crate) fn solid_stress<S: Simd>(
                &self,
                simd: S,
                kinematics: &SolidKinematics<S::Vector>,
            ) -> (SolidDeviator<S::Vector>, S::Vector) {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        law.solid_response(simd, kinematics),
                        { let _ = law; (SolidDeviator::none(simd), simd.splat(0.0)) }
                    ),)+
                }
            }

            /// Stress and energy of a compressible law of neighbouring tetrahedra. Nothing of an isochoric law.
            #[inline(always)]
            pub(crate) fn whole_solid_stress<S: Simd>(
                &self,
                simd: S,
                kinematics: &SolidKinematics<S::Vector>,
            ) -> WholeStress<S::Vector, SolidDeviator<S::Vector>> {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        { let _ = (law, kinematics); WholeStress::none(simd) },
                        law.solid_response(simd, kinematics)
                    ),)+
                }
            }

            /// Majorants of the moduli of shear and of volume strain of a compressible law, Pa. Nothing of an isochoric law.
            #[inline(always)]
            pub(crate) fn whole_solid_tangent<S: Simd>(&self, simd: S, stretches: [S::Vector; 3]) -> [S::Vector; 2] {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        { let _ = (law, stretches); [simd.splat(0.0); 2] },
                        law.solid_tangent(simd, stretches)
                    ),)+
                }
            }

            /// Stress and tangent of a compressible law along the principal directions of U of neighbouring triangles. Nothing of an
            /// isochoric law.
            #[inline(always)]
            pub fn principal_tangent<S: Simd>(
                &self,
                simd: S,
                kinematics: &Kinematics<S::Vector>,
            ) -> PrincipalTangent<S::Vector> {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        { let _ = (law, kinematics); PrincipalTangent::none(simd) },
                        law.principal_tangent(simd, kinematics)
                    ),)+
                }
            }

            /// Bulk modulus at rest of a compressible law, Pa; an isochoric one has none.
            pub fn bulk_modulus(&self) -> Option<Real> {
                match self {
                    $(Self::$law(law) => by_kind!($kind, { let _ = law; None }, Some(law.bulk_modulus())),)+
                }
            }

            /// Whether the law says the mean stress as well.
            pub fn is_compressible(&self) -> bool {
                match self {
                    $(Self::$law(_) => by_kind!($kind, false, true),)+
                }
            }

            /// Shear modulus at rest, Pa.
            pub fn shear_modulus(&self) -> Real {
                match self {
                    $(Self::$law(law) => law.shear_modulus(),)+
                }
            }

            /// A majorant of the shear tangent of an isochoric law at a stretch with the geometric stiffness of the stress, Pa.
            /// Nothing of a compressible law.
            #[inline(always)]
            pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
                match self {
                    $(Self::$law(law) => by_kind!(
                        $kind,
                        law.shear_tangent(simd, stretch),
                        { let _ = law; simd.splat(0.0) }
                    ),)+
                }
            }

            /// The closed form of [`HyperelasticLaw::principal_stress`], Pa.
            pub fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
                match self {
                    $(Self::$law(law) => law.principal_stress(stretches),)+
                }
            }
        }
    };
}

/// The list, with what stands behind the isochoric laws. A law keeps its place, which is the number of the choice; a new one goes
/// to the end.
macro_rules! list {
    ($($further:tt)*) => {
        laws! {
            NeoHookean: isochoric,
            MooneyRivlin: isochoric,
            Yeoh: isochoric,
            Ogden: isochoric,
            Gent: isochoric,
            ArrudaBoyce: isochoric,
            $($further)*
        }
    };
}

#[cfg(feature = "pads")]
list! { Hyperfoam: compressible }
#[cfg(not(feature = "pads"))]
list! {}

/// A law of the list.
pub trait ListedLaw: HyperelasticLaw {
    /// Its choice.
    const LAW: ElasticLaw;
}

/// How many coefficients the laws have together.
pub const N_COEFFICIENT: usize = n_distinct(LISTS);

/// Every coefficient of a law, once, in the order of the laws.
pub static COEFFICIENTS: [Coefficient; N_COEFFICIENT] = distinct(LISTS);

/// A law by the `places` of its values, the moduli times `scale`.
fn select<L: HyperelasticLaw>(places: &[usize], values: &[Real; N_COEFFICIENT], scale: Real) -> L {
    let mut own = L::Values::default();
    for (own, place) in own.as_mut().iter_mut().zip(places) {
        if let (Some(value), Some(coefficient)) = (values.get(*place), COEFFICIENTS.get(*place)) {
            *own = if coefficient.is_modulus() { scale * value } else { *value };
        }
    }
    L::from_values(own)
}

impl Elastic {
    /// W, J/m3 of reference volume, at a stretch that keeps the volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        let kinematics = Kinematics::of_isochoric(Scalar, stretch);
        let [(_, energy)] = self.stress(Scalar, &[kinematics], true);
        let [whole] = self.whole_stress(Scalar, &[kinematics], true);
        if self.is_compressible() { whole.energy } else { energy }
    }
}
