//! The cases of a sweep with what came of them, and the tables of it.

use itertools::Itertools;
use softanvil_kernel::Scenario;

use super::case::{Case, Outcome};
use super::sheet::Sheet;
use super::{Contrast, Sweep, convergence};
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{COUNT, QUANTITIES, Quantity};
use crate::run::Ending;

/// The cases of a sweep with what came of them.
pub struct Results {
    /// The sweep.
    pub sweep: Sweep,
    /// The scenario that it starts from.
    pub scenario: Scenario,
    /// Its cases.
    pub cases: Vec<Case>,
    /// For each case what came of it, or why nothing did; none if it was not simulated.
    pub outcomes: Vec<Option<Result<Outcome, String>>>,
}

/// Stands for a number that there is not.
const NONE: &str = "-";

impl Results {
    /// The outcome of the case with this number.
    pub fn outcome(&self, number: usize) -> Option<&Outcome> {
        self.outcomes.get(number)?.as_ref()?.as_ref().ok()
    }

    /// The cases that were simulated.
    pub fn done(&self) -> impl Iterator<Item = (&Case, &Outcome)> {
        self.cases.iter().enumerate().filter_map(|(number, case)| Some((case, self.outcome(number)?)))
    }

    /// The cases that failed, and why.
    pub fn failures(&self) -> impl Iterator<Item = (&Case, &str)> {
        self.cases.iter().zip(&self.outcomes).filter_map(|(case, outcome)| match outcome {
            Some(Err(reason)) => Some((case, reason.as_str())),
            _ => None,
        })
    }

    /// How many cases were not simulated.
    pub fn missing(&self) -> usize {
        self.outcomes.iter().filter(|outcome| outcome.is_none()).count()
    }

    /// The cases whose numbers are not those of a whole impact, or a whole press, with their simulations.
    pub fn cut(&self) -> impl Iterator<Item = (&Case, &Outcome)> {
        self.done().filter(|(_, outcome)| matches!(outcome.ending(), Ending::InContact | Ending::NoContact))
    }

    /// The outcome of the case with these settings.
    pub fn find(&self, settings: &[String]) -> Option<&Outcome> {
        self.done().find(|(case, _)| case.settings == settings).map(|(_, outcome)| outcome)
    }

    /// The simulated cases in groups, which differ by the last axis or by the mesh alone; each with what they have in common.
    pub fn groups(&self) -> Vec<(String, Vec<(&Case, &Outcome)>)> {
        let common = &self.sweep.axes[..self.sweep.common()];
        let name = |settings: &[String]| match common {
            [axis] if axis.is_of_numbers() => format!("{} = {}", axis.name, settings[0]),
            _ => settings.join(", "),
        };
        let chunks = self.done().chunk_by(|(case, _)| &case.settings[..common.len()]);
        chunks.into_iter().map(|(settings, cases)| (name(settings), cases.collect())).collect()
    }

    /// Every table.
    pub fn sheets(&self) -> Vec<Sheet> {
        let mut sheets = vec![self.all()];
        if self.sweep.refines() {
            sheets.extend(self.groups().iter().filter_map(|(name, cases)| {
                let title = "Order of convergence and discretisation error";
                let title = if name.is_empty() { title.into() } else { format!("{title}: {name}") };
                convergence::orders(&title, &cases.iter().map(|case| case.1).collect::<Vec<_>>())
            }));
        } else if self.sweep.axes.len() > 1 {
            sheets.insert(0, self.forces());
        }
        sheets
    }

    /// The four numbers and the restitution of every case, with changes in brackets.
    fn all(&self) -> Sheet {
        let pressed = self.done().any(|(_, outcome)| outcome.held_force().is_some());
        // A parameter goes by its field: the page has its whole name.
        let short = |name: &str| name.split_once('.').map_or(name, |(_, field)| field).to_string();
        let texts = self.sweep.headings();
        let numbers = QUANTITIES.iter().map(|quantity| format!("{} ({})", quantity.label, quantity.display_unit));
        let header = texts.iter().map(|name| short(name)).chain(numbers).chain(["restitution".into()]);
        let rows = self.cases.iter().enumerate().map(|(number, case)| {
            let (outcome, reference) = (self.outcome(number), self.outcome(case.reference));
            let held = pressed.then(|| held_of(outcome, reference));
            case.settings.iter().cloned().chain(numbers_of(outcome, reference)).chain(held).collect()
        });
        Sheet {
            title: "Simulations".into(),
            header: header.chain(pressed.then(|| "held force (N)".into())).collect(),
            rows: rows.collect(),
            n_text: texts.len(),
        }
    }

    /// The forces alone, with a column for each level of the last axis.
    fn forces(&self) -> Sheet {
        let common = self.sweep.common();
        let (headings, last) = (self.sweep.headings(), &self.sweep.axes[common]);
        let groups = self.cases.iter().map(|case| &case.settings[..common]).dedup();
        let rows = groups.map(|group| {
            let forces = last.levels.iter().map(|level| {
                let outcome = self.find(&[group, std::slice::from_ref(&level.name)].concat());
                outcome.map_or(NONE.into(), |o| o.ending().marked("result.peak_force", format!("{:.0}", o.force())))
            });
            group.iter().cloned().chain(forces).collect()
        });
        let levels = last.levels.iter().map(|level| level.name.clone());
        Sheet {
            title: format!("Force (N) by {}: peak force of an impact, held force of a press", last.name),
            header: headings[..common].iter().map(ToString::to_string).chain(levels).collect(),
            rows: rows.collect(),
            n_text: common,
        }
    }

    /// Changes of the four numbers of a contrast, %: none where a case is missing, of a press that of the force alone.
    pub fn changes(&self, contrast: &Contrast) -> [Option<f64>; COUNT] {
        let (from, to) = (self.find(&contrast.from), self.find(&contrast.to));
        let Some((from, to)) = from.zip(to) else { return [None; COUNT] };
        if from.held_force().is_some() || to.held_force().is_some() {
            return std::array::from_fn(|i| (i == 0).then(|| error_percent(to.force(), from.force())));
        }
        std::array::from_fn(|i| Some(error_percent(to.values[i], from.values[i])))
    }
}

/// The four numbers and the restitution, as texts.
fn numbers_of(outcome: Option<&Outcome>, reference: Option<&Outcome>) -> Vec<String> {
    let Some(outcome) = outcome.filter(|outcome| outcome.held_force().is_none()) else {
        return vec![NONE.into(); COUNT + 1];
    };
    let number = |(i, quantity): (usize, &Quantity)| {
        let value = format!("{:.*}", quantity.decimals, outcome.values[i] * quantity.display_scale);
        let value = outcome.ending().marked(quantity.output, value);
        match reference {
            Some(reference) if !std::ptr::eq(reference, outcome) && outcome.ending() != Ending::NoContact => {
                format!("{value} ({})", percent(error_percent(outcome.values[i], reference.values[i])))
            }
            _ => value,
        }
    };
    let numbers = QUANTITIES.iter().enumerate().map(number);
    let restitution = outcome.ending().marked("result.restitution", format!("{:.2}", outcome.restitution()));
    numbers.chain([restitution]).collect()
}

/// The force that holds a press, as a text.
fn held_of(outcome: Option<&Outcome>, reference: Option<&Outcome>) -> String {
    let Some(force) = outcome.and_then(Outcome::held_force) else { return NONE.into() };
    match reference.and_then(Outcome::held_force) {
        Some(reference) if reference != force => format!("{force:.0} ({})", percent(error_percent(force, reference))),
        _ => format!("{force:.0}"),
    }
}

/// A change in %, to a tenth, or to two digits where it is small; a dash if there is none.
pub fn percent_or_none(change: Option<f64>) -> String {
    change.map_or(NONE.into(), percent)
}

fn percent(change: f64) -> String {
    let decimals = if change.abs() >= 0.95 || change == 0.0 { 1 } else { 2 };
    let text = format!("{change:+.decimals$} %");
    // No sign before a zero.
    if text.contains(['1', '2', '3', '4', '5', '6', '7', '8', '9']) { text } else { "0 %".into() }
}
