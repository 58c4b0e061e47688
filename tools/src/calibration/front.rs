//! What the impacts cost the material tests, and the other way round: the best of a search for each of several weights of the
//! tests. A point that another one beats in both misfits is on no front, and says that its search has not found the best.

use std::fmt::Write;

use super::objective::scenario;
use super::problem::Problem;
use super::result::Found;
use crate::measurement::errors::error_percent;
use crate::plot::{self, Line, PlotError};
use crate::text::table::{align_right, new_table, text as table_text};

/// Names of the files of a front.
pub const FILES: [&str; 3] = ["front.csv", "front.svg", "front.txt"];

/// The best of one weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Weight of the material tests.
    pub weight: f64,
    /// Mean of the absolute errors of all measured numbers, %.
    pub mean_error: f64,
    /// Largest absolute error among them, %.
    pub worst_error: f64,
    /// Root mean square of the distances from the material tests that count, in standard deviations.
    pub distance: f64,
    /// Largest distance among them.
    pub farthest: f64,
    /// Whether the search has converged.
    pub converged: bool,
}

impl Point {
    /// What a search with the weight of `problem` has found.
    pub fn of(problem: &Problem, found: &Found) -> Self {
        let impacts = problem.targets.iter().zip(&found.evaluation.impacts);
        let errors = impacts.flat_map(|(target, simulated)| {
            target
                .measured
                .iter()
                .zip(simulated.values)
                .filter_map(|(measured, value)| Some(error_percent(value, (*measured)?)))
        });
        let counted = problem.material_tests.iter().filter(|test| !test.predict);
        let scenario = scenario(problem, &found.entry.values).ok();
        let distance = |test: &super::material_test::MaterialTest| {
            scenario.as_ref().map_or(f64::NAN, |scenario| test.distance(test.model(scenario)))
        };
        let distances: Vec<f64> = counted.map(distance).collect();
        let squares: f64 = distances.iter().map(|distance| distance * distance).sum();
        Self {
            weight: problem.objective.material_weight,
            mean_error: found.evaluation.mean_error,
            worst_error: errors.map(f64::abs).fold(0.0, f64::max),
            distance: (squares / distances.len().max(1) as f64).sqrt(),
            farthest: distances.iter().map(|distance| distance.abs()).fold(0.0, f64::max),
            converged: found.convergence.is_reached(),
        }
    }

    /// Whether `other` is better in one misfit and no worse in the other.
    fn is_beaten_by(&self, other: &Self) -> bool {
        let no_worse = other.mean_error <= self.mean_error && other.distance <= self.distance;
        no_worse && (other.mean_error < self.mean_error || other.distance < self.distance)
    }
}

/// The points as a table for people.
pub fn text(points: &[Point]) -> String {
    let header = ["weight", "mean |error|", "largest", "distance (rms)", "largest", "converged", "on the front"];
    let mut table = new_table(&header);
    for point in points {
        let yes = |yes: bool| if yes { "yes" } else { "no" }.to_string();
        table.add_row([
            point.weight.to_string(),
            format!("{:.2} %", point.mean_error),
            format!("{:.1} %", point.worst_error),
            format!("{:.2} sd", point.distance),
            format!("{:.2} sd", point.farthest),
            yes(point.converged),
            yes(!points.iter().any(|other| point.is_beaten_by(other))),
        ]);
    }
    align_right(&mut table, 0..5);
    table_text(&mut table) + "\nErrors are of the impacts, distances from the material tests.\n"
}

/// The points for programs.
pub fn csv(points: &[Point]) -> String {
    let mut text = "weight [1],mean_error [%],worst_error [%],distance [1],farthest [1],converged\n".to_string();
    for point in points {
        let Point { weight, mean_error, worst_error, distance, farthest, converged } = point;
        let _ = writeln!(text, "{weight},{mean_error},{worst_error},{distance},{farthest},{converged}");
    }
    text
}

/// The front as a picture, SVG.
///
/// # Errors
/// What the drawing library refuses.
pub fn picture(points: &[Point]) -> Result<String, PlotError> {
    let line = |label: &str, error: fn(&Point) -> f64| {
        let mut points: Vec<(f64, f64)> = points.iter().map(|point| (point.distance, error(point))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Line { label: label.into(), points }
    };
    let lines = [line("mean", |point| point.mean_error), line("largest", |point| point.worst_error)];
    plot::lines(
        "Impacts against material tests",
        ("distance from the material tests (rms, sd)", false),
        "error of the impacts (%)",
        &lines,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(mean_error: f64, distance: f64) -> Point {
        Point { weight: 1.0, mean_error, worst_error: 12.0, distance, farthest: 2.0, converged: true }
    }

    #[test]
    fn a_point_that_is_beaten_in_both_misfits_is_not_on_the_front() {
        let points = [point(5.0, 3.0), point(6.0, 1.0), point(6.5, 2.0)];
        assert_eq!(points.map(|point| points.iter().any(|other| point.is_beaten_by(other))), [false, false, true]);
        let text = text(&points);
        let ends = text.lines().filter(|line| line.contains(" sd")).map(|line| line.trim_end().ends_with("yes"));
        assert_eq!(ends.collect::<Vec<_>>(), [true, true, false], "{text}");
        assert!(picture(&points).unwrap().contains("<svg"));
        assert_eq!(csv(&points).lines().nth(2), Some("1,6,12,1,2,true"));
    }
}
