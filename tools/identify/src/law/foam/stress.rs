//! Nominal stress of the hyperfoam law in a test, and its derivatives by the coefficients.
//!
//! W = sum 2 mu / alpha^2 [l1^alpha + l2^alpha + l3^alpha - 3 + (J^(-alpha beta) - 1) / beta] with beta = nu / (1 - 2 nu), so the
//! principal Kirchhoff stresses are tau_i = sum 2 mu / alpha (l_i^alpha - J^(-alpha beta)) (Storakers, J. Mech. Phys. Solids 34
//! (1986) 125, after Ogden, Proc. R. Soc. A 328 (1972) 567, and Hill, Adv. Appl. Mech. 18 (1978) 1). A free direction carries none.

use crate::law::Mode;
use crate::law::stress::{divisor, stretches};

/// Coefficients of a term: mu, alpha and nu, in this order.
pub const PER_TERM: usize = 3;

/// A term of the law.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// Its part of the shear modulus at rest, Pa.
    pub mu: f64,
    /// Its exponent.
    pub alpha: f64,
    /// Its Poisson's ratio at rest.
    pub nu: f64,
}

impl Term {
    /// The terms of mu_1, alpha_1, nu_1, mu_2, ...
    pub fn list(values: &[f64]) -> Vec<Self> {
        values.chunks_exact(PER_TERM).map(|term| Self { mu: term[0], alpha: term[1], nu: term[2] }).collect()
    }

    /// beta = nu / (1 - 2 nu).
    fn beta(self) -> f64 {
        self.nu / (1.0 - 2.0 * self.nu)
    }

    /// Its part of the tangent, Pa: by the direction's own logarithmic strain, and by that of every direction through the volume.
    pub fn tangent(self, strain: f64, volume: f64) -> (f64, f64) {
        let slopes = self.stress(strain, volume);
        (slopes.by_strain, slopes.by_volume)
    }

    /// The stress of a direction of logarithmic strain `strain` at ln J = `volume`, and its derivatives.
    fn stress(self, strain: f64, volume: f64) -> Slopes {
        let beta = self.beta();
        let (own, all) = ((self.alpha * strain).exp(), (-self.alpha * beta * volume).exp());
        let unit = 2.0 / self.alpha * (own - all);
        let by_beta = 2.0 * self.mu * volume * all;
        Slopes {
            stress: self.mu * unit,
            by_strain: 2.0 * self.mu * own,
            by_volume: 2.0 * self.mu * beta * all,
            by_values: [
                unit,
                (2.0 * self.mu * (strain * own + beta * volume * all) - self.mu * unit) / self.alpha,
                by_beta / (1.0 - 2.0 * self.nu).powi(2),
            ],
        }
    }
}

/// The Kirchhoff stress of a direction, Pa, and its derivatives.
struct Slopes {
    stress: f64,
    by_strain: f64,
    by_volume: f64,
    /// By mu, alpha and nu of the term.
    by_values: [f64; PER_TERM],
}

/// A test at one state: logarithmic strains where they are known.
#[derive(Clone, Copy, Debug)]
pub struct State {
    loaded: f64,
    /// Logarithmic volume without the free directions.
    held: f64,
    free: Free,
    /// What the difference of Kirchhoff stresses is divided by to make the nominal stress.
    divisor: f64,
}

/// What is known of the direction whose stress is taken off.
#[derive(Clone, Copy, Debug)]
enum Free {
    /// So many directions carry no stress; their strain follows from that.
    Stressless(f64),
    /// One of this logarithmic strain.
    Known(f64),
}

impl State {
    /// The test `mode` at `x`: the stretch of the loaded direction, or the amount of shear.
    pub fn new(mode: Mode, x: f64) -> Self {
        let [loaded, ..] = stretches(mode, x);
        let loaded = loaded.ln();
        let (held, free) = match mode {
            Mode::Uniaxial => (loaded, Free::Stressless(2.0)),
            Mode::Planar => (loaded, Free::Stressless(1.0)),
            Mode::Equibiaxial => (2.0 * loaded, Free::Stressless(1.0)),
            // The shear keeps the volume: the other stretch is the inverse one.
            Mode::SimpleShear => (0.0, Free::Known(-loaded)),
        };
        Self { loaded, held, free, divisor: divisor(mode, x) }
    }

    /// Logarithmic strains of the loaded, the free and the third direction of `terms`; none if no free stretch is found.
    pub fn strains(&self, terms: &[Term]) -> Option<[f64; 3]> {
        let (free, _) = self.free(terms)?;
        let third = match self.free {
            Free::Stressless(count) if count > 1.0 => free,
            Free::Stressless(_) => self.held - self.loaded,
            Free::Known(_) => 0.0,
        };
        Some([self.loaded, free, third])
    }

    /// Logarithmic strain of the free direction, and how many alike ones the volume counts; of a shear none, as it keeps it.
    fn free(&self, terms: &[Term]) -> Option<(f64, f64)> {
        match self.free {
            Free::Known(strain) => Some((strain, 0.0)),
            Free::Stressless(count) => {
                // That of a constant volume, and that of a loaded direction.
                let ends = [-self.held / count, self.loaded];
                Some((stressless(terms, self.held, count, ends)?, count))
            }
        }
    }

    /// Nominal stress of `terms`, Pa, and its derivative by each of their values; none if no free stretch is found at which
    /// the free directions carry no stress.
    pub fn stress(&self, terms: &[Term]) -> Option<(f64, Vec<f64>)> {
        let (free, count) = self.free(terms)?;
        let volume = self.held + count * free;
        let pairs = terms.iter().map(|term| (term.stress(self.loaded, volume), term.stress(free, volume)));
        let pairs: Vec<(Slopes, Slopes)> = pairs.collect();
        // With a stressless direction the difference is the loaded stress itself, and its strain moves with the values.
        let (mut stress, mut by_free, mut stiffness) = (0.0, 0.0, 0.0);
        for (own, other) in &pairs {
            stress += own.stress - other.stress;
            by_free += own.by_volume * count - (other.by_strain + other.by_volume * count);
            stiffness += other.by_strain + other.by_volume * count;
        }
        let slope = |(own, other): &(Slopes, Slopes), k: usize| {
            let moved = if count > 0.0 { -other.by_values[k] / stiffness } else { 0.0 };
            (own.by_values[k] - other.by_values[k] + by_free * moved) / self.divisor
        };
        let slopes = pairs.iter().flat_map(|pair| (0..PER_TERM).map(move |k| slope(pair, k))).collect();
        Some((stress / self.divisor, slopes)).filter(|(stress, _)| stress.is_finite())
    }

    /// Nominal stress per mu, Pa/Pa, of a term where all terms have its Poisson's ratio: the free stretch is then a power of the
    /// loaded ones, whatever the moduli are.
    pub fn unit(&self, alpha: f64, nu: f64) -> f64 {
        let term = Term { mu: 1.0, alpha, nu };
        let free = match self.free {
            Free::Known(strain) => strain,
            // ln l_free = -beta ln J of J = held + count * free.
            Free::Stressless(count) => -term.beta() * self.held / (1.0 + count * term.beta()),
        };
        let count = if let Free::Stressless(count) = self.free { count } else { 0.0 };
        let volume = self.held + count * free;
        (term.stress(self.loaded, volume).stress - term.stress(free, volume).stress) / self.divisor
    }
}

/// Steps at most of a search whose halvings alone come to the last digit.
const STEPS: usize = 120;
/// Change of a logarithmic strain that ends the search.
const TOLERANCE: f64 = 1e-14;
/// By how much the search reaches beyond the strains between which that of any isotropic solid is.
const BEYOND: f64 = 0.01;

/// Newton's next change at the end of a search that found a strain without stress, at most.
const SOLVED: f64 = 1e-9;

/// A strain between those of a constant volume and of a loaded direction, as far from 0 as Poisson's ratios say.
fn start(terms: &[Term], [constant, _]: [f64; 2]) -> f64 {
    let sum = |of: fn(&Term) -> f64| terms.iter().map(of).sum::<f64>();
    let (whole, weighted) = (sum(|term| term.mu), sum(|term| term.mu * term.nu));
    if whole > 0.0 { 2.0 * weighted / whole * constant } else { 0.5 * constant }
}

/// The logarithmic strain at which `count` alike directions carry no stress beside the volume `held`, between `ends`, where a
/// stress rises with its strain, as with positive moduli; none where it has one sign. By Newton's method, with a halving where
/// that leaves the bounds or comes on slowly.
fn stressless(terms: &[Term], held: f64, count: f64, ends: [f64; 2]) -> Option<f64> {
    let stress = |strain: f64| {
        let slopes = terms.iter().map(|term| term.stress(strain, held + count * strain));
        slopes.fold((0.0, 0.0), |(stress, stiffness), s| {
            (stress + s.stress, stiffness + s.by_strain + count * s.by_volume)
        })
    };
    let [mut low, mut high] = [ends[0].min(ends[1]) - BEYOND, ends[0].max(ends[1]) + BEYOND];
    let (mut strain, mut last) = (start(terms, ends), high - low);
    for _ in 0..STEPS {
        let (excess, stiffness) = stress(strain);
        if excess < 0.0 {
            low = strain
        } else {
            high = strain
        }
        let newton = strain - excess / stiffness;
        let goes = newton > low && newton < high && (newton - strain).abs() < 0.5 * last;
        let next = if goes { newton } else { 0.5 * (low + high) };
        last = (next - strain).abs();
        strain = next;
        if last <= TOLERANCE * (1.0 + strain.abs()) {
            // At a bound the stress may have one sign.
            return Some(strain).filter(|_| (newton - strain).abs() < SOLVED);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODES: [Mode; 4] = [Mode::Uniaxial, Mode::Planar, Mode::Equibiaxial, Mode::SimpleShear];

    fn states() -> impl Iterator<Item = (Mode, f64)> {
        let points = |mode: Mode| match mode {
            Mode::SimpleShear => [-0.6, -0.1, 0.05, 0.9],
            _ => [0.25, 0.7, 1.05, 1.8],
        };
        MODES.into_iter().flat_map(move |mode| points(mode).map(|x| (mode, x)))
    }

    /// Source: central differences of the stress itself.
    #[test]
    fn derivatives_are_those_of_the_stress() {
        let values = [2e4, 6.0, 0.1, 5e4, -3.0, 0.3];
        for (mode, x) in states() {
            let state = State::new(mode, x);
            let (_, slopes) = state.stress(&Term::list(&values)).unwrap();
            for (k, slope) in slopes.iter().enumerate() {
                let at = |by: f64| {
                    let mut moved = values;
                    moved[k] *= 1.0 + by;
                    state.stress(&Term::list(&moved)).unwrap().0
                };
                let expected = (at(1e-5) - at(-1e-5)) / (2e-5 * values[k]);
                let scale = expected.abs().max(1e-3 * at(0.0).abs() / values[k].abs());
                assert!((slope - expected).abs() < 1e-5 * scale, "{mode:?} {x} {k}: {slope} {expected}");
            }
        }
    }

    /// With one Poisson's ratio for all terms the free stretch of a uniaxial test is l^-nu (Storakers 1986), so that the stress is
    /// the sum of the terms' own.
    #[test]
    fn one_ratio_makes_the_stress_linear_in_the_moduli() {
        let terms = Term::list(&[2e4, 6.0, 0.2, 5e4, -3.0, 0.2]);
        for (mode, x) in states() {
            let state = State::new(mode, x);
            let expected: f64 = terms.iter().map(|term| term.mu * state.unit(term.alpha, term.nu)).sum();
            let found = state.stress(&terms).unwrap().0;
            assert!((found - expected).abs() < 1e-9 * expected.abs(), "{mode:?} {x}: {found} {expected}");
        }
        let single = |l: f64| 2.0 / 6.0 * (l.powi(6) - l.powf(-6.0 * 0.2)) / l;
        assert!((State::new(Mode::Uniaxial, 0.6).unit(6.0, 0.2) - single(0.6)).abs() < 1e-12);
    }

    /// Linear elasticity at rest: E = 2 G (1 + nu), and G in shear.
    #[test]
    fn small_strains_are_those_of_linear_elasticity() {
        let terms = Term::list(&[3e4, 7.0, 0.25]);
        let slope = |mode: Mode, rest: f64| State::new(mode, rest + 1e-7).stress(&terms).unwrap().0 / 1e-7;
        assert!((slope(Mode::Uniaxial, 1.0) / (2.0 * 3e4 * 1.25) - 1.0).abs() < 1e-5);
        assert!((slope(Mode::SimpleShear, 0.0) / 3e4 - 1.0).abs() < 1e-5);
    }
}
