//! Whether a record may be of the drop that it should be of.

use super::record::{Clock, Record, Trace};
use crate::ReadError;
use crate::column::{Column, Kind};
use crate::robust::median;

impl Record<'_> {
    /// The trace with what is unlikely of it, an impact from the force `threshold` on; what can only be a wrong unit is refused.
    pub(super) fn judged(&self, mut trace: Trace, threshold: f64) -> Result<Trace, ReadError> {
        let warnings = &mut trace.understood.warnings;
        if let Some(count) = clipped(&trace.forces) {
            warnings
                .push(format!("{count} samples in a row show the largest force: it may be cut off by the amplifier"));
        }
        // From the sample before to the sample after, because there may be few of them.
        let first = trace.forces.iter().position(|force| *force >= threshold).unwrap_or_default().saturating_sub(1);
        let last = trace.forces.iter().rposition(|force| *force >= threshold).unwrap_or_default() + 1;
        let last = last.min(trace.forces.len() - 1);
        let duration = trace.times[last] - trace.times[first];
        let pairs =
            (first.max(1)..=last).map(|i| (trace.times[i] - trace.times[i - 1], trace.forces[i - 1] + trace.forces[i]));
        let impulse: f64 = pairs.map(|(step, sum)| 0.5 * step * sum).sum();
        let mut doubt = |far: bool, text: String| {
            if far && !self.channels.stated {
                return Err(ReadError::file(format!("{text}. {}", self.which_unit())));
            }
            warnings.push(text);
            Ok(())
        };
        if !LIKELY_DURATION.contains(&duration) {
            let far = duration > 20.0 * LIKELY_DURATION.end() || duration < 0.05 * LIKELY_DURATION.start();
            doubt(far, format!("an impact of {} is no drop on a soft anvil, which lasts some ms", seconds(duration)))?;
        }
        if let Some(expected) = self.expected {
            let momentum = expected.mass * expected.speed;
            let part = impulse / momentum;
            if !LIKELY_IMPULSE.contains(&part) {
                let far = part > 10.0 * LIKELY_IMPULSE.end() || part < 0.1 * LIKELY_IMPULSE.start();
                let text = format!(
                    "the impulse of {impulse:.4} N s is {part:.3} times the momentum of {momentum:.3} N s that {} kg have at {:.3} \
                     m/s; a rebound gives 1 to 2",
                    expected.mass, expected.speed
                );
                doubt(far, text)?;
            }
        }
        if let (Clock::Column(_), Some(fact)) = (&self.channels.time, &self.channels.table.sheet().facts.interval) {
            let part = step(&trace.times) / fact.value;
            if !(0.95..=1.05).contains(&part) {
                let text = format!(
                    "the times are {} apart, and line {} states {} ({})",
                    seconds(step(&trace.times)),
                    fact.line,
                    seconds(fact.value),
                    fact.text
                );
                doubt(!(0.02..=50.0).contains(&part), text)?;
            }
        }
        Ok(trace)
    }

    /// The options that settle units that cannot be right.
    fn which_unit(&self) -> String {
        let load = &self.channels.load;
        let title = |column: &Column| column.title.split(['[', '(']).next().unwrap_or_default().trim().to_string();
        let time = match &self.channels.time {
            Clock::Column(column) => format!("--time \"{} [ms]\"", title(column)),
            Clock::Rate(..) => "--rate \"20 kHz\"".into(),
        };
        let (option, unit) = if load.kind == Kind::Force { ("--force-column", "kN") } else { ("--acceleration", "g") };
        format!("State the units that are true, as in {time} or {option} \"{} [{unit}]\"", title(load))
    }
}

/// Durations of impacts on a soft layer, s.
const LIKELY_DURATION: std::ops::RangeInclusive<f64> = 0.5e-3..=0.2;
/// Impulses over the momentum at the touch: from no rebound to one without loss, with some error of both.
const LIKELY_IMPULSE: std::ops::RangeInclusive<f64> = 0.8..=2.2;

/// The number of samples in a row with the largest force, if they are more than a smooth peak has.
fn clipped(forces: &[f64]) -> Option<usize> {
    let peak = forces.iter().copied().fold(0.0, f64::max);
    let longest = forces.chunk_by(|a, b| a == b).filter(|run| run[0] == peak).map(<[f64]>::len).max()?;
    let above = forces.iter().filter(|force| **force > 0.5 * peak).count();
    (longest >= 5 && longest * 10 >= above).then_some(longest)
}

/// Part of the peak above which an offset that is left matters.
pub(super) const SMALL_OFFSET: f64 = 5e-3;

/// The median time between two samples.
pub(super) fn step(times: &[f64]) -> f64 {
    median(times.windows(2).map(|pair| pair[1] - pair[0]).collect())
}

pub(super) fn seconds(time: f64) -> String {
    match time {
        time if time >= 1.0 => format!("{time:.3} s"),
        time if time >= 1e-3 => format!("{:.3} ms", 1e3 * time),
        time => format!("{:.3} us", 1e6 * time),
    }
}
