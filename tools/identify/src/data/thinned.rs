//! Fewer points of very many.

use super::point::Point;

/// Points of one curve that are fitted as they are, at most; a machine that samples at a kilohertz writes many more.
pub const MAX_POINTS: usize = 2000;
/// Bins of equal width that more points are averaged in.
const BINS: usize = 1000;

/// `points` (sorted by stretch), or their means in bins of the stretch if there are more than [`MAX_POINTS`].
///
/// A mean of many points scatters less than each of them, and so do the residuals that standard errors come from.
pub fn thinned(points: Vec<Point>, notes: &mut Vec<String>) -> Vec<Point> {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return points };
    let (low, width) = (first.stretch, (last.stretch - first.stretch) / BINS as f64);
    if points.len() <= MAX_POINTS || width <= 0.0 {
        return points;
    }
    let bin = |point: &Point| (((point.stretch - low) / width) as usize).min(BINS - 1);
    let mean = |points: &[Point]| {
        let of = |value: fn(&Point) -> f64| points.iter().map(value).sum::<f64>() / points.len() as f64;
        Point { stretch: of(|point| point.stretch), stress: of(|point| point.stress), ..points[0] }
    };
    let means: Vec<Point> = points.chunk_by(|a, b| bin(a) == bin(b)).map(mean).collect();
    notes.push(format!("{} points averaged to {}", points.len(), means.len()));
    means
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_points_keep_their_line_and_few_stay() {
        let line = |count: usize| -> Vec<Point> {
            let stretch = |k: usize| 1.0 + k as f64 / count as f64;
            let point = |k| Point { line: k, cycle: None, stretch: stretch(k), stress: 3.0 * stretch(k) };
            (0..count).map(point).collect()
        };
        let mut notes = Vec::new();
        let means = thinned(line(100_000), &mut notes);
        assert!(means.len() <= BINS && notes.len() == 1, "{notes:?}");
        assert!(means.iter().all(|point| (point.stress - 3.0 * point.stretch).abs() < 1e-9));
        assert_eq!(thinned(line(50), &mut notes), line(50));
    }
}
