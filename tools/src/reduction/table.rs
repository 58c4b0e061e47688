//! The comparison for people.

use super::effective_length::Found;
use super::{Comparison, Reduction};
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::sweep::case::Outcome;
use crate::text::number::four_digits;
use crate::text::table::{FIXED_BLANK, align_right, new_table, text};
use crate::text::wrap::filled;

/// A table with a row for each scenario, and what follows from it.
pub fn of_reduction(reduction: &Reduction) -> String {
    let of_cases: Vec<&str> = reduction.headings.iter().map(String::as_str).collect();
    let common = reduction.common.as_ref();
    let shared = common.map(|common| format!("geometry.length {} m", four_digits(common.length)));
    // A dome has no length.
    let has_length = reduction.comparisons.iter().any(|comparison| comparison.length.is_some());
    let mut header = [&of_cases[..], &["quantity", "solid", "section"]].concat();
    header.extend(has_length.then_some("of its length"));
    header.extend(shared.as_deref());
    let mut table = new_table(&header);
    for (number, comparison) in reduction.comparisons.iter().enumerate() {
        let mut row = comparison.settings.clone();
        row.extend(cells(comparison).into_iter().take(3 + usize::from(has_length)));
        row.extend(common.map(|common| lines(comparison, &common.sections[number])));
        table.add_row(row);
    }
    align_right(&mut table, of_cases.len() + 1..header.len());
    format!("{}\n{}", text(&mut table), filled(&notes(reduction)))
}

/// Quantities; of the solid, of the section, and of the section that bears as much.
fn cells(comparison: &Comparison) -> [String; 4] {
    let names = QUANTITIES.iter().map(|quantity| format!("{} ({})", quantity.label, quantity.display_unit));
    let names = names.chain(comparison.length.is_some().then(|| "geometry.length (m)".into()));
    let solid = (0..COUNT).map(|i| value(&comparison.solid, i));
    let found = match &comparison.length {
        Some(Found::Length(length, section)) => format!("{}\n{}", lines(comparison, section), four_digits(*length)),
        Some(Found::SolidBearsMore(_)) => "none:\nthe solid\nbears more".into(),
        Some(Found::SolidBearsLess) => "none:\nthe solid\nbears less".into(),
        None => String::new(),
    };
    let own = comparison.length.as_ref().map(|_| {
        let length = comparison.section.run.constants.scenario.geometry.length;
        format!("\n{}", four_digits(length))
    });
    let section = lines(comparison, &comparison.section) + &own.unwrap_or_default();
    [joined(names), joined(solid), section, found].map(|cell| cell.replace(' ', &FIXED_BLANK.to_string()))
}

/// The four numbers of a section, and their differences from those of the solid.
fn lines(comparison: &Comparison, section: &Outcome) -> String {
    let line = |i: usize| {
        format!("{} ({:+.1} %)", value(section, i), error_percent(section.values[i], comparison.solid.values[i]))
    };
    joined((0..COUNT).map(line)).replace(' ', &FIXED_BLANK.to_string())
}

fn joined(lines: impl Iterator<Item = String>) -> String {
    lines.collect::<Vec<_>>().join("\n")
}

fn value(outcome: &Outcome, number: usize) -> String {
    let quantity = &QUANTITIES[number];
    let text = format!("{:.*}", quantity.decimals, outcome.values[number] * quantity.display_scale);
    outcome.ending().marked(quantity.output, text)
}

/// What the table rests on, and what to do with it.
fn notes(reduction: &Reduction) -> String {
    let mut notes = String::from(
        "Differences are from the solid, of the same element size. A section has no ends: what escapes or helps there the solid alone has.\n",
    );
    let first = reduction.comparisons.iter().find_map(|comparison| comparison.length.as_ref()?.length());
    match (&reduction.common, first) {
        (Some(common), _) => {
            notes += &format!(
                "geometry.length = {} m, the mean, brings the forces of all sections within {:.1} % of the solids'.\n",
                four_digits(common.length),
                common.worst
            );
        }
        (None, Some(length)) if reduction.comparisons.len() == 1 => {
            notes += &format!("geometry.length = {} m gives the section the solid's force.\n", four_digits(length));
        }
        _ => {}
    }
    notes
}
