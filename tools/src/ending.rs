//! How a run ended, and which of its numbers are those of the whole impact.

use crate::run::{LONGEST_EXTENSION, Run, Until};
use crate::studies::values::short;
use crate::table::filled;
use softanvil_kernel::scenario::Motion;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The impactor has touched the layer and left it.
    Complete,
    /// A press is at its depth.
    Held,
    /// The impactor still touches the layer, or presses it further.
    InContact,
    /// The impactor has not touched the layer.
    NoContact,
}

/// Stands behind a number that is the one so far.
pub const MARK: &str = "*";

impl Ending {
    /// Name for programs.
    pub fn key(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::Held => "held",
            Self::InContact => "in_contact",
            Self::NoContact => "no_contact",
        }
    }

    /// Whether the output called `name` has no final value by then.
    pub fn cuts(self, name: &str) -> bool {
        let lasting = ["impact_duration", "impulse", "rebound_speed", "restitution", "contact_time"];
        let largest = ["peak_force", "max_deformation"];
        let Some(field) = name.strip_prefix("result.") else { return false };
        match self {
            Self::Complete | Self::NoContact => false,
            Self::Held => lasting.contains(&field),
            Self::InContact => lasting.contains(&field) || largest.contains(&field),
        }
    }

    /// `text`, the value of the output called `name`, marked if it is not final; a dash if there was no impact.
    pub fn marked(self, name: &str, text: String) -> String {
        match self {
            Self::NoContact if name.starts_with("result.") => "-".into(),
            _ if self.cuts(name) => text + MARK,
            _ => text,
        }
    }
}

/// What the name of a run that was cut off ends with in a picture; nothing of others.
pub fn suffix(run: &Run) -> &'static str {
    if run.ending() == Ending::InContact { ", cut off in contact" } else { "" }
}

/// What a reader has to know of the end of `run` before its numbers, in lines; empty if nothing.
pub fn remark(run: &Run) -> String {
    let in_ms = |time: f64| short(1e3 * time);
    let (end, planned) = (in_ms(run.time(run.end())), in_ms(run.constants.scenario.time.duration));
    let pressed = run.constants.scenario.impactor.motion == Motion::Prescribed;
    let bound = format!("{LONGEST_EXTENSION} times time.duration, where the wait for its end stops");
    let text = match run.ending() {
        Ending::Complete if run.was_extended() => {
            format!("Simulated until the contact had ended, {end} ms, instead of the {planned} ms of time.duration.\n")
        }
        Ending::Complete => String::new(),
        Ending::Held => {
            let longer = if run.was_extended() { format!(", {end} ms instead of {planned} ms") } else { String::new() };
            format!("The press has come to its depth and holds{longer}: numbers marked {MARK} are those so far.\n")
        }
        Ending::InContact => {
            let why = match run.until {
                Until::Over => format!(", {bound}"),
                Until::Duration => ", the duration asked for".into(),
            };
            let what = if pressed { "press" } else { "impact" };
            format!(
                "! Cut off in contact after {end} ms{why}: numbers marked {MARK} are those so far, not of the whole {what}.\n"
            )
        }
        Ending::NoContact => {
            let what = if pressed { "press" } else { "impactor" };
            format!("! The {what} did not touch the layer in {end} ms: there are no results of an impact.\n")
        }
    };
    filled(&text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::Drop;
    use softanvil_kernel::{Output, preset};

    /// Source: the trace. The results are final once a sample after the first contact is without force.
    #[test]
    fn the_kernel_tells_when_its_results_are_final() {
        let run = Drop::new(&preset::study()).unwrap().run(|_| {}).unwrap();
        let complete = Output::find("result.complete").unwrap();
        let force: Vec<f64> = run.samples().iter().map(|sample| sample.sampler.last.contact_force).collect();
        let first = force.iter().position(|force| *force > 0.0).unwrap();
        let last = force.iter().rposition(|force| *force > 0.0).unwrap();
        for (i, sample) in run.samples().iter().enumerate() {
            let value = (complete.read)(&run.constants, sample);
            // Within the contact a node may let go for a sample.
            if i < first || force[i] > 0.0 || i > last {
                assert_eq!(value, if i > last { 1.0 } else { 0.0 }, "sample {i}");
            }
        }
        assert!(first > 10 && last + 10 < force.len());
        assert_eq!(run.ending(), Ending::Complete);
    }

    #[test]
    fn a_press_at_its_depth_has_a_final_force_and_no_final_impulse() {
        assert!(!Ending::Held.cuts("result.peak_force") && Ending::Held.cuts("result.impulse"));
        assert!(Ending::InContact.cuts("result.peak_force") && !Ending::InContact.cuts("result.impact_speed"));
        assert!(!Ending::InContact.cuts("energy.elastic") && !Ending::Complete.cuts("result.impulse"));
        assert_eq!(Ending::InContact.marked("result.impulse", "1.45".into()), "1.45*");
        assert_eq!(Ending::NoContact.marked("result.impulse", "0.00".into()), "-");
    }
}
