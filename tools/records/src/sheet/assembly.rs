//! Goes through the lines of a file and gathers its tables.

use std::cmp::Ordering;

use super::head::{Head, Width, filled, is_row_of_units};
use super::notation::{Notation, is_missing, is_numeric, is_plain};
use super::table::{Body, FIRST, Row, Sheet};
use crate::ReadError;
use crate::cells::{Cells, Separator, starts_with_digit};
use crate::column::Column;
use crate::facts::Facts;
use crate::number::{self, Cell, Decimal};
use crate::text::{self, Lines};

/// The tables in `lines`; `cells` tells what separates the cells, if that is known.
///
/// # Errors
/// As [`super::parse`].
pub fn of_lines(lines: Lines, decimal: Option<Decimal>, cells: Option<Separator>) -> Result<Sheet, ReadError> {
    let notation = Notation::find(&lines, decimal, cells)?.ok_or_else(|| no_table(&lines))?;
    Assembly::new(lines, notation).finish()
}

fn no_table(lines: &Lines) -> ReadError {
    let legal = "expected a table of numbers separated by tab ; , | or blanks, with units in its titles";
    let first = (1..=lines.len())
        .map(|number| (number, lines.get(number)))
        .filter(|(_, line)| text::comment(line).is_none())
        .find(|(_, line)| starts_with_digit(line.trim_start_matches(['"', ' '])));
    match first {
        Some((number, line)) => {
            let shown: String = line.trim().chars().take(60).collect();
            ReadError::line(number, format!("\"{shown}\" is no row of two or more numbers: {legal}"))
        }
        None => ReadError::file(format!("no row of two or more numbers: {legal}")),
    }
}

/// Goes through the lines and gathers tables.
struct Assembly {
    lines: Lines,
    separator: Separator,
    decimal: Decimal,
    notation: Notation,
    tables: Vec<Body>,
    /// Rows of the table that is being read.
    rows: Vec<Row>,
    /// Which of its columns are of numbers alone.
    numeric: Vec<bool>,
    /// Lines of text since the last row.
    above: Vec<usize>,
    comments: Vec<(usize, String)>,
    remarks: Vec<(usize, String)>,
    missing: usize,
}

impl Assembly {
    pub fn new(lines: Lines, notation: Notation) -> Self {
        Self {
            lines,
            separator: notation.separator,
            decimal: notation.decimal,
            notation,
            tables: Vec::new(),
            rows: Vec::new(),
            numeric: Vec::new(),
            above: Vec::new(),
            comments: Vec::new(),
            remarks: Vec::new(),
            missing: 0,
        }
    }

    pub fn finish(mut self) -> Result<Sheet, ReadError> {
        for number in 1..=self.lines.len() {
            self.line(number)?;
        }
        self.end_table()?;
        let kept = |number: &usize| (*number, self.lines.get(*number).trim().to_string());
        let footer: Vec<(usize, String)> = self.above.iter().map(kept).collect();
        let mut remarks = self.remarks;
        remarks.extend(self.comments);
        remarks.sort_by_key(|remark| remark.0);
        if self.tables.is_empty() {
            return Err(no_table(&self.lines));
        }
        let facts = Facts::new(&remarks, self.separator, self.decimal);
        let mut sheet = Sheet {
            lines: self.lines,
            separator: self.separator,
            decimal: self.decimal,
            tables: self.tables,
            remarks,
            footer,
            facts,
            missing: self.missing,
            name: None,
        };
        sheet.name_untitled();
        Ok(sheet)
    }

    fn line(&mut self, number: usize) -> Result<(), ReadError> {
        let line = self.lines.get(number);
        if line.trim().is_empty() {
            return Ok(());
        }
        if is_plain(line, self.separator) {
            self.rows.push(Row { line: number });
            return Ok(());
        }
        if let Some(comment) = text::comment(line) {
            self.comments.push((number, comment.to_string()));
            return Ok(());
        }
        if self.is_row(number) {
            self.rows.push(Row { line: number });
            return Ok(());
        }
        let cells = self.separator.cells(self.lines.get(number));
        if is_missing(cells.clone(), self.decimal) && !is_row_of_units(&cells.map(String::from).collect::<Vec<_>>()) {
            self.missing += usize::from(!self.rows.is_empty());
        } else {
            self.end_table()?;
            self.above.push(number);
        }
        Ok(())
    }

    /// Whether a line with words in it is a row of the table: its columns of numbers hold numbers, or the first of them does,
    /// and another does not, which whoever needs that one refuses.
    fn is_row(&mut self, number: usize) -> bool {
        let cells = self.separator.cells(self.lines.get(number));
        let numeric = is_numeric(cells.clone().skip(self.notation.beside), self.decimal, self.notation.least)
            && (self.notation.least > 1 || self.begins_with_number(cells));
        if self.numeric.is_empty() || self.rows.len() < FIRST {
            self.numeric = self.columns_of_numbers(&self.rows[..self.rows.len().min(FIRST)]);
        }
        let cells = self.separator.cells(self.lines.get(number));
        let first = self.numeric.iter().position(|numeric| *numeric);
        let begins = first.and_then(|first| cells.clone().nth(first)).is_some_and(|cell| {
            matches!(number::read(cell, self.decimal), Cell::Number(_)) && self.separator != Separator::Alone
        });
        numeric && fits(&self.numeric, cells, self.decimal) || begins && self.notation.beside == 0
    }

    fn cells(&self, row: Row) -> Cells<'_> {
        self.separator.cells(self.lines.get(row.line))
    }

    /// Whether `row` has more than `columns` cells, and a number beyond them: words there are a comment.
    fn is_wider(&self, row: Row, columns: usize) -> bool {
        let line = self.lines.get(row.line);
        // A sign that separates stands between all cells.
        let fits =
            matches!(self.separator, Separator::Sign(sign) if line.bytes().filter(|c| *c == sign).count() < columns);
        let beyond = |cell: &str| matches!(number::read(cell, self.decimal), Cell::Number(_));
        !fits && self.separator.cells(line).skip(columns).any(beyond)
    }

    /// Whether the first cell that is not empty is a number: where one number makes a row, a key before it makes a remark.
    fn begins_with_number(&self, mut cells: Cells) -> bool {
        cells
            .find(|cell| !cell.is_empty())
            .is_some_and(|cell| matches!(number::read(cell, self.decimal), Cell::Number(_)))
    }

    /// Which columns of `rows` hold numbers alone.
    fn columns_of_numbers(&self, rows: &[Row]) -> Vec<bool> {
        let mut columns: Vec<(bool, bool)> = Vec::new();
        for row in rows {
            for (index, cell) in self.separator.cells(self.lines.get(row.line)).enumerate() {
                if columns.len() <= index {
                    columns.push((false, false));
                }
                match number::read(cell, self.decimal) {
                    Cell::Number(_) => columns[index].0 = true,
                    Cell::Text => columns[index].1 = true,
                    Cell::Missing => {}
                }
            }
        }
        let beside = self.notation.beside;
        columns.into_iter().enumerate().map(|(index, (number, text))| number && !text && index >= beside).collect()
    }

    /// Makes a table, or another block of the last one, of the rows since the last line of text.
    fn end_table(&mut self) -> Result<(), ReadError> {
        let mut rows = std::mem::take(&mut self.rows);
        self.numeric.clear();
        let Some(columns) = usual_columns(&rows, self.separator, &self.lines) else { return Ok(()) };
        let count = |row: &Row| self.separator.cells(self.lines.get(row.line)).count();
        // Numbers of another layout above the table are remarks; below its titles a short row misses values.
        let titled = !self.above.is_empty();
        let belongs = |row: &Row| match count(row).cmp(&columns) {
            Ordering::Less => titled,
            Ordering::Equal => true,
            Ordering::Greater => !self.is_wider(*row, columns) && self.begins_with_number(self.cells(*row)),
        };
        let start = rows.iter().position(belongs).unwrap_or_default();
        self.above.extend(rows.drain(..start).map(|row| row.line));
        if let Some(row) = rows.iter().find(|row| self.is_wider(**row, columns)) {
            let reason = format!("{} cells in a table of {columns} columns: expected as many as above", count(row));
            return Err(ReadError::line(row.line, reason));
        }
        let above = std::mem::take(&mut self.above);
        let first = &rows[..rows.len().min(FIRST)];
        let filled = first.iter().map(|row| filled(self.separator.cells(self.lines.get(row.line)))).max();
        let width = Width { columns, filled: filled.unwrap_or(columns).min(columns) };
        let head = Head::find(&self.lines, &self.comments, &above, rows[0].line, width, (self.separator, self.decimal));
        let kept = |number: &usize| (*number, self.lines.get(*number).trim().to_string());
        let is_title = |number: &&usize| head.lines.contains(number);
        self.remarks.extend(above.iter().filter(|number| !is_title(number)).map(kept));
        let Some(last) = self.tables.last_mut() else {
            self.tables.push(Body { titles: head.titles, columns, blocks: vec![rows] });
            return Ok(());
        };
        if last.columns == columns && !head.titles.is_empty() && same(&last.titles, &head.titles) {
            last.blocks.push(rows);
            return Ok(());
        }
        // A line of text within a table does not end it in silence.
        let untitled = head.titles.is_empty() && (rows.len() > 1 || last.columns == columns);
        let continued =
            last.columns == columns && rows.len() > FEW && !head.titles.iter().any(|title| is_understood(title));
        if untitled || continued {
            let line = above.first().copied().unwrap_or(rows[0].line);
            let legal = "expected a row of numbers, a comment (#), or the titles again before the next specimen";
            return Err(ReadError::line(line, format!("\"{}\" is refused: {legal}", self.lines.get(line).trim())));
        }
        if head.titles.is_empty() {
            // A number or two among the words.
            self.remarks.extend(rows.iter().map(|row| kept(&row.line)));
        } else {
            self.tables.push(Body { titles: head.titles, columns, blocks: vec![rows] });
        }
        Ok(())
    }
}

/// Rows of statistics below a table, at most: under titles that say nothing else, more are rows of the table.
const FEW: usize = 3;

/// Whether a title is one of a column that may be needed.
fn is_understood(title: &str) -> bool {
    !matches!(Column::recognise(0, title), Ok(None))
}

/// The number of cells that most of the first rows have.
fn usual_columns(rows: &[Row], separator: Separator, lines: &Lines) -> Option<usize> {
    let mut counts: Vec<usize> = rows
        .iter()
        .take(FIRST + rows.len().min(FIRST))
        .map(|row| separator.cells(lines.get(row.line)).count())
        .collect();
    counts.sort_unstable();
    // The larger of two that are as frequent: a short row misses values.
    counts.chunk_by(|a, b| a == b).max_by_key(|chunk| (chunk.len(), chunk[0])).map(|chunk| chunk[0])
}

fn same(a: &[String], b: &[String]) -> bool {
    let plain = |titles: &[String]| titles.iter().map(|title| title.to_lowercase()).collect::<Vec<_>>();
    plain(a) == plain(b)
}

/// Whether the columns of numbers hold numbers, or nothing, in `cells`.
fn fits(numeric: &[bool], cells: Cells, decimal: Decimal) -> bool {
    cells.zip(numeric).all(|(cell, numeric)| !numeric || number::read(cell, decimal) != Cell::Text)
}
