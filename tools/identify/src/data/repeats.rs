//! One curve from several specimens.

use super::point::Point;

/// How several specimens count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeats {
    /// The median of their stresses at common strains, as in the study.
    #[default]
    Median,
    /// Every point of every specimen.
    All,
}

/// Fewest and most points of a median curve.
const POINTS: (usize, usize) = (10, 200);

/// The median curve of `specimens` (each sorted by stretch), over the stretches that all of them reach.
///
/// # Errors
/// Specimens without a stretch in common.
pub fn median(specimens: &[Vec<Point>]) -> Result<Vec<Point>, String> {
    let ends = specimens.iter().filter_map(|points| points.first().zip(points.last()));
    let (low, high) =
        ends.fold((f64::MIN, f64::MAX), |(low, high), (first, last)| (low.max(first.stretch), high.min(last.stretch)));
    if low >= high {
        return Err("the specimens have no strains in common, so there is no median: use --repeats all".into());
    }
    let mut counts: Vec<usize> = specimens.iter().map(Vec::len).collect();
    counts.sort_unstable();
    let count = counts[counts.len() / 2].clamp(POINTS.0, POINTS.1);
    let stretches = (0..count).map(|index| low + (high - low) * index as f64 / (count - 1) as f64);
    Ok(stretches
        .map(|stretch| Point { line: 0, cycle: None, stretch, stress: median_at(specimens, stretch) })
        .collect())
}

fn median_at(specimens: &[Vec<Point>], stretch: f64) -> f64 {
    let mut stresses: Vec<f64> = specimens.iter().map(|points| interpolate(points, stretch)).collect();
    stresses.sort_by(f64::total_cmp);
    let middle = stresses.len() / 2;
    if stresses.len() % 2 == 1 { stresses[middle] } else { 0.5 * (stresses[middle - 1] + stresses[middle]) }
}

/// The stress at `stretch`, on a straight line between neighbours.
fn interpolate(points: &[Point], stretch: f64) -> f64 {
    let after = points.partition_point(|point| point.stretch < stretch).clamp(1, points.len() - 1);
    let (a, b) = (points[after - 1], points[after]);
    if b.stretch == a.stretch {
        return 0.5 * (a.stress + b.stress);
    }
    a.stress + (b.stress - a.stress) * (stretch - a.stretch) / (b.stretch - a.stretch)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(slope: f64, stretches: impl IntoIterator<Item = f64>) -> Vec<Point> {
        let point = |stretch| Point { line: 1, cycle: None, stretch, stress: slope * (stretch - 1.0) };
        stretches.into_iter().map(point).collect()
    }

    #[test]
    fn the_median_ignores_an_outlier_and_keeps_to_the_common_range() {
        let specimens = [line(1.0, [1.0, 1.5, 2.0]), line(2.0, [1.1, 1.4, 1.9]), line(50.0, [1.0, 1.2, 2.2])];
        let curve = median(&specimens).unwrap();
        assert!((curve[0].stretch - 1.1).abs() < 1e-12 && (curve.last().unwrap().stretch - 1.9).abs() < 1e-12);
        for point in curve {
            assert!((point.stress - 2.0 * (point.stretch - 1.0)).abs() < 1e-9, "{point:?}");
        }
    }

    #[test]
    fn specimens_without_a_common_range_have_no_median() {
        assert!(median(&[line(1.0, [1.0, 1.2]), line(1.0, [1.3, 1.4])]).is_err());
    }
}
