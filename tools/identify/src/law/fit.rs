//! A law fitted to the data of several tests.

use nalgebra::{DMatrix, DVector};
use softanvil_kernel::material::{Elastic, ElasticLaw};

use super::degeneracy::Degeneracy;
use super::foam::search::{Bounds, Demand};
use super::foam::stress::{PER_TERM, Term};
use super::parts::Part;
use super::stability::Stability;
use super::statistics::Statistics;
use super::{DataSet, LAWS, Law, foam, linear, ogden, separable};

pub use super::stress::predict;

/// How residuals count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weighting {
    /// In Pa: large stresses rule.
    #[default]
    Absolute,
    /// Divided by the stress: all stretches count alike.
    Relative,
    /// Divided by the largest stress of the test, and by the root of its number of points: all tests count alike.
    Tests,
}

/// A relative residual is never taken of less than this part of the largest stress of its test, because a stress near
/// zero is mostly its own error.
pub const SMALLEST_RELATIVE: f64 = 0.01;

/// What to fit and how.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// How residuals count.
    pub weighting: Weighting,
    /// Stretches over which stability is asked for.
    pub stability_range: (f64, f64),
    /// Only stable laws.
    pub demand_stability: bool,
    /// Poisson's ratio of every term of a foam, where it is known.
    pub poissons_ratio: Option<f64>,
}

impl Settings {
    /// Residuals in Pa, stability asked for over the stretches `stability_range` and not demanded.
    pub fn plain(stability_range: (f64, f64)) -> Self {
        Self { weighting: Weighting::Absolute, stability_range, demand_stability: false, poissons_ratio: None }
    }
}

/// A fitted law.
///
/// ```
/// use softanvil_identify::law::fit::{Fit, Settings};
/// use softanvil_identify::law::{DataSet, Law, Mode};
///
/// // Tension of a neo-Hookean material with a shear modulus of 0.1 MPa: P = G (l - l^-2).
/// let stretches = (1..=10).map(|i| 1.0 + 0.1 * f64::from(i));
/// let points = stretches.map(|l| (l, 1e5 * (l - l.powi(-2)))).collect();
/// let data = [DataSet { mode: Mode::Uniaxial, points }];
/// let settings = Settings { demand_stability: true, ..Settings::plain((0.5, 2.0)) };
/// let fit = Fit::new(Law::find("neo_hookean").unwrap(), &data, &settings).unwrap();
/// assert!((fit.shear_modulus() / 1e5 - 1.0).abs() < 1e-9);
/// assert!(fit.is_stable && fit.statistics.rms < 1e-3);
/// ```
#[derive(Clone, Debug)]
pub struct Fit {
    /// The law.
    pub law: &'static Law,
    /// Values of its parameters, in their units.
    pub values: Vec<f64>,
    /// How well it describes the data.
    pub statistics: Statistics,
    /// Where it is stable.
    pub stability: Stability,
    /// Whether it is stable over the stretches asked for.
    pub is_stable: bool,
    /// Why its coefficients are not to be used, if they are not.
    pub degeneracy: Option<Degeneracy>,
}

impl Fit {
    /// `law` fitted to `data`; none if it cannot be made stable where that is demanded, or there are fewer points than
    /// parameters.
    pub fn new(law: &'static Law, data: &[DataSet], settings: &Settings) -> Option<Self> {
        let stresses: Vec<f64> = data.iter().flat_map(|set| set.points.iter().map(|point| point.1)).collect();
        if stresses.len() < law.parameters.len() {
            return None;
        }
        let weights = weights(data, settings.weighting);
        let values = values(law, data, &stresses, &weights, settings)?;
        let fitted = predict(law, &values, data);
        let residuals: Vec<f64> = fitted.iter().zip(&stresses).map(|(a, b)| a - b).collect();
        let jacobian = jacobian(law, &values, data);
        let free = free(law, settings);
        let statistics = Statistics::new(&stresses, &residuals, &weights, &jacobian.select_columns(&free));
        let statistics = statistics.among(values.len(), &free);
        let stability = stability(law, &values);
        let is_stable = stability.covers(settings.stability_range);
        if !statistics.residual_sum.is_finite() || settings.demand_stability && !is_stable {
            return None;
        }
        let degeneracy = Degeneracy::of(law, &values, &jacobian, statistics.condition);
        Some(Self { law, values, statistics, stability, is_stable, degeneracy })
    }

    /// The fitted law in the kernel.
    pub fn elastic(&self) -> Elastic {
        self.law.elastic(&self.values)
    }

    /// Shear modulus at rest, Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.elastic().shear_modulus()
    }

    /// Whether a simulation can use it: the kernel takes its modulus at rest, and its coefficients mean something.
    pub fn is_usable(&self) -> bool {
        self.shear_modulus() > 0.0 && self.degeneracy.is_none()
    }
}

/// Indices of the parameters that were not known before.
fn free(law: &Law, settings: &Settings) -> Vec<usize> {
    let known = law.is_compressible() && settings.poissons_ratio.is_some();
    (0..law.parameters.len()).filter(|k| !(known && k % PER_TERM == PER_TERM - 1)).collect()
}

/// What is asked of the coefficients of a foam.
pub(super) fn demand(law: &Law, settings: &Settings) -> Demand {
    let range = |place: usize| law.parameters.get(place).map_or((0.0, 0.0), |parameter| (parameter.min, parameter.max));
    Demand { bounds: Bounds { alpha: range(1), nu: range(2) }, nu: settings.poissons_ratio }
}

fn stability(law: &Law, values: &[f64]) -> Stability {
    match law.is_compressible() {
        true => foam::stability::of(&Term::list(values)),
        false => Stability::new(&law.elastic(values)),
    }
}

/// Derivative of the nominal stress by each parameter at each point, n_point x n_parameter.
fn jacobian(law: &Law, values: &[f64], data: &[DataSet]) -> DMatrix<f64> {
    match law.family {
        _ if law.is_linear() => linear::design(&linear::unit_laws(law, &[]), data),
        ElasticLaw::Ogden => ogden::jacobian(values, data),
        ElasticLaw::Hyperfoam => foam::search::jacobian(values, data),
        _ => separable::jacobian(law, values, data),
    }
}

fn values(law: &Law, data: &[DataSet], stresses: &[f64], weights: &[f64], settings: &Settings) -> Option<Vec<f64>> {
    match law.family {
        _ if law.is_linear() => linear_values(law, data, stresses, weights, settings),
        ElasticLaw::Ogden => Some(ogden::fit(law.parameters.len() / 2, data, weights, settings.demand_stability)),
        ElasticLaw::Hyperfoam => {
            Some(foam::search::fit(law.parameters.len() / PER_TERM, data, weights, &demand(law, settings)))
        }
        _ => {
            let stable = settings.demand_stability.then_some(settings.stability_range);
            separable::fit(law, data, weights, stable)
        }
    }
}

fn linear_values(
    law: &Law,
    data: &[DataSet],
    stresses: &[f64],
    weights: &[f64],
    settings: &Settings,
) -> Option<Vec<f64>> {
    let design = linear::design(&linear::unit_laws(law, &[]), data);
    let a = DMatrix::from_fn(design.nrows(), design.ncols(), |i, j| weights[i] * design[(i, j)]);
    let b = DVector::from_fn(stresses.len(), |i, _| weights[i] * stresses[i]);
    if settings.demand_stability {
        return stable_values(law, &a, &b, settings);
    }
    let solution = linear::solve(&a, &b);
    Some(solution.as_slice().to_vec())
}

/// The best stable coefficients that are found: of the law, or of a smaller one of its family with zeros for the rest,
/// where the rounds of [`linear::solve_stable`] do not end or their rounding leaves an unstable law.
fn stable_values(law: &Law, a: &DMatrix<f64>, b: &DVector<f64>, settings: &Settings) -> Option<Vec<f64>> {
    let family = LAWS.iter().rev().filter(|other| other.family == law.family);
    let smaller = family.filter(|other| other.parameters.len() <= law.parameters.len());
    let solve = |part: &Law| {
        let columns = a.columns(0, part.parameters.len()).into_owned();
        let mut values = linear::solve_stable(&linear::unit_laws(part, &[]), &columns, b, settings.stability_range)?
            .as_slice()
            .to_vec();
        values.resize(law.parameters.len(), 0.0);
        let stability = Stability::new(&law.elastic(&values));
        stability.covers(settings.stability_range).then_some(values)
    };
    smaller.filter_map(solve).next()
}

/// Weight of each residual, 1/Pa or 1.
pub(super) fn weights(data: &[DataSet], weighting: Weighting) -> Vec<f64> {
    if weighting == Weighting::Tests {
        return test_weights(data);
    }
    let of_set = |set: &DataSet| {
        let largest = set.points.iter().fold(0.0, |largest, point| f64::max(largest, point.1.abs()));
        let floor = SMALLEST_RELATIVE * largest;
        let weight = move |point: &(f64, f64)| match weighting {
            Weighting::Absolute | Weighting::Tests => 1.0,
            Weighting::Relative => 1.0 / point.1.abs().max(floor),
        };
        set.points.iter().map(weight).collect::<Vec<_>>()
    };
    data.iter().flat_map(of_set).collect()
}

/// Weights with which every test counts alike, by its largest stress; their squares times those of the largest stresses are 1 in
/// the mean.
fn test_weights(data: &[DataSet]) -> Vec<f64> {
    let measured: Vec<f64> = data.iter().flat_map(|set| set.points.iter().map(|point| point.1)).collect();
    let parts = Part::list(data);
    let mut weights = vec![0.0; measured.len()];
    let share = measured.len() as f64 / parts.len().max(1) as f64;
    for part in &parts {
        let weight = (share / part.places.len() as f64).sqrt() / part.largest(&measured);
        // A test without any stress says nothing that a weight could scale.
        let weight = if weight.is_finite() { weight } else { 0.0 };
        part.places.iter().for_each(|place| weights[*place] = weight);
    }
    weights
}
