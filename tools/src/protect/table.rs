//! What came of pads, for people.

use std::fmt::Write;

use super::numbers::{LayerNumbers, Numbers};
use super::standard::{Limit, Standard};
use super::trial::{Outcome, Trial};
use super::verdict::{Verdict, of_limit};
use crate::output::subject::{warning_lines, warnings};
use crate::sweep::sheet::Sheet;
use crate::text::number::{four_digits, short};
use crate::text::wrap::filled;

/// Everything: the drop, a pad beside the bare anvil or several pads in a table, and the verdict.
pub fn of_trial(trial: &Trial) -> String {
    let mut text = trial.subject.text();
    if let Some((_, outcome)) = trial.done().next() {
        text += &warning_lines(&warnings(&outcome.run.constants, outcome.run.end()));
    }
    text += &trial.remarks();
    text += "\n";
    match (&trial.pads[..], trial.done().next()) {
        ([_], Some((_, pad))) => {
            text += &side_by_side(trial.bare.as_ref(), pad).text();
            text.push('\n');
            text += &layers(pad).text();
        }
        _ => text += &several(trial).text(),
    }
    text + "\n" + &notes(trial)
}

/// A quantity that is shown: its name and unit, and its text.
type Row = (&'static str, fn(&Numbers) -> String);

const ROWS: [Row; 9] = [
    ("peak transmitted force (N)", |n| format!("{:.0}", n.transmitted)),
    ("peak acceleration (g)", |n| four_digits(n.acceleration)),
    ("duration (ms)", |n| four_digits(1e3 * n.duration)),
    ("impulse (N s)", |n| four_digits(n.impulse)),
    ("energy at impact (J)", |n| four_digits(n.energy)),
    ("energy absorbed (J)", |n| four_digits(n.absorbed)),
    ("restitution", |n| four_digits(n.restitution)),
    ("largest deformation (mm)", |n| four_digits(1e3 * n.deformation)),
    ("pad thickness (mm)", |n| short(1e3 * n.pad_thickness)),
];
/// How many of them a bare anvil has.
const OF_BARE: usize = ROWS.len() - 1;

fn side_by_side(bare: Option<&Outcome>, pad: &Outcome) -> Sheet {
    let row = |(index, (name, text)): (usize, &Row)| {
        let bare = bare.filter(|_| index < OF_BARE).map_or("-".into(), |bare| text(&bare.numbers));
        vec![(*name).to_string(), bare, text(&pad.numbers)]
    };
    Sheet {
        title: String::new(),
        header: ["result", "bare", "padded"].map(String::from).to_vec(),
        rows: ROWS.iter().enumerate().map(row).collect(),
        n_text: 1,
    }
}

fn layers(pad: &Outcome) -> Sheet {
    let row = |layer: &LayerNumbers| {
        let tears = match (layer.has_torn(), layer.tear_stretch) {
            (Some(true), Some(stretch)) => format!("yes, from a stretch of {stretch}"),
            (Some(false), Some(stretch)) => format!("no, would from {stretch}"),
            _ => "not modelled".into(),
        };
        let extremes = layer.extremes;
        let numbers = [format!("{:.1}", 100.0 * extremes.compression), format!("{:.3}", extremes.stretch)];
        [vec![layer.name.clone(), tears], numbers.to_vec()].concat()
    };
    Sheet {
        title: String::new(),
        header: ["layer, padded", "tears", "compression (%)", "largest stretch"].map(String::from).to_vec(),
        rows: pad.numbers.layers.iter().rev().map(row).collect(),
        n_text: 2,
    }
}

/// The columns of the table of several pads.
const COLUMNS: [Row; 6] = [
    ("thickness (mm)", |n| short(1e3 * n.pad_thickness)),
    ("transmitted (N)", |n| format!("{:.0}", n.transmitted)),
    ("peak (g)", |n| format!("{:.1}", n.acceleration)),
    ("duration (ms)", |n| format!("{:.2}", 1e3 * n.duration)),
    // No minus before a zero.
    ("absorbed (%)", |n| format!("{:.0}", (100.0 * n.absorbed / n.energy).round() + 0.0)),
    ("pad compressed (%)", |n| format!("{:.0}", 100.0 * n.pad_compression())),
];

/// A line for the bare anvil and for each pad.
fn several(trial: &Trial) -> Sheet {
    let texts = |numbers: &Numbers| COLUMNS.map(|(_, text)| text(numbers)).to_vec();
    let bare = trial.bare.iter().map(|bare| {
        let mut texts = texts(&bare.numbers);
        texts[0] = "-".into();
        texts[COLUMNS.len() - 1] = "-".into();
        [vec!["bare".to_string(), bare.verdict.short()], texts].concat()
    });
    let pads = trial.pads.iter().map(|(case, outcome)| match outcome {
        Ok(outcome) => [vec![case.name.clone(), outcome.verdict.short()], texts(&outcome.numbers)].concat(),
        Err(_) => {
            let mut texts = vec!["-".to_string(); COLUMNS.len()];
            texts[0] = short(1e3 * super::padding::thickness(&case.scenario));
            [vec![case.name.clone(), "failed".into()], texts].concat()
        }
    });
    let header = ["pad", "verdict"].into_iter().chain(COLUMNS.iter().map(|(name, _)| *name));
    Sheet {
        title: String::new(),
        header: header.map(String::from).collect(),
        rows: bare.chain(pads).collect(),
        n_text: 2,
    }
}

/// What a standard asks for, in a sentence or two.
fn limits(standard: &Standard) -> String {
    let limit = |limit: &Limit| format!("{}: {}", limit.level, of_limit(limit, standard));
    let limits = standard.limits.iter().map(limit).collect::<Vec<_>>().join("; ");
    let known = if limits.is_empty() { "no limit is known".to_string() } else { limits };
    let label = standard.quantity.label();
    filled(&format!("Verdict by {}, {label}: {known}. {}.\n", standard.name, standard.source))
}

/// The verdict, and what a reader has to know.
fn notes(trial: &Trial) -> String {
    let mut text = String::new();
    match (&trial.pads[..], trial.standard) {
        ([_, _, ..], Some(standard)) => text += &limits(standard),
        _ => {
            let verdict = trial.done().next().map(|(_, pad)| pad.verdict.text(&pad.numbers, trial.standard));
            text += &filled(&format!("{}\n", verdict.unwrap_or_default()));
        }
    }
    let changed = trial.done().find_map(|(_, pad)| match &pad.verdict {
        Verdict::OtherTest(changed) if trial.pads.len() > 1 => Some(changed.join(", ")),
        _ => None,
    });
    text +=
        &changed.map_or(String::new(), |changed| filled(&format!("No verdict, as this is not its test: {changed}.\n")));
    for (case, error) in trial.pads.iter().filter_map(|(case, outcome)| Some((case, outcome.as_ref().err()?))) {
        text += &filled(&format!("! {} failed: {error}\n", trial.label(case)));
    }
    if trial.bare.is_none() {
        let why = "Bare: a rigid face on a rigid anvil has no peak that a model without their elasticity could tell.\n";
        text += &filled(why);
    }
    for assumed in trial.standard.iter().flat_map(|standard| standard.assumed) {
        text += &filled(&format!("* {assumed}\n"));
    }
    let _ = write!(
        text,
        "{}",
        filled(
            "Transmitted force: reaction of the core at 20 kHz, unfiltered; acceleration: contact force over the weight of the \
             impactor.\n"
        )
    );
    text
}
