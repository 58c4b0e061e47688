//! The token that binds a model description to the code that it describes.

use core::fmt::{self, Write};

use softanvil_kernel::digest::Digest;

use super::{Table, ValueType, Variable, Version};

/// Digest of the table in the form of a GUID: the same variables, ranges and start values give the same token.
pub fn token() -> Token {
    let table = Table::new();
    let [a, b] = [1, 2].map(|seed| digest(seed, table.rows()));
    let mut token = Token { text: [0; LENGTH], length: 0 };
    let _ = write!(
        token,
        "{{{:08x}-{:04x}-{:04x}-{:04x}-{:012x}}}",
        a >> 32,
        a >> 16 & 0xffff,
        a & 0xffff,
        b >> 48,
        b & 0xffff_ffff_ffff
    );
    token
}

/// Characters of a token.
const LENGTH: usize = 38;

/// A token, in memory of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    text: [u8; LENGTH],
    length: usize,
}

impl Token {
    /// The characters.
    pub fn as_bytes(&self) -> &[u8] {
        self.text.get(..self.length).unwrap_or_default()
    }

    /// The text.
    pub fn as_str(&self) -> &str {
        core::str::from_utf8(self.as_bytes()).unwrap_or_default()
    }
}

impl Write for Token {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let room = self.text.get_mut(self.length..self.length + text.len()).ok_or(fmt::Error)?;
        room.copy_from_slice(text.as_bytes());
        self.length += text.len();
        Ok(())
    }
}

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
    for item in [
        variable.name,
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
        ValueType::Size { range: (min, max) } => [min, max].into_iter().for_each(|limit| digest.word(limit)),
        ValueType::Integer | ValueType::Boolean | ValueType::String => {}
    }
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
