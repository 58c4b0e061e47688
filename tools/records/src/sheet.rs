//! The tables of numbers in a file: separator and decimal sign, titles, and rows with their lines.

use super::ReadError;
use super::column::Column;
use super::facts::{self, Facts};
use super::number::{self, Cell, Decimal};
use super::text::{self, Lines};
use super::unit::{self, Unit};
use super::workbook;

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
    lines: Lines,
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

/// What separates cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// A sign.
    Sign(u8),
    /// Blanks, as many as there are; also columns of fixed width.
    Blanks,
    /// Nothing: one number in a line.
    Alone,
}

/// What may separate cells, the surest sign first.
const SEPARATORS: [Separator; 5] =
    [Separator::Sign(b'\t'), Separator::Sign(b';'), Separator::Sign(b'|'), Separator::Sign(b','), Separator::Blanks];

impl Separator {
    /// Name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign(b'\t') => "tabs",
            Self::Sign(b';') => "semicolons",
            Self::Sign(b'|') => "vertical bars",
            Self::Sign(_) => "commas",
            Self::Blanks => "blanks",
            Self::Alone => "lines",
        }
    }

    /// The cells of `line`, without blanks and quotation marks around them.
    pub fn cells(self, line: &str) -> Cells<'_> {
        Cells { separator: self, rest: Some(line) }
    }

    /// Whether a cell of `line` may be two numbers with a blank between them, of which a decimal comma separated a third.
    fn leaves_two(self, line: &str) -> bool {
        self == Self::Sign(b',')
            && self.cells(line).any(|cell| cell.contains(' ') && !is_date(cell) && starts_with_digit(cell))
    }
}

/// The cells of a line.
#[derive(Clone, Debug)]
pub struct Cells<'a> {
    separator: Separator,
    rest: Option<&'a str>,
}

impl<'a> Iterator for Cells<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest.take()?;
        match self.separator {
            Separator::Alone => Some(rest.trim()),
            Separator::Blanks => {
                let rest = rest.trim_start();
                if rest.is_empty() {
                    return None;
                }
                let (cell, rest) = quoted(rest, char::is_whitespace)
                    .or_else(|| rest.split_once(char::is_whitespace))
                    .unwrap_or((rest, ""));
                self.rest = Some(rest);
                Some(cell)
            }
            Separator::Sign(sign) => {
                let sign = char::from(sign);
                let start = rest.trim_start_matches(' ');
                let found = quoted(start, |c| c == sign).or_else(|| rest.split_once(sign));
                // Behind the last separator stands an empty cell.
                self.rest = found.map(|(_, rest)| rest).filter(|rest| !(rest.is_empty() && ends(start, found)));
                Some(found.map_or(rest, |(cell, _)| cell).trim())
            }
        }
    }
}

/// Whether a quoted cell that was `found` in `text` ends it, without a separator.
fn ends(text: &str, found: Option<(&str, &str)>) -> bool {
    found.is_some() && text.starts_with('"') && text.trim_end().ends_with('"')
}

/// The cell within quotation marks that `text` begins with, and what follows its separator. Inside of it a mark stands where
/// no separator follows.
fn quoted(text: &str, is_separator: impl Fn(char) -> bool) -> Option<(&str, &str)> {
    let inside = text.strip_prefix('"')?;
    inside.match_indices('"').find_map(|(at, _)| {
        let after = inside[at + 1..].trim_start_matches(' ');
        match after.chars().next() {
            None => Some((&inside[..at], "")),
            Some(c) if is_separator(c) => Some((&inside[..at], &after[c.len_utf8()..])),
            _ if after.len() < inside.len() - at - 1 && is_separator(' ') => Some((&inside[..at], after)),
            _ => None,
        }
    })
}

fn starts_with_digit(cell: &str) -> bool {
    cell.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit())
}

/// The tables in `bytes`, by `layout` where the file leaves it open.
///
/// # Errors
/// No table, or a line in it that is no row of numbers.
pub fn parse(bytes: &[u8], layout: &Layout) -> Result<Sheet, ReadError> {
    if softanvil_workbooks::is_workbook(bytes) {
        return workbook::parse(bytes, layout);
    }
    if let Some(sheet) = &layout.sheet {
        return Err(ReadError::file(format!("--sheet {sheet} is refused: this is text, not a workbook")));
    }
    of_lines(Lines::new(bytes)?, layout.decimal, None)
}

/// The tables in `lines`; `cells` tells what separates the cells, if that is known.
///
/// # Errors
/// As [`parse`].
pub fn of_lines(lines: Lines, decimal: Option<Decimal>, cells: Option<Separator>) -> Result<Sheet, ReadError> {
    let notation = Notation::find(&lines, decimal, cells).ok_or_else(|| no_table(&lines))?;
    Assembly::new(lines, notation).finish()
}

/// Lines at the beginning that tell how numbers are written, and as many throughout a longer file.
const SAMPLE: usize = 2000;

/// How rows of numbers are written.
#[derive(Clone, Copy, Debug)]
struct Notation {
    separator: Separator,
    decimal: Decimal,
    /// Numbers in a row, at least.
    least: usize,
    /// Columns of metadata on the left of the numbers, as Tektronix writes them.
    beside: usize,
}

impl Notation {
    /// The notation that the file states, or else by which most lines of a sample are rows of numbers.
    fn find(lines: &Lines, decimal: Option<Decimal>, cells: Option<Separator>) -> Option<Self> {
        if let Some((separator, stated)) = facts::notation_of_labview(lines) {
            return Some(Self { separator, decimal: decimal.unwrap_or(stated), least: 1, beside: 0 });
        }
        let step = (lines.len() / SAMPLE).max(1);
        let sample = (1..=lines.len().min(SAMPLE)).chain((SAMPLE + 1..=lines.len()).step_by(step));
        let sample = sample.map(|number| lines.get(number)).filter(|line| text::comment(line).is_none());
        let texts: Vec<&str> = sample.collect();
        let decimals = decimal.map_or(vec![Decimal::Point, Decimal::Comma], |decimal| vec![decimal]);
        let separators = cells.map_or(SEPARATORS.to_vec(), |separator| vec![separator]);
        let (mut best, mut most) = (None, 0);
        for &separator in &separators {
            for &decimal in &decimals {
                let row = |line: &&&str| is_numeric(separator.cells(line), decimal, 2) && !separator.leaves_two(line);
                let count = texts.iter().filter(row).count();
                if count > most {
                    (best, most) = (Some(Self { separator, decimal, least: 2, beside: 0 }), count);
                }
            }
        }
        // One number in a line, as channels with a rate are written.
        for decimal in decimals.into_iter().filter(|_| cells.is_none()) {
            let alone = |line: &&&str| matches!(number::read(line, decimal), Cell::Number(_));
            let count = texts.iter().filter(alone).count();
            if count > most.max(2) {
                (best, most) = (Some(Self { separator: Separator::Alone, decimal, least: 1, beside: 0 }), count);
            }
        }
        let beside = if facts::is_tektronix(lines.get(1)) { 3 } else { 0 };
        best.map(|best| Self { beside, ..best })
    }
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

/// Whether cells are a row of numbers: `least` or more, beside them only names, dates and times of day.
fn is_numeric<'a>(cells: impl Iterator<Item = &'a str>, decimal: Decimal, least: usize) -> bool {
    let mut numbers = 0;
    for cell in cells {
        match number::read(cell, decimal) {
            Cell::Number(_) => numbers += 1,
            Cell::Missing => {}
            Cell::Text if is_name(cell) || is_date(cell) => {}
            Cell::Text => return false,
        }
    }
    numbers >= least
}

fn is_name(cell: &str) -> bool {
    !cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ','))
}

/// Whether a row says that its values are missing.
fn is_missing(cells: Cells, decimal: Decimal) -> bool {
    let missing = |cell: &str| number::read(cell, decimal) == Cell::Missing;
    cells.clone().any(|cell| !cell.is_empty() && missing(cell))
        || cells.clone().all(|cell| missing(cell) || is_date(cell))
}

/// Whether a cell is a date, a time of day, or both.
fn is_date(cell: &str) -> bool {
    let legal = |c: char| c.is_ascii_digit() || matches!(c, '-' | '/' | ':' | '.' | ',' | ' ' | 'T' | 'Z');
    cell.chars().all(legal) && cell.matches([':', '/', '-', '.']).count() >= 2
}

/// Whether `line` has only what numbers are written with, and a digit among it: nearly every row of a table.
fn is_plain(line: &str, separator: Separator) -> bool {
    let sign = if let Separator::Sign(sign) = separator { sign } else { b' ' };
    let of_numbers = |c: u8| {
        c.is_ascii_digit() || matches!(c, b'.' | b',' | b'-' | b'+' | b'e' | b'E' | b' ' | b'\t' | b'"') || c == sign
    };
    line.bytes().all(of_numbers) && line.bytes().any(|c| c.is_ascii_digit())
}

/// Rows that tell which columns are of numbers.
const FIRST: usize = 20;

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
    fn new(lines: Lines, notation: Notation) -> Self {
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

    fn finish(mut self) -> Result<Sheet, ReadError> {
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

    /// Whether `row` has more than `columns` cells, not all of them empty.
    fn is_wider(&self, row: Row, columns: usize) -> bool {
        let line = self.lines.get(row.line);
        // A sign that separates stands between all cells.
        let fits =
            matches!(self.separator, Separator::Sign(sign) if line.bytes().filter(|c| *c == sign).count() < columns);
        !fits && self.separator.cells(line).skip(columns).any(|cell| !cell.is_empty())
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
        // Numbers of another layout above the table are remarks.
        let start = rows.iter().position(|row| count(row) == columns).unwrap_or_default();
        self.above.extend(rows.drain(..start).map(|row| row.line));
        if let Some(row) = rows.iter().find(|row| self.is_wider(**row, columns)) {
            let reason = format!("{} cells in a table of {columns} columns: expected as many as above", count(row));
            return Err(ReadError::line(row.line, reason));
        }
        let above = std::mem::take(&mut self.above);
        let first = &rows[..rows.len().min(FIRST)];
        let filled = first.iter().map(|row| filled(self.separator.cells(self.lines.get(row.line)))).max();
        let width = Width { columns, filled: filled.unwrap_or(columns) };
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

/// How many cells a row has.
#[derive(Clone, Copy)]
struct Width {
    columns: usize,
    /// Without empty ones at the end.
    filled: usize,
}

/// The number of cells up to the last that is not empty.
fn filled<'a>(cells: impl Iterator<Item = &'a str>) -> usize {
    cells.enumerate().filter(|(_, cell)| !cell.is_empty()).last().map_or(0, |(index, _)| index + 1)
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
    fn name_untitled(&mut self) {
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

/// The titles and where they stand.
struct Head {
    titles: Vec<String>,
    /// Their lines, from 1.
    lines: Vec<usize>,
}

impl Head {
    /// The titles among the lines `above` a table of `width` whose first line is `table`.
    fn find(
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
fn is_row_of_units(cells: &[String]) -> bool {
    let filled: Vec<&str> = cells.iter().map(|cell| cell.trim()).filter(|cell| !cell.is_empty()).collect();
    let known = filled.iter().filter(|cell| unit::is_unit(bare(cell))).count();
    let bracketed = filled.iter().all(|cell| cell.starts_with(['(', '[']) && cell.ends_with([')', ']']));
    let composed =
        |cell: &&&str| unit::is_unit(bare(cell)) || cell.contains(['/', '^', '·', '²', '³']) && !cell.contains(' ');
    let rest = bracketed || known >= 2 && filled.iter().filter(composed).count() == filled.len();
    filled.iter().any(|cell| bare(cell) != "-" && Unit::parse(bare(cell)).is_some())
        && (known == filled.len() || rest && 2 * known >= filled.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(text: &str) -> Sheet {
        parse(text.as_bytes(), &Layout::default()).unwrap()
    }

    fn titles(text: &str) -> Vec<String> {
        sheet(text).tables[0].titles.clone()
    }

    fn numbers(sheet: &Sheet) -> Vec<Vec<f64>> {
        let read = |cell: &str| match number::read(cell, sheet.decimal) {
            Cell::Number(number) => number,
            _ => f64::NAN,
        };
        sheet.tables[0].blocks.iter().flatten().map(|row| sheet.cells(*row).map(read).collect()).collect()
    }

    #[test]
    fn every_separator_and_decimal_sign_is_found() {
        for text in [
            "strain,stress\n0.1,0.2\n0.3,0.4\n",
            "strain;stress\n0,1;0,2\n0,3;0,4\n",
            "strain;stress\n0.1;0.2\n0.3;0.4\n",
            "strain\tstress\n0,1\t0,2\n0,3\t0,4\n",
            "strain stress\n0.1 0.2\n0.3 0.4\n",
            "strain stress\n0,1 0,2\n0,3 0,4\n",
            "  strain    stress\n   0.1     0.2\n   0.3     0.4\n",
            "strain|stress\n0.1|0.2\n0.3|0.4\n",
            "strain, stress\n0.1, 0.2\n0.3, 0.4\n",
            "strain,stress\n\"0,1\",\"0,2\"\n\"0,3\",\"0,4\"\n",
            "# note\r\nstrain;stress\r\n0.1;0.2\r\n\r\n0.3;0.4",
            "# strain stress\n0.1 0.2\n0.3 0.4\n",
            "strain,stress\n0.1,0.2\n0.3,0.4\nMax,0.4\nend of test\n",
            "strain,stress\n0.1,0.2\n0.3,0.4\nMean,0.2,0.3\n",
        ] {
            let sheet = sheet(text);
            assert_eq!(sheet.tables[0].titles, ["strain", "stress"], "{text}");
            assert_eq!(numbers(&sheet), [[0.1, 0.2], [0.3, 0.4]], "{text}");
        }
    }

    #[test]
    fn cells_are_those_of_the_csv_rules() {
        for (separator, line, cells) in [
            (Separator::Sign(b','), "a, b ,c", &["a", "b", "c"][..]),
            (Separator::Sign(b','), "a,b,", &["a", "b", ""]),
            (Separator::Sign(b','), "\"a,1\",\"b\"", &["a,1", "b"]),
            (Separator::Sign(b','), "\"a\",", &["a", ""]),
            (Separator::Sign(b','), "5\" pipe,2", &["5\" pipe", "2"]),
            (Separator::Sign(b','), "\"unpaired,2", &["\"unpaired", "2"]),
            (Separator::Sign(b'\t'), "\ta\t", &["", "a", ""]),
            (Separator::Sign(b';'), "", &[""]),
            (Separator::Blanks, "  a   b ", &["a", "b"]),
            (Separator::Blanks, "\"a b\" c", &["a b", "c"]),
            (Separator::Alone, " 1.5 ", &["1.5"]),
        ] {
            assert_eq!(separator.cells(line).collect::<Vec<_>>(), cells, "{line}");
        }
    }

    #[test]
    fn a_head_of_a_test_machine_is_passed_over() {
        let text =
            "Test;Compression;;\nSpecimen Length (mm);33;;\n\nTime;Strain;Stress\n(s);(%);(MPa)\n0;0,5;1\n1;0,7;2\n";
        let sheet = sheet(text);
        assert_eq!(sheet.tables[0].titles, ["Time [s]", "Strain [%]", "Stress [MPa]"]);
        assert_eq!(numbers(&sheet), [[0.0, 0.5, 1.0], [1.0, 0.7, 2.0]]);
        assert!(sheet.words().contains("Compression"));
    }

    #[test]
    fn rows_of_missing_values_above_the_table_are_no_titles() {
        assert_eq!(titles("a;b\nnan;nan\n0.1;nan\n1;2\n3;4\n"), ["a", "b"]);
        assert_eq!(titles("a;b\n-;MPa\n1;2\n3;4\n"), ["a [-]", "b [MPa]"]);
        assert_eq!(titles("t,E,T\ns,MPa,°C\n1,2,3\n3,4,5\n"), ["t [s]", "E [MPa]", "T [°C]"]);
    }

    #[test]
    fn a_unit_that_is_not_known_leaves_the_row_one_of_units() {
        let expected = ["Time [s]", "Load [N]", "Tenacity [N/tex2]"];
        assert_eq!(titles("Time,Load,Tenacity\n(s),(N),(N/tex2)\n1,2,3\n3,4,5\n"), expected);
        assert_eq!(titles("Time,Load,Tenacity\ns,N,N/tex2\n1,2,3\n3,4,5\n"), expected);
    }

    #[test]
    fn titles_may_have_fewer_or_more_cells_than_rows() {
        assert_eq!(titles("a;b\n1;2;\n3;4;\n"), ["a", "b"]);
        assert_eq!(titles("a\tb\tComment\n1\t2\n3\t4\n"), ["a", "b", "Comment"]);
        assert!(sheet("a;b\n1;2;3\n3;4;5\n").tables[0].titles.is_empty());
        assert_eq!(titles("Time (s) Force (N)\n1 2\n3 4\n"), ["Time (s)", "Force (N)"]);
    }

    #[test]
    fn a_comment_for_each_column_is_its_title() {
        let text = "% made by a program\n% column 1: Time [s]\n% column 2: True Strain\n%\n1 2\n3 4\n";
        assert_eq!(titles(text), ["Time [s]", "True Strain"]);
    }

    #[test]
    fn titles_again_begin_another_block() {
        for text in ["a,b\n1,2\n3,4\na,b\n5,6\n", "a,b\n1,2\n3,4\n\nSpecimen 2\nA,B\n5,6\n"] {
            let sheet = sheet(text);
            assert_eq!(sheet.tables[0].blocks.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1]);
        }
    }

    #[test]
    fn other_titles_begin_another_table() {
        let sheet = sheet("Specimen,Peak\n1,2\n2,4\n\ntime,load,strain\n1,2,3\n5,6,7\n");
        assert_eq!(sheet.tables.iter().map(Body::len).collect::<Vec<_>>(), [2, 2]);
        assert_eq!(sheet.tables[1].titles, ["time", "load", "strain"]);
    }

    #[test]
    fn a_line_that_is_no_row_is_refused_by_its_number() {
        let error = parse(b"a,b\n1,2\n3,4\npause\n5,6\n7,8\n", &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: \"pause\" is refused"), "{error}");
        let text = b"a,b\n1,2\n3,4\ntrigger,start\n5,6\n7,8\n9,1\n2,3\n";
        let error = parse(text, &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: \"trigger,start\" is refused"), "{error}");
        let error = parse(b"a,b\n1,2\n3,4\n5,6,7\n", &Layout::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 4: 3 cells in a table of 2 columns"), "{error}");
        for empty in ["", "strain,stress\n", "hello\nworld\n", "# only a comment"] {
            assert!(parse(empty.as_bytes(), &Layout::default()).is_err(), "{empty}");
        }
    }

    #[test]
    fn names_dates_and_missing_values_stand_beside_numbers() {
        let sheet =
            sheet("date;by;a;b\n2024-01-02 10:00:00;me;1,5;2\n02.01.2024;me;nan;-\n-;-;-;-\n3.1.2024;you;2;3\n");
        assert_eq!(sheet.tables[0].titles, ["date", "by", "a", "b"]);
        assert_eq!((sheet.tables[0].blocks[0].len(), sheet.missing), (2, 2));
    }

    #[test]
    fn a_blank_is_no_group_of_thousands_beside_a_decimal_comma() {
        assert_eq!(numbers(&sheet("a b\n10 200,5\n20 300,5\n")), [[10.0, 200.5], [20.0, 300.5]]);
        assert_eq!(numbers(&sheet("a;b\n1;1 200,5\n2;1 300,5\n")), [[1.0, 1200.5], [2.0, 1300.5]]);
    }

    #[test]
    fn what_is_no_table_is_refused_at_its_first_line_of_digits() {
        let error = parse(b"strain;stress\n10 %;0.2 MPa\n", &Layout::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 2: \"10 %;0.2 MPa\" is no row"), "{error}");
    }

    #[test]
    fn numbers_without_titles_have_none() {
        assert!(titles("1.0 2.0\n3.0 4.0\n").is_empty());
    }

    #[test]
    fn one_number_in_a_line_is_a_column() {
        let sheet = sheet("Rate: 20 kHz\nForce [N]\n0.5\n1.5\n2.5\n3.5\n");
        assert_eq!((sheet.tables[0].titles[0].as_str(), sheet.tables[0].len()), ("Force [N]", 4));
    }
}
