//! The table of numbers in a text file: its separator and decimal sign, its titles, and its rows with their lines.

use super::ReadError;
use super::number::{self, Cell, Decimal};
use super::text;
use super::unit::Unit;

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

fn split_line(line: &str, delimiter: u8) -> Vec<String> {
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
            let count = rows.iter().filter(|row| is_numeric(row, decimal)).count();
            if count > most {
                (best, most) = (Some((rows.clone(), decimal)), count);
            }
        }
    }
    let (rows, decimal) = best.ok_or_else(|| {
        ReadError::file("no row of two or more numbers: legal is a table of numbers separated by tab ; , | or blanks")
    })?;
    assemble(&text, &comments, rows, decimal)
}

/// Whether a row is one of numbers: at least two, and at most one cell of another kind (a specimen's name).
fn is_numeric(row: &Row, decimal: Decimal) -> bool {
    let count = |wanted: fn(&Cell) -> bool| row.cells.iter().filter(|c| wanted(&number::read(c, decimal))).count();
    let texts = row.cells.iter().filter(|cell| number::read(cell, decimal) == Cell::Text);
    let name = |cell: &String| !cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ','));
    let numbers = count(|cell| matches!(cell, Cell::Number(_)));
    numbers >= 2 && texts.clone().count() <= 1 && texts.clone().all(name)
}

fn assemble(text: &str, comments: &[(usize, String)], rows: Vec<Row>, decimal: Decimal) -> Result<Sheet, ReadError> {
    let first = first_row(&rows, decimal);
    let columns = rows[first].cells.len();
    let head = Head::find(text, comments, &rows[..first], rows[first].line, columns);
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
        } else {
            let found = lines.get(row.line - 1).copied().unwrap_or_default().trim();
            let legal = "legal is a row of numbers, a comment (#), or the titles again before the next specimen";
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
                // As numpy writes it: the titles are the last comment above the numbers.
                let comment = comments.iter().rev().find(|(line, _)| *line < table);
                let titles = comment.and_then(|(_, comment)| cells_of(comment, columns)).unwrap_or_default();
                Self { titles, lines: Vec::new(), start: table }
            }
        }
    }
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
    let mut filled = cells.iter().filter(|cell| !cell.is_empty()).peekable();
    filled.peek().is_some() && filled.all(|cell| Unit::parse(bare(cell)).is_some())
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
    fn numbers_without_titles_have_none() {
        assert!(sheet("1.0 2.0\n3.0 4.0\n").titles.is_empty());
    }
}
