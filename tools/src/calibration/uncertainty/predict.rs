//! What samples of a posterior say about an impact: each is simulated, and the bands are over all of them.
//!
//! A number to be measured is a simulated one times the log-normal error of its sample, so its band is of the mixture of
//! these distributions. A force over time is a simulated one, stretched in force and in time by errors drawn for the peak
//! force and for the duration: what the model misses of these two, and nothing of the shape.

use fcmaes_core::Rng;
use rayon::prelude::*;
use softanvil_kernel::Scenario;

use super::error_model::ErrorModel;
use super::normal::{mixture_quantile, quantile};
use super::waves::Sample;
use crate::calibration::variable::{Variable, apply};
use crate::failure::Failure;
use crate::measurement::band::{Band, Expected, ForceBand, TAIL};
use crate::measurement::quantity::{COUNT, PEAK_FORCE};
use crate::measurement::reading::Reading;
use crate::run::{Drop, Until};

/// Part of the highest force below which the end of a band is left out.
const SEEN: f64 = 0.005;
/// Index of the impact duration.
const DURATION: usize = 2;

/// A simulated sample.
struct Impact {
    values: [f64; COUNT],
    /// Forces from the last sample before contact on, N.
    force: Vec<f64>,
    interval: f64,
}

/// The bands of `scenario` with the values of all `samples` of `variables`, read by `reading`; `progress` hears of every sample.
///
/// # Errors
/// A sample that cannot be simulated.
pub fn expect(
    scenario: &Scenario,
    until: Until,
    reading: Reading,
    variables: &[Variable],
    (errors, samples): (&ErrorModel, &[Sample]),
    progress: &(dyn Fn() + Sync),
) -> Result<Expected, Failure> {
    let simulate = |sample: &Sample| {
        let mut scenario = scenario.clone();
        apply(variables, &sample.values, &mut scenario).map_err(Failure::Failed)?;
        let impact = impact(&scenario, until, reading);
        progress();
        impact
    };
    let impacts = samples.par_iter().map(simulate).collect::<Result<Vec<_>, _>>()?;
    let deviations: Vec<[f64; COUNT]> = samples
        .iter()
        .map(|sample| std::array::from_fn(|quantity| errors.deviation(quantity, &sample.discrepancies)))
        .collect();
    let of_parameters = |i: usize| {
        let values: Vec<f64> = impacts.iter().map(|impact| impact.values[i]).collect();
        band(&|part| quantile(&values, part))
    };
    let of_measured = |i: usize| {
        let components: Vec<(f64, f64)> = impacts
            .iter()
            .zip(&deviations)
            .map(|(impact, deviations)| (impact.values[i].max(f64::MIN_POSITIVE).ln(), deviations[i]))
            .collect();
        band(&|part| mixture_quantile(&components, part).exp())
    };
    let impactor = &scenario.impactor;
    Ok(Expected {
        samples: samples.len(),
        energy: 0.5 * impactor.mass * impactor.start_speed().powi(2),
        parameters: std::array::from_fn(of_parameters),
        measured: std::array::from_fn(of_measured),
        force: force_band(&impacts, &deviations),
    })
}

fn band(quantile: &dyn Fn(f64) -> f64) -> Band {
    Band { low: quantile(TAIL), median: quantile(0.5), high: quantile(1.0 - TAIL) }
}

fn impact(scenario: &Scenario, until: Until, reading: Reading) -> Result<Impact, Failure> {
    let run = Drop::until(scenario, until)?.run(|_| {})?;
    let record = reading.take(&run).map_err(|error| Failure::Input(error.to_string()))?;
    let forces = &record.series.force;
    let first = forces.iter().position(|force| *force > 0.0).unwrap_or(forces.len());
    let last = forces.iter().rposition(|force| *force > 0.0).unwrap_or(0);
    let force = forces.get(first.saturating_sub(1)..(last + 2).min(forces.len())).unwrap_or_default().to_vec();
    Ok(Impact { values: record.values, force, interval: record.series.interval })
}

/// The band of the forces at each time since contact.
fn force_band(impacts: &[Impact], deviations: &[[f64; COUNT]]) -> ForceBand {
    let mut random = Rng::new(1);
    let stretches: Vec<[f64; 2]> = deviations
        .iter()
        .map(|deviations| [PEAK_FORCE, DURATION].map(|i| random.normreal(0.0, deviations[i]).exp()))
        .collect();
    let longest = impacts.iter().map(|impact| impact.force.len()).max().unwrap_or(0);
    let at = |time: usize| {
        let forces = impacts.iter().zip(&stretches);
        let forces = forces.map(|(impact, [force, duration])| force * between(&impact.force, time as f64 / duration));
        let forces: Vec<f64> = forces.collect();
        [TAIL, 1.0 - TAIL].map(|part| quantile(&forces, part))
    };
    let ends: Vec<[f64; 2]> = (0..2 * longest).map(at).collect();
    // Longest tails would shrink the rest of a picture.
    let seen = SEEN * ends.iter().map(|ends| ends[1]).fold(0.0, f64::max);
    let count = ends.iter().rposition(|[_, high]| *high > seen).map_or(0, |last| (last + 2).min(ends.len()));
    ForceBand {
        interval: impacts.first().map_or(0.0, |impact| impact.interval),
        low: ends[..count].iter().map(|ends| ends[0]).collect(),
        high: ends[..count].iter().map(|ends| ends[1]).collect(),
    }
}

/// The force at `place`, counted in samples; none outside.
fn between(forces: &[f64], place: f64) -> f64 {
    let (below, share) = (place.floor() as usize, place.fract());
    let at = |i: usize| forces.get(i).copied().unwrap_or(0.0);
    at(below) + share * (at(below + 1) - at(below))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the quantiles of the normal distribution that the deviations state.
    #[test]
    fn the_band_of_a_force_has_the_width_of_its_errors() {
        let impact = || Impact { values: [0.0; COUNT], force: vec![0.0, 1000.0, 1000.0, 1000.0, 0.0], interval: 5e-5 };
        let impacts: Vec<Impact> = (0..4000).map(|_| impact()).collect();
        let band = force_band(&impacts, &vec![[0.1, 0.0, 0.0, 0.0]; 4000]);
        let expected = |sign: f64| 1000.0 * (sign * 0.1 * 1.644_85f64).exp();
        assert_eq!(band.low.len(), 5);
        assert!((band.low[2] / expected(-1.0) - 1.0).abs() < 0.02, "{}", band.low[2]);
        assert!((band.high[2] / expected(1.0) - 1.0).abs() < 0.02, "{}", band.high[2]);
        let sure = force_band(&impacts, &vec![[0.0; COUNT]; 4000]);
        assert_eq!((sure.low, sure.high.len()), (vec![0.0, 1000.0, 1000.0, 1000.0, 0.0], 5));
    }
}
