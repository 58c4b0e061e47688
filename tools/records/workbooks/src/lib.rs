//! Sheets of workbooks as lines of text, with tabs between the cells: XLSX, XLSB, XLS and ODS, read by the library calamine.
//!
//! A crate of its own, because what is generic in that library is compiled where it is used, and need not be optimised.

mod percentages;

use std::borrow::Cow;
use std::io::Cursor;

use calamine::{Data, DataRef, ExcelDateTime, Range, Reader, Sheets, Style, open_workbook_auto_from_rs};

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
pub struct Workbook<'a>(Sheets<Cursor<Cow<'a, [u8]>>>);

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
        let bytes = percentages::shown(bytes)?.map_or(Cow::Borrowed(bytes), Cow::Owned);
        open_workbook_auto_from_rs(Cursor::new(bytes)).map(Self).map_err(refuse)
    }

    /// Names of the sheets.
    pub fn names(&self) -> Vec<String> {
        self.0.sheet_names()
    }

    /// The sheet `name` as text: a line for each row, tabs between the cells, numbers with all their digits, times and durations as
    /// 10:11:12.995, percentages of XLSX and ODS with their sign, and [`TYPED`] before a text that begins as a number does.
    ///
    /// # Errors
    /// A sheet that cannot be read, or of too many cells.
    pub fn text(&mut self, name: &str) -> Result<String, String> {
        rows(&mut self.0, name)
    }
}

fn rows(workbook: &mut Sheets<Cursor<Cow<[u8]>>>, name: &str) -> Result<String, String> {
    let refuse = |error: &dyn std::fmt::Display| format!("sheet \"{name}\" cannot be read: {error}");
    match workbook {
        // Cell by cell: a range would hold every cell between the first and the last.
        Sheets::Xlsx(workbook) => {
            let mut cells = workbook.worksheet_cells_reader(name).map_err(|error| refuse(&error))?;
            let percent: Vec<bool> = cells.styles().iter().map(is_percent).collect();
            let mut text = Text::default();
            while let Some((cell, style)) = cells.next_cell_with_style_id().map_err(|error| refuse(&error))? {
                let shown = match cell.get_value() {
                    DataRef::Float(number) if percent.get(style) == Some(&true) => format!("{}%", 100.0 * number),
                    value => shown_of(value),
                };
                text.push(cell.get_position(), &shown)?;
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
        // The library's count of a row beyond every sheet wraps around, to one of the first.
        if (row, column) < (self.row, self.column) {
            return Err(format!("row {} stands after row {}: expected cells in their order", row + 1, self.row + 1));
        }
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
        Data::String(text) => typed(text),
        Data::DateTimeIso(text) => one_line(text),
        Data::DurationIso(text) => of_duration(text).unwrap_or_else(|| one_line(text)),
        Data::Bool(value) => value.to_string(),
        Data::DateTime(time) => of_time(time),
        Data::Error(_) => "#N/A".into(),
        _ => String::new(),
    }
}

fn shown_of(value: &DataRef) -> String {
    match value {
        DataRef::Int(number) => number.to_string(),
        DataRef::Float(number) => number.to_string(),
        DataRef::String(text) => typed(text),
        DataRef::SharedString(text) => typed(text),
        DataRef::DateTimeIso(text) => one_line(text),
        DataRef::DurationIso(text) => of_duration(text).unwrap_or_else(|| one_line(text)),
        DataRef::Bool(value) => value.to_string(),
        DataRef::DateTime(time) => of_time(time),
        DataRef::Error(_) => "#N/A".into(),
        _ => String::new(),
    }
}

/// Stands before a text that begins as a number does: somebody typed it with whatever decimal sign.
pub const TYPED: char = '\u{1}';

fn typed(text: &str) -> String {
    let text = one_line(text);
    let is_number =
        text.trim_start().starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ',' | '−'));
    if is_number { format!("{TYPED}{text}") } else { text }
}

/// Whether numbers of `style` are shown as percentages.
fn is_percent(style: &Style) -> bool {
    let Some(format) = &style.number_format else { return false };
    let (mut quoted, mut escaped) = (false, false);
    format.format_code.chars().any(|c| {
        let plain = !quoted && !escaped;
        quoted ^= c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        plain && c == '%'
    })
}

/// A time or a duration, in days, as hours, minutes and seconds; a date alone as a date.
fn of_time(time: &ExcelDateTime) -> String {
    let days = time.as_f64();
    if time.is_datetime() && days >= 1.0 && days.fract() == 0.0 {
        let (year, month, day, ..) = time.to_ymd_hms_milli();
        return format!("{year}-{month:02}-{day:02}");
    }
    if days.is_nan() || days < 0.0 { days.to_string() } else { clock(86_400.0 * days) }
}

/// The clock of `seconds`, to a nanosecond.
fn clock(seconds: f64) -> String {
    const SECOND: u128 = 1_000_000_000;
    let count = (seconds * SECOND as f64).round() as u128;
    let (whole, fraction) = (count / SECOND, count % SECOND);
    format!("{:02}:{:02}:{:02}.{fraction:09}", whole / 3600, whole / 60 % 60, whole % 60)
}

/// The clock of a duration such as PT1H2M3.5S.
fn of_duration(text: &str) -> Option<String> {
    let mut rest = text.strip_prefix("PT")?.strip_suffix('S')?;
    let mut seconds = 0.0;
    for (sign, length) in [('H', 3600.0), ('M', 60.0)] {
        if let Some((number, behind)) = rest.split_once(sign) {
            seconds += length * number.parse::<f64>().ok()?;
            rest = behind;
        }
    }
    seconds += rest.replace(',', ".").parse::<f64>().ok()?;
    (seconds.is_finite() && seconds >= 0.0).then(|| clock(seconds))
}

/// Text without tabs and line ends. A quotation mark at its beginning would swallow the cells behind it.
fn one_line(text: &str) -> String {
    text.replace(['\t', '\n', '\r', TYPED], " ").replace('"', "”")
}
