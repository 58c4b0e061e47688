//! Numbers as test machines write them.

use std::str::FromStr;

/// Which sign stands before the fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// 0.5
    Point,
    /// 0,5
    Comma,
}

impl FromStr for Decimal {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "point" => Ok(Self::Point),
            "comma" => Ok(Self::Comma),
            _ => Err("expected point or comma".into()),
        }
    }
}

/// What instruments write for a value beyond their range (SCPI 1999.0, volume 1, 7.2.1.4), and for none (7.2.1.5). No unit makes a number
/// below it infinite.
const BEYOND_RANGE: f64 = 9.9e37;
const NOT_A_NUMBER: f64 = 9.91e37;

/// What a cell of a table holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number below 9.9e37, which instruments write for one beyond their range.
    Number(f64),
    /// Nothing, or a word or a number (9.91e37) that says so.
    Missing,
    /// Anything else.
    Text,
}

/// Reads a cell. The other decimal sign, a blank or an apostrophe may stand between groups of thousands.
pub fn read(cell: &str, decimal: Decimal) -> Cell {
    if let Some(number) = simple(cell, decimal) {
        return Cell::Number(number);
    }
    let text = cell.trim().trim_matches('\u{a0}');
    if text.chars().all(|c| matches!(c, '-' | '–' | '—')) || MISSING.iter().any(|word| text.eq_ignore_ascii_case(word))
    {
        return Cell::Missing;
    }
    let text = joined(&with_e(&text.replace('−', "-")));
    let plain = match decimal {
        Decimal::Point => ungrouped(&text, ',', '.'),
        Decimal::Comma => ungrouped(&text, '.', ',').map(|number| number.replace(',', ".")),
    };
    match plain.map(|number| number.parse::<f64>()) {
        Some(Ok(number)) if number == NOT_A_NUMBER => Cell::Missing,
        Some(Ok(number)) if is_in_range(number) && !text.contains(char::is_alphabetic) => Cell::Number(number),
        Some(Ok(number)) if is_in_range(number) && has_exponent(&text) => Cell::Number(number),
        _ => Cell::Text,
    }
}

fn is_in_range(number: f64) -> bool {
    number.abs() < BEYOND_RANGE
}

/// The part of one in a cell such as 10 %.
pub fn percentage(cell: &str, decimal: Decimal) -> Option<f64> {
    match read(cell.trim().strip_suffix('%')?, decimal) {
        Cell::Number(number) => Some(0.01 * number),
        _ => None,
    }
}

/// The decimal sign that a cell tells, as a number that is none by the other sign.
pub fn told(cell: &str) -> Option<Decimal> {
    match [Decimal::Point, Decimal::Comma].map(|decimal| matches!(read(cell, decimal), Cell::Number(_))) {
        [true, false] => Some(Decimal::Point),
        [false, true] => Some(Decimal::Comma),
        _ => None,
    }
}

/// Whether a cell is one number with a decimal point and another with a comma, as 1,234 is: both of them.
pub fn two_meanings(cell: &str) -> Option<[f64; 2]> {
    match [Decimal::Point, Decimal::Comma].map(|decimal| read(cell, decimal)) {
        [Cell::Number(a), Cell::Number(b)] if a != b => Some([a, b]),
        _ => None,
    }
}

/// The number in a cell of digits, signs, an exponent and at most one decimal sign, as nearly all are.
fn simple(cell: &str, decimal: Decimal) -> Option<f64> {
    let cell = cell.trim_ascii();
    let only =
        |sign: u8| cell.bytes().all(|c| c.is_ascii_digit() || matches!(c, b'-' | b'+' | b'e' | b'E') || c == sign);
    let number = match decimal {
        Decimal::Point if only(b'.') => cell.parse().ok(),
        Decimal::Comma if only(b',') => {
            let mut copy = [0; LONGEST];
            let copy = copy.get_mut(..cell.len())?;
            copy.copy_from_slice(cell.as_bytes());
            copy.iter_mut().filter(|c| **c == b',').for_each(|c| *c = b'.');
            std::str::from_utf8(copy).ok()?.parse().ok()
        }
        _ => None,
    };
    number.filter(|number: &f64| is_in_range(*number))
}

/// Bytes of a simple number, at most.
const LONGEST: usize = 40;

/// Words of spreadsheets and programs for a value that is not there.
const MISSING: [&str; 20] = [
    "nan",
    "-nan",
    "nan(ind)",
    "-nan(ind)",
    "-1.#ind",
    "1.#qnan",
    "n/a",
    "#n/a",
    "#nv",
    "#value!",
    "#div/0!",
    "na",
    "null",
    "none",
    "missing",
    "noval",
    "novalue",
    "k.a.",
    "nd",
    "#num!",
];

/// `text` with E for the D of a Fortran exponent, as in 1.5D-03.
fn with_e(text: &str) -> String {
    match text.split_once(['D', 'd']) {
        Some((number, exponent))
            if number.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ','))
                && exponent.trim_start_matches(['-', '+']).chars().all(|c| c.is_ascii_digit())
                && exponent.ends_with(|c: char| c.is_ascii_digit()) =>
        {
            format!("{number}E{exponent}")
        }
        _ => text.into(),
    }
}

/// `text` without blanks or apostrophes between its groups of thousands; as it is if they stand anywhere else.
fn joined(text: &str) -> String {
    let is_gap = |c: char| matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’');
    let end = text.find(['.', ',']).unwrap_or(text.len());
    let mut groups = text[..end].trim_start_matches(['-', '+']).split(is_gap);
    let first = groups.next().unwrap_or_default();
    let digits = |group: &str| group.chars().all(|c| c.is_ascii_digit());
    let grouped = (1..=3).contains(&first.len()) && digits(first);
    match grouped && groups.all(|group| group.len() == 3 && digits(group)) && !text[end..].contains(is_gap) {
        true => text.replace(is_gap, ""),
        false => text.into(),
    }
}

/// `text` without its groups of thousands; none if a `group` sign stands anywhere else.
fn ungrouped(text: &str, group: char, decimal: char) -> Option<String> {
    if !text.contains(group) {
        return Some(text.into());
    }
    let (whole, fraction) = text.split_once(decimal).unwrap_or((text, ""));
    let mut groups = whole.trim_start_matches(['-', '+']).split(group);
    let first = groups.next()?;
    let digits = |group: &str| group.chars().all(|c| c.is_ascii_digit());
    let grouped = (1..=3).contains(&first.len()) && !first.starts_with('0') && digits(first);
    (grouped && groups.all(|group| group.len() == 3 && digits(group)) && !fraction.contains(group))
        .then(|| text.replace(group, ""))
}

/// Whether the only letter is the e of an exponent ("inf" parses as a number, too).
fn has_exponent(text: &str) -> bool {
    text.chars().filter(|c| c.is_alphabetic()).all(|c| matches!(c, 'e' | 'E'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_both_conventions() {
        for (text, decimal, number) in [
            ("0.5", Decimal::Point, 0.5),
            (" -1.2E-3 ", Decimal::Point, -1.2e-3),
            ("−3", Decimal::Point, -3.0),
            ("1,234.5", Decimal::Point, 1234.5),
            ("0,5", Decimal::Comma, 0.5),
            ("1.234,5", Decimal::Comma, 1234.5),
            ("1,2e-3", Decimal::Comma, 1.2e-3),
            ("+7", Decimal::Comma, 7.0),
            ("1,234", Decimal::Point, 1234.0),
            ("-12.345.678", Decimal::Comma, -12345678.0),
            ("1 234.5", Decimal::Point, 1234.5),
            ("-12\u{202f}345\u{a0}678", Decimal::Comma, -12345678.0),
            ("1'234,5", Decimal::Comma, 1234.5),
            ("1.50000D-03", Decimal::Point, 1.5e-3),
            ("-2,5d+02", Decimal::Comma, -250.0),
        ] {
            assert_eq!(read(text, decimal), Cell::Number(number), "{text}");
        }
    }

    #[test]
    fn a_group_alone_has_two_meanings() {
        assert_eq!(two_meanings("54,711"), Some([54711.0, 54.711]));
        assert_eq!(two_meanings("54.711"), Some([54.711, 54711.0]));
        for (text, decimal) in [
            ("0,711", Some(Decimal::Comma)),
            ("54,71", Some(Decimal::Comma)),
            ("1.234,5", Some(Decimal::Comma)),
            ("1.234.567", Some(Decimal::Comma)),
            ("1234.567", Some(Decimal::Point)),
            ("54711", None),
            ("word", None),
        ] {
            assert_eq!((two_meanings(text), told(text)), (None, decimal), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_not_taken_for_one() {
        for (text, decimal) in [
            ("0,123", Decimal::Point),
            ("1,2345", Decimal::Point),
            ("1.234e3", Decimal::Comma),
            ("1234.567", Decimal::Comma),
            ("1;0", Decimal::Point),
            ("inf", Decimal::Point),
            ("12 mm", Decimal::Point),
            ("1,23,4.5", Decimal::Point),
            ("1 23.4", Decimal::Point),
            ("0.1 0.2", Decimal::Point),
            ("infinity", Decimal::Comma),
            ("3D", Decimal::Point),
            ("1e999", Decimal::Point),
            ("-1e308", Decimal::Point),
            ("9.9E+37", Decimal::Point),
            ("9,9e37", Decimal::Comma),
        ] {
            assert_eq!(read(text, decimal), Cell::Text, "{text}");
        }
        for text in ["", "  ", "NaN", "n/a", "-", "---", "-nan", "#N/A", "9.91E+37", "9.91e37"] {
            assert_eq!(read(text, Decimal::Point), Cell::Missing, "{text}");
        }
    }
}
