//! From the bytes of a file to its lines: UTF-8 or UTF-16 with or without their marks, or Latin-1.

use std::borrow::Cow;

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE, WINDOWS_1252};

use super::ReadError;

/// The lines of a text, with any kind of line end.
#[derive(Clone, Debug)]
pub struct Lines {
    text: String,
    /// Where each line begins.
    starts: Vec<usize>,
    /// Name of the encoding that was decoded.
    pub encoding: &'static str,
}

impl Lines {
    /// The lines of the text in `bytes`.
    ///
    /// # Errors
    /// Bytes that are no text.
    pub fn new(bytes: &[u8]) -> Result<Self, ReadError> {
        let (text, encoding) = decode(bytes)?;
        Ok(Self::of(text.into_owned(), encoding))
    }

    /// The lines of `text`, of an `encoding` that is named only.
    pub fn of(text: String, encoding: &'static str) -> Self {
        let bytes = text.as_bytes();
        let mut starts = vec![0];
        for (index, byte) in bytes.iter().enumerate() {
            let ends = *byte == b'\n' || *byte == b'\r' && bytes.get(index + 1) != Some(&b'\n');
            if ends && index + 1 < bytes.len() {
                starts.push(index + 1);
            }
        }
        Self { text, starts, encoding }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.starts.len()
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// Line `number`, from 1, without its end; empty if there is none.
    pub fn get(&self, number: usize) -> &str {
        let Some(start) = number.checked_sub(1).and_then(|index| self.starts.get(index)) else { return "" };
        let end = self.starts.get(number).copied().unwrap_or(self.text.len());
        self.text[*start..end].trim_end_matches(['\n', '\r'])
    }
}

/// The text in `bytes` and the name of its encoding.
fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, &'static str), ReadError> {
    let (encoding, mark) = Encoding::for_bom(bytes).unwrap_or_else(|| (unmarked(bytes), 0));
    // The standard library's check of UTF-8 is the faster one.
    let (text, wrong) = match std::str::from_utf8(&bytes[mark..]) {
        Ok(text) if encoding == UTF_8 => (Cow::Borrowed(text), false),
        _ => encoding.decode_without_bom_handling(&bytes[mark..]),
    };
    // Text has no zeros, and no file of a table has control characters.
    if wrong || text.chars().take(4096).any(|c| matches!(c, '\0'..='\x08' | '\x0e'..='\x1a')) {
        let legal = "expected text in UTF-8, UTF-16 or Latin-1, or a workbook (XLSX, XLS, ODS)";
        return Err(ReadError::file(format!("this is no text: {legal}")));
    }
    let name = if encoding == WINDOWS_1252 { "Latin-1 (Windows-1252)" } else { encoding.name() };
    Ok((text, name))
}

/// The encoding of text without a mark.
fn unmarked(bytes: &[u8]) -> &'static Encoding {
    // UTF-16 of western text has a zero in every other byte.
    match bytes {
        [0, second, ..] if *second != 0 => UTF_16BE,
        [first, 0, ..] if *first != 0 => UTF_16LE,
        _ if std::str::from_utf8(bytes).is_ok() => UTF_8,
        // Every byte is a character of it, so a stray µ or ° cannot stop the reading.
        _ => WINDOWS_1252,
    }
}

/// What `line` says as a comment: it begins with #, // or !, or with a % that is no unit of a first column, neither
/// a separator nor a row of units following.
pub fn comment(line: &str) -> Option<&str> {
    let start = line.trim_start().trim_start_matches('"');
    let percent = start.strip_prefix('%').is_some_and(is_comment);
    let marked = start.starts_with(['#', '!']) && !is_error(start) || start.starts_with("//") || percent;
    marked.then(|| start.trim_start_matches(['#', '/', '%', '!', ' ']).trim_end_matches('"'))
}

/// Whether `text` begins with the error of a spreadsheet's cell, such as #N/A.
fn is_error(text: &str) -> bool {
    ["#N/A", "#NV", "#VALUE", "#DIV", "#NUM", "#REF", "#NAME"].iter().any(|error| text.starts_with(error))
}

/// Whether what follows a % is a comment.
fn is_comment(rest: &str) -> bool {
    let separated = rest.trim_start_matches(' ').starts_with([';', ',', '\t', '|', '"']);
    let mut words = rest.split_whitespace().peekable();
    let units = words.peek().is_some() && words.all(|word| super::unit::Unit::parse(word).is_some());
    !(separated || units)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_gives_the_same_text() {
        let text = "strain [%];Dehnung µ\n1;2";
        let utf16: Vec<u8> = [0xfeff_u16].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        let big: Vec<u8> = [0xfeff_u16].into_iter().chain(text.encode_utf16()).flat_map(u16::to_be_bytes).collect();
        let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
        let marked: Vec<u8> = "\u{feff}".bytes().chain(text.bytes()).collect();
        for bytes in [text.as_bytes(), &utf16, &big, &utf16[2..], &big[2..], &latin, &marked] {
            assert_eq!(Lines::new(bytes).unwrap().text, text);
        }
    }

    #[test]
    fn lines_end_as_they_may() {
        for text in ["a\nb\n\nc", "a\r\nb\r\n\r\nc\r\n", "a\rb\r\rc\r"] {
            let lines = Lines::of(text.into(), "");
            assert_eq!((lines.len(), lines.get(1), lines.get(2), lines.get(3), lines.get(4)), (4, "a", "b", "", "c"));
            assert_eq!((lines.get(0), lines.get(5)), ("", ""));
        }
    }

    #[test]
    fn comments_have_their_marks() {
        for (line, expected) in [
            ("# compression", Some("compression")),
            ("// x", Some("x")),
            ("% note", Some("note")),
            ("%;MPa", None),
            ("% MPa", None),
            ("#N/A;1", None),
            ("1;2", None),
        ] {
            assert_eq!(comment(line), expected, "{line}");
        }
    }

    #[test]
    fn binary_is_no_text() {
        for bytes in
            [&b"PK\x03\x04rest"[..], &[0, 0, 1, 2, 3, 4], &[0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1, 0x1a, 0xe1, 0, 0]]
        {
            assert!(Lines::new(bytes).unwrap_err().to_string().contains("this is no text"));
        }
    }
}
