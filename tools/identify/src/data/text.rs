//! From the bytes of a file to text: UTF-8 or UTF-16 with or without their marks, or Latin-1.

use super::unit::Unit;

/// The text in `bytes`.
pub fn decode(bytes: &[u8]) -> String {
    match bytes {
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        // Text has no zeros; UTF-16 of western text has one in every other byte.
        [0, second, ..] if *second != 0 => utf16(bytes, u16::from_be_bytes),
        [first, 0, ..] if *first != 0 => utf16(bytes, u16::from_le_bytes),
        // Every byte is a character of Latin-1, so a stray µ or ° cannot stop the reading.
        _ => String::from_utf8(bytes.into()).unwrap_or_else(|_| bytes.iter().copied().map(char::from).collect()),
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units: Vec<u16> = bytes.as_chunks::<2>().0.iter().copied().map(unit).collect();
    String::from_utf16_lossy(&units)
}

/// `text` with one kind of line end and its comments as blank lines, so that line numbers stay.
///
/// Returns the comments with their lines beside it. A comment begins with # or //, or with a % that
/// is no unit of a first column: neither a separator nor a row of units follows.
pub fn without_comments(text: &str) -> (String, Vec<(usize, String)>) {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let (mut lines, mut comments) = (Vec::new(), Vec::new());
    for (index, line) in text.split('\n').enumerate() {
        let start = line.trim_start();
        let percent = start.strip_prefix('%').is_some_and(is_comment);
        if start.starts_with('#') || start.starts_with("//") || percent {
            comments.push((index + 1, start.trim_start_matches(['#', '/', '%', ' ']).to_string()));
            lines.push("");
        } else {
            lines.push(line);
        }
    }
    (lines.join("\n"), comments)
}

/// Whether what follows a % is a comment.
fn is_comment(rest: &str) -> bool {
    let separated = rest.trim_start_matches(' ').starts_with([';', ',', '\t', '|']);
    let mut words = rest.split_whitespace().peekable();
    let units = words.peek().is_some() && words.all(|word| Unit::parse(word).is_some());
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
            assert_eq!(decode(bytes), text);
        }
    }

    #[test]
    fn comments_leave_their_line_behind() {
        let (text, comments) = without_comments("# compression\r\na,b\r%;MPa\n// x\n% note\n1,2\n% MPa");
        assert_eq!(text, "\na,b\n%;MPa\n\n\n1,2\n% MPa");
        assert_eq!(comments, [(1, "compression".into()), (4, "x".into()), (5, "note".into())]);
    }
}
