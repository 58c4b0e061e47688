//! Arruda and Boyce's chains of eight, isochoric (E. M. Arruda and M. C. Boyce, J. Mech. Phys. Solids 41 (1993) 389), with
//! the first five terms of the series of the inverse Langevin function, which is the form of Abaqus and LS-DYNA:
//!
//! W = mu sum_i C_i / lm^(2i - 2) (I1^i - 3^i), C = 1/2, 1/20, 11/1050, 19/7000, 519/673750,
//!
//! with I1 = tr C-bar and the stretch lm at which the chains are fully extended, whose square is their number N of links. The
//! series goes on to rise beyond it. The shear modulus at rest is not mu but
//!
//! G = mu (1 + 3/5 lm^-2 + 99/175 lm^-4 + 513/875 lm^-6 + 42039/67375 lm^-8).
//!
//! The kernel has the polynomial in a = I1 - 3, W = sum d_j a^j, all of whose coefficients are positive: it takes no difference
//! of nearly equal powers.

use crate::material::coefficient::Coefficient;
use crate::material::invariants::{invariant_principal_stress, invariant_shear_tangent};
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricState, IsochoricTensor};

/// C_i.
const SERIES: [Real; 5] = [0.5, 0.05, 11.0 / 1050.0, 19.0 / 7000.0, 519.0 / 673_750.0];

/// Coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArrudaBoyce {
    /// Modulus, Pa.
    mu: Real,
    /// Stretch at which the chains are fully extended.
    lambda_m: Real,
    /// d_j, Pa.
    polynomial: [Real; 5],
}

impl ArrudaBoyce {
    /// The law with a modulus, Pa, and a stretch at which the chains are fully extended.
    pub fn new(mu: Real, lambda_m: Real) -> Self {
        let [k1, k2, k3, k4, k5] = terms(mu, lambda_m);
        // By the binomial theorem with I1 = 3 + a.
        let polynomial = [
            k1 + 6.0 * k2 + 27.0 * k3 + 108.0 * k4 + 405.0 * k5,
            k2 + 9.0 * k3 + 54.0 * k4 + 270.0 * k5,
            k3 + 12.0 * k4 + 90.0 * k5,
            k4 + 15.0 * k5,
            k5,
        ];
        Self { mu, lambda_m, polynomial }
    }

    /// Stress, Pa, and W, J/m3, at a C-bar.
    #[inline(always)]
    fn of_strain<V: Vector, C: IsochoricTensor<V>>(&self, c: &C) -> (C::Deviator, V) {
        let a = c.first_invariant();
        (c.scaled_deviator(self.slope(a).mul_scalar(2.0)), self.energy(a))
    }

    /// W, J/m3, at a = I1 - 3.
    #[inline(always)]
    fn energy<V: Vector>(&self, a: V) -> V {
        let [d1, d2, d3, d4, d5] = self.polynomial;
        a * horner(a, [d1, d2, d3, d4, d5])
    }

    /// dW/dI1, Pa.
    #[inline(always)]
    fn slope<V: Vector>(&self, a: V) -> V {
        let [d1, d2, d3, d4, d5] = self.polynomial;
        horner(a, [d1, 2.0 * d2, 3.0 * d3, 4.0 * d4, 5.0 * d5])
    }

    /// d2W/dI1^2, Pa.
    #[inline(always)]
    fn second<V: Vector>(&self, a: V) -> V {
        let [_, d2, d3, d4, d5] = self.polynomial;
        horner(a, [2.0 * d2, 6.0 * d3, 12.0 * d4, 20.0 * d5, 0.0])
    }
}

/// mu C_i / lm^(2i - 2), Pa.
fn terms(mu: Real, lambda_m: Real) -> [Real; 5] {
    let shrink = 1.0 / (lambda_m * lambda_m);
    let mut factor = mu;
    SERIES.map(|c| {
        let term = c * factor;
        factor *= shrink;
        term
    })
}

/// The polynomial of these coefficients, from that of 1 on.
#[inline(always)]
fn horner<V: Vector>(a: V, [c0, c1, c2, c3, c4]: [Real; 5]) -> V {
    let sum = a * a.mul_scalar(c4).add_scalar(c3);
    (a * (a * sum.add_scalar(c2)).add_scalar(c1)).add_scalar(c0)
}

impl HyperelasticLaw for ArrudaBoyce {
    const NAME: &'static str = "arruda_boyce";
    const LABEL: &'static str = "Arruda-Boyce";
    const DESCRIPTION: &'static str = "W = mu sum C_i / lambda_m^(2i - 2) (I1^i - 3^i), five terms";
    const COEFFICIENTS: &'static [Coefficient] = &[
        Coefficient {
            min: 0.0,
            ..Coefficient::modulus(
                "arruda_boyce_mu",
                (2.0, 2.0),
                "arruda_boyce modulus; that of shear at rest is mu (1 + 3/5 lambda_m^-2 + ...), series of five terms",
            )
        },
        Coefficient::shape(
            "arruda_boyce_lambda_m",
            "arruda_boyce_mu",
            (1.0, 100.0),
            5.0,
            (2.5, 8.0),
            "arruda_boyce stretch at which the chains are fully extended, the root of their number of links",
        ),
    ];
    const VARIANTS: &'static [Variant] = &[Variant { name: "arruda_boyce", label: "Arruda-Boyce", n_coefficient: 2 }];
    const MODULUS_AT_REST: &'static str = "arruda_boyce_mu gives";
    const EXAMPLE: &'static [Real] = &[0.25e6, 5.0];

    type Values = [Real; 2];

    fn from_values([mu, lambda_m]: [Real; 2]) -> Self {
        Self::new(mu, lambda_m)
    }

    fn values(&self) -> [Real; 2] {
        [self.mu, self.lambda_m]
    }

    fn shear_modulus(&self) -> Real {
        2.0 * self.polynomial[0]
    }

    /// From the series in I1 itself.
    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        invariant_principal_stress(stretches, |i1, _| {
            let [k1, k2, k3, k4, k5] = terms(self.mu, self.lambda_m);
            (k1 + i1 * (2.0 * k2 + i1 * (3.0 * k3 + i1 * (4.0 * k4 + i1 * 5.0 * k5))), 0.0)
        })
    }
}

impl IsochoricLaw for ArrudaBoyce {
    #[inline(always)]
    fn response<S: Simd>(&self, _: S, kinematics: &Kinematics<S::Vector>, _: bool) -> (Deviator<S::Vector>, S::Vector) {
        self.of_strain(&kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        _: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        self.of_strain(&kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let (a, zero) = (stretch.invariants().0.add_scalar(-3.0), simd.splat(0.0));
        invariant_shear_tangent(simd, stretch, [self.slope(a), zero], [self.second(a), zero, zero])
    }
}

#[cfg(all(test, not(feature = "single")))]
#[allow(clippy::excessive_precision, reason = "references have the digits of their source")]
mod tests {
    use super::*;
    use crate::material::Elastic;
    use crate::tensor::stretch::IsochoricStretch;

    /// W, J/m3, and the difference of the principal stresses in uniaxial extension, Pa, and the shear modulus at rest, of mu =
    /// 0.27 MPa and lambda_m = 5.
    ///
    /// Source: the definition of W, differentiated numerically with 40 digits (mpmath 1.3), and the series of G.
    #[test]
    fn energy_and_stress_in_uniaxial_extension() {
        let law = ArrudaBoyce::new(0.27e6, 5.0);
        for (l, energy, difference) in [
            (0.5, 173_881.086_998_476_809, -489_476.777_327_462_338),
            (1.000_976_562_5, 0.395_615_049_345_867_224, 810.747_203_392_599_727),
            (1.5, 80_913.907_384_280_346_3, 440_335.783_767_073_222),
            (4.0, 1_988_986.560_658_800_45, 4_963_028.940_588_342_86),
        ] {
            let side = 1.0 / crate::number::math::sqrt(l);
            let [loaded, free, _] = law.principal_stress([l, side, side]);
            let stretch = IsochoricStretch { u11: l, u22: side, u12: 0.0, u33: side };
            let found = Elastic::ArrudaBoyce(law).strain_energy_density(&stretch);
            // I1 is rounded to the last digit of 3, which counts next to rest.
            let rounding = 1e-15 * law.mu;
            assert!((found - energy).abs() < 1e-14 * energy + rounding, "{l}: {found} J/m3 of {energy}");
            assert!(((loaded - free) / difference - 1.0).abs() < 1e-12, "{l}: {} of {difference} Pa", loaded - free);
        }
        assert!((law.shear_modulus() / 276_734.950_866_594_434 - 1.0).abs() < 1e-15, "{}", law.shear_modulus());
    }
}
