//! Files changed as people and programs get them wrong: by words, numbers, cells and lines, and by bytes.

use arbitrary::{Result, Unstructured};
use softanvil_kernel::Parameter;

/// What is put in the place of words.
const WORDS: [&str; 48] = [
    "NaN",
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e-320",
    "1e999",
    "0",
    "-0",
    "-1",
    "1",
    "0.1",
    "1,5",
    "1.234,5",
    "18446744073709551616",
    "-9223372036854775809",
    "0x7f",
    "1_000",
    "true",
    "\"",
    "\"\"\"",
    "'",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    ";",
    "\t",
    "\n",
    "\r",
    " ",
    "#",
    "%",
    "mm",
    "kN",
    "ms",
    "µs",
    "[s]",
    "e",
    "\u{feff}",
    "\u{0}",
    "layers",
    "[[layers]]",
];

/// Edits of one file, at most.
const MOST: usize = 12;
/// Bytes of a file, at most: what readers do grows with it.
const LONGEST: usize = 1 << 14;

/// One of the `seeds`, edited as `choices` say; in one of eight cases the rest of the choices as it is.
pub fn edited(seeds: &[Vec<u8>], choices: &mut Unstructured) -> Result<Vec<u8>> {
    let way: u8 = choices.arbitrary()?;
    if way % 8 == 7 {
        return choices.bytes(choices.len()).map(<[u8]>::to_vec);
    }
    let seed = choices.choose(seeds)?;
    let mut bytes = seed[..seed.len().min(LONGEST)].to_vec();
    for _ in 0..MOST {
        if choices.is_empty() || bytes.len() > 2 * LONGEST {
            break;
        }
        edit(&mut bytes, choices)?;
    }
    Ok(bytes)
}

/// The same as text, with what is no text replaced.
pub fn edited_text(seeds: &[Vec<u8>], choices: &mut Unstructured) -> Result<String> {
    Ok(String::from_utf8_lossy(&edited(seeds, choices)?).into_owned())
}

fn edit(bytes: &mut Vec<u8>, choices: &mut Unstructured) -> Result<()> {
    let at = choices.int_in_range(0..=bytes.len())?;
    let word = word_around(bytes, at);
    let line = line_around(bytes, at);
    match choices.int_in_range(0..=11)? {
        0..=3 => drop(bytes.splice(word, replacement(choices)?)),
        4 => {
            let other = word_around(bytes, choices.int_in_range(0..=bytes.len())?);
            let copy = bytes[other].to_vec();
            bytes.splice(word, copy);
        }
        5 => drop(bytes.drain(word)),
        6 => drop(bytes.drain(line)),
        7 => {
            let copy = bytes[line.clone()].to_vec().repeat(choices.int_in_range(1..=8)?);
            bytes.splice(line.end..line.end, copy);
        }
        8 => {
            let other = choices.int_in_range(0..=bytes.len())?;
            let copy = bytes[line].to_vec();
            let start = line_around(bytes, other).start;
            bytes.splice(start..start, copy);
        }
        9 => drop(bytes.splice(at..at, replacement(choices)?)),
        10 => bytes.truncate(at),
        _ => {
            let byte: u8 = choices.arbitrary()?;
            if at < bytes.len() { bytes[at] = byte } else { bytes.push(byte) }
        }
    }
    Ok(())
}

/// A word, a number, or the name of a parameter or of one of its choices.
fn replacement(choices: &mut Unstructured) -> Result<Vec<u8>> {
    Ok(match choices.int_in_range(0..=7)? {
        0..=3 => (*choices.choose(&WORDS)?).into(),
        4 => f64::from_bits(choices.arbitrary()?).to_string().into_bytes(),
        5 => (f64::from(choices.arbitrary::<i16>()?) * 1e-3).to_string().into_bytes(),
        kind => {
            let number = choices.int_in_range(0..=Parameter::COUNT - 1)?;
            let parameter = Parameter::all().nth(number).unwrap();
            let labels = parameter.labels();
            match labels.is_empty() || kind == 6 {
                true => parameter.name().to_string().rsplit('.').next().unwrap_or_default().into(),
                false => format!("\"{}\"", choices.choose(labels)?).into_bytes(),
            }
        }
    })
}

/// Where the word at a place begins and ends; a single byte if there is none.
fn word_around(bytes: &[u8], at: usize) -> std::ops::Range<usize> {
    let is_part = |byte: &u8| byte.is_ascii_alphanumeric() || b"._+-".contains(byte) || !byte.is_ascii();
    let before = bytes[..at].iter().rev().take_while(|byte| is_part(byte)).count();
    let after = bytes[at..].iter().take_while(|byte| is_part(byte)).count();
    if before + after == 0 { at..(at + 1).min(bytes.len()) } else { at - before..at + after }
}

/// Where the line at a place begins and ends, with its end.
fn line_around(bytes: &[u8], at: usize) -> std::ops::Range<usize> {
    let start = bytes[..at].iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
    let end = bytes[at..].iter().position(|byte| *byte == b'\n').map_or(bytes.len(), |end| at + end + 1);
    start..end
}
