//! Sheets of workbooks as lines of text, with tabs between the cells: XLSX, XLSB, XLS and ODS, read by the library calamine.
//!
//! A crate of its own, because what is generic in that library is compiled where it is used, and need not be optimised.

use std::io::Cursor;

use calamine::{Data, DataRef, Range, Reader, Sheets, open_workbook_auto_from_rs};

/// Cells of a sheet, at most, empty ones among them: a file of a few bytes may claim any number.
const MAX_CELLS: u64 = 30_000_000;

/// Bytes of a compressed workbook, at most.
const MAX_BYTES: usize = 200_000_000;

/// Bytes of a workbook when it is unpacked, at most: a small archive may hold any number.
const MAX_UNPACKED: u128 = 2_000_000_000;

/// The size that the archive in `bytes` states; none if it is no archive.
fn unpacked_size(bytes: &[u8]) -> Option<u128> {
    zip::ZipArchive::new(Cursor::new(bytes)).ok()?.decompressed_size()
}

/// Whether `bytes` are those of a workbook: a zip archive, or the container of older ones.
pub fn is_workbook(bytes: &[u8]) -> bool {
    bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1, 0x1a, 0xe1])
}

/// A workbook that is open.
pub struct Workbook<'a>(Sheets<Cursor<&'a [u8]>>);

impl<'a> Workbook<'a> {
    /// Opens the workbook in `bytes`.
    ///
    /// # Errors
    /// No workbook, or too large a one.
    pub fn open(bytes: &'a [u8]) -> Result<Self, String> {
        if bytes.len() > MAX_BYTES {
            return Err(format!("a workbook of {} bytes: expected {MAX_BYTES} at most", bytes.len()));
        }
        if let Some(size) = unpacked_size(bytes).filter(|size| *size > MAX_UNPACKED) {
            return Err(format!("a workbook of {size} bytes when it is unpacked: expected {MAX_UNPACKED} at most"));
        }
        let refuse = |error: calamine::Error| format!("this is no workbook that can be read: {error}");
        open_workbook_auto_from_rs(Cursor::new(bytes)).map(Self).map_err(refuse)
    }

    /// Names of the sheets.
    pub fn names(&self) -> Vec<String> {
        self.0.sheet_names()
    }

    /// The sheet `name` as text: a line for each row, tabs between the cells, numbers with all their digits.
    ///
    /// # Errors
    /// A sheet that cannot be read, or of too many cells.
    pub fn text(&mut self, name: &str) -> Result<String, String> {
        rows(&mut self.0, name)
    }
}

fn rows(workbook: &mut Sheets<Cursor<&[u8]>>, name: &str) -> Result<String, String> {
    let refuse = |error: &dyn std::fmt::Display| format!("sheet \"{name}\" cannot be read: {error}");
    match workbook {
        // Cell by cell: a range would hold every cell between the first and the last.
        Sheets::Xlsx(workbook) => {
            let mut cells = workbook.worksheet_cells_reader(name).map_err(|error| refuse(&error))?;
            let mut text = Text::default();
            while let Some(cell) = cells.next_cell().map_err(|error| refuse(&error))? {
                text.push(cell.get_position(), &shown_of(cell.get_value()))?;
            }
            Ok(text.text)
        }
        Sheets::Xlsb(workbook) => {
            let mut cells = workbook.worksheet_cells_reader(name).map_err(|error| refuse(&error))?;
            let mut text = Text::default();
            while let Some(cell) = cells.next_cell().map_err(|error| refuse(&error))? {
                text.push(cell.get_position(), &shown_of(cell.get_value()))?;
            }
            Ok(text.text)
        }
        Sheets::Xls(workbook) => of_range(&workbook.worksheet_range(name).map_err(|error| refuse(&error))?),
        Sheets::Ods(workbook) => of_range(&workbook.worksheet_range(name).map_err(|error| refuse(&error))?),
    }
}

fn of_range(range: &Range<Data>) -> Result<String, String> {
    let (first_row, first_column) = range.start().unwrap_or_default();
    let mut text = Text::default();
    for (row, column, value) in range.used_cells() {
        text.push((first_row + row as u32, first_column + column as u32), &shown(value))?;
    }
    Ok(text.text)
}

/// Cells in the order of rows, as text.
#[derive(Default)]
struct Text {
    text: String,
    row: u32,
    column: u32,
    cells: u64,
}

impl Text {
    fn push(&mut self, (row, column): (u32, u32), value: &str) -> Result<(), String> {
        let lines = row.saturating_sub(self.row);
        let tabs = if lines > 0 { column } else { column.saturating_sub(self.column) };
        self.cells += u64::from(lines) + u64::from(tabs);
        if self.cells > MAX_CELLS {
            return Err(format!("more than {MAX_CELLS} cells: expected a table of measured data"));
        }
        self.text.extend(std::iter::repeat_n('\n', lines as usize));
        self.text.extend(std::iter::repeat_n('\t', tabs as usize));
        self.text.push_str(value);
        (self.row, self.column) = (row, column);
        Ok(())
    }
}

/// A value as a cell of text: numbers with all their digits, text in one line.
fn shown(value: &Data) -> String {
    match value {
        Data::Int(number) => number.to_string(),
        Data::Float(number) => number.to_string(),
        Data::String(text) | Data::DateTimeIso(text) | Data::DurationIso(text) => one_line(text),
        Data::Bool(value) => value.to_string(),
        Data::DateTime(time) => time.as_f64().to_string(),
        Data::Error(_) => "#N/A".into(),
        _ => String::new(),
    }
}

fn shown_of(value: &DataRef) -> String {
    match value {
        DataRef::Int(number) => number.to_string(),
        DataRef::Float(number) => number.to_string(),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => one_line(text),
        DataRef::SharedString(text) => one_line(text),
        DataRef::Bool(value) => value.to_string(),
        DataRef::DateTime(time) => time.as_f64().to_string(),
        DataRef::Error(_) => "#N/A".into(),
        _ => String::new(),
    }
}

/// Text without tabs and line ends. A quotation mark at its beginning would swallow the cells behind it.
fn one_line(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ").replace('"', "”")
}
