//! The cases of a study with what came of them.

use softanvil_kernel::Scenario;
use softanvil_kernel::preset::Preset;

use super::case::{Case, Outcome};
use super::evaluation::{Evaluation, Sheet};
use crate::failure::Failure;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::run::Ending;

/// Makes the cases of a study for a scenario and some values.
pub type Plan = fn(&Study, &Scenario, &[String]) -> Result<Vec<Case>, Failure>;

/// One of the studies.
pub struct Study {
    /// Name on the command line and of its files.
    pub name: &'static str,
    /// Title of its page.
    pub title: &'static str,
    /// What is changed and why, for the reader of the page.
    pub about: &'static str,
    /// What its values are, with their unit.
    pub values: &'static str,
    /// The values unless told otherwise.
    pub default_values: &'static [&'static str],
    /// Names of what tells its cases apart, with units.
    pub settings: &'static [&'static str],
    /// Its cases for a scenario and some values.
    pub plan: Plan,
    /// What the results say.
    pub evaluate: fn(&Results) -> Evaluation,
}

impl std::fmt::Debug for Study {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// The cases of a study with what came of them.
pub struct Results {
    /// The study.
    pub study: &'static Study,
    /// The scenario that it starts from.
    pub scenario: Scenario,
    /// The preset that this one starts from.
    pub preset: &'static Preset,
    /// Its cases.
    pub cases: Vec<Case>,
    /// For each case what came of it, or why nothing did; none if it was not simulated.
    pub outcomes: Vec<Option<Result<Outcome, String>>>,
}

impl Results {
    /// The cases that were simulated.
    pub fn done(&self) -> impl Iterator<Item = (&Case, &Outcome)> {
        self.cases.iter().zip(&self.outcomes).filter_map(|(case, outcome)| match outcome {
            Some(Ok(outcome)) => Some((case, outcome)),
            _ => None,
        })
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

    /// What errors of the scenario's own silicone against the experiment are worth, in a sentence; none of a silicone that is
    /// not the preset's.
    pub fn fitted(&self) -> Option<String> {
        let own = (self.preset.scenario)().layers[0].material;
        let text = format!("Of the silicone as it is, {}.", self.preset.fitted);
        (self.scenario.layers[0].material == own).then_some(text)
    }

    /// The cases whose numbers are not those of a whole impact, or a whole press, with their simulations.
    pub fn cut(&self) -> impl Iterator<Item = (&Case, &Outcome)> {
        self.done().filter(|(_, outcome)| matches!(outcome.ending(), Ending::InContact | Ending::NoContact))
    }

    /// The outcome of the case with these settings.
    pub fn find(&self, settings: &[&str]) -> Option<&Outcome> {
        self.done().find(|(case, _)| case.settings == settings).map(|(_, outcome)| outcome)
    }

    /// A sheet of the four numbers and the restitution of the cases that `wanted` takes, told apart by `settings`
    /// (indices). Changes from `reference` stand in brackets.
    pub fn sheet(
        &self,
        title: &str,
        settings: &[usize],
        wanted: impl Fn(&Case) -> bool,
        reference: Option<&Outcome>,
    ) -> Sheet {
        // A parameter goes by its field: the page has its whole name.
        let short = |name: &&str| name.split_once('.').map_or(*name, |(_, field)| field).to_string();
        let names = settings.iter().filter_map(|index| self.study.settings.get(*index)).map(short);
        let numbers = QUANTITIES.iter().map(|quantity| format!("{} ({})", quantity.label, quantity.display_unit));
        let header = names.chain(numbers).chain(["restitution".into()]).collect();
        let rows = self.cases.iter().zip(&self.outcomes).filter(|(case, _)| wanted(case)).map(|(case, outcome)| {
            let texts = settings.iter().map(|index| case.settings.get(*index).cloned().unwrap_or_default());
            let outcome = outcome.as_ref().and_then(|outcome| outcome.as_ref().ok());
            texts.chain(numbers_of(outcome, reference)).collect()
        });
        Sheet { title: title.into(), header, rows: rows.collect(), n_text: settings.len() }
    }
}

/// The four numbers and the restitution, as texts.
fn numbers_of(outcome: Option<&Outcome>, reference: Option<&Outcome>) -> Vec<String> {
    let Some(outcome) = outcome else { return vec!["-".into(); QUANTITIES.len() + 1] };
    let number = |(i, quantity): (usize, &crate::measurement::quantity::Quantity)| {
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

/// A change in %, to a tenth, or to two digits where it is small.
pub fn percent(change: f64) -> String {
    let decimals = if change.abs() >= 0.95 || change == 0.0 { 1 } else { 2 };
    let text = format!("{change:+.decimals$} %");
    // No sign before a zero.
    if text.contains(['1', '2', '3', '4', '5', '6', '7', '8', '9']) { text } else { "0 %".into() }
}
