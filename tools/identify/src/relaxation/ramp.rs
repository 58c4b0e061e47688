//! Whether a load rises to its peak during a ramp, or stands there at once and scatters.

use softanvil_records::robust::{NORMAL, median};

/// Part of the peak below which a first load is none that was there at once, whatever the scatter.
const AT_ONCE: f64 = 0.5;
/// Standard deviations of the scatter that a rise to the peak has at least: the larger of some dozen loads and the first are
/// nearer to each other by chance in all but one of 100,000 tests.
const RISE: f64 = 6.0;
/// Standard deviations of the scatter below the largest load that are as large as that.
const ALIKE: f64 = 4.0;
/// A slope over its standard error that is one.
const SLOPE: f64 = 3.0;

/// The time at which the load of `points` (time since loading began, load) has risen to its peak; none if it was there at
/// once.
pub fn end(points: &[(f64, f64)]) -> Option<f64> {
    let larger = |best: usize, index: usize| if points[index].1 > points[best].1 { index } else { best };
    let peak = (0..points.len()).fold(0, larger);
    let (first, top) = (points.first()?.1, points[peak].1);
    let scatter = scatter(&points[peak..], top);
    if peak == 0 || first >= AT_ONCE * top && top - first < RISE * scatter {
        return None;
    }
    // Among loads that are alike the noisiest is the largest, and that one is no end of a ramp.
    let alike = points.iter().position(|point| point.1 >= top - ALIKE * scatter).unwrap_or(peak);
    let end = if rises(&points[alike..=peak]) { peak } else { alike };
    Some(points[end].0).filter(|time| *time > 0.0)
}

/// Standard deviation of the errors of `relaxing` loads where they are `top`, by how far each is from the straight line (over
/// the logarithm of time) between its neighbours: as large as they have it in the middle, absolute or as parts of the load.
fn scatter(relaxing: &[(f64, f64)], top: f64) -> f64 {
    let logarithmic = relaxing.iter().all(|point| point.0 > 0.0);
    let place = |time: f64| if logarithmic { time.ln() } else { time };
    let distance = |points: &[(f64, f64)]| {
        let [before, here, after] = [0, 1, 2].map(|k| place(points[k].0));
        let part = (here - before) / (after - before);
        let line = (1.0 - part) * points[0].1 + part * points[2].1;
        (points[1].1 - line).abs() / (1.0 + part * part + (1.0 - part) * (1.0 - part)).sqrt()
    };
    let distances: Vec<f64> = relaxing.windows(3).map(distance).collect();
    let parts = relaxing.windows(3).zip(&distances).map(|(points, distance)| distance / points[1].1.abs()).collect();
    // Loads of nothing, or at one time, tell no scatter.
    let known = |deviation: f64| if deviation.is_finite() { deviation } else { 0.0 };
    NORMAL * f64::max(known(median(distances)), top * known(median(parts)))
}

/// Whether the loads of `points` rise over time by more than they scatter around a straight line.
fn rises(points: &[(f64, f64)]) -> bool {
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / n, sum.1 + point.1 / n));
    let moment = |f: &dyn Fn(f64, f64) -> f64| points.iter().map(|(t, y)| f(t - mean.0, y - mean.1)).sum::<f64>();
    let slope = moment(&|t, y| t * y) / moment(&|t, _| t * t);
    let residual = moment(&|t, y| (y - slope * t).powi(2));
    n > 2.0 && slope > SLOPE * (residual / (n - 2.0) / moment(&|t, _| t * t)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::relaxation::history::History;

    /// Relaxation to a third with two terms, at `times`.
    fn loads(times: &[f64], history: &History, error: impl Fn(usize) -> f64) -> Vec<(f64, f64)> {
        let (fast, slow) = (history.response(times, 0.3), history.response(times, 20.0));
        let elastic = history.elastic(times);
        let load = |k: usize| 100.0 * (elastic[k] + fast[k] + slow[k]) / 3.0 * (1.0 + error(k));
        times.iter().enumerate().map(|(k, time)| (*time, load(k))).collect()
    }

    /// A number of -1 to 1, evenly distributed (SplitMix64 of Steele, Lea and Flood 2014).
    fn even(seed: usize, k: usize) -> f64 {
        let mut z = ((1_000_003 * seed + k) as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Errors of up to 1.7 and 3.5 %, evenly distributed: standard deviations of 1 and 2 %.
    #[test]
    fn noise_makes_no_ramp() {
        let logarithmic: Vec<f64> = (0..80).map(|k| 0.01 * 10f64.powf(f64::from(k) / 20.0)).collect();
        let even_times: Vec<f64> = (0..2000).map(|k| 0.05 * f64::from(k)).collect();
        for times in [logarithmic, even_times] {
            for (seed, size) in (0..200).flat_map(|seed| [(seed, 0.017), (seed, 0.035)]) {
                let points = loads(&times, &History::step(0.0), |k| size * even(seed, k));
                assert_eq!(end(&points), None, "{seed} {size}");
            }
        }
    }

    #[test]
    fn a_ramp_is_found_through_the_noise() {
        let times: Vec<f64> = (0..500).map(|k| 0.1 * f64::from(k)).collect();
        for (seed, size) in (0..50).flat_map(|seed| [(seed, 0.0), (seed, 0.017), (seed, 0.035)]) {
            let points = loads(&times, &History::ramp(0.0, 5.0, |part| part), |k| size * even(seed, k));
            let end = end(&points).unwrap();
            // Within the scatter the last loads of a ramp are alike.
            assert!((end - 5.0).abs() < 0.11 + 40.0 * size, "{seed} {size}: {end}");
        }
    }

    /// A trigger row without load, then a load that hardly relaxes: the largest is some late one, by chance.
    #[test]
    fn the_ramp_ends_where_the_load_is_reached_not_where_noise_is_largest() {
        let mut points: Vec<(f64, f64)> =
            (1..300).map(|k| (0.01 * f64::from(k), 100.0 - 0.002 * f64::from(k) + even(3, k as usize))).collect();
        points.insert(0, (0.0, 0.0));
        assert_eq!(end(&points), Some(0.01));
    }
}
