//! Whether a search has converged.
//!
//! A descent of CMA-ES has ended when [`PATIENCE`] evaluations for each parameter brought less than [`IMPROVEMENT`] points of
//! score, or CMA-ES stopped by itself. One descent may end in a local minimum: a search counts as converged when a second
//! one, which began elsewhere or with another step, has ended as low. A search that was cut off before has evaluations in a
//! small region for no other reason than that it was there, so that their spread says nothing.

use serde_json::{Value, json};

/// A restart that has not improved its best score by more than [`IMPROVEMENT`] in this many evaluations per variable ends.
pub const PATIENCE: usize = 60;
/// Points of score that count as an improvement.
pub const IMPROVEMENT: f64 = 0.01;
/// Points of score, and part of the best score, within which two descents have ended alike; the larger one counts.
const ALIKE: (f64, f64) = (0.05, 0.01);

/// One restart of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descent {
    /// Its best score.
    pub best: f64,
    /// Its evaluations.
    pub evaluations: usize,
    /// Whether it came to its end, and was not cut off.
    pub ended: bool,
}

/// How far a search has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convergence {
    /// No descent has ended as low as the best score found.
    No,
    /// One has.
    Once,
    /// So many have.
    Yes(usize),
}

impl Convergence {
    /// Judges the descents of a search.
    pub fn of(descents: &[Descent]) -> Self {
        let best = descents.iter().map(|descent| descent.best).fold(f64::INFINITY, f64::min);
        let alike = best + f64::max(ALIKE.0, ALIKE.1 * best.abs());
        match descents.iter().filter(|descent| descent.ended && descent.best <= alike).count() {
            0 => Self::No,
            1 => Self::Once,
            several => Self::Yes(several),
        }
    }

    /// Whether the search has converged.
    pub fn is_reached(self) -> bool {
        matches!(self, Self::Yes(_))
    }

    /// For people, in lines.
    pub fn text(self, n_variable: usize) -> String {
        let ends =
            format!("a descent ends when {} evaluations bring less than {IMPROVEMENT} points", PATIENCE * n_variable);
        let (points, percent) = (ALIKE.0, 100.0 * ALIKE.1);
        let alike = format!("within {points} points or {percent} % of the best score");
        match self {
            Self::Yes(count) => format!("Converged: {count} descents ended {alike} ({ends}).\n"),
            Self::Once => format!(
                "! Not confirmed: one descent ended {alike}, no second one yet ({ends}).\n\
                 ! The values may be those of a local minimum; more --evaluations continue the search.\n"
            ),
            Self::No => format!(
                "! Not converged: no descent ended {alike} ({ends}).\n\
                 ! The values are the best so far; more --evaluations continue the search.\n"
            ),
        }
    }

    /// For programs.
    pub fn json(self, descents: &[Descent]) -> Value {
        let rows = descents.iter().map(
            |descent| json!({ "best_score": descent.best, "evaluations": descent.evaluations, "ended": descent.ended }),
        );
        json!({
            "converged": self.is_reached(),
            "patience_per_parameter": PATIENCE,
            "improvement": IMPROVEMENT,
            "alike": { "points": ALIKE.0, "part": ALIKE.1 },
            "descents": rows.collect::<Vec<_>>(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_descents_have_to_end_alike() {
        let descent = |best, ended| Descent { best, evaluations: 100, ended };
        for (descents, convergence) in [
            (vec![], Convergence::No),
            (vec![descent(5.0, false)], Convergence::No),
            (vec![descent(5.0, true)], Convergence::Once),
            (vec![descent(5.0, true), descent(5.04, false)], Convergence::Once),
            (vec![descent(5.0, true), descent(5.2, true)], Convergence::Once),
            (vec![descent(5.0, true), descent(5.04, true)], Convergence::Yes(2)),
            // The best was found in a descent that was cut off: the others ended too high.
            (vec![descent(5.0, true), descent(5.0, true), descent(4.0, false)], Convergence::No),
        ] {
            assert_eq!(Convergence::of(&descents), convergence, "{descents:?}");
        }
    }
}
