//! The isochoric hyperelastic laws, one a line of `laws!`, from whose descriptions everything else follows: the choice
//! of a user, the coefficients of all laws together, and the dispatch, which is made once per block of triangles and
//! outside the loop over lanes.

use strum::{FromRepr, VariantNames};

use crate::material::coefficient::Coefficient;
use crate::material::law::{IsochoricLaw, LawDescription, sealed};
use crate::material::union::{distinct, n_distinct, places};
use crate::material::{ArrudaBoyce, Gent, MooneyRivlin, NeoHookean, Ogden, Yeoh};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// Makes of the laws the choice among them and their dispatch.
macro_rules! laws {
    ($($law:ident),+ $(,)?) => {
        /// The isochoric hyperelastic law.
        #[derive(Clone, Copy, Debug, FromRepr, PartialEq, Eq)]
        pub enum ElasticLaw {
            $(#[doc = concat!("See [`", stringify!($law), "`].")] $law,)+
        }

        /// Long-term isochoric elasticity.
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

            /// What the law says of itself.
            pub fn description(self) -> &'static LawDescription {
                match self {
                    $(Self::$law => &const { LawDescription::of::<$law>() },)+
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

            /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of `N` neighbouring triangles each; without
            /// `axisymmetric`, U33 = 1.
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
                            response[i] = law.response(simd, &kinematics[i], axisymmetric);
                        }
                    })+
                }
                response
            }

            /// Shear modulus at rest, Pa.
            pub fn shear_modulus(&self) -> Real {
                match self {
                    $(Self::$law(law) => law.shear_modulus(),)+
                }
            }

            /// A majorant of the shear tangent at a stretch with the geometric stiffness of the stress, Pa.
            #[inline(always)]
            pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
                match self {
                    $(Self::$law(law) => law.shear_tangent(simd, stretch),)+
                }
            }

            /// The closed form of [`IsochoricLaw::principal_stress`], Pa.
            pub fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
                match self {
                    $(Self::$law(law) => law.principal_stress(stretches),)+
                }
            }
        }
    };
}

// The list. A law keeps its place, which is the number of the choice; a new one goes to the end.
laws! {
    NeoHookean,
    MooneyRivlin,
    Yeoh,
    Ogden,
    Gent,
    ArrudaBoyce,
}

/// A law of the list.
pub trait ListedLaw: IsochoricLaw {
    /// Its choice.
    const LAW: ElasticLaw;
}

/// How many coefficients the laws have together.
pub const N_COEFFICIENT: usize = n_distinct(LISTS);

/// Every coefficient of a law, once, in the order of the laws.
pub static COEFFICIENTS: [Coefficient; N_COEFFICIENT] = distinct(LISTS);

/// A law by the `places` of its values, the moduli times `scale`.
fn select<L: IsochoricLaw>(places: &[usize], values: &[Real; N_COEFFICIENT], scale: Real) -> L {
    let mut own = L::Values::default();
    for (own, place) in own.as_mut().iter_mut().zip(places) {
        if let (Some(value), Some(coefficient)) = (values.get(*place), COEFFICIENTS.get(*place)) {
            *own = if coefficient.is_modulus() { scale * value } else { *value };
        }
    }
    L::from_values(own)
}

impl Elastic {
    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        let kinematics = Kinematics {
            mean: 0.5 * (stretch.u11 + stretch.u22),
            difference: 0.5 * (stretch.u11 - stretch.u22),
            shear: stretch.u12,
            hoop: stretch.u33,
            ..Kinematics::REST
        };
        let [(_, energy)] = self.stress(Scalar, &[kinematics], true);
        energy
    }
}
