//! Where a test begins to bear load: what lies before is a gap, slack, or the way in which a specimen seats itself, and no strain.
//!
//! A machine that starts above the specimen, or with a slack one, moves without load at first, which makes every strain too large
//! and the modulus too small. Standards begin at a preload, or lay the toe's tangent back to no load (toe compensation of ASTM D638
//! and D695). Here the beginning counts as empty where the load over a part of the way rises by less than a twentieth of what it
//! rises by over an equal way behind it: a load that begins with the way as its square rises by a third, as its cube by a seventh.

use softanvil_records::robust::{NORMAL, median};

use super::point::Point;

/// Where a specimen is touched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Strain there, as the record counts it.
    pub strain: f64,
    /// Stress before, Pa: that of a load cell that bears nothing.
    pub stress: f64,
    /// Part of the loading's way that lies before.
    pub part: f64,
}

/// Part of the way that is none to speak of.
const SMALLEST: f64 = 0.02;
/// Slope of the load before the touch over that behind it.
const EMPTY: f64 = 0.05;
/// Part of a beginning that looks empty which lies before the touch in any case.
const QUIET: f64 = 0.8;
/// Points that a beginning without load has, and the loading behind it.
const FEWEST: (usize, usize) = (4, 3);
/// Standard deviations of the scatter that the loading rises by behind the touch, at least.
const RISE: f64 = 6.0;
/// The same below which a load is none.
const NONE: f64 = 4.0;
/// Part of the largest load by which it rises at most where it is none: a foam that bottoms out at last has borne more before.
const LEVEL: f64 = 5e-3;
/// Part of the rise behind the touch below which a load is none, too.
const NEXT_TO_NONE: f64 = 0.02;
/// Bins of the way: a fourth of the smallest part.
const BINS: usize = 200;

/// Where the specimen of `points` (strains in `stretch`, of either sign) is touched, if that is not where its record begins.
pub fn find(points: &[Point]) -> Option<Touch> {
    let Loading { points: loading, scatter, signs } = Loading::of(points)?;
    let way = loading.last()?.0;
    let empty = |end: &usize| is_empty(&loading, *end, scatter);
    let least = loading.partition_point(|point| point.0 < SMALLEST * way).max(FEWEST.0 - 1);
    let end = (least..loading.len()).rev().find(empty)?;
    // The slopes tell the touch to a sixth of the way before it: the loads tell it closely.
    let quiet: Vec<f64> =
        loading.iter().filter(|point| point.0 <= QUIET * loading[end].0).map(|point| point.1).collect();
    let rest = quiet.iter().sum::<f64>() / quiet.len() as f64;
    let behind = loading.iter().rev().find(|point| point.0 <= 2.0 * loading[end].0)?;
    let none = f64::max(NONE * scatter, NEXT_TO_NONE * (behind.1 - rest));
    let last = loading.iter().rposition(|point| point.1 - rest <= none)?;
    let strain = onset(&loading, last, rest);
    (strain >= SMALLEST * way).then(|| Touch {
        strain: points[0].stretch + signs.0 * strain,
        stress: signs.1 * rest,
        part: strain / way,
    })
}

/// The first loading of a specimen, up to the largest load.
struct Loading {
    /// (way, load), both positive at the end, in bins if there are many.
    points: Vec<(f64, f64)>,
    /// Standard deviation of the scatter of the loads as they were.
    scatter: f64,
    /// Signs of the way and the load in the record.
    signs: (f64, f64),
}

impl Loading {
    fn of(points: &[Point]) -> Option<Self> {
        let first = points.first()?;
        let rise = |point: &Point| (point.stress - first.stress).abs();
        let peak = (0..points.len()).max_by(|a, b| rise(&points[*a]).total_cmp(&rise(&points[*b])))?;
        let signs = ((points[peak].stretch - first.stretch).signum(), (points[peak].stress - first.stress).signum());
        let mut loading: Vec<(f64, f64)> = Vec::new();
        for point in &points[..=peak] {
            let way = signs.0 * (point.stretch - first.stretch);
            // Ways back, of cycles or of noise, tell nothing new.
            if loading.last().is_none_or(|last| way > last.0) {
                loading.push((way, signs.1 * point.stress));
            }
        }
        let distance = |three: &[(f64, f64)]| (three[1].1 - 0.5 * (three[0].1 + three[2].1)).abs() / 1.5_f64.sqrt();
        let scatter = NORMAL * median(loading.windows(3).map(distance).collect());
        Some(Self { points: binned(loading), scatter, signs })
    }
}

/// The `points`, or their means in bins of the way if there are many.
fn binned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let Some(way) = points.last().map(|last| last.0).filter(|_| points.len() > BINS) else { return points };
    let bin = |point: &(f64, f64)| (BINS as f64 * point.0 / way).floor();
    let mean = |points: &[(f64, f64)]| {
        let sum = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0, sum.1 + point.1));
        (sum.0 / points.len() as f64, sum.1 / points.len() as f64)
    };
    points.chunk_by(|a, b| bin(a) == bin(b)).map(mean).collect()
}

/// Whether the `loading` up to the point `end` bears nothing beside what it bears over an equal way behind.
fn is_empty(loading: &[(f64, f64)], end: usize, scatter: f64) -> bool {
    let far = loading.partition_point(|point| point.0 <= 2.0 * loading[end].0);
    let (before, behind) = (&loading[..=end], &loading[end..far]);
    if behind.len() < FEWEST.1 {
        return false;
    }
    let (before, slope) = (line(before).1, line(behind).1);
    let rise = slope * (behind[behind.len() - 1].0 - behind[0].0);
    // The end may lie a little behind the touch.
    let quiet = loading.partition_point(|point| point.0 <= QUIET * loading[end].0);
    let level = (line(&loading[..quiet]).1 * QUIET * loading[end].0).abs();
    let largest = loading[loading.len() - 1].1;
    rise > RISE * scatter && before.abs() < EMPTY * slope && level <= f64::max(NONE * scatter, LEVEL * largest)
}

/// Where the loads behind the point `last`, the last that bears none, lead back to the load at `rest`.
fn onset(loading: &[(f64, f64)], last: usize, rest: f64) -> f64 {
    let here = loading[last].0;
    let next = loading.get(last + 1).map_or(here, |point| point.0);
    let end = here + f64::min(0.2 * here, 0.1 * (loading[loading.len() - 1].0 - here));
    let near = loading.partition_point(|point| point.0 <= end).max(last + 1 + FEWEST.1).min(loading.len());
    let (at, slope) = line(&loading[last + 1..near]);
    let back = at.0 - (at.1 - rest) / slope;
    // A load that bends at once, as a foam's, leads back too far.
    if back.is_finite() { back.clamp(0.95 * here, next) } else { here }
}

/// The straight line by least squares: a point of it, and its slope.
fn line(points: &[(f64, f64)]) -> ((f64, f64), f64) {
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / n, sum.1 + point.1 / n));
    let moment = |f: &dyn Fn(f64, f64) -> f64| points.iter().map(|(x, y)| f(x - mean.0, y - mean.1)).sum::<f64>();
    (mean, moment(&|x, y| x * y) / moment(&|x, _| x * x))
}

/// Makes strains and stresses of `points` count from `touch`; what lies before it is no state of a specimen.
pub fn take_off(points: &mut Vec<Point>, touch: &Touch) {
    let start = points.first().map_or(0.0, |point| point.stretch);
    let direction = (touch.strain - start).signum();
    points.retain(|point| direction * (point.stretch - touch.strain) >= 0.0);
    for point in points {
        point.stretch -= touch.strain;
        point.stress -= touch.stress;
    }
}

/// Part of the largest strain up to which a specimen is at rest.
const AT_REST: f64 = 2e-3;
/// Part of the largest stress that one at rest may have.
const OFFSET: f64 = 0.01;
/// Points at rest that tell it.
const MOST: usize = 1000;

/// Stress of `points` where the record begins at rest, Pa, if it is more than a hundredth of the largest and no scatter.
pub fn offset(points: &[Point]) -> Option<f64> {
    let strains = points.iter().map(|point| point.stretch.abs()).fold(0.0, f64::max);
    let largest = points.iter().map(|point| point.stress.abs()).fold(0.0, f64::max);
    let at_rest = points.iter().take_while(|point| point.stretch.abs() <= AT_REST * strains).take(MOST);
    let stresses: Vec<f64> = at_rest.map(|point| point.stress).collect();
    let scatter = Loading::of(points)?.scatter;
    let rest = median(stresses);
    (rest.abs() > OFFSET * largest + NONE * scatter).then_some(rest)
}

#[cfg(test)]
mod tests {
    use crate::data::curve::{Curve, Direction, Options, read};
    use crate::data::specimen::Specimen;

    /// Of a neo-Hookean cylinder, 10 mm high and 1 cm2, of G = 200 kPa, that is pressed by 5 mm in `n` steps by a machine that
    /// starts `gap` mm above it, with a load cell that shows `offset` N more and `noise` N of either sign.
    fn press(gap: f64, offset: f64, noise: f64, n: u32) -> Curve {
        let row = |k: u32| {
            let way = (gap + 5.0) * f64::from(k) / f64::from(n);
            let l = 1.0 - 0.1 * (way - gap).max(0.0);
            let load = 20.0 * (l.powi(-2) - l) + offset + noise * (f64::from(k) * 12.9898).sin();
            format!("{way},{load}\n")
        };
        let text: String = (0..=n).map(row).collect();
        let specimen = Specimen { height: Some(10e-3), area: Some(1e-4) };
        let options = Options { specimen, direction: Some(Direction::Compression), ..Options::default() };
        read("press.csv", format!("displacement [mm],force [N]\n{text}").as_bytes(), &options).unwrap()
    }

    /// The modulus by least squares of P = G (l - l^-2), Pa.
    fn modulus(curve: &Curve) -> f64 {
        let points = || curve.repeats.iter().flat_map(|repeat| &repeat.points);
        let shape = |l: f64| l - l.powi(-2);
        points().map(|p| p.stress * shape(p.stretch)).sum::<f64>()
            / points().map(|p| shape(p.stretch).powi(2)).sum::<f64>()
    }

    #[test]
    fn a_gap_before_the_touch_is_no_strain() {
        for (gap, offset, noise, n) in [
            (2.0, 0.0, 0.0, 70),
            (2.0, 0.0, 0.2, 700),
            (2.0, 3.0, 0.2, 20_000),
            (0.3, 0.0, 0.05, 5000),
            (8.0, 0.0, 0.1, 400),
        ] {
            let curve = press(gap, offset, noise, n);
            let found = modulus(&curve);
            assert!((found / 200e3 - 1.0).abs() < 0.02, "{gap} {offset} {noise}: {found} {:?}", curve.warnings);
            let said = &curve.warnings[0];
            assert!(said.contains("\"displacement [mm]\" moves by") && said.contains("before \"force [N]\""), "{said}");
            assert!(curve.repeats[0].points.iter().all(|point| point.stretch <= 1.0));
        }
    }

    #[test]
    fn a_test_that_begins_at_the_touch_is_left_as_it_is() {
        for (noise, n) in [(0.0, 10), (0.0, 70), (0.2, 700), (1.0, 20_000)] {
            let curve = press(0.0, 0.0, noise, n);
            assert!(curve.warnings.is_empty(), "{noise} {n}: {:?}", curve.warnings);
            assert_eq!(curve.repeats[0].points.len(), n as usize + 1);
        }
        // The air in a foam, which bottoms out (Gibson and Ashby, Cellular Solids, 1997).
        let row = |k: i32| (0.02 * f64::from(k), 101.325 * 0.02 * f64::from(k) / (0.967 - 0.02 * f64::from(k)));
        for (from, to) in [(0, 46), (1, 45), (0, 30)] {
            let text: String = (from..=to).map(row).map(|(e, p)| format!("{e},{p}\n")).collect();
            let curve = read("x", format!("strain,stress [kPa]\n{text}").as_bytes(), &Options::default()).unwrap();
            assert!(curve.warnings.is_empty(), "{from} {to}: {:?}", curve.warnings);
        }
        // Loads that begin with the square and the cube of the strain.
        for power in [2, 3] {
            let row = |k: i32| format!("{},{}\n", 0.01 * f64::from(k), f64::from(k).powi(power));
            let text: String = (0..=50).map(row).collect();
            let curve = read("x", format!("strain,stress [Pa]\n{text}").as_bytes(), &Options::default()).unwrap();
            assert!(curve.warnings.is_empty(), "{power}: {:?}", curve.warnings);
        }
    }

    #[test]
    fn a_load_at_rest_is_said_with_its_figure() {
        let warnings = press(0.0, 2.8, 0.1, 700).warnings;
        assert!(warnings[0].starts_with("\"force [N]\" is 2.8"), "{warnings:?}");
        assert!(warnings[0].contains("% of the largest) where the specimen is at rest"), "{warnings:?}");
        assert!(press(0.0, 0.5, 0.1, 700).warnings.is_empty());
    }

    /// Slack in tension; strains that an extensometer may have measured as true ones are left as they are.
    #[test]
    fn slack_is_taken_off_an_engineering_strain_and_said_of_others() {
        let row = |k: i32| format!("{},{}\n", 0.01 * f64::from(k), 10.0 * f64::from(k - 10).max(0.0));
        let text: String = (0..=50).map(row).collect();
        let curve =
            |title: &str| read("x", format!("{title},stress [kPa]\n{text}").as_bytes(), &Options::default()).unwrap();
        let slack = curve("strain");
        let first = slack.repeats[0].points[0];
        assert!((first.stretch - 1.0).abs() < 0.011 && slack.warnings.len() == 1, "{first:?} {:?}", slack.warnings);
        let left = curve("true strain");
        assert_eq!(left.repeats[0].points.len(), 51);
        assert!(left.warnings[0].contains("is not taken off a true strain"), "{:?}", left.warnings);
    }
}
