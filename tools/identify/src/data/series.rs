//! The columns of a table in SI units, one set for each specimen in the file.

use super::ReadError;
use super::column::{self, Column, Kind};
use super::number::{self, Cell, Decimal};
use super::sheet::{Row, Sheet};

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
    /// The columns that a fit may need.
    pub columns: Vec<Column>,
    /// What else the file says, with its titles.
    pub words: String,
    /// The specimens.
    pub series: Vec<Series>,
    decimal: Decimal,
}

impl Table {
    /// Understands `sheet`; `titles` stand instead of its own, a minus sign for a column to be passed over.
    ///
    /// # Errors
    /// Titles that are missing, too many or not understood.
    pub fn new(sheet: Sheet, titles: Option<&[String]>) -> Result<Self, ReadError> {
        let width = sheet.blocks.first().and_then(|rows| rows.first()).map_or(0, |row| row.cells.len());
        let titles = match titles {
            Some(given) if given.len() > width => {
                let reason = format!("--columns names {} columns, the table has {width}", given.len());
                return Err(ReadError::file(reason));
            }
            Some(given) => given.iter().map(|title| if title == "-" { "" } else { title.as_str() }).collect(),
            None => sheet.titles.iter().map(String::as_str).collect::<Vec<_>>(),
        };
        if titles.is_empty() {
            let reason = format!("the {width} columns have no titles: name them with --columns, such as \"{EXAMPLE}\"");
            return Err(ReadError::file(reason));
        }
        let mut columns = Vec::new();
        let mut unclear = Vec::new();
        for (index, title) in titles.iter().enumerate() {
            match Column::recognise(index, title) {
                Ok(column) => columns.extend(column),
                Err(reason) => unclear.push(reason),
            }
        }
        if columns.iter().filter(|column| column.kind.dimension().is_some()).count() < 2 {
            if column::are_dynamic(titles.iter().copied()) {
                return Err(ReadError::file(DYNAMIC));
            }
            let reason = unclear.into_iter().next().unwrap_or_else(|| {
                format!(
                    "no two columns understood among {}: name them with --columns, such as \"{EXAMPLE}\"",
                    list(&titles)
                )
            });
            return Err(ReadError::file(reason));
        }
        let words = format!("{}\n{}", titles.join("\n"), sheet.remarks);
        let series = split(&sheet, &columns);
        Ok(Self { columns, words, series, decimal: sheet.decimal })
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
        let cell = row.cells.get(column.index).map_or("", String::as_str);
        match number::read(cell, self.decimal) {
            Cell::Number(number) => Ok(Some(number)),
            Cell::Missing => Ok(None),
            Cell::Text => {
                let sign = if self.decimal == Decimal::Point { "point" } else { "comma" };
                let reason =
                    format!("{} = \"{cell}\" is refused: expected a number with a decimal {sign}", column.title);
                Err(ReadError::line(row.line, reason))
            }
        }
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

/// What is said of storage and loss moduli.
pub const DYNAMIC: &str = "a test with oscillations (storage and loss moduli over frequency) is not read: expected a relaxation, \
                           a modulus, stress or force over time";

const EXAMPLE: &str = "strain [%], stress [kPa]";

fn list(titles: &[&str]) -> String {
    titles.iter().map(|title| format!("\"{title}\"")).collect::<Vec<_>>().join(", ")
}

/// The specimens: blocks of rows, and in each what a column of names tells apart.
fn split(sheet: &Sheet, columns: &[Column]) -> Vec<Series> {
    let name_column = columns.iter().find(|column| column.kind == Kind::Specimen);
    let mut series: Vec<Series> = Vec::new();
    for (block, rows) in sheet.blocks.iter().enumerate() {
        for row in rows {
            let own = name_column.and_then(|column| row.cells.get(column.index)).map_or("", String::as_str);
            let name =
                if sheet.blocks.len() > 1 { format!("{} {own}", block + 1).trim().into() } else { own.to_string() };
            match series.iter_mut().find(|known| known.name == name) {
                Some(known) => known.rows.push(row.clone()),
                None => series.push(Series { name, rows: vec![row.clone()] }),
            }
        }
    }
    series
}
