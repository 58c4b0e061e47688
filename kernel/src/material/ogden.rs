//! Ogden with three terms, isochoric (Ogden 1972), in Ogden's own convention, which is also that of LS-DYNA (MAT_077_O)
//! and OpenRadioss (LAW42):
//!
//! W = sum_k mu_k / alpha_k (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3), shear modulus at rest G = 1/2 sum mu_k alpha_k,
//!
//! with the principal values l_i of U-bar. Abaqus writes 2 mu_k / alpha_k^2 in front, so its mu_k = G_k are to be
//! entered here as 2 mu_k / alpha_k. A term with mu = 0 is off, and one with alpha = 0 contributes nothing.
//!
//! The principal Kirchhoff stresses are tau_i = sum mu_k l_i^alpha_k less their mean. With g = sqrt(l1 l2) in the section,
//! l3 = g^-2, and sinh x = r / g with r the radius of Mohr's circle of U-bar, the stretches are l1 = g e^x, l2 = g e^-x.
//! The stress is then, with y = alpha ln g,
//!
//! mean of the section - stress out of it = mu (e^y cosh(alpha x) - e^(-2y)),
//! half difference in the section / r     = mu e^y sinh(alpha x) / sinh x / g,
//!
//! where no difference of nearly equal powers is taken: sinh(alpha x) / sinh x is a quotient of two numbers that both
//! carry their full relative accuracy, and tends to alpha where the stretches coincide. The first line and W are
//! written with e^y - 1 and sinh(alpha x / 2), which keeps them accurate for small strains as well.

use crate::element::Kinematics;
use crate::lanes::{Deviator, SQRT_THIRD};
use crate::math;
use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::IsochoricStretch;
use crate::vector::Instructions;

/// Most terms of an Ogden law.
pub const MAX_OGDEN_TERMS: usize = 3;

/// Long-term coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ogden {
    /// Coefficients, Pa; 0 where a term is off.
    pub mu: [Real; MAX_OGDEN_TERMS],
    /// Exponents.
    pub alpha: [Real; MAX_OGDEN_TERMS],
}

/// An isochoric stretch as the law sees it.
struct Mohr {
    /// ln g.
    log: Real,
    /// r / g = sinh x.
    sinh: Real,
    /// x.
    x: Real,
    /// Deviatoric in-plane part of U-bar over g: (u11 - u22) / 2 and u12.
    direction: [Real; 2],
}

impl Mohr {
    /// From mean, half difference and shear of U-bar in the section.
    fn new(mean: Real, difference: Real, shear: Real) -> Self {
        let g = math::sqrt((mean - difference) * (mean + difference) - shear * shear);
        let direction = [difference / g, shear / g];
        let sinh = math::sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        Self { log: math::ln(g), sinh, x: math::asinh(sinh), direction }
    }
}

/// What one term adds, per mu.
struct Term {
    /// Mean of the section less the stress out of it.
    step: Real,
    /// Half difference in the section over r / g.
    slope: Real,
    /// alpha W / mu.
    energy: Real,
}

impl Term {
    fn new(alpha: Real, mohr: &Mohr) -> Self {
        // E = e^y - 1 and S = sinh(alpha x / 2): cosh(alpha x) = 1 + 2 S^2, sinh(alpha x) = 2 S sqrt(1 + S^2).
        let e = math::expm1(alpha * mohr.log);
        let s = math::sinh(0.5 * (alpha * mohr.x));
        let power = 1.0 + e;
        let spread = 2.0 * (s * s) * power;
        let inverse_square = 1.0 / (power * power);
        let quotient = if mohr.sinh > 0.0 { 2.0 * s * math::sqrt(1.0 + s * s) / mohr.sinh } else { alpha };
        Self {
            step: e * (3.0 + e * (3.0 + e)) * inverse_square + spread,
            slope: power * quotient,
            energy: e * e * (3.0 + 2.0 * e) * inverse_square + 2.0 * spread,
        }
    }
}

impl Ogden {
    /// The long-term law of `material`.
    pub fn new(material: &Material) -> Self {
        let scale = material.long_term_scale();
        Self { mu: material.ogden_mu.map(|mu| scale * mu), alpha: material.ogden_alpha }
    }

    /// The terms that are on: (mu, alpha).
    #[inline(always)]
    fn terms(&self) -> impl Iterator<Item = (Real, Real)> {
        self.mu.into_iter().zip(self.alpha).filter(|(mu, alpha)| *mu != 0.0 && *alpha != 0.0)
    }

    /// W, J/m3 of reference volume.
    pub fn strain_energy_density(&self, stretch: &IsochoricStretch) -> Real {
        let mohr = Mohr::new(0.5 * (stretch.u11 + stretch.u22), 0.5 * (stretch.u11 - stretch.u22), stretch.u12);
        self.terms().fold(0.0, |sum, (mu, alpha)| sum + mu / alpha * Term::new(alpha, &mohr).energy)
    }

    /// Kirchhoff stress in the unrotated frame, Pa, and W, J/m3, of neighbouring triangles.
    #[inline(always)]
    pub fn stress<S: Instructions>(
        &self,
        set: S,
        kinematics: &Kinematics<S::Vector>,
    ) -> (Deviator<S::Vector>, S::Vector) {
        let Kinematics { mean, difference, shear, inverse_cbrt_j, .. } = *kinematics;
        let stretch = [mean, difference, shear].map(|component| inverse_cbrt_j * component);
        let [mean, difference, shear, energy] = set.map(stretch, |stretch| self.stress_of_one(stretch));
        (Deviator { mean, difference, shear }, energy)
    }

    /// Components of the [`Deviator`] of stress, Pa, and W, J/m3, from mean, half difference and shear of U-bar.
    fn stress_of_one(&self, [mean, difference, shear]: [Real; 3]) -> [Real; 4] {
        let mohr = Mohr::new(mean, difference, shear);
        let (mut step, mut slope, mut energy) = (0.0, 0.0, 0.0);
        for (mu, alpha) in self.terms() {
            let term = Term::new(alpha, &mohr);
            step += mu * term.step;
            slope += mu * term.slope;
            energy += mu / alpha * term.energy;
        }
        [SQRT_THIRD * step, slope * mohr.direction[0], slope * mohr.direction[1], energy]
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> Real {
        0.5 * self.terms().fold(0.0, |sum, (mu, alpha)| sum + mu * alpha)
    }

    /// An upper bound of the shear tangent, Pa. Only terms with mu alpha > 0 count; the others soften.
    ///
    /// Strains along the principal directions have the tangent of a weighted mean of 1/2 sum mu alpha l_i^alpha, so the
    /// largest of the three bounds it. Turning the directions of l_i and l_j meets
    /// (tau_i - tau_j)(l_i^2 + l_j^2) / (2 (l_i^2 - l_j^2)), which exceeds it only for exponents between -2 and 2, by
    /// a factor of at most h coth h < 1 + h with h = |ln(l_i / l_j)|.
    pub fn shear_tangent(&self, stretch: &IsochoricStretch) -> Real {
        let stiffening = || self.terms().filter(|(mu, alpha)| mu * alpha > 0.0);
        let logs = stretch.principal().map(math::ln);
        let along =
            logs.map(|log| 0.5 * stiffening().fold(0.0, |sum, (mu, alpha)| sum + mu * alpha * math::exp(alpha * log)));
        let largest = |v: [Real; 3]| math::larger(v[0], math::larger(v[1], v[2]));
        let spread = largest(logs) + largest(logs.map(|log| -log));
        let soft = stiffening().any(|(_, alpha)| math::abs(alpha) < 2.0);
        largest(along) * if soft { 1.0 + spread } else { 1.0 }
    }
}
