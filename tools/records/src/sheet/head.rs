//! The titles of a table, with the units of a row of units.

use crate::cells::{SEPARATORS, Separator};
use crate::facts;
use crate::number::{self, Cell, Decimal};
use crate::text::Lines;
use crate::unit::{self, Unit};

/// How many cells a row has.
#[derive(Clone, Copy)]
pub(super) struct Width {
    pub columns: usize,
    /// Without empty ones at the end.
    pub filled: usize,
}

/// The number of cells up to the last that is not empty.
pub(super) fn filled<'a>(cells: impl Iterator<Item = &'a str>) -> usize {
    cells.enumerate().filter(|(_, cell)| !cell.is_empty()).last().map_or(0, |(index, _)| index + 1)
}

/// The titles and where they stand.
pub(super) struct Head {
    pub titles: Vec<String>,
    /// Their lines, from 1.
    pub lines: Vec<usize>,
}

impl Head {
    /// The titles among the lines `above` a table of `width` whose first line is `table`.
    pub fn find(
        lines: &Lines,
        comments: &[(usize, String)],
        above: &[usize],
        table: usize,
        width: Width,
        notation: (Separator, Decimal),
    ) -> Self {
        let (separator, decimal) = notation;
        let words = |number: &usize| -> Option<Vec<String>> {
            let cells = cells_of(lines.get(*number), width, separator)?;
            // A line with numbers in it is no row of titles, but for the counts of specimens.
            let count = |test: &dyn Fn(&str) -> bool| cells.iter().filter(|cell| test(cell)).count();
            let texts = count(&|cell| number::read(cell, decimal) == Cell::Text);
            let numbers = count(&|cell| matches!(number::read(cell, decimal), Cell::Number(_)));
            let sized = count(&|cell| {
                matches!(number::read(cell, decimal), Cell::Number(_)) && cell.contains(['.', ',', 'e', 'E'])
            });
            let titled = texts > numbers && sized == 0 || facts::is_sequence(&cells);
            (titled || is_row_of_units(&cells)).then_some(cells)
        };
        let mut candidates = above.iter().rev().take(4).filter_map(|number| Some((*number, words(number)?)));
        match candidates.next() {
            Some((line, units)) if is_row_of_units(&units) || facts::is_sequence(&units) => {
                let names = candidates.next().filter(|names| names.0 + 2 >= line);
                let titles = units.iter().enumerate().map(|(index, unit)| {
                    let name = names.as_ref().and_then(|names| names.1.get(index)).map_or("", String::as_str);
                    match bare(unit) {
                        "" => name.to_string(),
                        unit => format!("{name} [{unit}]"),
                    }
                });
                let titles = titles.collect();
                // What stands beside the units of a sequence are remarks.
                let lines = names.iter().map(|names| names.0).chain([line]).filter(|_| !facts::is_sequence(&units));
                Self { titles, lines: lines.collect() }
            }
            Some((line, titles)) => Self { titles, lines: vec![line] },
            None => {
                // As numpy writes it: the titles are the last comment above the numbers; or one comment for each.
                let above = || comments.iter().filter(|(line, _)| *line < table);
                let last = above().next_back().and_then(|(_, comment)| cells_of(comment, width, separator));
                let titles =
                    numbered(above().map(|(_, comment)| comment.as_str()), width.columns).or(last).unwrap_or_default();
                Self { titles, lines: Vec::new() }
            }
        }
    }
}

/// The titles of all `columns` in comments such as "column 1: Time".
fn numbered<'a>(comments: impl Iterator<Item = &'a str>, columns: usize) -> Option<Vec<String>> {
    let mut titles = vec![String::new(); columns];
    for comment in comments {
        let Some((place, title)) = comment.trim().split_once(':') else { continue };
        let index = place.to_lowercase().strip_prefix("column").and_then(|index| index.trim().parse::<usize>().ok());
        if let Some(slot) = index.and_then(|index| titles.get_mut(index.wrapping_sub(1))) {
            *slot = title.trim().into();
        }
    }
    titles.iter().all(|title| !title.is_empty()).then_some(titles)
}

/// `line` as a row of titles, by whichever separator makes that many of it; empty cells at the end do not count.
fn cells_of(line: &str, width: Width, own: Separator) -> Option<Vec<String>> {
    let of = |separator: Separator| -> Vec<String> { separator.cells(line).map(String::from).collect() };
    if let Separator::Sign(_) = own {
        // There may be titles of columns without any values.
        let cells = of(own);
        if cells.len() >= 2 && cells.len() >= width.filled {
            return Some(cells);
        }
    }
    if own == Separator::Alone {
        let title = line.trim();
        let stated = title.contains(['[', '(']);
        return stated.then(|| vec![title.to_string()]);
    }
    let wide: Vec<String> =
        line.trim().split("  ").map(str::trim).filter(|c| !c.is_empty()).map(String::from).collect();
    let fits = |cells: &Vec<String>| {
        let filled = filled(cells.iter().map(String::as_str));
        cells.len() >= 2 && filled <= width.columns && cells.len() >= width.filled
    };
    SEPARATORS.into_iter().map(of).chain([joined(of(Separator::Blanks)), wide]).find(fits)
}

/// Cells that a blank separates, with a unit in brackets at the title before it: "Time (s)" is one.
fn joined(cells: Vec<String>) -> Vec<String> {
    let mut titles: Vec<String> = Vec::new();
    for cell in cells {
        match titles.last_mut() {
            Some(title) if cell.starts_with(['(', '[', '<', '{']) => *title = format!("{title} {cell}"),
            _ => titles.push(cell),
        }
    }
    titles
}

fn bare(unit: &str) -> &str {
    unit.trim().trim_matches(['[', ']', '(', ')', '<', '>'])
}

/// Whether `cells` are the units of a table. One that is not known does not change what the others are: all stand in
/// brackets, or it is written as a quotient or a power.
pub(super) fn is_row_of_units(cells: &[String]) -> bool {
    let filled: Vec<&str> = cells.iter().map(|cell| cell.trim()).filter(|cell| !cell.is_empty()).collect();
    let known = filled.iter().filter(|cell| unit::is_unit(bare(cell))).count();
    let bracketed = filled.iter().all(|cell| cell.starts_with(['(', '[']) && cell.ends_with([')', ']']));
    let composed =
        |cell: &&&str| unit::is_unit(bare(cell)) || cell.contains(['/', '^', '·', '²', '³']) && !cell.contains(' ');
    let rest = bracketed || known >= 2 && filled.iter().filter(composed).count() == filled.len();
    filled.iter().any(|cell| bare(cell) != "-" && Unit::parse(bare(cell)).is_some())
        && (known == filled.len() || rest && 2 * known >= filled.len())
}
