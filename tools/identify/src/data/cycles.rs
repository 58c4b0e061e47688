//! Loading, unloading, and cycles of a specimen.

use super::point::Point;

/// Which part of a cyclic test to use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Leave out the first cycle, in which rubber softens (Mullins 1969).
    pub drop_first_cycle: bool,
    /// Use unloading as well as loading.
    pub unloading: bool,
}

/// Part of a test between two turns.
struct Branch {
    start: usize,
    end: usize,
    loading: bool,
}

/// A turn is one that comes back by more than this part of the range of strains; less is noise.
const TURN: f64 = 0.05;
/// With fewer points between its turns on average, a list of points is no test in the order of time.
const POINTS_PER_BRANCH: usize = 5;

/// The points of `selection`, sorted by stretch, without exact repetitions; adds to `notes` what was left out.
///
/// # Errors
/// A first cycle to be dropped where there is no second.
pub fn select(points: &[Point], selection: Selection, notes: &mut Vec<String>) -> Result<Vec<Point>, String> {
    let branches = branches(points);
    let cyclic = branches.iter().any(|branch| !branch.loading) && points.len() >= POINTS_PER_BRANCH * branches.len();
    let cycles: Vec<usize> = cycle_numbers(points, if cyclic { &branches } else { &[] });
    let loading = |index: usize| {
        !cyclic || branches.iter().any(|branch| branch.loading && (branch.start..branch.end).contains(&index))
    };
    let first = cycles.iter().min().copied().unwrap_or_default();
    if selection.drop_first_cycle && cycles.iter().all(|cycle| *cycle == first) {
        return Err("--drop-first-cycle needs a second cycle, and the data have one".into());
    }
    let kept = (0..points.len())
        .filter(|index| !(selection.drop_first_cycle && cycles[*index] == first))
        .filter(|index| selection.unloading || loading(*index));
    let mut kept: Vec<Point> = kept.map(|index| points[index]).collect();
    if kept.len() < points.len() {
        notes.push(format!("{} of {} points used: {}", kept.len(), points.len(), reasons(selection)));
    } else if !cyclic && branches.len() > 1 {
        notes.push("points in no order, sorted by strain".into());
    }
    kept.sort_by(|a, b| a.stretch.total_cmp(&b.stretch));
    let before = kept.len();
    kept.dedup_by(|a, b| (a.stretch, a.stress) == (b.stretch, b.stress));
    if kept.len() < before {
        notes.push(format!("{} repeated points dropped", before - kept.len()));
    }
    Ok(kept)
}

fn reasons(selection: Selection) -> String {
    let mut reasons = Vec::new();
    if selection.drop_first_cycle {
        reasons.push("without the first cycle");
    }
    if !selection.unloading {
        reasons.push("loading only");
    }
    reasons.join(", ")
}

/// The number of the cycle of each point: from its column, else one more with each beginning of loading.
fn cycle_numbers(points: &[Point], branches: &[Branch]) -> Vec<usize> {
    let mut numbers = vec![0; points.len()];
    if points.iter().all(|point| point.cycle.is_some()) {
        for (number, point) in numbers.iter_mut().zip(points) {
            *number = point.cycle.map_or(0, |cycle| cycle.max(0.0) as usize);
        }
        return numbers;
    }
    let mut cycle = 0;
    for (index, branch) in branches.iter().enumerate() {
        cycle += usize::from(branch.loading && index > 0);
        numbers[branch.start..branch.end].fill(cycle);
    }
    numbers
}

/// The branches between turns of the strain.
fn branches(points: &[Point]) -> Vec<Branch> {
    let (low, high) =
        points.iter().fold((f64::MAX, f64::MIN), |(l, h), p| (f64::min(l, p.stretch), f64::max(h, p.stretch)));
    let threshold = TURN * (high - low);
    let mut turns = vec![0];
    // The extreme since the last turn, and the direction in which it lies (0 before any motion).
    let (mut extreme, mut heading) = (0, 0.0);
    for (index, point) in points.iter().enumerate() {
        let advance = point.stretch - points[extreme].stretch;
        if heading == 0.0 && advance.abs() > threshold {
            heading = advance.signum();
            extreme = index;
        } else if heading != 0.0 && advance * heading > 0.0 {
            // The first point at the turn: a hold there belongs to the way back.
            extreme = index;
        } else if heading != 0.0 && advance * heading < -threshold {
            turns.push(extreme + 1);
            heading = -heading;
            extreme = index;
        }
    }
    turns.push(points.len());
    let branch = |pair: &[usize]| {
        let (start, end) = (pair[0], pair[1]);
        let strain = |index: usize| (points[index].stretch - 1.0).abs();
        // The way back begins at the last point before it.
        let from = start.saturating_sub(1);
        Branch { start, end, loading: end > start && strain(end - 1) >= strain(from) }
    };
    let mut branches: Vec<Branch> = turns.windows(2).map(branch).collect();
    if let [only] = branches.as_mut_slice() {
        // From compression through rest to tension, or listed from its end: all of it is loading.
        only.loading = true;
    }
    branches
}

#[cfg(test)]
mod tests {
    use super::*;

    fn test(strains: impl IntoIterator<Item = f64>) -> Vec<Point> {
        let point = |(index, strain): (usize, f64)| Point {
            line: index + 1,
            cycle: None,
            stretch: 1.0 + strain,
            stress: index as f64,
        };
        strains.into_iter().enumerate().map(point).collect()
    }

    fn triangle(cycles: usize, sign: f64) -> Vec<Point> {
        let one = (0..10).chain((1..11).rev()).map(move |k| sign * 0.05 * f64::from(k));
        test((0..cycles).flat_map(|_| one.clone()))
    }

    fn selected(points: &[Point], drop_first_cycle: bool, unloading: bool) -> Vec<Point> {
        select(points, Selection { drop_first_cycle, unloading }, &mut Vec::new()).unwrap()
    }

    #[test]
    fn loading_alone_is_used_and_the_first_cycle_dropped_on_request() {
        for sign in [1.0, -1.0] {
            let points = triangle(3, sign);
            let count = |drop, unloading| selected(&points, drop, unloading).len();
            assert_eq!(count(false, true), 60);
            assert!((count(false, false) as i32 - 31).abs() <= 3, "{}", count(false, false));
            // The point between two cycles ends the first.
            assert_eq!(count(true, true), 39);
            assert!(selected(&points, true, true).iter().all(|point| point.line > 20));
        }
    }

    #[test]
    fn one_way_tests_are_used_whole_in_either_order() {
        for strains in [[-0.3, -0.1, 0.1, 0.4], [0.4, 0.2, 0.1, 0.0], [0.0, -0.1, -0.2, -0.3]] {
            let kept = selected(&test(strains), false, false);
            assert_eq!(kept.len(), 4, "{strains:?}");
            assert!(kept.is_sorted_by(|a, b| a.stretch <= b.stretch));
        }
    }

    #[test]
    fn points_in_no_order_are_sorted_and_repetitions_dropped() {
        let mut points = test([0.1, 0.5, 0.2, 0.9, 0.0, 0.7, 0.3]);
        points.push(points[2]);
        let mut notes = Vec::new();
        assert_eq!(select(&points, Selection::default(), &mut notes).unwrap().len(), 7);
        assert_eq!(notes.len(), 2, "{notes:?}");
    }

    #[test]
    fn a_single_cycle_cannot_be_dropped() {
        let selection = Selection { drop_first_cycle: true, unloading: false };
        assert!(select(&triangle(1, 1.0), selection, &mut Vec::new()).is_err());
    }
}
