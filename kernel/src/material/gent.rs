//! Gent, isochoric (A. N. Gent, Rubber Chem. Technol. 69 (1996) 59): W = -mu Jm/2 ln(1 - (I1-3)/Jm), I1 = tr C-bar, with the
//! shear modulus mu at rest and the limit Jm of I1 - 3, at which the chains of the network are fully extended. The
//! Kirchhoff stress in the unrotated frame is tau = dev(mu C-bar / (1 - (I1-3)/Jm)).
//!
//! The law ends at I1 - 3 = Jm, where a step may lead. From [`LAST`] of the limit on, W is continued by its Taylor polynomial of
//! degree two in I1, so that the stress goes on to rise, without a jump of it or of its tangent, at the tangent that it has
//! reached: 400 mu / Jm of 2 dW/dI1 by I1. The energy stays that of the stress, and the shear tangent its majorant.

use crate::material::coefficient::Coefficient;
use crate::material::invariants::{invariant_principal_stress, invariant_shear_tangent};
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::power;
use crate::number::real::Real;
use crate::number::real::consts::LN_2;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricState, IsochoricTensor};

/// Part of the limit up to which the law is Gent's: the stress is then twenty times that of a neo-Hookean material, more
/// than a rubber bears. Nearer to the limit its tangent, and so the step, is of no use.
pub const LAST: Real = 0.95;

/// 1 / (1 - [`LAST`]), what the stress is a multiple of there.
const LAST_FACTOR: Real = 1.0 / (1.0 - LAST);

/// Coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gent {
    /// Shear modulus at rest, Pa.
    mu: Real,
    /// Limit of I1 - 3.
    jm: Real,
    /// Its inverse.
    inverse_jm: Real,
}

/// Where the law is between rest and its limit.
struct State<V> {
    /// (I1 - 3) / Jm, and [`LAST`] beyond that.
    part: V,
    /// 1 less this.
    left: V,
    /// What there is beyond [`LAST`]; 0 before.
    beyond: V,
}

impl Gent {
    /// The law with a shear modulus at rest, Pa, and a limit of I1 - 3.
    pub fn new(mu: Real, jm: Real) -> Self {
        Self { mu, jm, inverse_jm: 1.0 / jm }
    }

    /// At a = I1 - 3. What is not a number stays so.
    #[inline(always)]
    fn state<S: Simd>(&self, simd: S, a: S::Vector) -> State<S::Vector> {
        let (whole, last) = (a.mul_scalar(self.inverse_jm), simd.splat(LAST));
        let part = whole.select_greater(last, last, whole);
        State { part, left: simd.splat(1.0) - part, beyond: whole - part }
    }

    /// Stress, Pa, and W, J/m3, at a C-bar.
    #[inline(always)]
    fn of_strain<S: Simd, C: IsochoricTensor<S::Vector>>(&self, simd: S, c: &C) -> (C::Deviator, S::Vector) {
        let state = self.state(simd, c.first_invariant());
        (c.scaled_deviator(self.factor(simd, &state)), self.energy(simd, &state))
    }

    /// 2 dW/dI1, Pa.
    #[inline(always)]
    fn factor<S: Simd>(&self, simd: S, state: &State<S::Vector>) -> S::Vector {
        let continued = state.beyond.mul_scalar(LAST_FACTOR * LAST_FACTOR);
        (simd.splat(1.0) / state.left + continued).mul_scalar(self.mu)
    }

    /// W, J/m3.
    #[inline(always)]
    fn energy<S: Simd>(&self, simd: S, state: &State<S::Vector>) -> S::Vector {
        // As a quotient whose difference is known, the logarithm is accurate however small the strain is.
        let logarithm = power::log2_of_quotient(simd, simd.splat(1.0), state.left, state.part).mul_scalar(LN_2);
        let scaled = state.beyond.mul_scalar(LAST_FACTOR);
        (logarithm + scaled + scaled * scaled.mul_scalar(0.5)).mul_scalar(0.5 * self.mu * self.jm)
    }
}

impl HyperelasticLaw for Gent {
    const NAME: &'static str = "gent";
    const LABEL: &'static str = "Gent";
    const DESCRIPTION: &'static str = "W = -mu Jm/2 ln(1 - (I1 - 3)/Jm)";
    const COEFFICIENTS: &'static [Coefficient] = &[
        Coefficient {
            min: 0.0,
            ..Coefficient::modulus(
                "gent_mu",
                (2.0, 2.0),
                "gent shear modulus at rest, W = -mu Jm/2 ln(1 - (I1 - 3)/Jm)",
            )
        },
        Coefficient::shape("gent_jm", "gent_mu", (0.01, 1e6), 80.0, (30.0, 150.0), "gent limit Jm of I1 - 3"),
    ];
    const VARIANTS: &'static [Variant] = &[Variant { name: "gent", label: "Gent", n_coefficient: 2 }];
    const MODULUS_AT_REST: &'static str = "gent_mu gives";
    const EXAMPLE: &'static [Real] = &[0.25e6, 80.0];

    type Values = [Real; 2];

    fn from_values([mu, jm]: [Real; 2]) -> Self {
        Self::new(mu, jm)
    }

    fn values(&self) -> [Real; 2] {
        [self.mu, self.jm]
    }

    fn shear_modulus(&self) -> Real {
        self.mu
    }

    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        invariant_principal_stress(stretches, |i1, _| {
            let at_last = 3.0 + LAST * self.jm;
            let gent = |i1: Real| 0.5 * self.mu * self.jm / (self.jm - (i1 - 3.0));
            let tangent = 0.5 * self.mu / self.jm / ((1.0 - LAST) * (1.0 - LAST));
            (if i1 <= at_last { gent(i1) } else { gent(at_last) + tangent * (i1 - at_last) }, 0.0)
        })
    }
}

impl IsochoricLaw for Gent {
    #[inline(always)]
    fn response<S: Simd>(
        &self,
        simd: S,
        kinematics: &Kinematics<S::Vector>,
        _: bool,
    ) -> (Deviator<S::Vector>, S::Vector) {
        self.of_strain(simd, &kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        self.of_strain(simd, &kinematics.isochoric_cauchy_green())
    }

    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        let state = self.state(simd, stretch.invariants().0.add_scalar(-3.0));
        let first = self.factor(simd, &state).mul_scalar(0.5);
        let second = simd.splat(0.5 * self.mu * self.inverse_jm) / (state.left * state.left);
        invariant_shear_tangent(simd, stretch, [first, zero], [second, zero, zero])
    }
}

#[cfg(all(test, not(feature = "single")))]
#[allow(clippy::excessive_precision, reason = "references have the digits of their source")]
mod tests {
    use super::*;
    use crate::material::Elastic;
    use crate::number::vector::Scalar;
    use crate::tensor::stretch::IsochoricStretch;

    fn uniaxial(l: Real) -> IsochoricStretch {
        let side = 1.0 / crate::number::math::sqrt(l);
        IsochoricStretch { u11: l, u22: side, u12: 0.0, u33: side }
    }

    /// W, J/m3, and the difference of the principal stresses in uniaxial extension, Pa, of mu = 0.27 MPa and Jm = 25.
    ///
    /// Source: the definition of W, differentiated numerically with 40 digits (mpmath 1.3).
    #[test]
    fn energy_and_stress_in_uniaxial_extension() {
        let law = Gent::new(0.27e6, 25.0);
        for (l, energy, difference) in [
            (0.5, 173_114.868_557_983_05, -497_368.421_052_631_579),
            (1.000_976_562_5, 0.385_986_908_445_363_715, 791.015_966_677_486_721),
            (1.5, 79_683.296_532_076_418, 437_713.310_580_204_778),
            (4.0, 2_620_784.664_559_112_74, 9_244_565.217_391_304_35),
        ] {
            let [loaded, free, _] = law.principal_stress([l, uniaxial(l).u22, uniaxial(l).u22]);
            let found = Elastic::Gent(law).strain_energy_density(&uniaxial(l));
            // I1 is rounded to the last digit of 3, which counts next to rest.
            let rounding = 1e-15 * law.mu;
            assert!((found - energy).abs() < 1e-14 * energy + rounding, "{l}: {found} J/m3 of {energy}");
            assert!(((loaded - free) / difference - 1.0).abs() < 1e-12, "{l}: {} of {difference} Pa", loaded - free);
        }
    }

    /// Energy and stress go on without a jump across [`LAST`] and beyond the limit, and stay numbers as far as I1 is one.
    #[test]
    fn beyond_its_limit_the_law_goes_on() {
        let law = Gent::new(0.27e6, 2.0);
        let at = |part: Real| {
            let state = law.state(Scalar, part * law.jm);
            [law.energy(Scalar, &state), law.factor(Scalar, &state)]
        };
        let step = 1e-7;
        for part in [0.5, LAST - step, LAST, LAST + step, 1.0, 1.5, 1e6] {
            let ([below, _], [above, _], [_, factor]) = (at(part * (1.0 - step)), at(part * (1.0 + step)), at(part));
            let slope = (above - below) / (step * part * law.jm);
            assert!((slope / factor - 1.0).abs() < 1e-5, "{part}: 2 dW/dI1 is {factor} Pa, the difference {slope} Pa");
        }
        assert!(at(1e150).into_iter().all(Real::is_finite));
        assert!(at(Real::NAN).into_iter().all(Real::is_nan));
        let stiff = Elastic::Gent(law).shear_tangent(Scalar, &uniaxial(10.0));
        assert!(stiff.is_finite() && stiff > LAST_FACTOR * law.mu, "{stiff}");
    }
}
