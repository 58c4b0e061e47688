//! Channels as crash and impact tests name them: codes of ISO/TS 13499, and how they are filtered.

use std::fmt;

use super::kind::Kind;

/// How a channel was filtered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filter {
    /// Not at all, or by the amplifier alone.
    Unfiltered,
    /// By a channel frequency class, Hz (SAE J211, ISO 6487).
    Class(u32),
    /// Somehow.
    Filtered,
}

impl fmt::Display for Filter {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Unfiltered => write!(f, "unfiltered"),
            Self::Class(class) => write!(f, "CFC {class}"),
            Self::Filtered => write!(f, "filtered"),
        }
    }
}

/// What a channel code says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Code {
    /// What the channel holds; none for what is not needed.
    pub kind: Option<Kind>,
    /// How it was filtered.
    pub filter: Option<Filter>,
}

/// The code of ISO/TS 13499 in `title`: 16 signs, of which the 13th and 14th are the quantity and the last the filter.
pub fn code(title: &str) -> Option<Code> {
    let is_code = |word: &&str| {
        let of_code = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit();
        word.len() == 16 && word.chars().all(of_code) && word.contains(|c: char| c.is_ascii_uppercase())
    };
    let code = title.split(|c: char| !c.is_ascii_alphanumeric()).find(is_code)?;
    let kind = match &code[12..14] {
        "FO" => Some(Kind::Force),
        "AC" => Some(Kind::Acceleration),
        "DS" => Some(Kind::Displacement),
        "TI" => Some(Kind::Time),
        _ => None,
    };
    let filter = match &code[15..] {
        "0" | "P" => Some(Filter::Unfiltered),
        "A" => Some(Filter::Class(1000)),
        "B" => Some(Filter::Class(600)),
        "C" => Some(Filter::Class(180)),
        "D" => Some(Filter::Class(60)),
        _ => None,
    };
    Some(Code { kind, filter })
}

/// How `title` says that its channel was filtered.
pub fn filter(title: &str) -> Option<Filter> {
    if let Some(code) = code(title) {
        return code.filter;
    }
    let text = title.to_lowercase();
    if let Some((_, after)) = text.split_once("cfc") {
        let digits: String =
            after.trim_start_matches([' ', '_', '-', '=']).chars().take_while(char::is_ascii_digit).collect();
        return Some(digits.parse().map_or(Filter::Filtered, Filter::Class));
    }
    let has = |words: &[&str]| words.iter().any(|word| text.contains(word));
    let is = |name: &str| text.split(|c: char| !c.is_alphanumeric()).any(|word| word == name);
    if has(&["unfilter", "ungefiltert", "non filtr", "sin filtr"]) || is("raw") || is("roh") || is("brut") {
        Some(Filter::Unfiltered)
    } else if has(&["filter", "filtr", "smooth", "geglättet", "butterworth", "lowpass", "low-pass"]) {
        Some(Filter::Filtered)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_tell_quantity_and_filter() {
        let code = |title| code(title).map(|code| (code.kind, code.filter));
        assert_eq!(code("11HEAD0000H3ACXA"), Some((Some(Kind::Acceleration), Some(Filter::Class(1000)))));
        assert_eq!(code("D0HEAD0000PAFOZP [N]"), Some((Some(Kind::Force), Some(Filter::Unfiltered))));
        assert_eq!(code("11HEAD0000H3AVXD"), Some((None, Some(Filter::Class(60)))));
        assert_eq!(code("acceleration [g]"), None);
        assert_eq!(code("0000000000000000"), None);
    }

    #[test]
    fn words_tell_the_filter() {
        for (title, expected) in [
            ("Force CFC600 [N]", Some(Filter::Class(600))),
            ("Fz_CFC_180", Some(Filter::Class(180))),
            ("Kraft ungefiltert", Some(Filter::Unfiltered)),
            ("Force (raw)", Some(Filter::Unfiltered)),
            ("Force filtered", Some(Filter::Filtered)),
            ("Force [N]", None),
        ] {
            assert_eq!(filter(title), expected, "{title}");
        }
    }
}
