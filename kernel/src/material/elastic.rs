//! The choice of isochoric hyperelastic law, made once per block of triangles and outside the loop over lanes.

use crate::kinematics::Kinematics;
use crate::lanes::Deviator;
use crate::material::{MooneyRivlin, NeoHookean, Ogden, Yeoh};
use crate::math::THIRD;
use crate::real::Real;
use crate::scenario::{ElasticLaw, Material};
use crate::stretch::IsochoricStretch;
use crate::vector::{Instructions, Vector};

/// Long-term isochoric elasticity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elastic {
    /// See [`crate::material::neo_hookean`].
    NeoHookean(NeoHookean),
    /// See [`crate::material::mooney_rivlin`].
    MooneyRivlin(MooneyRivlin),
    /// See [`crate::material::yeoh`].
    Yeoh(Yeoh),
    /// See [`crate::material::ogden`].
    Ogden(Ogden),
}

impl Elastic {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        match material.law {
            ElasticLaw::NeoHookean => Self::NeoHookean(NeoHookean::new(material)),
            ElasticLaw::MooneyRivlin => Self::MooneyRivlin(MooneyRivlin::new(material)),
            ElasticLaw::Yeoh => Self::Yeoh(Yeoh::new(material)),
            ElasticLaw::Ogden => Self::Ogden(Ogden::new(material)),
        }
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        match self {
            Self::NeoHookean(law) => law.strain_energy_density(stretch),
            Self::MooneyRivlin(law) => law.strain_energy_density(stretch),
            Self::Yeoh(law) => law.strain_energy_density(stretch),
            Self::Ogden(law) => law.strain_energy_density(stretch),
        }
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of `N` neighbouring triangles each; without `rings`,
    /// U33 = 1.
    #[inline(always)]
    pub fn stress<S: Instructions, const N: usize>(
        &self,
        set: S,
        kinematics: &[Kinematics<S::Vector>; N],
        rings: bool,
    ) -> [(Deviator<S::Vector>, S::Vector); N] {
        let zero = set.splat(0.0);
        let mut response = [(Deviator { mean: zero, difference: zero, shear: zero }, zero); N];
        // The law is chosen outside the loop, so that the triangles go through it side by side.
        match self {
            Self::NeoHookean(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i]);
                }
            }
            Self::MooneyRivlin(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i], rings);
                }
            }
            Self::Yeoh(law) => {
                for i in 0..N {
                    response[i] = law.stress(&kinematics[i]);
                }
            }
            Self::Ogden(law) => {
                let kinematics = *kinematics;
                for i in 0..N {
                    response[i] = law.stress(set, &kinematics[i]);
                }
            }
        }
        response
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        match self {
            Self::NeoHookean(law) => law.shear_modulus(),
            Self::MooneyRivlin(law) => law.shear_modulus(),
            Self::Yeoh(law) => law.shear_modulus(),
            Self::Ogden(law) => law.shear_modulus(),
        }
    }

    /// A majorant of the shear tangent at a stretch with the geometric stiffness of the stress, Pa.
    #[inline(always)]
    pub fn shear_tangent<S: Instructions>(&self, set: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        match self {
            Self::NeoHookean(law) => law.shear_tangent(set, stretch),
            Self::MooneyRivlin(law) => law.shear_tangent(set, stretch),
            Self::Yeoh(law) => law.shear_tangent(set, stretch),
            Self::Ogden(law) => law.shear_tangent(set, stretch),
        }
    }
}

/// A majorant of the shear tangent of a law of the invariants, Pa, with what its own stress adds to it, from the first
/// derivatives W1, W2 and the second ones W11, W12, W22.
///
/// With the principal values b_i of C-bar, turning the directions i and j meets W1 (b_i + b_j) + W2 (1/b_i + 1/b_j). Strain
/// along them meets, with the geometric stiffness of the stress, W1 b_i + 3 W2 / b_i, of which a plane state that keeps its
/// volume leaves W2 / b_i; the sums W1 (I1 - 1) + W2 (2 I2 - 4), and 2 W2 for every unit that b_3 or its inverse exceeds
/// one by, are found to cover both in meshes of any state (`tests/verification/tests/suite/frequency.rs`). The second
/// derivatives add the squares of dev b and dev 1/b, exactly. What softens is not counted.
#[inline(always)]
pub(crate) fn invariant_shear_tangent<S: Instructions>(
    set: S,
    stretch: &IsochoricStretch<S::Vector>,
    [w1, w2]: [S::Vector; 2],
    [w11, w12, w22]: [S::Vector; 3],
) -> S::Vector {
    let ((i1, i2), zero) = (stretch.invariants(), set.splat(0.0));
    let out = stretch.u33 * stretch.u33;
    let around = out.larger(set.splat(1.0) / out).plus(-1.0);
    let first = w1.larger(zero) * i1.plus(-1.0) + w2.larger(zero) * (i2 + around).times(2.0).plus(-4.0);
    // Squares and product of dev b and dev 1/b, the latter with its sign turned.
    let squares = [i1 * i1.times(2.0 * THIRD) - i2.times(2.0), i2 * i2.times(2.0 * THIRD) - i1.times(2.0)];
    let product = (i1 * i2.times(THIRD)).plus(-3.0);
    let second = w11.larger(zero) * squares[0].larger(zero)
        + w22.larger(zero) * squares[1].larger(zero)
        + (w12.larger(zero) * product.larger(zero)).times(2.0);
    first + second.times(2.0)
}
