//! The digest of the table of variables.

use softanvil_kernel::number::digest::Digest;
use softanvil_kernel::parameter::Name;

use super::variable::{ValueType, Variable, Version};

/// Digest of everything that a master can know of the table, and of the version.
pub(super) fn digest(seed: u64, rows: &[Variable]) -> u64 {
    let mut digest = Digest::new();
    digest.word(seed);
    text(&mut digest, env!("CARGO_PKG_VERSION"));
    for variable in rows {
        row(&mut digest, variable);
    }
    digest.value()
}

fn row(digest: &mut Digest, variable: &Variable) {
    digest.word(u64::from(variable.reference));
    name(digest, variable.name);
    for item in [
        variable.description,
        variable.value.name(Version::Fmi3),
        variable.causality(),
        variable.variability(),
        variable.initial().unwrap_or_default(),
    ] {
        text(digest, item);
    }
    digest.number(variable.start().unwrap_or_default());
    match variable.value {
        ValueType::Real { unit, range } => {
            text(digest, unit);
            let (min, max) = range.unwrap_or_default();
            digest.number(min);
            digest.number(max);
        }
        ValueType::Enumeration { labels } => labels.iter().for_each(|label| text(digest, label)),
        ValueType::Array { unit } => text(digest, unit),
        ValueType::Integer { range: Some((min, max)) } => {
            [min, max].into_iter().for_each(|limit| digest.number(f64::from(limit)))
        }
        ValueType::Size { range: (min, max) } => [min, max].into_iter().for_each(|limit| digest.word(limit)),
        ValueType::Integer { range: None } | ValueType::Boolean | ValueType::String => {}
    }
}

/// A name by its parts.
fn name(digest: &mut Digest, name: Name) {
    digest.word(name.layer().map_or(0, |layer| layer as u64 + 1));
    text(digest, name.group());
    text(digest, name.field());
}

/// Length and bytes, so that two texts cannot run into each other.
fn text(digest: &mut Digest, text: &str) {
    digest.word(text.len() as u64);
    for chunk in text.as_bytes().chunks(8) {
        let mut word = [0; 8];
        word.iter_mut().zip(chunk).for_each(|(to, from)| *to = *from);
        digest.word(u64::from_le_bytes(word));
    }
}
