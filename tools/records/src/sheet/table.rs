//! Tables of numbers, with the lines that they stand in.

use crate::cells::{Cells, Separator};
use crate::facts::Facts;
use crate::number::Decimal;
use crate::text::Lines;

/// Rows that tell which columns are of numbers.
pub(super) const FIRST: usize = 20;

/// What a file leaves open about its layout.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// Decimal sign of the numbers.
    pub decimal: Option<Decimal>,
    /// Sheet of a workbook.
    pub sheet: Option<String>,
}

/// The tables in a file.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub(super) lines: Lines,
    /// What separates the cells.
    pub separator: Separator,
    /// Decimal sign of the numbers.
    pub decimal: Decimal,
    /// The tables, in the order of the file.
    pub tables: Vec<Body>,
    /// Comments and lines above and between the tables, with their numbers.
    pub remarks: Vec<(usize, String)>,
    /// Lines below the last table, with their numbers.
    pub footer: Vec<(usize, String)>,
    /// What the remarks state.
    pub facts: Facts,
    /// Number of rows whose values are all missing.
    pub missing: usize,
    /// Name of the sheet, if the file is a workbook.
    pub name: Option<String>,
}

/// A table: titles, and the rows under them.
#[derive(Clone, Debug)]
pub struct Body {
    /// Title of each column, with the unit of a row of units in brackets; empty if there is none.
    pub titles: Vec<String>,
    /// Number of columns.
    pub columns: usize,
    /// Rows between repetitions of the titles.
    pub blocks: Vec<Vec<Row>>,
}

impl Body {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.blocks.iter().map(Vec::len).sum()
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Line of the first row.
    pub fn line(&self) -> usize {
        self.blocks.first().and_then(|rows| rows.first()).map_or(0, |row| row.line)
    }
}

/// A row of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Line of the file, from 1.
    pub line: usize,
}

impl Sheet {
    /// The cells of `row`.
    pub fn cells(&self, row: Row) -> Cells<'_> {
        self.separator.cells(self.lines.get(row.line))
    }

    /// The cell of `row` in column `index`; empty if the row is shorter.
    pub fn cell(&self, row: Row, index: usize) -> &str {
        self.cells(row).nth(index).unwrap_or_default()
    }

    /// Number of lines.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there are no lines.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Name of the encoding.
    pub fn encoding(&self) -> &'static str {
        self.lines.encoding
    }

    /// Comments and lines above the tables, as one text.
    pub fn words(&self) -> String {
        self.remarks.iter().map(|remark| remark.1.as_str()).collect::<Vec<_>>().join("\n")
    }

    /// Titles of tables without any, where the layout of an instrument states what the columns are.
    pub(super) fn name_untitled(&mut self) {
        let facts = &self.facts;
        let (separator, lines) = (self.separator, &self.lines);
        for body in self.tables.iter_mut().filter(|body| body.titles.is_empty()) {
            let rows = body.blocks.first().map_or(&[][..], Vec::as_slice);
            let beside: Vec<Vec<&str>> =
                rows.iter().take(FIRST).map(|row| separator.cells(lines.get(row.line)).collect()).collect();
            body.titles = facts.titles(&beside, body.columns);
        }
        let rows = self.tables.iter().flat_map(|body| body.blocks.first()).flat_map(|rows| rows.iter().take(FIRST));
        let beside: Vec<(usize, String)> = rows.map(|row| (row.line, lines.get(row.line).to_string())).collect();
        self.facts.add_beside(&beside, separator, self.decimal);
    }
}
