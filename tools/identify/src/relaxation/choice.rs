//! How many terms a Prony series has, and which part of the test tells them.

use super::prony::{Prony, Relaxation, fit};

/// Fewest and most terms that are tried; the study tried 2 to 5.
pub const TERMS: std::ops::RangeInclusive<usize> = 1..=5;

/// Series of each number of terms.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The series, in order of their number of terms; those that are worse than the mean of the loads are left out.
    pub series: Vec<Prony>,
    /// Index of the chosen one.
    pub chosen: usize,
    /// What to think of before believing it.
    pub caveats: Vec<String>,
}

/// No series describes the loads better than their mean does.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "no series describes this relaxation: the loads scatter less around their mean than around the best of them (R2 = {0:.3}); \
     are time, load and strain read as they are meant (--relaxation-columns, --relaxation-start, --ramp-time)?"
)]
pub struct Undescribed(f64);

/// Root mean square of a ramp over that of the hold, and that of the hold over what it would be without the ramp, beyond which
/// ramp and hold are not of one linear material; and the parts of the largest load that are no misfit.
const ONE_MATERIAL: [(f64, f64); 2] = [(2.0, 5e-3), (1.5, 1e-3)];
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
    /// Series that are all worse than the mean.
    pub fn new(data: &Relaxation, n_term: Option<usize>) -> Result<Self, Undescribed> {
        let mut choice = Self::of(data, n_term);
        let hold = data.hold();
        if data.n_ramp() > 0 && hold.times.len() >= FEWEST {
            let of_hold = Self::of(&hold, n_term);
            if let Some(misfit) = misfit(data, choice.prony(), of_hold.prony()) {
                choice = of_hold;
                choice.caveats.push(misfit);
            }
        }
        choice.keep_described()?;
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

    /// Leaves out the series that are worse than the mean of the loads.
    fn keep_described(&mut self) -> Result<(), Undescribed> {
        let r_squared = self.prony().statistics.r_squared;
        if r_squared < 0.0 {
            return Err(Undescribed(r_squared));
        }
        let n_term = self.prony().terms.len();
        self.series.retain(|prony| prony.statistics.r_squared >= 0.0);
        self.chosen = self.series.iter().position(|prony| prony.terms.len() == n_term).unwrap_or_default();
        Ok(())
    }

    /// The chosen series.
    pub fn prony(&self) -> &Prony {
        &self.series[self.chosen]
    }
}

/// Why the ramp does not count, if no series follows both it and the hold.
fn misfit(data: &Relaxation, of_all: &Prony, of_hold: &Prony) -> Option<String> {
    let largest = largest(data);
    let ((ramp, hold), (left_out, best)) = (of_all.residuals(data), of_hold.residuals(data));
    let [within, beside] = ONE_MATERIAL;
    let follows = ramp? <= within.0 * hold + within.1 * largest && hold <= beside.0 * best + beside.1 * largest;
    (!follows).then(|| {
        format!(
            "the ramp is not that of the material that relaxes in the hold (a sample that softens, a law that is not \
             linear, or another ramp time): the series is of the hold alone, and misses the ramp by {:.1} % of the largest load",
            100.0 * left_out.unwrap_or_default() / largest
        )
    })
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
