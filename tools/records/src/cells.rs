//! The cells of a line, by what separates them.

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
pub(crate) const SEPARATORS: [Separator; 5] =
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
    pub(crate) fn leaves_two(self, line: &str) -> bool {
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

pub(crate) fn starts_with_digit(cell: &str) -> bool {
    cell.trim_start_matches(['-', '+']).starts_with(|c: char| c.is_ascii_digit())
}

/// Whether a cell is a date, a time of day, or both.
pub(crate) fn is_date(cell: &str) -> bool {
    let legal = |c: char| c.is_ascii_digit() || matches!(c, '-' | '/' | ':' | '.' | ',' | ' ' | 'T' | 'Z');
    cell.chars().all(legal) && cell.matches([':', '/', '-', '.']).count() >= 2
}

/// The time of day in a cell such as 10:11:12.995, in s; a date may stand before it.
pub(crate) fn clock(cell: &str) -> Option<f64> {
    let time = match cell.trim_end_matches('Z').rsplit_once([' ', 'T']) {
        Some((date, time)) => Some(time).filter(|_| is_date(date))?,
        None => cell.trim_end_matches('Z'),
    };
    let mut parts = time.split(':');
    let [hours, minutes, seconds] = [parts.next()?, parts.next()?, parts.next()?];
    let (whole, fraction) = seconds.split_once(['.', ',']).unwrap_or((seconds, "0"));
    let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let legal = [hours, minutes, whole, fraction].into_iter().all(is_digits) && minutes.len() == 2 && whole.len() == 2;
    if !legal || parts.next().is_some() {
        return None;
    }
    let [hours, minutes, whole] = [hours, minutes, whole].map(|text| text.parse::<f64>().ok());
    let seconds = whole? + format!("0.{fraction}").parse::<f64>().ok()?;
    let minutes = minutes.filter(|minutes| *minutes < 60.0)?;
    Some(3600.0 * hours? + 60.0 * minutes + seconds).filter(|_| seconds < 61.0)
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn a_clock_is_read_in_seconds() {
        for (cell, seconds) in [
            ("10:11:12.995", Some(36672.995)),
            ("0:00:00,0125", Some(0.0125)),
            ("2024-05-02 10:11:12", Some(36672.0)),
            ("2024-05-02T10:11:12.5Z", Some(36672.5)),
            ("10:11", None),
            ("10:61:12", None),
            ("10:11:12:13", None),
            ("at 10:11:12", None),
            ("10:11:12.", None),
        ] {
            assert_eq!(clock(cell), seconds, "{cell}");
        }
    }
}
