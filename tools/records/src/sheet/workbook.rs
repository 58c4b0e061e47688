//! The tables in a workbook: XLSX, XLSB, XLS or ODS.

use softanvil_workbooks::{TYPED, Workbook};

use super::assembly::of_lines;
use super::table::{Layout, Sheet};
use crate::ReadError;
use crate::cells::Separator;
use crate::number::{self, Cell, Decimal};
use crate::text::Lines;

/// The tables in the workbook `bytes`, in the sheet that `layout` names, or in the only one that has any.
///
/// # Errors
/// No workbook, no such sheet, several sheets with tables, or what [`of_lines`] refuses.
pub fn parse(bytes: &[u8], layout: &Layout) -> Result<Sheet, ReadError> {
    let mut workbook = Workbook::open(bytes).map_err(ReadError::file)?;
    let names = workbook.names();
    if let Some(name) = &layout.sheet {
        let Some(name) = names.iter().find(|known| *known == name) else {
            return Err(ReadError::file(format!("--sheet {name} is refused: expected {}", quoted(&names))));
        };
        return table(&mut workbook, name, layout.decimal);
    }
    let mut found = Vec::new();
    let mut refused = None;
    for name in &names {
        match table(&mut workbook, name, layout.decimal) {
            Ok(sheet) => found.push(sheet),
            Err(error) => refused = refused.or(Some((name, error))),
        }
    }
    match (found.len(), refused) {
        (1, _) => Ok(found.remove(0)),
        (0, Some((name, error))) => Err(ReadError::file(format!("sheet \"{name}\": {error}"))),
        (0, None) => Err(ReadError::file("a workbook without sheets")),
        _ => {
            let names: Vec<String> = found.iter().filter_map(|sheet| sheet.name.clone()).collect();
            Err(ReadError::file(format!("tables in the sheets {}: name one with --sheet", quoted(&names))))
        }
    }
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ")
}

/// The tables in the sheet `name`: its rows as lines, with tabs between the cells.
fn table(workbook: &mut Workbook, name: &str, decimal: Option<Decimal>) -> Result<Sheet, ReadError> {
    let text = untyped(workbook.text(name).map_err(ReadError::file)?, decimal)?;
    let lines = Lines::of(text, "workbook");
    let mut sheet = of_lines(lines, Some(Decimal::Point), Some(Separator::Sign(b'\t')))?;
    sheet.name = Some(name.into());
    Ok(sheet)
}

/// `text` with the numbers in its rows that are typed as text written as others are: by `decimal`, or by the sign that they tell.
fn untyped(text: String, decimal: Option<Decimal>) -> Result<String, ReadError> {
    if !text.contains(TYPED) {
        return Ok(text);
    }
    let decimal = match decimal {
        Some(decimal) => Some(decimal),
        None => told(&text)?,
    };
    let number = |cell: &str| -> Option<String> {
        let cell = cell.strip_prefix(TYPED)?;
        match number::read(cell, number::told(cell).filter(|_| decimal.is_none()).or(decimal)?) {
            Cell::Number(number) => Some(number.to_string()),
            _ => None,
        }
    };
    let line = |line: &str| -> String {
        let rewritten = |cell: &str| number(cell).unwrap_or_else(|| cell.trim_start_matches(TYPED).to_string());
        match is_row(line) {
            true => line.split('\t').map(rewritten).collect::<Vec<_>>().join("\t"),
            false => line.replace(TYPED, ""),
        }
    };
    Ok(text.split('\n').map(line).collect::<Vec<_>>().join("\n"))
}

/// The decimal sign that the typed numbers of `text` tell; none if some tell the one and some the other.
fn told(text: &str) -> Result<Option<Decimal>, ReadError> {
    let (mut found, mut unclear) = (Vec::new(), None);
    for (index, line) in text.split('\n').enumerate().filter(|(_, line)| is_row(line)) {
        for cell in line.split('\t').filter_map(|cell| cell.strip_prefix(TYPED)) {
            match number::told(cell) {
                Some(decimal) if !found.contains(&decimal) => found.push(decimal),
                None if unclear.is_none() => unclear = number::two_meanings(cell).map(|_| (index + 1, cell)),
                _ => {}
            }
        }
    }
    match (found.as_slice(), unclear) {
        ([decimal], _) => Ok(Some(*decimal)),
        ([], None) => Ok(Some(Decimal::Point)),
        (_, None) => Ok(None),
        (_, Some((line, cell))) => {
            let reason =
                format!("\"{cell}\", typed as text, has two meanings: expected --decimal point or --decimal comma");
            Err(ReadError::line(line, reason))
        }
    }
}

/// Whether `line` has two numbers or more, typed ones among them.
fn is_row(line: &str) -> bool {
    let is_number = |cell: &&str| {
        let plain = cell.trim_start_matches(TYPED);
        [Decimal::Point, Decimal::Comma].iter().any(|decimal| matches!(number::read(plain, *decimal), Cell::Number(_)))
    };
    line.split('\t').filter(is_number).count() >= 2
}
