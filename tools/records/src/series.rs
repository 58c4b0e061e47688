//! The columns of a table in SI units, one set for each specimen in the file.

use std::sync::Arc;

use super::ReadError;
use super::cells::clock;
use super::column::{self, Column, Kind};
use super::number::{self, Cell, Decimal};
use super::sheet::{Body, Row, Sheet};
use super::unit::{Dimension, Unit};

/// The rows of one specimen.
#[derive(Clone, Debug)]
pub struct Series {
    /// Name of the specimen; empty if the file has one only.
    pub name: String,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// A table whose columns are understood.
#[derive(Clone, Debug)]
pub struct Table {
    /// The columns that are needed.
    pub columns: Vec<Column>,
    /// Every title.
    pub titles: Vec<String>,
    /// What else the file says, with its titles.
    pub words: String,
    /// The specimens.
    pub series: Vec<Series>,
    /// Why columns are not understood.
    pub unclear: Vec<String>,
    /// How the file was understood where it left a choice.
    pub notes: Vec<String>,
    sheet: Arc<Sheet>,
}

impl Table {
    /// Understands `sheet`; `titles` stand instead of its own, a minus sign for a column to be passed over.
    ///
    /// # Errors
    /// Titles that are missing, too many or not understood.
    pub fn new(sheet: Sheet, titles: Option<&[String]>) -> Result<Self, ReadError> {
        let sheet = Arc::new(sheet);
        let mut order: Vec<usize> = (0..sheet.tables.len()).collect();
        order.sort_by_key(|index| std::cmp::Reverse(sheet.tables[*index].len()));
        let mut refused = None;
        for index in order {
            match Self::of_body(&sheet, index, titles, 2) {
                Ok(table) => return Ok(table),
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        Err(refused.unwrap_or_else(|| ReadError::file("no table")))
    }

    /// Understands table `index` of `sheet`, in which `least` columns or more have to be understood.
    ///
    /// # Errors
    /// As [`Table::new`].
    pub fn of_body(
        sheet: &Arc<Sheet>,
        index: usize,
        titles: Option<&[String]>,
        least: usize,
    ) -> Result<Self, ReadError> {
        let body = &sheet.tables[index];
        let width = body.columns.max(body.titles.len());
        let titles = match titles {
            Some(given) if given.len() > width => {
                let reason = format!("--columns names {} columns, the table has {width}", given.len());
                return Err(ReadError::file(reason));
            }
            Some(given) => given.iter().map(|title| if title == "-" { String::new() } else { title.clone() }).collect(),
            None => body.titles.clone(),
        };
        if titles.is_empty() {
            let reason = format!("the {width} columns have no titles: name them with --columns, such as \"{EXAMPLE}\"");
            return Err(ReadError::file(reason));
        }
        let mut notes = Vec::new();
        let (columns, unclear) = understood(sheet, body, &titles, &mut notes);
        if columns.iter().filter(|column| column.kind.dimension().is_some()).count() < least {
            if column::are_dynamic(titles.iter().map(String::as_str)) {
                return Err(ReadError::file(DYNAMIC));
            }
            let reason = unclear.into_iter().next().unwrap_or_else(|| {
                format!(
                    "no two columns understood among {}: name them with --columns, such as \"{EXAMPLE}\"",
                    list(&titles)
                )
            });
            return Err(ReadError::file(format!("{reason}{}", noted(&notes))));
        }
        let words = format!("{}\n{}", titles.join("\n"), sheet.words());
        let series = split(sheet, body, &columns);
        notes.insert(0, described(sheet, body));
        Ok(Self { columns, titles, words, series, unclear, notes, sheet: Arc::clone(sheet) })
    }

    /// The columns of `kind`.
    pub fn of(&self, kind: Kind) -> impl Iterator<Item = &Column> {
        self.columns.iter().filter(move |column| column.kind == kind)
    }

    /// The value of `column` in `row`, in the unit of the file; none if the cell is empty.
    ///
    /// # Errors
    /// A cell that is no number.
    pub fn value(&self, column: &Column, row: &Row) -> Result<Option<f64>, ReadError> {
        let cell = self.sheet.cell(*row, column.index);
        match number::read(cell, self.sheet.decimal) {
            Cell::Number(number) => Ok(Some(number)),
            Cell::Missing => Ok(None),
            Cell::Text if column.kind == Kind::Time && clock(cell).is_some() => {
                Ok(clock(cell).map(|seconds| seconds / column.si.unwrap_or(1.0)))
            }
            Cell::Text if column.kind.dimension() == Some(Dimension::Ratio) && self.percentage(cell).is_some() => {
                Ok(self.percentage(cell).map(|part| part / column.si.unwrap_or(1.0)))
            }
            Cell::Text => {
                let sign = if self.sheet.decimal == Decimal::Point { "point" } else { "comma" };
                let reason =
                    format!("{} = \"{cell}\" is refused: expected a number with a decimal {sign}", column.title);
                Err(ReadError::line(row.line, reason))
            }
        }
    }

    fn percentage(&self, cell: &str) -> Option<f64> {
        number::percentage(cell, self.sheet.decimal)
    }

    /// The sheet that the table stands in.
    pub fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// Factor from the unit of `column` to SI.
    ///
    /// # Errors
    /// A title without a unit.
    pub fn si(&self, column: &Column) -> Result<f64, ReadError> {
        column.si.ok_or_else(|| {
            let (name, example) = column.kind.example();
            let reason = format!(
                "column \"{}\" has no unit: write it in the title or give --columns, {name} such as \"{example}\"",
                column.title
            );
            ReadError::file(reason)
        })
    }
}

/// Notes as the end of an error.
pub(super) fn noted(notes: &[String]) -> String {
    notes.iter().map(|note| format!("; {note}")).collect()
}

/// The columns of a table that are understood, those without any number left out, and why others are not.
fn understood(sheet: &Sheet, body: &Body, titles: &[String], notes: &mut Vec<String>) -> (Vec<Column>, Vec<String>) {
    let mut columns: Vec<Column> = Vec::new();
    let mut unclear = Vec::new();
    let mut others = Vec::new();
    for (index, title) in titles.iter().enumerate().filter(|(_, title)| !title.is_empty()) {
        if column::is_of_a_model(title, titles) {
            notes.push(format!("\"{title}\" is passed over, as a fit, a model or a scatter"));
            continue;
        }
        match Column::recognise(index, title) {
            Ok(Some(column)) if column.kind.dimension().is_some() && is_empty(sheet, body, index) => {
                notes.push(format!("\"{title}\" has no values and is passed over"));
            }
            Ok(Some(column)) => columns.push(column),
            Ok(None) => others.push((index, title)),
            Err(reason) => unclear.push(reason),
        }
    }
    // LabVIEW's first column, by what stands above it.
    for (index, title) in others.iter().filter(|(_, title)| sheet.facts.x_is_time && title.starts_with("X_Value")) {
        if let Ok(column) =
            Column::named(*index, title, Kind::Time, Some("s")).map(|column| Column { index: *index, ..column })
            && !is_empty(sheet, body, *index)
        {
            columns.push(column);
        }
    }
    for column in columns.iter_mut().filter(|column| column.si.is_none()) {
        let (text, of) = match column.kind {
            Kind::Time => (sheet.facts.horizontal_unit.clone(), "the horizontal unit"),
            _ => (sheet.facts.channel_units.get(column.index.wrapping_sub(1)).cloned(), "the channel's unit"),
        };
        let unit = text.as_deref().zip(column.kind.dimension()).and_then(|(text, dimension)| Unit::of(dimension, text));
        if let (Some(unit), Some(text)) = (unit, text) {
            notes.push(format!("\"{}\" is in {text}: {of} above the table says so", column.title));
            (column.si, column.unit) = (Some(unit.si), Some(text));
        }
    }
    for column in columns.iter_mut().filter(|column| column.si.is_none()) {
        let cell = body.blocks.iter().flatten().next().map_or("", |row| sheet.cell(*row, column.index));
        let ratio = column.kind.dimension() == Some(Dimension::Ratio);
        let (unit, of) = match column.kind {
            Kind::Time if clock(cell).is_some() => ("s", "times of day"),
            _ if ratio && number::percentage(cell, sheet.decimal).is_some() => ("1", "percentages"),
            _ => continue,
        };
        notes.push(format!("\"{}\" holds {of}", column.title));
        (column.si, column.unit) = (Some(1.0), Some(unit.into()));
    }
    let by_unit: Vec<Column> = others.iter().filter_map(|(index, title)| Column::by_unit(*index, title)).collect();
    for column in &by_unit {
        let only = by_unit.iter().filter(|other| other.kind == column.kind).count() == 1;
        if only && columns.iter().all(|known| known.kind != column.kind) && !is_empty(sheet, body, column.index) {
            notes.push(format!("\"{}\" is read as {}, by its unit", column.title, column.kind.example().0));
            columns.push(column.clone());
        }
    }
    columns.sort_by_key(|column| column.index);
    (columns, unclear)
}

/// Whether no row of `body` has a number in column `index`.
fn is_empty(sheet: &Sheet, body: &Body, index: usize) -> bool {
    let number =
        |row: &Row| matches!(number::read(sheet.cell(*row, index), sheet.decimal), Cell::Number(_) | Cell::Text);
    !body.blocks.iter().flatten().any(number)
}

/// How a file was taken apart.
fn described(sheet: &Sheet, body: &Body) -> String {
    let place = match &sheet.name {
        Some(name) => format!("sheet \"{name}\" of a workbook"),
        None => {
            let sign = if sheet.decimal == Decimal::Point { "point" } else { "comma" };
            format!("{}, cells separated by {}, decimal {sign}", sheet.encoding(), sheet.separator.name())
        }
    };
    let mut text = format!("{place}: {} rows from line {}", body.len(), body.line());
    if sheet.missing > 0 {
        text += &format!(", {} more without values", sheet.missing);
    }
    if let Some((line, first)) = sheet.footer.first() {
        let shown: String = first.chars().take(40).collect();
        text += &format!(", {} lines below passed over from line {line}, \"{shown}\"", sheet.footer.len());
    }
    for other in sheet.tables.iter().filter(|other| other.line() != body.line()) {
        text += &format!(", a table of {} rows from line {} passed over", other.len(), other.line());
    }
    text
}

/// What is said of storage and loss moduli.
pub const DYNAMIC: &str = "a test with oscillations (storage and loss moduli over frequency) is not read: expected a relaxation, \
                           a modulus, stress or force over time";

const EXAMPLE: &str = "strain [%], stress [kPa]";

fn list(titles: &[String]) -> String {
    titles.iter().map(|title| format!("\"{title}\"")).collect::<Vec<_>>().join(", ")
}

/// The specimens: blocks of rows, and in each what a column of names tells apart.
fn split(sheet: &Sheet, body: &Body, columns: &[Column]) -> Vec<Series> {
    let name_column = columns.iter().find(|column| column.kind == Kind::Specimen);
    let number = |block: usize| if body.blocks.len() > 1 { (block + 1).to_string() } else { String::new() };
    let Some(column) = name_column else { return blocks_of(body) };
    // What counts the rows names no specimens.
    if is_count(sheet, body, column.index) {
        return blocks_of(body);
    }
    let mut series: Vec<Series> = Vec::new();
    for (block, rows) in body.blocks.iter().enumerate() {
        for row in rows {
            let name = format!("{} {}", number(block), sheet.cell(*row, column.index));
            match series.iter_mut().rfind(|known| known.name == name.trim()) {
                Some(known) => known.rows.push(*row),
                None => series.push(Series { name: name.trim().into(), rows: vec![*row] }),
            }
        }
    }
    series
}

/// A series for each block of rows.
fn blocks_of(body: &Body) -> Vec<Series> {
    let name = |block: usize| if body.blocks.len() > 1 { (block + 1).to_string() } else { String::new() };
    let blocks = body.blocks.iter().enumerate();
    blocks.map(|(block, rows)| Series { name: name(block), rows: rows.clone() }).collect()
}

/// Whether column `index` has another value in every row, of the first ones.
fn is_count(sheet: &Sheet, body: &Body, index: usize) -> bool {
    let first: Vec<&str> = body.blocks.iter().flatten().take(200).map(|row| sheet.cell(*row, index)).collect();
    let distinct: std::collections::BTreeSet<&str> = first.iter().copied().collect();
    first.len() > 5 && distinct.len() == first.len()
}
