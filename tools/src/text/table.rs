//! Tables of text.

use std::io::IsTerminal;
use std::ops::Range;

use comfy_table::presets::{ASCII_HORIZONTAL_ONLY, UTF8_HORIZONTAL_ONLY};
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, LineStyle, Table, TableStyle, Width};

use super::wrap::WIDTH;

/// Lines of tables: as drawn for a terminal, plain for what reads a pipe or a file.
fn style() -> TableStyle {
    if std::io::stdout().is_terminal() { UTF8_HORIZONTAL_ONLY } else { ASCII_HORIZONTAL_ONLY }
}

/// A table with these titles and no line between its rows.
pub(crate) fn new_plain_table(header: &[&str]) -> Table {
    let mut table = new_table(header);
    table.load_style(style().row_separator(LineStyle::none()));
    table
}

/// An empty table with this header, which fits the terminal, or `WIDTH` characters.
pub fn new_table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.load_style(style()).set_header(header).set_content_arrangement(ContentArrangement::Dynamic);
    if !std::io::stdout().is_terminal() {
        table.set_width(WIDTH);
    }
    // One space after each cell and one between the columns are enough.
    for column in table.column_iter_mut() {
        column.set_padding((0, 1));
    }
    table
}

/// A blank at which no line of a table breaks; [`text`] makes an ordinary one of it.
pub const FIXED_BLANK: char = '\u{a0}';

/// The text of a table, in which no word is cut: a table of too many words for the width is wider.
pub fn text(table: &mut Table) -> String {
    let mut longest: Vec<usize> = Vec::new();
    for row in table.header().into_iter().chain(table.row_iter()) {
        for (column, cell) in row.cell_iter().enumerate() {
            let words = cell.content().split([' ', '\n']).map(|word| word.chars().count()).max().unwrap_or_default();
            longest.resize(longest.len().max(column + 1), 0);
            longest[column] = longest[column].max(words);
        }
    }
    // Where even the words alone are too wide, the columns come closer: one blank between them stays.
    let needed = longest.iter().map(|longest| longest + 2).sum::<usize>();
    let crowded = table.width().is_some_and(|width| needed > usize::from(width));
    for (column, longest) in table.column_iter_mut().zip(longest) {
        if crowded {
            column.set_padding((0, 0));
        }
        let width = longest as u16 + column.padding_width();
        column.set_constraint(ColumnConstraint::LowerBoundary(Width::Fixed(width)));
    }
    table.trim_fmt().replace(FIXED_BLANK, " ")
}

/// Aligns columns of numbers to the right.
pub fn align_right(table: &mut Table, columns: Range<usize>) {
    for column in table.column_iter_mut().take(columns.end).skip(columns.start) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}
