//! How many terms a Prony series has, and which part of the test tells them.

use super::prony::{Prony, Relaxation, fit};

/// Fewest and most terms that are tried; the study tried 2 to 5.
pub const TERMS: std::ops::RangeInclusive<usize> = 1..=5;

/// Series of each number of terms.
///
/// ```
/// use softanvil_identify::relaxation::choice::{Choice, TERMS};
/// use softanvil_identify::relaxation::history::History;
/// use softanvil_identify::relaxation::prony::Relaxation;
///
/// let times: Vec<f64> = (0..60).map(|i| 1e-2 * 1.2_f64.powi(i)).collect();
/// let loads = times.iter().map(|t| 50e3 + 30e3 * (-t / 0.1).exp() + 20e3 * (-t / 10.0).exp()).collect();
/// let counts = vec![1; times.len()];
/// let relaxation = Relaxation { times, loads, counts, loaded: 0.0, history: History::step(0.0) };
/// let choice = Choice::new(&relaxation, None).unwrap();
/// assert_eq!((choice.series.len(), choice.prony().terms.len()), (TERMS.count(), 2));
/// ```
#[derive(Clone, Debug)]
pub struct Choice {
    /// The series, in order of their number of terms; those that are worse than the mean of the loads are left out.
    pub series: Vec<Prony>,
    /// Index of the chosen one.
    pub chosen: usize,
    /// What to think of before believing it.
    pub caveats: Vec<String>,
}

/// Why there is no series.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Undescribed {
    /// None describes the loads better than their mean does: its R2.
    #[error(
        "no series describes this relaxation: the loads scatter less around their mean than around the best of them (R2 = {0:.3}); \
         are time, load and strain read as they are meant (--relaxation-columns, --relaxation-start, --ramp-time)?"
    )]
    Loads(f64),
    /// That of the hold has another ramp: by which part of the largest load it misses that, and what it may at most.
    #[error(
        "the series of the hold misses the ramp by {:.0} % of the largest load (root mean square; expected {:.0} % at most): the \
         load did not rise like this; --relaxation-start and --ramp-time say how, and a file without the ramp is one of a step",
        100.0 * .0, 100.0 * GROSS
    )]
    Ramp(f64),
}

/// Root mean square of a ramp over that of the hold, and that of the hold over what it would be without the ramp, beyond which
/// ramp and hold are not of one linear material; and the parts of the largest load that are no misfit.
const ONE_MATERIAL: [(f64, f64); 2] = [(2.0, 5e-3), (1.5, 1e-3)];
/// Part of the largest load by which a series misses the ramp of no sample, root mean square: one that softens at once, to where
/// it stays, is missed by a third.
const GROSS: f64 = 0.4;
/// Part of a load that is no misfit.
const ROUNDING: f64 = 1e-6;
/// Points of a hold that tell a series by themselves, at least.
const FEWEST: usize = 4;
/// The instantaneous load over the largest measured one from which on it is said to be an extrapolation.
const EXTRAPOLATED: f64 = 1.5;

impl Choice {
    /// Fits every number of terms and chooses `n_term`, or the lowest AIC among those whose terms are all identified
    /// (among all, if none are). The ramp counts as long as one series follows both it and the hold; a sample that softens
    /// while it is loaded is none that does.
    ///
    /// The residual falls with every term, so the study's rule, the lowest residual, would choose the most terms.
    ///
    /// # Errors
    /// Series that are all worse than the mean, or that have another ramp altogether.
    pub fn new(data: &Relaxation, n_term: Option<usize>) -> Result<Self, Undescribed> {
        let mut choice = Self::of(data, n_term);
        let hold = data.hold();
        if data.n_ramp() > 0 && hold.times.len() >= FEWEST {
            let of_hold = fit(choice.prony().terms.len(), &hold);
            if !is_one_material(data, choice.prony(), &of_hold) {
                choice = Self::of(&hold, n_term);
                let missed = choice.prony().residuals(data).0.unwrap_or_default() / largest(data);
                if missed > GROSS {
                    return Err(Undescribed::Ramp(missed));
                }
                choice.caveats.push(left_out(missed));
            }
        }
        choice.keep_described(largest(data))?;
        choice.caveats.extend(extrapolation(data, choice.prony()));
        Ok(choice)
    }

    fn of(data: &Relaxation, n_term: Option<usize>) -> Self {
        let series: Vec<Prony> = TERMS.map(|count| fit(count, data)).collect();
        let lowest = |accept: fn(&Prony) -> bool| {
            let candidates = series.iter().enumerate().filter(|(_, prony)| accept(prony));
            candidates.min_by(|a, b| a.1.statistics.aic.total_cmp(&b.1.statistics.aic)).map(|(index, _)| index)
        };
        let given = n_term.map(|count| count - TERMS.start());
        let identified = || lowest(|prony| prony.doubts.is_empty());
        let chosen = given.or_else(identified).or_else(|| lowest(|_| true)).unwrap_or_default();
        Self { series, chosen, caveats: Vec::new() }
    }

    /// Leaves out the series that are worse than the mean of the loads, of which one is `largest`.
    fn keep_described(&mut self, largest: f64) -> Result<(), Undescribed> {
        // A load that does not relax is its mean: nothing is better but for rounding.
        let is_described =
            |prony: &Prony| prony.statistics.r_squared >= 0.0 || prony.statistics.rms <= ROUNDING * largest;
        if !is_described(self.prony()) {
            return Err(Undescribed::Loads(self.prony().statistics.r_squared));
        }
        let n_term = self.prony().terms.len();
        self.series.retain(is_described);
        self.chosen = self.series.iter().position(|prony| prony.terms.len() == n_term).unwrap_or_default();
        Ok(())
    }

    /// The chosen series.
    pub fn prony(&self) -> &Prony {
        &self.series[self.chosen]
    }
}

/// Whether a series follows both the ramp and the hold, which one of the hold alone does not follow much better.
fn is_one_material(data: &Relaxation, of_all: &Prony, of_hold: &Prony) -> bool {
    let largest = largest(data);
    let ((ramp, hold), (_, best)) = (of_all.residuals(data), of_hold.residuals(data));
    let [within, beside] = ONE_MATERIAL;
    ramp.is_none_or(|ramp| ramp <= within.0 * hold + within.1 * largest) && hold <= beside.0 * best + beside.1 * largest
}

/// That the ramp does not count.
fn left_out(missed: f64) -> String {
    format!(
        "the ramp is not that of the material that relaxes in the hold (a sample that softens, a law that is not linear, or \
         another ramp time): the series is of the hold alone, and misses the ramp by {:.1} % of the largest load",
        100.0 * missed
    )
}

/// That the instantaneous load was never measured, if it is far above all that were.
fn extrapolation(data: &Relaxation, prony: &Prony) -> Option<String> {
    let (whole, largest) = (prony.instantaneous(), largest(data));
    let loading = match data.loaded > 0.0 {
        true => format!("during the loading of {:.4} s", data.loaded),
        false => "before the first point".into(),
    };
    (whole > EXTRAPOLATED * largest).then(|| {
        format!(
            "the instantaneous load is extrapolated, {:.2} times the largest that was measured: most of it relaxes {loading}",
            whole / largest
        )
    })
}

fn largest(data: &Relaxation) -> f64 {
    data.loads.iter().fold(0.0, |largest, load| f64::max(largest, load.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::relaxation::history::History;

    /// A ramp of 10 s and a hold of five minutes, whose material relaxes by 0.15 at 2 s and 0.2 at 40 s; `elastic` is its
    /// response during the ramp, and the largest load is about 4.
    fn slow_ramp(elastic: fn(f64) -> f64) -> Relaxation {
        let hold = (0..100).map(|k| 20.0 + 2.8 * f64::from(k));
        let times: Vec<f64> = (0..100).map(|k| 0.2 * f64::from(k)).chain(hold).collect();
        let truth = History::ramp(0.0, 10.0, elastic);
        let (fast, slow) = (truth.response(&times, 2.0), truth.response(&times, 40.0));
        let whole = truth.elastic(&times);
        // A little noise of two frequencies.
        let error = |k: usize| 1.0 + 0.002 * ((7.3 * k as f64).sin() + (2.9 * k as f64).cos());
        let loads = (0..times.len()).map(|k| 4.9 * (0.65 * whole[k] + 0.15 * fast[k] + 0.2 * slow[k]) * error(k));
        let loads = loads.collect();
        Relaxation::of_samples(times, loads, 10.0, History::ramp(0.0, 10.0, |part| part))
    }

    #[test]
    fn a_linear_sample_is_fitted_to_ramp_and_hold() {
        let data = slow_ramp(|part| part);
        let choice = Choice::new(&data, Some(2)).unwrap();
        assert!(choice.caveats.is_empty() && choice.prony().statistics.n_point == data.times.len());
        assert!((choice.prony().instantaneous() / 4.9 - 1.0).abs() < 0.02, "{:?}", choice.prony());
    }

    /// A sample that softens while it is loaded rises at first much faster than it relaxes later.
    #[test]
    fn a_softening_ramp_is_not_taken_for_relaxation() {
        let data = slow_ramp(|part| (1.0 - (-4.0 * part).exp()) / (1.0 - (-4.0_f64).exp()));
        let largest = data.loads.iter().copied().fold(0.0, f64::max);
        let choice = Choice::new(&data, None).unwrap();
        assert!(choice.caveats[0].starts_with("the ramp is not that of the material"), "{:?}", choice.caveats);
        let (ramp, hold) = choice.prony().residuals(&data);
        assert!(ramp.unwrap() > 0.1 * largest && hold < 0.005 * largest, "{ramp:?} {hold}");
        let instantaneous = choice.prony().instantaneous();
        assert!(instantaneous > largest && instantaneous < 1.5 * largest, "{instantaneous} {largest}");
    }

    /// A load that stands there for most of what is said to be its ramp, and then jumps.
    #[test]
    fn a_ramp_that_is_none_is_refused() {
        let mut data = slow_ramp(|part| part);
        let step = |(load, time): (&mut f64, &f64)| {
            *load = if *time < 9.9 { 0.3 } else { 2.0 + 3.0 * (-(time - 9.9) / 40.0).exp() }
        };
        data.loads.iter_mut().zip(&data.times).for_each(step);
        let error = Choice::new(&data, None).unwrap_err();
        assert!(matches!(error, Undescribed::Ramp(missed) if missed > 0.4), "{error:?}");
        assert!(error.to_string().contains("expected 40 % at most"), "{error}");
    }

    /// Terms of a tenth of the loading time are as fast as any that are looked for.
    #[test]
    fn what_was_never_measured_is_said() {
        let times: Vec<f64> = (0..200).map(|k| 0.05 * f64::from(k)).collect();
        let history = History::ramp(0.0, 2.0, |part| part);
        let fast = history.response(&times, 0.3);
        let loads = history.elastic(&times).iter().zip(fast).map(|(e, q)| e + 9.0 * q).collect();
        let choice = Choice::new(&Relaxation::of_samples(times, loads, 2.0, history), None).unwrap();
        assert!((choice.prony().instantaneous() / 10.0 - 1.0).abs() < 1e-3);
        assert!(choice.caveats[0].contains("extrapolated, 4."), "{:?}", choice.caveats);
    }

    #[test]
    fn a_load_that_does_not_relax_is_described() {
        let times: Vec<f64> = (0..20).map(f64::from).collect();
        let data = Relaxation::of_samples(times, vec![3.0; 20], 0.0, History::step(0.0));
        let choice = Choice::new(&data, None).unwrap();
        assert!((choice.prony().equilibrium / 3.0 - 1.0).abs() < 0.01, "{:?}", choice.prony());
    }

    /// A load that grows under a strain that is said to have been taken off.
    #[test]
    fn a_series_worse_than_the_mean_is_none() {
        let times: Vec<f64> = (0..50).map(f64::from).collect();
        let loads = times.iter().map(|time| 1.0 + 0.1 * time).collect();
        let history = History::measured(vec![(0.0, 1.0), (49.0, 0.01)]);
        let error = Choice::new(&Relaxation::of_samples(times, loads, 0.0, history), None).unwrap_err();
        assert!(matches!(error, Undescribed::Loads(r_squared) if r_squared < 0.0), "{error:?}");
        assert!(error.to_string().contains("--relaxation-columns"), "{error}");
    }
}
