//! Impacts in a record: the reading before contact, the sign of a push, and where contact begins and ends.

use std::ops::Range;

use super::ReadError;
use super::robust::{median, median_and_deviation};

/// One impact: the samples from the first to the last that are clearly in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// First sample.
    pub first: usize,
    /// Last sample.
    pub last: usize,
    /// Largest value without the offset, positive.
    pub peak: f64,
}

/// What a record holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// 1 if a push is positive in the file, -1 if negative.
    pub sign: f64,
    /// Reading without contact, in the unit of the record.
    pub offset: f64,
    /// Samples before contact that show what it does without, those next to it.
    pub before: usize,
    /// Median of those samples.
    pub reading: f64,
    /// Standard deviation of those samples, from their median deviation.
    pub noise: f64,
    /// Largest value against the push, over the peak.
    pub opposite: f64,
    /// The impacts, in their order.
    pub impacts: Vec<Impact>,
}

/// What a user states of a record.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Given {
    /// 1 if a push is positive in the file, -1 if negative.
    pub sign: Option<f64>,
    /// Reading without contact, in the unit of the record.
    pub offset: Option<f64>,
}

/// Samples before contact that tell the offset, at least.
pub const MIN_BEFORE: usize = 10;
/// Samples at the beginning from which values are counted until the offset is known.
const FIRST: usize = 5;
/// Time before contact, s, whose samples show what the force is without; those before count if they show the same.
const NEXT: f64 = 5e-3;
/// Part of the peak by which two readings may differ that show the same, and standard deviations of the noise.
const STEADY: f64 = 1e-3;
const STEADY_NOISE: f64 = 3.0;
/// Part of the peak above which a sample is in contact.
const IN_CONTACT: f64 = 0.05;
/// Standard deviations of the noise above which a sample is in contact.
const ABOVE_NOISE: f64 = 6.0;
/// Part of the largest peak and of the largest impulse that an impact has, at least.
const MIN_IMPACT: f64 = 0.1;
/// Time between two impacts, s, at least; less is an oscillation of one. It is also at least half of the longer one.
const MIN_FLIGHT: f64 = 2e-3;
/// Part of the peak above which a force is not none, if noise does not hide it.
const CLEAR: f64 = 2.5e-3;
/// A value of the other sign that is as large, over the peak, leaves the sign open.
const AS_LARGE: f64 = 0.8;

impl Contact {
    /// Finds the impacts in `values` over `times`, s, which rise.
    ///
    /// # Errors
    /// Values that are all the same, or of both signs alike.
    pub fn find(times: &[f64], values: &[f64], given: Given) -> Result<Self, ReadError> {
        let start = given.offset.unwrap_or_else(|| median(values[..values.len().min(FIRST)].to_vec()));
        let (low, high) = values.iter().fold((0.0_f64, 0.0_f64), |(l, h), v| (l.min(v - start), h.max(v - start)));
        let sign = given.sign.unwrap_or(if high >= -low { 1.0 } else { -1.0 });
        let (peak, opposite) = if sign > 0.0 { (high, -low) } else { (-low, high) };
        if peak <= 0.0 {
            return Err(ReadError::file(format!("nothing hits: no value is on the pushing side of {start}")));
        }
        if given.sign.is_none() && opposite > AS_LARGE * peak {
            let reason = format!(
                "the values go as far to one side ({:.4}) as to the other ({:.4}): --sign \"+\" or --sign \"-\" says which \
                 of them is a push",
                start + high,
                start + low
            );
            return Err(ReadError::file(reason));
        }
        let touch = quiet(values, |value| sign * (value - start) / peak);
        let quiet = settled(&times[..touch], &values[..touch], STEADY * peak);
        let before = quiet.len();
        let ((reading, scatter), enough) = (median_and_deviation(quiet), before >= MIN_BEFORE);
        let offset = given.offset.unwrap_or(if enough { reading } else { 0.0 });
        let noise = if enough { scatter } else { 0.0 };
        let push = |index: usize| sign * (values[index] - offset);
        let peak = (0..values.len()).map(push).fold(0.0, f64::max);
        let impacts = impacts(times, push, in_contact(peak, noise));
        Ok(Self { sign, offset, before, reading, noise, opposite: opposite / peak, impacts })
    }

    /// The push from which a sample of impact `index` is in contact.
    pub fn threshold(&self, index: usize) -> f64 {
        in_contact(self.impacts[index].peak, self.noise)
    }

    /// The samples of impact `index` in a record of `values` over `times`, with the flight before and after it, up to the
    /// middle between two impacts: what pushes farther away, as a mass at rest, a small bounce or a release does, is none of it.
    pub fn range(&self, index: usize, times: &[f64], values: &[f64]) -> Range<usize> {
        let middle = |a: &Impact, b: &Impact| a.last + (b.first - a.last) / 2;
        let start = index.checked_sub(1).map_or(0, |before| middle(&self.impacts[before], &self.impacts[index]));
        let after = self.impacts.get(index + 1);
        let end = after.map_or(times.len(), |after| middle(&self.impacts[index], after) + 1);
        let Impact { first, last, peak } = self.impacts[index];
        let push = |index: usize| self.sign * (values[index] - self.offset);
        let noise = if self.before >= MIN_BEFORE { self.noise } else { roughness(&values[last..end]) };
        let clear = (CLEAR * peak).max(ABOVE_NOISE * noise);
        let is_quiet = |index: &usize| push(*index).abs() <= clear;
        let flight = |stretch: &Stretch| (times[stretch.0] - times[stretch.1]).abs() > MIN_FLIGHT;
        let start = stretch(start..first, is_quiet, flight, true).map_or(start, |(_, far)| far);
        let quiet = stretch(last + 1..end, is_quiet, flight, false);
        let tail = last + 1..quiet.map_or(end, |(near, _)| near);
        let lasting = tail.end.checked_sub(1).map_or(0.0, |end| times[end] - times[last]);
        let end = quiet.map_or(end, |(_, far)| far + 1);
        // What goes on for longer than the impact is a zero that has shifted, or the weight of a mass at rest.
        if lasting > MIN_FLIGHT.max(times[last] - times[first]) {
            let level = median(tail.clone().map(push).collect());
            let settled = tail.clone().find(|index| push(*index) <= level + clear).filter(|_| level > clear);
            return start..settled.unwrap_or(end);
        }
        start..end
    }
}

/// The ends of a stretch of samples, the one next to the impact first.
type Stretch = (usize, usize);

/// The stretch in `part` that is nearest to its impact, of samples that are quiet, as long as a flight; `before` tells whether
/// the impact is behind it.
fn stretch(
    part: Range<usize>,
    is_quiet: impl Fn(&usize) -> bool,
    is_flight: impl Fn(&Stretch) -> bool,
    before: bool,
) -> Option<Stretch> {
    let count = part.len();
    let at = |distance: usize| if before { part.end - 1 - distance } else { part.start + distance };
    let mut distance = 0;
    while distance < count {
        let near = distance;
        while distance < count && is_quiet(&at(distance)) {
            distance += 1;
        }
        if let Some(found) = (distance > near).then(|| (at(near), at(distance - 1))).filter(&is_flight) {
            return Some(found);
        }
        distance += 1;
    }
    None
}

/// The standard deviation of the noise of `values`, by the median difference of neighbours, which a slow force does not change.
fn roughness(values: &[f64]) -> f64 {
    /// Median of the size of a difference of two normal errors, over the standard deviation of one.
    const MEDIAN: f64 = 0.953_872_552_417_3;
    let differences: Vec<f64> = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    if differences.is_empty() { 0.0 } else { median(differences) / MEDIAN }
}

/// The push from which a sample is in contact, where the largest is `peak`.
fn in_contact(peak: f64, noise: f64) -> f64 {
    (IN_CONTACT * peak).max(ABOVE_NOISE * noise)
}

/// Number of samples before the first rise above half of the peak begins; `part` is a value over the peak.
fn quiet(values: &[f64], part: impl Fn(f64) -> f64) -> usize {
    let half = values.iter().position(|value| part(*value) >= 0.5).unwrap_or_default();
    let low = values[..half].iter().rposition(|value| part(*value) < 0.01).map_or(0, |index| index + 1);
    // What rises to there without a break is contact already; noise breaks it.
    let breaks = |index: &usize| part(values[index - 1]) >= part(values[*index]);
    (1..low).rev().find(breaks).unwrap_or_default()
}

/// The last of `values` over `times` that all show the same, by `steady` or the noise: an accelerometer shows less as it falls
/// than as it was held.
fn settled<'a>(times: &[f64], values: &'a [f64], steady: f64) -> &'a [f64] {
    let count = values.len();
    let next = times.last().map_or(0, |last| times.iter().rev().take_while(|time| last - **time <= NEXT).count());
    let mut length = next.max(MIN_BEFORE).min(count);
    while length < count {
        let longer = (2 * length).min(count);
        let (level, noise) = median_and_deviation(&values[count - length..]);
        let (before, scatter) = median_and_deviation(&values[count - longer..count - length]);
        if (level - before).abs() > steady.max(STEADY_NOISE * noise.max(scatter)) {
            break;
        }
        length = longer;
    }
    &values[count - length..]
}

fn impacts(times: &[f64], push: impl Fn(usize) -> f64, threshold: f64) -> Vec<Impact> {
    let mut runs: Vec<Impact> = Vec::new();
    for index in 0..times.len() {
        let value = push(index);
        if value < threshold || value <= 0.0 {
            continue;
        }
        match runs.last_mut() {
            Some(run) if run.last + 1 == index => {
                run.last = index;
                run.peak = run.peak.max(value);
            }
            _ => runs.push(Impact { first: index, last: index, peak: value }),
        }
    }
    let duration = |run: &Impact| times[run.last] - times[run.first];
    let mut joined: Vec<Impact> = Vec::new();
    for run in runs {
        let flight = joined.last().map(|last| times[run.first] - times[last.last]);
        match joined.last_mut() {
            Some(last) if flight.is_some_and(|f| f < MIN_FLIGHT.max(0.5 * duration(last).max(duration(&run)))) => {
                (last.last, last.peak) = (run.last, last.peak.max(run.peak));
            }
            _ => joined.push(run),
        }
    }
    let largest = joined.iter().map(|run| run.peak).fold(0.0, f64::max);
    let area = |run: &Impact| run.peak * (run.last - run.first + 1) as f64;
    let largest_area = joined.iter().map(area).fold(0.0, f64::max);
    joined.retain(|run| run.peak >= MIN_IMPACT * largest && area(run) >= MIN_IMPACT * largest_area);
    joined
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half sines of 8 ms that begin at `starts`, s, sampled at 20 kHz over half a second.
    fn record(starts: &[(f64, f64)], offset: f64) -> (Vec<f64>, Vec<f64>) {
        let times: Vec<f64> = (0..10_000).map(|i| 5e-5 * f64::from(i)).collect();
        let value = |time: &f64| {
            let pulse = |(start, peak): &(f64, f64)| match time - start {
                t if (0.0..8e-3).contains(&t) => peak * (std::f64::consts::PI * t / 8e-3).sin(),
                _ => 0.0,
            };
            offset + starts.iter().map(pulse).sum::<f64>()
        };
        let values = times.iter().map(value).collect();
        (times, values)
    }

    #[test]
    fn offset_and_sign_are_those_before_contact() {
        for (peak, offset, sign) in [(1e3, 0.0, 1.0), (-1e3, 0.0, -1.0), (1e3, -60.0, 1.0), (-1e3, -250.0, -1.0)] {
            let (times, values) = record(&[(3e-3, peak)], offset);
            let contact = Contact::find(&times, &values, Given::default()).unwrap();
            assert_eq!((contact.sign, contact.offset), (sign, offset));
            assert!((contact.impacts[0].peak - 1e3).abs() < 1.0);
        }
    }

    #[test]
    fn impacts_are_told_apart_and_oscillations_are_not() {
        let (times, values) = record(&[(3e-3, 1e3), (0.2, 450.0), (0.4, 50.0)], 0.0);
        let contact = Contact::find(&times, &values, Given::default()).unwrap();
        assert_eq!(contact.impacts.len(), 2, "{contact:?}");
        let range = contact.range(0, &times, &values);
        assert!(range.start == 0 && (0.1..0.11).contains(&times[range.end]));
        // The small one is none of the second.
        let range = contact.range(1, &times, &values);
        assert!((0.1..0.11).contains(&times[range.start]) && (0.399..=0.401).contains(&times[range.end]), "{range:?}");
        let (times, values) = record(&[(3e-3, 1e3), (0.012, 900.0)], 0.0);
        assert_eq!(Contact::find(&times, &values, Given::default()).unwrap().impacts.len(), 1);
    }

    /// A release of 300 N at 10 ms, an impact from 50 to 58 ms, and what stays behind it.
    #[test]
    fn an_impact_ends_where_the_force_has_gone() {
        let noise = |state: &mut u64| {
            *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (*state >> 33) as f64 / 2_f64.powi(31) - 0.5
        };
        for scatter in [0.0, 4.0] {
            // The weight of the mass from 0.3 s on, a zero that has shifted, one that comes back, nothing.
            let rest = |time: f64| if time > 0.3 { 49.0 } else { 0.0 };
            let shifted = |time: f64| if time > 0.058 { 60.0 } else { 0.0 };
            let drifting = |time: f64| if time > 0.058 { 60.0 * (-(time - 0.058) / 0.05).exp() } else { 0.0 };
            for (what, stays, end) in [
                ("rest", &rest as &dyn Fn(f64) -> f64, 0.3),
                ("shift", &shifted, 0.058),
                ("drift", &drifting, 0.058),
                ("nothing", &|_| 0.0, 0.5),
            ] {
                let mut state = 1_u64;
                let (times, mut values) = record(&[(0.05, 4e3)], 0.0);
                for (time, value) in times.iter().zip(&mut values) {
                    let release = if (time - 0.01).abs() < 2e-5 { 300.0 } else { 0.0 };
                    *value += release + stays(*time) + scatter * noise(&mut state);
                }
                let contact = Contact::find(&times, &values, Given::default()).unwrap();
                let range = contact.range(0, &times, &values);
                let found = (times[range.start], times[range.end - 1]);
                assert!(contact.impacts.len() == 1 && (found.0 - 0.01005).abs() < 1e-9, "{what} {scatter}: {found:?}");
                let tolerance = if what == "drift" { 4e-2 } else { 2e-4 };
                assert!((found.1 - end).abs() < tolerance, "{what} {scatter}: {found:?}");
            }
        }
    }

    /// Held for 0.2 s at 1 g, which falls for 0.1 s.
    #[test]
    fn the_offset_is_that_next_to_the_contact() {
        for (held, falling) in [(1.0, 0.0), (0.0, -1.0), (0.3, 0.3)] {
            let (times, mut values) = record(&[(0.3, 81.0)], 0.0);
            for (time, value) in times.iter().zip(&mut values) {
                *value += if *time < 0.2 { held } else { falling };
            }
            let contact = Contact::find(&times, &values, Given::default()).unwrap();
            assert!((contact.offset - falling).abs() < 1e-12, "{contact:?}");
            assert!(contact.before > if held == falling { 5990 } else { 1000 }, "{contact:?}");
        }
    }

    #[test]
    fn a_record_that_begins_in_contact_has_no_offset() {
        let (times, values) = record(&[(0.0, 1e3)], 0.0);
        let contact = Contact::find(&times[1..], &values[1..], Given::default()).unwrap();
        assert_eq!((contact.before, contact.offset, contact.impacts.len()), (0, 0.0, 1), "{contact:?}");
    }

    #[test]
    fn noise_makes_no_impacts() {
        let (times, mut values) = record(&[(0.1, 1e3)], 20.0);
        let mut state = 1_u64;
        for value in &mut values {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            *value += 100.0 * ((state >> 33) as f64 / 2_f64.powi(31) - 0.5);
        }
        let contact = Contact::find(&times, &values, Given::default()).unwrap();
        assert_eq!(contact.impacts.len(), 1, "{contact:?}");
        assert!((contact.offset - 20.0).abs() < 5.0);
    }

    #[test]
    fn both_signs_alike_are_refused_and_an_option_decides() {
        let (times, values) = record(&[(3e-3, 1e3), (0.2, -950.0)], 0.0);
        let error = Contact::find(&times, &values, Given::default()).unwrap_err().to_string();
        assert!(error.contains("--sign \"+\""), "{error}");
        let given = Given { sign: Some(-1.0), offset: None };
        assert!((Contact::find(&times, &values, given).unwrap().impacts[0].peak - 950.0).abs() < 1.0);
    }
}
