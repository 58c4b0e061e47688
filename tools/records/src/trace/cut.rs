//! One impact of a record as a trace.

use super::plausible::{seconds, step};
use super::record::{Channels, Samples, Trace};
use crate::ReadError;
use crate::impact::Contact;
use crate::understood::Understood;

/// The part of a record with one impact.
pub(super) struct Cut<'a> {
    pub samples: &'a Samples,
    pub contact: &'a Contact,
    pub index: usize,
    pub factor: f64,
}

/// A step between two samples that is longer than so many usual ones is a gap.
const GAP: f64 = 5.0;
/// Part of the duration below which a gap does not matter.
const SMALL_GAP: f64 = 0.02;

impl Cut<'_> {
    pub fn trace(&self, channels: &Channels) -> Result<Trace, ReadError> {
        self.check_gaps()?;
        let Self { samples, contact, index, factor } = self;
        let range = contact.range(*index, &samples.times, &samples.loads);
        let impact = contact.impacts[*index];
        let push = |load: &f64| contact.sign * (load - contact.offset) * factor;
        let forces: Vec<f64> = samples.loads[range.clone()].iter().map(push).collect();
        Ok(Trace {
            times: samples.times[range.clone()].to_vec(),
            forces,
            deformation: self.deformation(range.start, impact.first, impact.last),
            filter: channels.load.filter,
            understood: Understood::default(),
        })
    }

    /// Refuses an impact with samples missing in it.
    fn check_gaps(&self) -> Result<(), ReadError> {
        let impact = self.contact.impacts[self.index];
        let times = &self.samples.times;
        let (before, after) = (impact.first.saturating_sub(1), (impact.last + 1).min(times.len() - 1));
        let (usual, duration) = (step(times), times[after] - times[before]);
        let around = before + 1..=after;
        let is_gap = |index: &usize| {
            let step = times[*index] - times[index - 1];
            step > GAP * usual && step > SMALL_GAP * duration
        };
        match around.into_iter().find(is_gap) {
            Some(index) => {
                let reason = format!(
                    "{} without a sample before this one, within the impact, where samples are {} apart: expected an impact \
                     without gaps",
                    seconds(times[index] - times[index - 1]),
                    seconds(usual)
                );
                Err(ReadError::line(self.samples.lines[index] as usize, reason))
            }
            None => Ok(()),
        }
    }

    /// Largest displacement since the force began to rise.
    fn deformation(&self, start: usize, first: usize, last: usize) -> Option<f64> {
        let displacements = self.samples.displacements.get(start..)?;
        if displacements.is_empty() {
            return None;
        }
        let contact = self.contact;
        let quiet = (0.01 * contact.impacts[self.index].peak).max(3.0 * contact.noise);
        let pushes = |index: &usize| contact.sign * (self.samples.loads[*index] - contact.offset) > quiet;
        let touch = (start..=first).rev().take_while(pushes).last().unwrap_or(first);
        let zero = self.samples.displacements[touch.saturating_sub(1).max(start)];
        let largest =
            self.samples.displacements[touch..=last].iter().map(|value| (value - zero).abs()).fold(0.0, f64::max);
        largest.is_finite().then_some(largest).filter(|largest| *largest > 0.0)
    }
}
