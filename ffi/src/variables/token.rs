//! The token that binds a model description to the code that it describes.

use core::fmt::Write;

use heapless::String;

use super::digest::digest;
use super::table::Table;

/// Characters of a token.
const LENGTH: usize = 38;

/// Digest of the table in the form of a GUID: the same variables, ranges and start values give the same token.
pub fn token() -> String<LENGTH> {
    let table = Table::new();
    let [a, b] = [1, 2].map(|seed| digest(seed, table.rows()));
    let mut token = String::new();
    // A GUID has as many characters as there is room for.
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
