//! Percentages of ODS, which the library gives as plain numbers: a hundredth of what people see under a title in per cent.

use std::io::{Cursor, Read, Write};

use zip::result::ZipResult;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

const CONTENT: &str = "content.xml";
const KIND: &str = "office:value-type=";
const PERCENTAGE: &str = "percentage";
const VALUE: &str = "office:value=";
/// What the library takes as a text that nobody has typed.
const SHOWN: &str = "office:time-value=";

/// Bytes of the cells of a spreadsheet, at most, whatever its archive states.
const MAX_CONTENT: u64 = 1_000_000_000;

/// The spreadsheet in `bytes` with its percentages as they are shown, with all their digits: `10%`; none if it has none, or is none.
///
/// # Errors
/// Too large a spreadsheet, or one that cannot be written again.
pub(super) fn shown(bytes: &[u8]) -> Result<Option<Vec<u8>>, String> {
    let Some(content) = content(bytes) else { return Ok(None) };
    if content.len() as u64 > MAX_CONTENT {
        return Err(format!(
            "a workbook whose cells are more than {MAX_CONTENT} bytes: expected a table of measured data"
        ));
    }
    if !places(&content).any(|(_, kind)| kind == PERCENTAGE) {
        return Ok(None);
    }
    let text = in_content(&content);
    drop(content);
    let refuse = |error| format!("percentages of this workbook cannot be read: {error}");
    with_content(bytes, &text).map(Some).map_err(refuse)
}

/// The cells of the spreadsheet in `bytes`, and a byte more than there may be at most; none of what is no spreadsheet.
fn content(bytes: &[u8]) -> Option<String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).ok()?;
    let mut content = String::new();
    archive.by_name(CONTENT).ok()?.take(MAX_CONTENT + 1).read_to_string(&mut content).ok()?;
    Some(content)
}

/// The archive in `bytes` with other cells.
fn with_content(bytes: &[u8], content: &str) -> ZipResult<Vec<u8>> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))?;
    let mut written = ZipWriter::new(Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let file = archive.by_index_raw(index)?;
        if file.name()? != CONTENT {
            written.raw_copy_file(file)?;
        }
    }
    written.start_file(CONTENT, SimpleFileOptions::default().compression_method(CompressionMethod::Stored))?;
    written.write_all(content.as_bytes())?;
    Ok(written.finish()?.into_inner())
}

/// Where each cell says of which kind it is, and which.
fn places(content: &str) -> impl Iterator<Item = (usize, &str)> {
    content.match_indices(KIND).filter_map(|(place, _)| Some((place, quoted(&content[place + KIND.len()..])?.1)))
}

/// The quote that `text` begins with, and what stands between it and the next one.
fn quoted(text: &str) -> Option<(char, &str)> {
    let quote = text.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    text[1..].split_once(quote).map(|(inside, _)| (quote, inside))
}

/// The text of the spreadsheet with its percentages as they are shown.
fn in_content(content: &str) -> String {
    let (mut text, mut done) = (String::with_capacity(content.len()), 0);
    for (place, _) in places(content).filter(|(_, kind)| *kind == PERCENTAGE) {
        let start = content[..place].rfind('<').unwrap_or(place).max(done);
        let end = place + end_of_tag(&content[place..]);
        text.push_str(&content[done..start]);
        text.push_str(&in_tag(&content[start..end]));
        done = end;
    }
    text + &content[done..]
}

/// Length of what is left of a tag from the start of one of its attributes on.
fn end_of_tag(rest: &str) -> usize {
    let mut quote = None;
    let ends = |(_, c): &(usize, char)| {
        match quote {
            Some(mark) if *c == mark => quote = None,
            None if matches!(c, '"' | '\'') => quote = Some(*c),
            _ => {}
        }
        quote.is_none() && *c == '>'
    };
    rest.char_indices().find(ends).map_or(rest.len(), |(place, _)| place)
}

/// The tag of a cell with its value as a text in per cent; as it is without a number.
fn in_tag(tag: &str) -> String {
    let changed = || {
        let (before, after) = tag.split_once(VALUE)?;
        let (quote, number) = quoted(after)?;
        let percent = 100.0 * number.parse::<f64>().ok()?;
        let rest = &after[number.len() + 2..];
        Some(format!("{before}{SHOWN}{quote}{percent}%{quote}{rest}"))
    };
    changed().unwrap_or_else(|| tag.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentages_alone_are_rewritten_however_their_tags_are_quoted() {
        let plain = r#"<c office:value-type="float" office:value="0.1"><p>0.1</p></c>"#;
        let cells = [
            (
                r#"<c office:value-type="percentage" office:value="0.1"/>"#,
                r#"<c office:value-type="percentage" office:time-value="10%"/>"#,
            ),
            (
                r"<c office:value='2.5e-1' office:value-type='percentage'>",
                r"<c office:time-value='25%' office:value-type='percentage'>",
            ),
            (r#"<c f="A1>0" office:value-type="percentage">"#, r#"<c f="A1>0" office:value-type="percentage">"#),
        ];
        for (given, expected) in cells {
            assert_eq!(in_content(&format!("{plain}{given}{plain}")), format!("{plain}{expected}{plain}"));
        }
        assert_eq!(in_content(plain), plain);
        assert_eq!(in_content("office:value-type=\"percentage"), "office:value-type=\"percentage");
    }
}
