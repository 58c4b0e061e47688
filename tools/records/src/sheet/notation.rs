//! How the rows of numbers in a file are written: separator, decimal sign, and what else may stand in them.

use crate::ReadError;
use crate::cells::{Cells, SEPARATORS, Separator, clock, is_date};
use crate::facts;
use crate::number::{self, Cell, Decimal};
use crate::text::{self, Lines};

/// Lines at the beginning that tell how numbers are written, and as many throughout a longer file.
const SAMPLE: usize = 2000;

/// How rows of numbers are written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Notation {
    pub separator: Separator,
    pub decimal: Decimal,
    /// Numbers in a row, at least.
    pub least: usize,
    /// Columns of metadata on the left of the numbers, as Tektronix writes them.
    pub beside: usize,
}

impl Notation {
    /// The notation that the file states, or else by which most lines of a sample are rows of numbers.
    ///
    /// # Errors
    /// Numbers that all have two meanings.
    pub fn find(lines: &Lines, decimal: Option<Decimal>, cells: Option<Separator>) -> Result<Option<Self>, ReadError> {
        if let Some((separator, stated)) = facts::notation_of_labview(lines) {
            return Ok(Some(Self { separator, decimal: decimal.unwrap_or(stated), least: 1, beside: 0 }));
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
        if let (Some(best), None) = (&mut best, decimal) {
            best.decimal = best.told_decimal(lines)?;
        }
        Ok(best.map(|best| Self { beside, ..best }))
    }

    /// The decimal sign, where cells with groups of three digits have two meanings: that which other cells tell, or a point where
    /// commas separate the cells.
    fn told_decimal(&self, lines: &Lines) -> Result<Decimal, ReadError> {
        let is_row = |line: &&str| {
            let of = |decimal| is_numeric(self.separator.cells(line), decimal, self.least);
            text::comment(line).is_none() && (of(Decimal::Point) || of(Decimal::Comma))
        };
        let (mut told, mut unclear) = ([false; 2], None);
        for number in 1..=lines.len() {
            for cell in Some(lines.get(number)).filter(is_row).into_iter().flat_map(|line| self.separator.cells(line)) {
                match number::told(cell) {
                    Some(decimal) => told[usize::from(decimal == Decimal::Comma)] = true,
                    None if unclear.is_none() => unclear = number::two_meanings(cell).map(|both| (number, cell, both)),
                    None => {}
                }
            }
            // What both signs tell is left to the number of rows.
            if told[0] && told[1] || (told[0] || told[1]) && number >= SAMPLE {
                break;
            }
        }
        match (told, unclear) {
            ([true, true], _) | (_, None) => Ok(self.decimal),
            ([true, false], _) => Ok(Decimal::Point),
            ([false, true], _) => Ok(Decimal::Comma),
            _ if self.separator == Separator::Sign(b',') => Ok(Decimal::Point),
            (_, Some((line, cell, [a, b]))) => {
                let reason = format!(
                    "\"{cell}\" is {a} with a decimal point and {b} with a decimal comma, and no other number tells which: \
                     expected --decimal point or --decimal comma"
                );
                Err(ReadError::line(line, reason))
            }
        }
    }
}

/// Whether cells are a row of numbers: `least` or more, of which one may be a time of day, beside them only names and dates.
pub(super) fn is_numeric<'a>(cells: impl Iterator<Item = &'a str>, decimal: Decimal, least: usize) -> bool {
    let (mut numbers, mut clocks) = (0, 0);
    for cell in cells {
        match number::read(cell, decimal) {
            Cell::Number(_) => numbers += 1,
            Cell::Missing => {}
            Cell::Text if number::percentage(cell, decimal).is_some() => numbers += 1,
            Cell::Text if clock(cell).is_some() => clocks = 1,
            Cell::Text if is_name(cell) || is_date(cell) => {}
            Cell::Text => return false,
        }
    }
    numbers > 0 && numbers + clocks >= least
}

fn is_name(cell: &str) -> bool {
    !cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ','))
}

/// Whether a row says that its values are missing.
pub(super) fn is_missing(cells: Cells, decimal: Decimal) -> bool {
    let missing = |cell: &str| number::read(cell, decimal) == Cell::Missing;
    cells.clone().any(|cell| !cell.is_empty() && missing(cell))
        || cells.clone().all(|cell| missing(cell) || is_date(cell))
}

/// Whether `line` has only what numbers are written with, and a digit among it: nearly every row of a table.
pub(super) fn is_plain(line: &str, separator: Separator) -> bool {
    let sign = if let Separator::Sign(sign) = separator { sign } else { b' ' };
    let of_numbers = |c: u8| {
        c.is_ascii_digit() || matches!(c, b'.' | b',' | b'-' | b'+' | b'e' | b'E' | b' ' | b'\t' | b'"') || c == sign
    };
    line.bytes().all(of_numbers) && line.bytes().any(|c| c.is_ascii_digit())
}
