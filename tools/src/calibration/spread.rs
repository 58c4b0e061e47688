//! What a search tells about how well its parameters are pinned: the spread of values that are about as good as the best.

use super::log::Entry;
use super::problem::Problem;
use super::search::best;

/// Scores within this factor of the best, or within so many points, count as equally good: no test is as exact as a score
/// near 0 would ask for.
pub const EQUALLY_GOOD: (f64, f64) = (1.05, 0.1);

/// The spread of one variable among equally good values.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Smallest value.
    pub min: f64,
    /// Median.
    pub median: f64,
    /// Largest value.
    pub max: f64,
    /// Distance from smallest to largest, as a part of the searched range (on its scale): near 0 the impacts pin the
    /// variable, near 1 they say nothing about it.
    pub part: f64,
}

/// The spread of every variable, and of how many evaluations.
pub fn spread(problem: &Problem, entries: &[Entry]) -> (usize, Vec<Spread>) {
    let Some(best) = best(entries) else { return (0, Vec::new()) };
    let limit = f64::max(EQUALLY_GOOD.0 * best.score, best.score + EQUALLY_GOOD.1);
    let good: Vec<&Entry> = entries.iter().filter(|entry| entry.score <= limit).collect();
    let of_variable = |index: usize| {
        let variable = &problem.variables[index];
        let mut values: Vec<f64> = good.iter().map(|entry| entry.values[index]).collect();
        values.sort_by(f64::total_cmp);
        let (min, max) = (values[0], values[values.len() - 1]);
        Spread { min, median: values[values.len() / 2], max, part: variable.part(max) - variable.part(min) }
    };
    (good.len(), (0..problem.variables.len()).map(of_variable).collect())
}
