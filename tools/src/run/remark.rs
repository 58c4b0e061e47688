//! What a reader has to know of the end of a run before its numbers.

use softanvil_kernel::scenario::Motion;

use super::drop::{LONGEST_EXTENSION, Run, Until};
use super::ending::{Ending, MARK};
use crate::text::number::short;
use crate::text::wrap::filled;

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
