//! Whether the straight-line errors of a nonlinear fit can be believed: the profile of the residual sum (Bates and Watts,
//! Nonlinear Regression Analysis and Its Applications, 1988, chapter 6).
//!
//! With one parameter held at the end of its 95 % interval and the others fitted anew, the residual sum of a linear law rises
//! by t^2 s^2, where s^2 is the variance of the residuals and t the factor of the interval. How far the rise is from that
//! says how far the interval is from the true one: a smaller rise means that values beyond are as likely.

use softanvil_kernel::material::ElasticLaw;

use super::fit::{Fit, Settings, demand, weights};
use super::{DataSet, foam, ogden, separable};

/// The rise of the residual sum at an end of an interval, over that of a linear law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Index of the parameter.
    pub parameter: usize,
    /// Rise over the linear law's; infinite where the others find no minimum.
    pub ratio: f64,
}

/// Ratios that leave an interval within about a fifth of its width, which goes as the root of the rise.
const BELIEVED: std::ops::RangeInclusive<f64> = 0.64..=1.5;

impl End {
    /// Whether the end is where a linear law would have it.
    pub fn is_believed(self) -> bool {
        BELIEVED.contains(&self.ratio)
    }

    /// How far from there, in either direction.
    pub fn distance(self) -> f64 {
        self.ratio.max(0.0).ln().abs()
    }
}

/// Both ends of the interval of each parameter of a law with shapes; none of a linear one, and where nothing is
/// left to estimate the errors from.
pub fn ends(fit: &Fit, data: &[DataSet], settings: &Settings) -> Vec<End> {
    let statistics = &fit.statistics;
    let (n, k) = (statistics.n_point, statistics.n_parameter);
    let known = n > k && statistics.residual_sum > 0.0 && statistics.standard_errors.iter().all(|e| e.is_finite());
    if fit.law.is_linear() || !known {
        return Vec::new();
    }
    let weights = weights(data, settings.weighting);
    let factor = statistics.interval();
    let expected = factor * factor * statistics.residual_sum / (n - k) as f64;
    let end = |parameter: usize, side: f64| {
        // Where a linear law would have the others.
        let moved = |i: usize| side * factor * statistics.correlation[(i, parameter)] * statistics.standard_errors[i];
        let start: Vec<f64> = fit.values.iter().enumerate().map(|(i, value)| value + moved(i)).collect();
        let least = match fit.law.family {
            ElasticLaw::Ogden => ogden::minimum_at(parameter, &start, &fit.values, data, &weights),
            ElasticLaw::Hyperfoam => {
                let demand = demand(fit.law, settings);
                foam::search::minimum_at(parameter, &start, &fit.values, data, &weights, &demand)
            }
            _ => separable::minimum_at(fit.law, parameter, &start, &fit.values, data, &weights),
        };
        let rise = least - statistics.residual_sum;
        End { parameter, ratio: rise / expected }
    };
    // What was known has no interval.
    let free = (0..fit.values.len()).filter(|parameter| statistics.standard_errors[*parameter] > 0.0);
    free.flat_map(|parameter| [end(parameter, -1.0), end(parameter, 1.0)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::fit::predict;
    use crate::law::{Law, MODES, Mode};

    fn ends_of(modes: &[Mode], stretches: (f64, f64)) -> Vec<End> {
        let law = Law::find("ogden_3").unwrap();
        let stretch = |k: u32| stretches.0 + (stretches.1 - stretches.0) * f64::from(k) / 29.0;
        let set = |mode: &Mode| DataSet { mode: *mode, points: (0..30).map(|k| (stretch(k), 0.0)).collect() };
        let mut data: Vec<DataSet> = modes.iter().map(set).collect();
        let stresses = predict(law, &[0.0012e6, 5.0, 0.63e6, 1.3, -0.01e6, -2.0], &data);
        for (k, (point, stress)) in data.iter_mut().flat_map(|set| &mut set.points).zip(stresses).enumerate() {
            point.1 = stress + 2e3 * ((k * 7919 % 101) as f64 / 50.0 - 1.0);
        }
        let settings = Settings::plain((0.5, 2.0));
        ends(&Fit::new(law, &data, &settings).unwrap(), &data, &settings)
    }

    #[test]
    fn wide_data_in_three_modes_make_intervals_that_hold() {
        let ends = ends_of(&MODES, (0.5, 5.0));
        assert!(ends.len() == 12 && ends.iter().all(|end| end.is_believed()), "{ends:?}");
    }

    #[test]
    fn data_of_one_mode_do_not() {
        let ends = ends_of(&[Mode::Uniaxial], (0.5, 3.0));
        assert!(ends.iter().any(|end| !end.is_believed()), "{ends:?}");
    }
}
