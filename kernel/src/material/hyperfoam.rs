//! Ogden and Hill's law of highly compressible foams with up to three terms (Ogden 1972; Hill 1978; Storakers 1986), in the
//! convention of Abaqus' hyperfoam:
//!
//! W = sum_k 2 mu_k / alpha_k^2 (l1^alpha_k + l2^alpha_k + l3^alpha_k - 3 + (J^(-alpha_k beta_k) - 1) / beta_k),
//!
//! with the principal values l_i of U, J = l1 l2 l3 and beta_k = nu_k / (1 - 2 nu_k); where nu_k = 0 the last part is
//! -alpha_k ln J. LS-DYNA's MAT_177 writes C_k = 2 mu_k / alpha_k, b_k = alpha_k and n = beta. At rest the shear modulus is
//! sum mu_k and the bulk modulus sum 2 mu_k (1/3 + beta_k). A term with mu = 0 or alpha = 0 is off.
//!
//! The principal Kirchhoff stresses are tau_i = sum 2 mu_k / alpha_k (l_i^alpha_k - J^(-alpha_k beta_k)). As in
//! [`crate::material::ogden`], l1 = g e^x and l2 = g e^-x in the section, and all is written with powers less 1, which
//! [`crate::number::power`] gives accurately however small their exponents are, a beta next to 0 among them.

use crate::material::coefficient::Coefficient;
use crate::material::law::{CompressibleLaw, HyperelasticLaw, PrincipalTangent, Variant, WholeStress};
use crate::number::math::THIRD;
use crate::number::real::consts::LN_2;
use crate::number::real::{LARGEST_EXPONENT, Real, TINY_SQUARE};
use crate::number::vector::{Simd, Vector};
use crate::number::{math, power};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;

/// Most terms of the law.
pub const MAX_FOAM_TERMS: usize = 3;

/// Coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hyperfoam {
    terms: [Term; MAX_FOAM_TERMS],
    /// Binary logarithms of stretches and of J are taken to be these at most, so that no power leaves the domain of
    /// [`power::exp2_of_both_signs`]. The stress there is beyond all that a step can follow.
    largest_log: [Real; 2],
}

/// One term.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Term {
    mu: Real,
    alpha: Real,
    nu: Real,
    beta: Real,
    /// 2 mu / alpha, Pa; 0 where the term is off.
    factor: Real,
}

impl Term {
    fn new([mu, alpha, nu]: [Real; 3]) -> Self {
        let on = mu != 0.0 && alpha != 0.0;
        Self { mu, alpha, nu, beta: nu / (1.0 - 2.0 * nu), factor: if on { 2.0 * mu / alpha } else { 0.0 } }
    }
}

/// What is below this counts as a beta of 0: the difference is below the last digit of any stress.
const NO_BETA: Real = 1e-20;

/// Logarithms of the stretches of `N` triangles, to the base of 2.
struct Logs<V, const N: usize> {
    /// Of l1 and l2 in the section, the larger first.
    section: [[V; 2]; N],
    /// Of l3; none where that is 1.
    out: Option<[[V; 1]; N]>,
    /// Of J.
    volume: [V; N],
}

/// Powers of one term less 1.
struct Powers<V, const N: usize> {
    /// l1^alpha and l2^alpha.
    section: [[V; 2]; N],
    /// l3^alpha.
    out: [[V; 1]; N],
    /// J^(-alpha beta).
    volume: [[V; 1]; N],
    /// (J^(-alpha beta) - 1) / beta, or its limit.
    volume_energy: [V; N],
}

impl Hyperfoam {
    /// The law of these moduli, Pa, exponents and Poisson's ratios; a term with mu = 0 is off.
    pub fn new(mu: [Real; MAX_FOAM_TERMS], alpha: [Real; MAX_FOAM_TERMS], nu: [Real; MAX_FOAM_TERMS]) -> Self {
        let terms = core::array::from_fn(|k| Term::new([mu, alpha, nu].map(|of| of.get(k).copied().unwrap_or(0.0))));
        let steepest = |exponent: fn(&Term) -> Real| {
            terms.iter().fold(1.0, |steepest, term| math::max(steepest, math::abs(exponent(term))))
        };
        // Powers in the section are multiplied with each other.
        let largest_log = [
            0.5 * LARGEST_EXPONENT / steepest(|term| term.alpha),
            LARGEST_EXPONENT / steepest(|term| term.alpha * term.beta),
        ];
        Self { terms, largest_log }
    }

    /// The terms that are on.
    fn active(&self) -> impl Iterator<Item = &Term> {
        self.terms.iter().filter(|term| term.factor != 0.0)
    }

    /// Logarithms of the principal stretches, of which those in the section are `radius` from their mean.
    #[inline(always)]
    fn logs<S: Simd, const N: usize>(
        &self,
        simd: S,
        kinematics: &[Kinematics<S::Vector>; N],
        radius: &[S::Vector; N],
        axisymmetric: bool,
    ) -> Logs<S::Vector, N> {
        let [stretch, jacobian] = self.largest_log;
        let (mut section, mut out) = ([[simd.splat(0.0); 2]; N], [[simd.splat(1.0)]; N]);
        for i in 0..N {
            section[i] = [kinematics[i].mean + radius[i], kinematics[i].mean - radius[i]];
            out[i] = [kinematics[i].hoop];
        }
        section = power::log2_of_all(simd, section);
        if axisymmetric {
            out = power::log2_of_all(simd, out);
        }
        let mut volume = *radius;
        for i in 0..N {
            let [longer, shorter] = section[i];
            let whole = longer + shorter;
            volume[i] = limited(simd, if axisymmetric { whole + out[i][0] } else { whole }, jacobian);
            section[i] = [limited(simd, longer, stretch), limited(simd, shorter, stretch)];
            out[i] = [limited(simd, out[i][0], stretch)];
        }
        Logs { section, out: if axisymmetric { Some(out) } else { None }, volume }
    }
}

impl Term {
    /// Powers of the stretches.
    #[inline(always)]
    fn powers<S: Simd, const N: usize>(&self, simd: S, logs: &Logs<S::Vector, N>) -> Powers<S::Vector, N> {
        let (zero, mut section) = (simd.splat(0.0), logs.section);
        let (mut out, mut volume, mut volume_energy) = ([[zero]; N], [[zero]; N], [zero; N]);
        for i in 0..N {
            section[i] = [section[i][0].mul_scalar(self.alpha), section[i][1].mul_scalar(self.alpha)];
        }
        // No closure: those need not be inlined.
        if let Some(logs) = &logs.out {
            for i in 0..N {
                out[i] = [logs[i][0].mul_scalar(self.alpha)];
            }
            out = power::exp2_m1_of_all(out);
        }
        if self.beta > NO_BETA {
            for i in 0..N {
                volume[i] = [logs.volume[i].mul_scalar(-self.alpha * self.beta)];
            }
            volume = power::exp2_m1_of_all(volume);
            for i in 0..N {
                volume_energy[i] = volume[i][0].mul_scalar(1.0 / self.beta);
            }
        } else {
            for i in 0..N {
                volume_energy[i] = logs.volume[i].mul_scalar(-self.alpha * LN_2);
            }
        }
        Powers { section: power::exp2_m1_of_all(section), out, volume, volume_energy }
    }
}

/// A logarithm between minus and plus the largest one. A NaN stays one.
#[inline(always)]
fn limited<S: Simd>(simd: S, log: S::Vector, largest: Real) -> S::Vector {
    let [most, least] = [simd.splat(largest), simd.splat(-largest)];
    let log = log.select_greater(most, most, log);
    least.select_greater(log, least, log)
}

/// Binary logarithms of the principal stretches of a tetrahedron, then of J.
struct SolidLogs<V>([V; 3], V);

impl Hyperfoam {
    #[inline(always)]
    fn solid_logs<S: Simd>(&self, simd: S, stretches: [S::Vector; 3]) -> SolidLogs<S::Vector> {
        let [stretch, jacobian] = self.largest_log;
        let (mut logs, mut volume) = ([simd.splat(0.0); 3], simd.splat(0.0));
        for i in 0..3 {
            let log = power::log2(simd, stretches[i]);
            volume = volume + log;
            logs[i] = limited(simd, log, stretch);
        }
        SolidLogs(logs, limited(simd, volume, jacobian))
    }
}

impl Term {
    /// l_i^alpha - 1 of a tetrahedron, J^(-alpha beta) - 1, and (J^(-alpha beta) - 1) / beta.
    #[inline(always)]
    fn solid_powers<S: Simd>(
        &self,
        simd: S,
        SolidLogs(logs, volume): &SolidLogs<S::Vector>,
    ) -> ([S::Vector; 3], S::Vector, S::Vector) {
        let mut powers = [simd.splat(0.0); 3];
        for i in 0..3 {
            powers[i] = power::exp2_of_both_signs(logs[i].mul_scalar(self.alpha))[0].exp2_m1;
        }
        if self.beta > NO_BETA {
            let power = power::exp2_of_both_signs(volume.mul_scalar(-self.alpha * self.beta))[0].exp2_m1;
            (powers, power, power.mul_scalar(1.0 / self.beta))
        } else {
            (powers, simd.splat(0.0), volume.mul_scalar(-self.alpha * LN_2))
        }
    }
}

impl HyperelasticLaw for Hyperfoam {
    const NAME: &'static str = "hyperfoam";
    const LABEL: &'static str = "Ogden-Hill foam";
    const DESCRIPTION: &'static str =
        "W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1)/beta), beta = nu/(1 - 2 nu)";
    const COEFFICIENTS: &'static [Coefficient] = &[
        mu("foam_mu_1", (0.5, 1.0)),
        alpha("foam_alpha_1", "foam_mu_1", 2.0, (2.0, 20.0)),
        nu("foam_nu_1", "foam_mu_1"),
        mu("foam_mu_2", (0.0, 1.0)),
        alpha("foam_alpha_2", "foam_mu_2", -2.0, (-4.0, -0.5)),
        nu("foam_nu_2", "foam_mu_2"),
        mu("foam_mu_3", (0.0, 0.2)),
        alpha("foam_alpha_3", "foam_mu_3", 4.0, (2.0, 8.0)),
        nu("foam_nu_3", "foam_mu_3"),
    ];
    const VARIANTS: &'static [Variant] = &[
        Variant { name: "foam_1", label: "Ogden-Hill foam 1", n_coefficient: 3 },
        Variant { name: "foam_2", label: "Ogden-Hill foam 2", n_coefficient: 6 },
        Variant { name: "foam_3", label: "Ogden-Hill foam 3", n_coefficient: 9 },
    ];
    const MODULUS_AT_REST: &'static str = "foam_mu_1 to _3 give";
    const EXAMPLE: &'static [Real] = &[60e3, 8.0, 0.0, 40e3, -2.0, 0.1, 2e3, 4.0, 0.3];

    type Values = [Real; 9];

    fn from_values([mu_1, alpha_1, nu_1, mu_2, alpha_2, nu_2, mu_3, alpha_3, nu_3]: [Real; 9]) -> Self {
        Self::new([mu_1, mu_2, mu_3], [alpha_1, alpha_2, alpha_3], [nu_1, nu_2, nu_3])
    }

    fn values(&self) -> [Real; 9] {
        let [[mu_1, alpha_1, nu_1], [mu_2, alpha_2, nu_2], [mu_3, alpha_3, nu_3]] =
            self.terms.map(|term| [term.mu, term.alpha, term.nu]);
        [mu_1, alpha_1, nu_1, mu_2, alpha_2, nu_2, mu_3, alpha_3, nu_3]
    }

    fn shear_modulus(&self) -> Real {
        self.active().fold(0.0, |sum, term| sum + term.mu)
    }

    /// 2 mu_k / alpha_k (l^alpha_k - J^(-alpha_k beta_k)), summed (Storakers 1986).
    fn principal_stress(&self, stretches: [Real; 3]) -> [Real; 3] {
        let power = |base: Real, exponent: Real| math::exp(exponent * math::ln(base));
        let [first, second, third] = stretches;
        let volume = first * second * third;
        let of_term = |stretch: Real, term: &Term| {
            term.factor * (power(stretch, term.alpha) - power(volume, -term.alpha * term.beta))
        };
        stretches.map(|stretch| self.active().fold(0.0, |sum, term| sum + of_term(stretch, term)))
    }
}

impl CompressibleLaw for Hyperfoam {
    fn bulk_modulus(&self) -> Real {
        self.active().fold(0.0, |sum, term| sum + 2.0 * term.mu * (THIRD + term.beta))
    }

    #[inline(always)]
    fn response<S: Simd, const N: usize>(
        &self,
        simd: S,
        kinematics: &[Kinematics<S::Vector>; N],
        axisymmetric: bool,
    ) -> [WholeStress<S::Vector>; N] {
        let zero = simd.splat(0.0);
        let (mut radius, mut sums) =
            ([zero; N], [Sums { section: [zero; 2], out: zero, volume: zero, energy: zero }; N]);
        for i in 0..N {
            radius[i] = radius_of(&kinematics[i]);
        }
        let logs = self.logs(simd, kinematics, &radius, axisymmetric);
        for term in &self.terms {
            if term.factor != 0.0 {
                let powers = term.powers(simd, &logs);
                for i in 0..N {
                    sums[i].add(term, &powers, i, axisymmetric);
                }
            }
        }
        let mut stress = [WholeStress::none(simd); N];
        for i in 0..N {
            stress[i] = sums[i].stress(&kinematics[i], radius[i]);
        }
        stress
    }

    #[inline(always)]
    fn solid_response<S: Simd>(
        &self,
        simd: S,
        kinematics: &SolidKinematics<S::Vector>,
    ) -> WholeStress<S::Vector, SolidDeviator<S::Vector>> {
        let zero = simd.splat(0.0);
        let principal = kinematics.stretch.principal(simd);
        let logs = self.solid_logs(simd, principal.values);
        let (mut stress, mut mean, mut energy) = ([zero; 3], zero, zero);
        for term in &self.terms {
            if term.factor == 0.0 {
                continue;
            }
            let (powers, volume, volume_energy) = term.solid_powers(simd, &logs);
            let sum = powers[0] + powers[1] + powers[2];
            for i in 0..3 {
                stress[i] = stress[i] + powers[i].mul_scalar(term.factor);
            }
            mean = mean + (sum.mul_scalar(THIRD) - volume).mul_scalar(term.factor);
            energy = energy + (sum + volume_energy).mul_scalar(term.factor / term.alpha);
        }
        WholeStress { deviator: SolidDeviator::of(&principal.with_values(stress)), mean, energy }
    }

    /// Along a principal direction 2 mu l^alpha meets a strain, half of which is the shear modulus, and 2 mu beta J^(-alpha beta)
    /// one of volume; a compression adds its stress to both. Turning the directions meets the shear modulus of an exponent between.
    #[inline(always)]
    fn solid_tangent<S: Simd>(&self, simd: S, stretches: [S::Vector; 3]) -> [S::Vector; 2] {
        let zero = simd.splat(0.0);
        let logs = self.solid_logs(simd, stretches);
        let (mut own, mut stress, mut common) = ([zero; 3], [zero; 3], zero);
        for term in &self.terms {
            if term.factor == 0.0 {
                continue;
            }
            let (powers, volume, _) = term.solid_powers(simd, &logs);
            for i in 0..3 {
                own[i] = own[i] + powers[i].add_scalar(1.0).mul_scalar(2.0 * term.mu);
                stress[i] = stress[i] + (powers[i] - volume).mul_scalar(term.factor);
            }
            common = common + volume.add_scalar(1.0).mul_scalar(2.0 * term.mu * term.beta);
        }
        let mut shear = zero;
        for i in 0..3 {
            let pressed = (zero - stress[i]).max(zero);
            shear = shear.max(own[i].mul_scalar(0.5) + pressed);
        }
        // A third of 2 G is what a strain along one direction has of the volume's modulus.
        [shear, common.max(zero) + shear.mul_scalar(2.0 * THIRD)]
    }

    /// The tangents are 2 mu l_i^alpha, summed, and 2 mu beta J^(-alpha beta).
    #[inline(always)]
    fn principal_tangent<S: Simd>(&self, simd: S, kinematics: &Kinematics<S::Vector>) -> PrincipalTangent<S::Vector> {
        let (radius, mean) = (radius_of(kinematics), kinematics.mean);
        let logs = self.logs(simd, &[*kinematics], &[radius], true);
        let (mut tangent, mut alike) = (PrincipalTangent::none(simd), simd.splat(0.0));
        for term in &self.terms {
            if term.factor == 0.0 {
                continue;
            }
            let Powers { section: [[longer, shorter]], out: [[out]], volume: [[volume]], volume_energy: [of_volume] } =
                term.powers(simd, &logs);
            for (i, length) in [longer, shorter, out].into_iter().enumerate() {
                tangent.own[i] = tangent.own[i] + length.add_scalar(1.0).mul_scalar(2.0 * term.mu);
                tangent.stress[i] = tangent.stress[i] + (length - volume).mul_scalar(term.factor);
            }
            tangent.turning = tangent.turning + (longer - shorter).mul_scalar(0.25 * term.factor);
            alike = alike + longer.add_scalar(1.0).mul_scalar(term.mu);
            tangent.common = tangent.common + volume.add_scalar(1.0).mul_scalar(2.0 * term.mu * term.beta);
            tangent.energy = tangent.energy + (longer + shorter + out + of_volume).mul_scalar(term.factor / term.alpha);
        }
        // Of nearly equal stretches the difference says nothing.
        let limit = alike / (mean * mean);
        tangent.turning = radius.select_greater(mean.mul_scalar(ALIKE), tangent.turning / (radius * mean), limit);
        tangent
    }
}

/// Stretches in the section whose difference is below this part of them count as equal where a tangent is formed.
const ALIKE: Real = if cfg!(feature = "single") { 1e-3 } else { 1e-6 };

/// Half of the difference of the principal stretches in the section. Never zero, so that the quotient by it has its limit; no
/// stretch sees what is added.
#[inline(always)]
fn radius_of<V: Vector>(kinematics: &Kinematics<V>) -> V {
    let Kinematics { difference, shear, .. } = *kinematics;
    (difference * difference + shear * shear).add_scalar(TINY_SQUARE).square_root()
}

/// Sums over the terms, Pa: of the powers times 2 mu / alpha, and the energy.
#[derive(Clone, Copy)]
struct Sums<V> {
    section: [V; 2],
    out: V,
    volume: V,
    energy: V,
}

impl<V: Vector> Sums<V> {
    /// Adds a term of triangle `i`.
    #[inline(always)]
    fn add<const N: usize>(&mut self, term: &Term, powers: &Powers<V, N>, i: usize, axisymmetric: bool) {
        let ([longer, shorter], [out], [volume]) = (powers.section[i], powers.out[i], powers.volume[i]);
        let mut whole = longer + shorter;
        self.section[0] = self.section[0] + longer.mul_scalar(term.factor);
        self.section[1] = self.section[1] + shorter.mul_scalar(term.factor);
        if axisymmetric {
            whole = whole + out;
            self.out = self.out + out.mul_scalar(term.factor);
        }
        if term.beta > NO_BETA {
            self.volume = self.volume + volume.mul_scalar(term.factor);
        }
        self.energy = self.energy + (whole + powers.volume_energy[i]).mul_scalar(term.factor / term.alpha);
    }

    /// Deviator and mean of the stress of a triangle whose stretches are `radius` from their mean.
    #[inline(always)]
    fn stress(&self, kinematics: &Kinematics<V>, radius: V) -> WholeStress<V> {
        let [longer, shorter] = self.section;
        let slope = (longer - shorter).mul_scalar(0.5) / radius;
        let (double, out) = (longer + shorter, self.out);
        let deviator = Deviator {
            mean: (double.mul_scalar(0.5) - out).mul_scalar(SQRT_THIRD),
            difference: slope * kinematics.difference,
            shear: slope * kinematics.shear,
        };
        WholeStress { deviator, mean: (double + out).mul_scalar(THIRD) - self.volume, energy: self.energy }
    }
}

const fn mu(name: &'static str, plausible: (Real, Real)) -> Coefficient {
    const MEANING: &str = "hyperfoam modulus, W = sum 2 mu/alpha^2 (l1^alpha + l2^alpha + l3^alpha - 3 + \
                           (J^(-alpha beta) - 1)/beta); the shear modulus at rest is their sum; 0 switches the term off";
    Coefficient::modulus(name, plausible, MEANING)
}

const fn alpha(name: &'static str, of: &'static str, start: Real, plausible: (Real, Real)) -> Coefficient {
    Coefficient::shape(name, of, (-30.0, 30.0), start, plausible, "hyperfoam exponent; 0 switches the term off")
}

const fn nu(name: &'static str, of: &'static str) -> Coefficient {
    const MEANING: &str = "hyperfoam Poisson's ratio of the term, beta = nu/(1 - 2 nu)";
    Coefficient::shape(name, of, (0.0, 0.499), 0.0, (0.0, 0.3), MEANING)
}
