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
}
