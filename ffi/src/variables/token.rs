//! The token that binds a model description to the code that it describes.

use core::fmt::{self, Write};

use super::digest::digest;
use super::table::Table;

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
