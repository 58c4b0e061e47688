//! Percentages of ODS, which the library gives as plain numbers: a hundredth of what people see under a title in per cent.

use std::io::{Cursor, Read, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

const CONTENT: &str = "content.xml";
const PERCENTAGE: &str = "office:value-type=\"percentage\"";
const VALUE: &str = " office:value=\"";
/// What the library takes as a text that nobody has typed.
const SHOWN: &str = " office:time-value=\"";

/// The spreadsheet in `bytes` with its percentages as they are shown, with all their digits: `10%`; none if it has none, or is none.
pub(super) fn shown(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).ok()?;
    let mut content = String::new();
    archive.by_name(CONTENT).ok()?.read_to_string(&mut content).ok()?;
    if !content.contains(PERCENTAGE) {
        return None;
    }
    let mut written = ZipWriter::new(Cursor::new(Vec::new()));
    for index in 0..archive.len() {
        let file = archive.by_index_raw(index).ok()?;
        if file.name().ok()? != CONTENT {
            written.raw_copy_file(file).ok()?;
        }
    }
    written.start_file(CONTENT, SimpleFileOptions::default().compression_method(CompressionMethod::Stored)).ok()?;
    written.write_all(in_content(&content).as_bytes()).ok()?;
    Some(written.finish().ok()?.into_inner())
}

/// The text of the spreadsheet with its percentages as they are shown.
fn in_content(content: &str) -> String {
    let (mut text, mut rest) = (String::with_capacity(content.len()), content);
    while let Some(found) = rest.find(PERCENTAGE) {
        let start = rest[..found].rfind('<').unwrap_or(found);
        let end = found + end_of_tag(&rest[found..]);
        text.push_str(&rest[..start]);
        text.push_str(&in_tag(&rest[start..end]));
        rest = &rest[end..];
    }
    text + rest
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

fn in_tag(tag: &str) -> String {
    let changed = || {
        let (before, value) = tag.split_once(VALUE)?;
        let (number, after) = value.split_once('"')?;
        let number: f64 = number.parse().ok()?;
        Some(format!("{before}{SHOWN}{}%\"{after}", 100.0 * number))
    };
    changed().unwrap_or_else(|| tag.to_string())
}
