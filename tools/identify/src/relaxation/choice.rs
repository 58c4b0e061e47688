//! How many terms a Prony series has.

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
/// let choice = Choice::new(&Relaxation { times, loads, history: History::step(0.0) }, None);
/// assert_eq!((choice.series.len(), choice.prony().terms.len()), (TERMS.count(), 2));
/// ```
#[derive(Clone, Debug)]
pub struct Choice {
    /// The series, in order of their number of terms.
    pub series: Vec<Prony>,
    /// Index of the chosen one.
    pub chosen: usize,
}

impl Choice {
    /// Fits every number of terms and chooses `n_term`, or the lowest AIC among those whose terms are all identified
    /// (among all, if none are).
    ///
    /// The residual falls with every term, so the study's rule, the lowest residual, would choose the most terms.
    pub fn new(data: &Relaxation, n_term: Option<usize>) -> Self {
        let series: Vec<Prony> = TERMS.map(|count| fit(count, data)).collect();
        let lowest = |accept: fn(&Prony) -> bool| {
            let candidates = series.iter().enumerate().filter(|(_, prony)| accept(prony));
            candidates.min_by(|a, b| a.1.statistics.aic.total_cmp(&b.1.statistics.aic)).map(|(index, _)| index)
        };
        let given = n_term.map(|count| count - TERMS.start());
        let identified = || lowest(|prony| prony.doubts.is_empty());
        let chosen = given.or_else(identified).or_else(|| lowest(|_| true)).unwrap_or_default();
        Self { series, chosen }
    }

    /// The chosen series.
    pub fn prony(&self) -> &Prony {
        &self.series[self.chosen]
    }
}
