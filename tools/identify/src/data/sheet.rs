//! The table of numbers in a text file: its separator and decimal sign, its titles, and its rows with their lines.

use super::ReadError;
use super::number::{self, Cell, Decimal};
use super::text;
use super::unit::{self, Unit};

/// A table.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Title of each column, with the unit of a row of units in brackets; empty if there is none.
    pub titles: Vec<String>,
    /// Everything else that the file says: comments and what stands above the titles.
    pub remarks: String,
    /// Decimal sign of the numbers.
    pub decimal: Decimal,
    /// Rows between repetitions of the titles.
    pub blocks: Vec<Vec<Row>>,
}

/// A row of a table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Line of the file, from 1.
    pub line: usize,
    /// Its cells as they stand there.
    pub cells: Vec<String>,
}

/// What may separate cells, the surest sign first.
const SEPARATORS: [Separator; 5] =
    [Separator::Sign(b'\t'), Separator::Sign(b';'), Separator::Sign(b'|'), Separator::Sign(b','), Separator::Blanks];

#[derive(Clone, Copy, PartialEq)]
enum Separator {
    Sign(u8),
    Blanks,
}

impl Separator {
    /// Whether a cell of `row` may be two numbers with a blank between them, of which a decimal comma separated a third.
    fn leaves_two(self, row: &Row) -> bool {
        self == Self::Sign(b',')
            && row.cells.iter().any(|cell| cell.contains(' ') && !is_date(cell) && starts_with_digit(cell))
    }

    /// The rows of `text`, without blank ones.
    fn split(self, text: &str) -> Vec<Row> {
        let Self::Sign(delimiter) = self else {
            let rows = text.lines().enumerate().map(|(index, line)| Row {
                line: index + 1,
                cells: line.split_whitespace().map(String::from).collect(),
            });
            return rows.filter(|row| !row.cells.is_empty()).collect();
        };
        // Line by line: an unpaired quote must not swallow the lines after it.
        let rows = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        rows.map(|(index, line)| Row { line: index + 1, cells: split_line(line, delimiter) })
            .filter(|row| row.cells.iter().any(|cell| !cell.is_empty()))
            .collect()
    }
}

fn starts_with_digit(cell: &str) -> bool {
    cell.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit())
}

fn split_line(line: &str, delimiter: u8) -> Vec<String> {
    if !line.contains('"') {
        return line.split(char::from(delimiter)).map(|cell| cell.trim().into()).collect();
    }
    let mut reader =
        csv::ReaderBuilder::new().delimiter(delimiter).has_headers(false).flexible(true).from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    match reader.read_record(&mut record) {
        Ok(true) => record.iter().map(|cell| cell.trim().into()).collect(),
        _ => Vec::new(),
    }
}

/// The table in `bytes`; `decimal` settles what the numbers leave open.
///
/// # Errors
/// No table, or a line in it that is no row of numbers.
pub fn parse(bytes: &[u8], decimal: Option<Decimal>) -> Result<Sheet, ReadError> {
    let (text, comments) = text::without_comments(&text::decode(bytes));
    let decimals = decimal.map_or(vec![Decimal::Point, Decimal::Comma], |decimal| vec![decimal]);
    let (mut best, mut most) = (None, 0);
    for separator in SEPARATORS {
        let rows = separator.split(&text);
        for &decimal in &decimals {
            let count = rows.iter().filter(|row| is_numeric(row, decimal) && !separator.leaves_two(row)).count();
            if count > most {
                (best, most) = (Some((rows.clone(), decimal)), count);
            }
        }
    }
    let (rows, decimal) = best.ok_or_else(|| no_table(&text))?;
    assemble(&text, &comments, rows, decimal)
}

fn no_table(text: &str) -> ReadError {
    let legal = "expected a table of numbers separated by tab ; , | or blanks, with units in its titles";
    match text.lines().enumerate().find(|(_, line)| starts_with_digit(line.trim_start_matches(['"', ' ']))) {
        Some((index, line)) => {
            let shown: String = line.trim().chars().take(60).collect();
            ReadError::line(index + 1, format!("\"{shown}\" is no row of two or more numbers: {legal}"))
        }
        None => ReadError::file(format!("no row of two or more numbers: {legal}")),
    }
}

/// Whether a row is one of numbers: at least two, beside them only names, dates and times of day.
fn is_numeric(row: &Row, decimal: Decimal) -> bool {
    let cells = || row.cells.iter().map(|cell| (cell, number::read(cell, decimal)));
    let name = |cell: &str| !cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ','));
    let numbers = cells().filter(|(_, read)| matches!(read, Cell::Number(_))).count();
    numbers >= 2 && cells().filter(|(_, read)| *read == Cell::Text).all(|(cell, _)| name(cell) || is_date(cell))
}

/// Whether a row says that its values are missing.
fn is_missing(row: &Row, decimal: Decimal) -> bool {
    let missing = |cell: &String| number::read(cell, decimal) == Cell::Missing;
    row.cells.iter().any(|cell| !cell.is_empty() && missing(cell))
        || row.cells.iter().all(|cell| missing(cell) || is_date(cell))
}

/// Whether a cell is a date, a time of day, or both.
fn is_date(cell: &str) -> bool {
    let legal = |c: char| c.is_ascii_digit() || matches!(c, '-' | '/' | ':' | '.' | ',' | ' ' | 'T' | 'Z');
    cell.chars().all(legal) && cell.matches([':', '/', '-', '.']).count() >= 2
}

fn assemble(text: &str, comments: &[(usize, String)], rows: Vec<Row>, decimal: Decimal) -> Result<Sheet, ReadError> {
    let first = first_row(&rows, decimal);
    let columns = rows[first].cells.len();
    let empty = |row: &&Row| row.cells.iter().all(|cell| number::read(cell, decimal) != Cell::Text);
    let above: Vec<Row> =
        rows[..first].iter().filter(|row| !empty(row) || is_row_of_units(&row.cells)).cloned().collect();
    let head = Head::find(text, comments, &above, rows[first].line, columns);
    let lines: Vec<&str> = text.lines().collect();
    let mut blocks = vec![Vec::new()];
    for row in rows.into_iter().skip(first) {
        if row.cells.iter().any(|cell| matches!(number::read(cell, decimal), Cell::Number(_))) {
            if let Some(block) = blocks.last_mut() {
                block.push(row);
            }
        } else if head.lines.iter().any(|&line| lines.get(line - 1) == lines.get(row.line - 1)) {
            if blocks.last().is_some_and(|block| !block.is_empty()) {
                blocks.push(Vec::new());
            }
        } else if !is_missing(&row, decimal) {
            let found = lines.get(row.line - 1).copied().unwrap_or_default().trim();
            let legal = "expected a row of numbers, a comment (#), or the titles again before the next specimen";
            return Err(ReadError::line(row.line, format!("\"{found}\" is refused: {legal}")));
        }
    }
    blocks.retain(|block| !block.is_empty());
    let above = lines.iter().take(head.start.saturating_sub(1)).copied();
    let remarks = comments.iter().map(|(_, comment)| comment.as_str()).chain(above).collect::<Vec<_>>().join("\n");
    Ok(Sheet { titles: head.titles, remarks, decimal, blocks })
}

/// The first row of the table: a row of numbers with another one of as many cells behind it, else the first.
fn first_row(rows: &[Row], decimal: Decimal) -> usize {
    let numeric = |index: usize| rows.get(index).is_some_and(|row| is_numeric(row, decimal));
    let followed = |index: &usize| numeric(index + 1) && rows[*index].cells.len() == rows[index + 1].cells.len();
    let candidates = || (0..rows.len()).filter(|index| numeric(*index));
    candidates().find(followed).or_else(|| candidates().next()).unwrap_or_default()
}

/// The titles and where they stand.
struct Head {
    titles: Vec<String>,
    /// Their lines, from 1.
    lines: Vec<usize>,
    /// First of their lines, or that of the table.
    start: usize,
}

impl Head {
    /// The titles among the rows `above` a table of `columns` whose first line is `table`.
    fn find(text: &str, comments: &[(usize, String)], above: &[Row], table: usize, columns: usize) -> Self {
        let line = |row: &Row| text.lines().nth(row.line - 1).unwrap_or_default();
        let last = above.last().map(|row| (row, cells_of(line(row), columns)));
        match last {
            Some((row, Some(units))) if is_row_of_units(&units) => {
                let names = above.iter().rev().nth(1);
                let titles = names.and_then(|names| cells_of(line(names), columns));
                let start = names.filter(|_| titles.is_some()).map_or(row.line, |names| names.line);
                let merged = units.iter().enumerate().map(|(index, unit)| {
                    let name = titles.as_ref().and_then(|titles| titles.get(index)).map_or("", String::as_str);
                    format!("{name} [{}]", bare(unit))
                });
                Self { titles: merged.collect(), lines: (start..=row.line).collect(), start }
            }
            Some((row, Some(titles))) => Self { titles, lines: vec![row.line], start: row.line },
            _ => {
                // As numpy writes it: the titles are the last comment above the numbers; or one comment for each.
                let above = || comments.iter().filter(|(line, _)| *line < table);
                let last = above().next_back().and_then(|(_, comment)| cells_of(comment, columns));
                let titles =
                    numbered(above().map(|(_, comment)| comment.as_str()), columns).or(last).unwrap_or_default();
                Self { titles, lines: Vec::new(), start: table }
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

/// `line` as a row of `columns` cells, by whichever separator makes that many of it; empty cells at the end do not count.
fn cells_of(line: &str, columns: usize) -> Option<Vec<String>> {
    let wide: Vec<String> =
        line.trim().split("  ").map(str::trim).filter(|c| !c.is_empty()).map(String::from).collect();
    let signs = SEPARATORS.iter().map(|separator| match separator {
        Separator::Sign(sign) => split_line(line.trim_end(), *sign),
        Separator::Blanks => line.split_whitespace().map(String::from).collect(),
    });
    let fits = |cells: &Vec<String>| {
        let filled = cells.iter().rposition(|cell| !cell.is_empty()).map_or(0, |last| last + 1);
        cells.len() >= 2 && filled <= columns && cells.len() >= columns
    };
    signs.chain([wide]).find(fits)
}

fn bare(unit: &str) -> &str {
    unit.trim().trim_matches(['[', ']', '(', ')', '<', '>'])
}

fn is_row_of_units(cells: &[String]) -> bool {
    let filled = || cells.iter().filter(|cell| !cell.is_empty()).map(|cell| bare(cell));
    filled().any(|unit| Unit::parse(unit).is_some()) && filled().all(unit::is_unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(text: &str) -> Sheet {
        parse(text.as_bytes(), None).unwrap()
    }

    fn numbers(sheet: &Sheet) -> Vec<Vec<f64>> {
        let read = |cell: &String| match number::read(cell, sheet.decimal) {
            Cell::Number(number) => number,
            _ => f64::NAN,
        };
        sheet.blocks.iter().flatten().map(|row| row.cells.iter().map(read).collect()).collect()
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
        ] {
            let sheet = sheet(text);
            assert_eq!(sheet.titles, ["strain", "stress"], "{text}");
            assert_eq!(numbers(&sheet), [[0.1, 0.2], [0.3, 0.4]], "{text}");
        }
    }

    #[test]
    fn a_head_of_a_test_machine_is_passed_over() {
        let text =
            "Test;Compression;;\nSpecimen Length (mm);33;;\n\nTime;Strain;Stress\n(s);(%);(MPa)\n0;0,5;1\n1;0,7;2\n";
        let sheet = sheet(text);
        assert_eq!(sheet.titles, ["Time [s]", "Strain [%]", "Stress [MPa]"]);
        assert_eq!(numbers(&sheet), [[0.0, 0.5, 1.0], [1.0, 0.7, 2.0]]);
        assert!(sheet.remarks.contains("Compression"));
    }

    #[test]
    fn rows_of_missing_values_above_the_table_are_no_titles() {
        assert_eq!(sheet("a;b\nnan;nan\n0.1;nan\n1;2\n3;4\n").titles, ["a", "b"]);
        assert_eq!(sheet("a;b\n-;MPa\n1;2\n3;4\n").titles, ["a [-]", "b [MPa]"]);
        assert_eq!(sheet("t,E,T\ns,MPa,°C\n1,2,3\n3,4,5\n").titles, ["t [s]", "E [MPa]", "T [°C]"]);
    }

    #[test]
    fn a_comment_for_each_column_is_its_title() {
        let text = "% made by a program\n% column 1: Time [s]\n% column 2: True Strain\n%\n1 2\n3 4\n";
        assert_eq!(sheet(text).titles, ["Time [s]", "True Strain"]);
    }

    #[test]
    fn titles_again_begin_another_block() {
        let sheet = sheet("a,b\n1,2\n3,4\na,b\n5,6\n");
        assert_eq!(sheet.blocks.iter().map(Vec::len).collect::<Vec<_>>(), [2, 1]);
    }

    #[test]
    fn a_line_that_is_no_row_is_refused_by_its_number() {
        let error = parse(b"a,b\n1,2\n3,4\nend of test\n", None).unwrap_err();
        assert!(error.to_string().starts_with("line 4: \"end of test\" is refused"), "{error}");
        for empty in ["", "strain,stress\n", "hello\nworld\n", "# only a comment"] {
            assert!(parse(empty.as_bytes(), None).is_err(), "{empty}");
        }
    }

    #[test]
    fn names_dates_and_missing_values_stand_beside_numbers() {
        let sheet =
            sheet("date;by;a;b\n2024-01-02 10:00:00;me;1,5;2\n02.01.2024;me;nan;-\n-;-;-;-\n3.1.2024;you;2;3\n");
        assert_eq!(sheet.titles, ["date", "by", "a", "b"]);
        assert_eq!(sheet.blocks[0].len(), 2);
    }

    #[test]
    fn a_blank_is_no_group_of_thousands_beside_a_decimal_comma() {
        assert_eq!(numbers(&sheet("a b\n10 200,5\n20 300,5\n")), [[10.0, 200.5], [20.0, 300.5]]);
        assert_eq!(numbers(&sheet("a;b\n1;1 200,5\n2;1 300,5\n")), [[1.0, 1200.5], [2.0, 1300.5]]);
    }

    #[test]
    fn what_is_no_table_is_refused_at_its_first_line_of_digits() {
        let error = parse(b"strain;stress\n10 %;0.2 MPa\n", None).unwrap_err().to_string();
        assert!(error.starts_with("line 2: \"10 %;0.2 MPa\" is no row"), "{error}");
    }

    #[test]
    fn numbers_without_titles_have_none() {
        assert!(sheet("1.0 2.0\n3.0 4.0\n").titles.is_empty());
    }
}
