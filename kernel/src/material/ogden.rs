//! Ogden with three terms, isochoric (Ogden 1972), in Ogden's own convention, which is also that of LS-DYNA (MAT_077_O)
//! and OpenRadioss (LAW42):
//!
//! W = sum_k mu_k / alpha_k (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3), shear modulus at rest G = 1/2 sum mu_k alpha_k,
//!
//! with the principal values l_i of U-bar. Abaqus writes 2 mu_k / alpha_k^2 in front, so its mu_k = G_k are to be
//! entered here as 2 mu_k / alpha_k. A term with mu = 0 is off, and one with alpha = 0 contributes nothing.
//!
//! The principal Kirchhoff stresses are tau_i = sum mu_k l_i^alpha_k less their mean. With g = sqrt(l1 l2) in the section,
//! l3 = g^-2, and tanh x = r / m with m the mean and r the radius of Mohr's circle of U, the stretches are l1 = g e^x,
//! l2 = g e^-x. The stress is then, with y = alpha ln g,
//!
//! mean of the section - stress out of it = mu (e^y cosh(alpha x) - e^(-2y)),
//! half difference in the section / r     = mu e^y sinh(alpha x) / r,
//!
//! where no difference of nearly equal powers is taken: sinh(alpha x) / r is a quotient of two numbers that both carry
//! their full relative accuracy, and tends to alpha / m where the stretches coincide. All is written with e^y - 1,
//! e^-y - 1, e^(alpha x) - 1 and e^(-alpha x) - 1, which [`crate::number::power`] gives accurately however small the
//! strain is: cosh(alpha x) - 1 is -1/2 of the product of the last two, and the part of W without x is
//! (e^-y - 1)(e^-y - 1 - 2 (e^y - 1)).

use crate::material::coefficient::Coefficient;
use crate::material::law::{HyperelasticLaw, IsochoricLaw, Variant};
use crate::number::real::consts::LN_2;
use crate::number::real::{LARGEST_EXPONENT, Real, TINY_SQUARE};
use crate::number::vector::{Simd, Vector};
use crate::number::{math, power};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::IsochoricState;

/// Most terms of the law.
pub const MAX_OGDEN_TERMS: usize = 3;

/// Coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ogden {
    /// Coefficients, Pa; 0 where a term is off.
    mu: [Real; MAX_OGDEN_TERMS],
    /// Exponents.
    alpha: [Real; MAX_OGDEN_TERMS],
    /// mu / alpha, Pa; 0 where a term is off.
    energy_factor: [Real; MAX_OGDEN_TERMS],
    /// Binary logarithms of stretches are taken to be this at most, so that no power leaves the domain of
    /// [`power::exp2_of_both_signs`]. The stress there is beyond all that a step can follow.
    largest_log: Real,
}

impl Ogden {
    /// The law of these coefficients, Pa, and exponents; a term with mu = 0 is off.
    pub fn new(mu: [Real; MAX_OGDEN_TERMS], alpha: [Real; MAX_OGDEN_TERMS]) -> Self {
        let steepest = alpha.into_iter().fold(1.0, |steepest, alpha| math::max(steepest, math::abs(0.5 * alpha)));
        let mut energy_factor = [0.0; MAX_OGDEN_TERMS];
        for k in 0..MAX_OGDEN_TERMS {
            energy_factor[k] = if alpha[k] == 0.0 { 0.0 } else { mu[k] / alpha[k] };
        }
        Self { mu, alpha, energy_factor, largest_log: LARGEST_EXPONENT / steepest }
    }

    /// The terms that are on: (mu, alpha).
    #[inline(always)]
    fn terms(&self) -> impl Iterator<Item = (Real, Real)> {
        self.mu.into_iter().zip(self.alpha).filter(|(mu, alpha)| *mu != 0.0 && *alpha != 0.0)
    }

    /// Kirchhoff stress, Pa, and W, J/m3, from mean, half difference and shear of U in the section, whatever its volume, and
    /// the isochoric stretch out of it.
    #[inline(always)]
    fn of_stretch<S: Simd>(
        &self,
        simd: S,
        [mean, difference, shear]: [S::Vector; 3],
        out: S::Vector,
    ) -> (Deviator<S::Vector>, S::Vector) {
        let zero = simd.splat(0.0);
        let square = difference * difference + shear * shear;
        // Never zero, so that the quotient by the radius has its limit. Nothing else may see what is added.
        let radius = square.add_scalar(TINY_SQUARE).square_root();
        // Binary logarithms of l1 / l2 = e^(2x) and of l3 = e^(-2y / alpha).
        let log_in = self.limited(simd, power::log2_of_quotient(simd, mean + radius, mean - radius, radius + radius));
        let log_out = self.limited(simd, power::log2(simd, out));
        let (mut step, mut slope, mut energy) = (zero, zero, zero);
        for k in 0..MAX_OGDEN_TERMS {
            let (mu, alpha) = (self.mu[k], self.alpha[k]);
            if mu == 0.0 || alpha == 0.0 {
                continue;
            }
            // e^-y and e^y, e^(alpha x) and e^(-alpha x).
            let [inverse, power] = power::exp2_of_both_signs(log_out.mul_scalar(0.5 * alpha));
            let [longer, shorter] = power::exp2_of_both_signs(log_in.mul_scalar(0.5 * alpha));
            let (inverse, direct, power) = (inverse.exp2_m1, power.exp2_m1, power.whole);
            let (longer, shorter) = (longer.exp2_m1, shorter.exp2_m1);
            // -2 e^y (cosh(alpha x) - 1).
            let spread = simd.splat(TINY_SQUARE).select_greater(square, zero, power * (longer * shorter));
            step = step + (direct - inverse * inverse.add_scalar(2.0) - spread.mul_scalar(0.5)).mul_scalar(mu);
            slope = slope + (power * (longer - shorter)).mul_scalar(0.5 * mu);
            energy = energy + (inverse * (inverse - (direct + direct)) - spread).mul_scalar(self.energy_factor[k]);
        }
        let slope = slope / radius;
        (Deviator { mean: step.mul_scalar(SQRT_THIRD), difference: slope * difference, shear: slope * shear }, energy)
    }

    /// A logarithm between minus and plus the largest one. A NaN stays one.
    #[inline(always)]
    fn limited<S: Simd>(&self, simd: S, log: S::Vector) -> S::Vector {
        let [most, least] = [simd.splat(self.largest_log), simd.splat(-self.largest_log)];
        let log = log.select_greater(most, most, log);
        least.select_greater(log, least, log)
    }
}

impl HyperelasticLaw for Ogden {
    const NAME: &'static str = "ogden";
    const LABEL: &'static str = "Ogden";
    const DESCRIPTION: &'static str = "W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3)";
    const COEFFICIENTS: &'static [Coefficient] = &[
        mu("ogden_mu_1", (0.0, 1.0)),
        alpha("ogden_alpha_1", "ogden_mu_1", 2.0, (0.5, 6.0)),
        mu("ogden_mu_2", (-1.0, 0.0)),
        alpha("ogden_alpha_2", "ogden_mu_2", -2.0, (-6.0, -0.5)),
        mu("ogden_mu_3", (0.0, 0.1)),
        alpha("ogden_alpha_3", "ogden_mu_3", 4.0, (4.0, 8.0)),
    ];
    const VARIANTS: &'static [Variant] = &[
        Variant { name: "ogden_1", label: "Ogden 1", n_coefficient: 2 },
        Variant { name: "ogden_2", label: "Ogden 2", n_coefficient: 4 },
        Variant { name: "ogden_3", label: "Ogden 3", n_coefficient: 6 },
    ];
    const MODULUS_AT_REST: &'static str = "ogden_mu_1 to _3 and ogden_alpha_1 to _3 give";
    const EXAMPLE: &'static [Real] = &[0.63e6, 1.3, -0.01e6, -2.0, 0.0012e6, 5.0];

    type Values = [Real; 6];

    fn from_values([mu_1, alpha_1, mu_2, alpha_2, mu_3, alpha_3]: [Real; 6]) -> Self {
        Self::new([mu_1, mu_2, mu_3], [alpha_1, alpha_2, alpha_3])
    }

    fn values(&self) -> [Real; 6] {
        let ([mu_1, mu_2, mu_3], [alpha_1, alpha_2, alpha_3]) = (self.mu, self.alpha);
        [mu_1, alpha_1, mu_2, alpha_2, mu_3, alpha_3]
    }

    fn shear_modulus(&self) -> Real {
        0.5 * self.terms().fold(0.0, |sum, (mu, alpha)| sum + mu * alpha)
    }

    /// mu_k l^alpha_k, summed (Ogden 1972).
    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        let power = |stretch: Real, alpha: Real| math::exp(alpha * math::ln(stretch));
        stretches.map(|stretch| self.terms().fold(0.0, |sum, (mu, alpha)| sum + mu * power(stretch, alpha)))
    }
}

impl IsochoricLaw for Ogden {
    #[inline(always)]
    fn response<S: Simd>(
        &self,
        simd: S,
        kinematics: &Kinematics<S::Vector>,
        _: bool,
    ) -> (Deviator<S::Vector>, S::Vector) {
        let Kinematics { mean, difference, shear, hoop, inverse_cbrt_j, .. } = *kinematics;
        self.of_stretch(simd, [mean, difference, shear], inverse_cbrt_j * hoop)
    }

    /// mu_k l^alpha_k along the principal directions.
    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> (SolidDeviator<S::Vector>, S::Vector) {
        let principal = kinematics.stretch.principal(simd);
        let zero = simd.splat(0.0);
        let (mut stress, mut energy) = ([zero; 3], zero);
        for i in 0..3 {
            let log = power::log2(simd, kinematics.inverse_cbrt_j * principal.values[i]);
            let log = self.limited(simd, log);
            for k in 0..MAX_OGDEN_TERMS {
                let (mu, alpha) = (self.mu[k], self.alpha[k]);
                if mu == 0.0 || alpha == 0.0 {
                    continue;
                }
                // Squared, as logarithms are limited for half of the exponent.
                let root = power::exp2_of_both_signs(log.mul_scalar(0.5 * alpha))[0].exp2_m1;
                let power = root * root.add_scalar(2.0);
                stress[i] = stress[i] + power.mul_scalar(mu);
                energy = energy + power.mul_scalar(self.energy_factor[k]);
            }
        }
        (SolidDeviator::of(&principal.with_values(stress)), energy)
    }

    /// A majorant of the shear tangent with the geometric stiffness of the stress, Pa. Only terms with mu alpha > 0 count;
    /// the others soften.
    ///
    /// Strains along the principal directions have the tangent of a weighted mean of 1/2 sum mu alpha l_i^alpha, so the
    /// largest of the three bounds it; to negative exponents the stress adds about mu (1 - l_i^alpha). Turning the directions
    /// of l_i and l_j meets (tau_i - tau_j)(l_i^2 + l_j^2) / (2 (l_i^2 - l_j^2)), which exceeds it only for exponents a
    /// between -2 and 2, by less than (1 + h^2/3) / (1 + |a| h/2) with h = |ln(l_i / l_j)|, as h coth h < 1 + h^2/3 and
    /// (1 - e^-x)/x < 1 / (1 + x/2).
    #[inline(always)]
    fn shear_tangent<S: Simd>(&self, simd: S, stretch: &impl IsochoricState<S::Vector>) -> S::Vector {
        let zero = simd.splat(0.0);
        let logs = stretch.principal().map(|stretch| self.limited(simd, power::log2(simd, stretch)));
        let largest = |logs: [S::Vector; 3]| logs[0].max(logs[1]).max(logs[2]);
        let range = (largest(logs) + largest(logs.map(|log| zero - log))).mul_scalar(LN_2);
        let mut tangent = zero;
        for log in logs {
            let mut along = zero;
            for k in 0..MAX_OGDEN_TERMS {
                let (mu, alpha) = (self.mu[k], self.alpha[k]);
                if mu * alpha > 0.0 {
                    let [root, _] = power::exp2_of_both_signs(log.mul_scalar(0.5 * alpha));
                    let power = root.whole * root.whole;
                    let mut term = power.mul_scalar(0.5 * mu * alpha);
                    if alpha < 0.0 {
                        term = term + power.add_scalar(-1.0).max(zero).mul_scalar(-mu);
                    }
                    if math::abs(alpha) < 2.0 {
                        let turned = (range * range).mul_scalar(math::THIRD).add_scalar(1.0)
                            / range.mul_scalar(0.5 * math::abs(alpha)).add_scalar(1.0);
                        term = term * turned.max(simd.splat(1.0));
                    }
                    along = along + term;
                }
            }
            tangent = tangent.max(along);
        }
        tangent
    }
}

const fn mu(name: &'static str, plausible: (Real, Real)) -> Coefficient {
    const MEANING: &str =
        "ogden coefficient, W = sum mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3); 0 switches the term off";
    Coefficient::modulus(name, plausible, MEANING)
}

const fn alpha(name: &'static str, of: &'static str, start: Real, plausible: (Real, Real)) -> Coefficient {
    const MEANING: &str = "ogden exponent; the shear modulus at rest is sum mu alpha / 2";
    Coefficient::shape(name, of, (-30.0, 30.0), start, plausible, MEANING)
}
