//! FNV-1a, 64 bit, over little-endian bytes: the fingerprint of scenarios, traces and snapshots.
//!
//! It detects change and corruption; it is no protection against an adversary.

use crate::number::real::{self, Real};

/// A running digest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

impl Digest {
    /// The digest of nothing.
    pub const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Continues from [`Digest::value`].
    pub const fn resume(value: u64) -> Self {
        Self(value)
    }

    /// Takes in eight bytes, least significant first.
    pub fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Takes in the bits of a number.
    pub fn number(&mut self, number: Real) {
        self.word(real::to_word(number));
    }

    /// The digest so far.
    pub const fn value(self) -> u64 {
        self.0
    }
}

impl Default for Digest {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matches_the_published_test_vector() {
        // Fowler, Noll and Vo: FNV-1a 64 of "foobar" is 0x85944171f73967e8; fed here as single bytes.
        let mut hash = Digest::new().value();
        for byte in b"foobar" {
            hash = (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        assert_eq!(hash, 0x8594_4171_f739_67e8);
        let mut digest = Digest::new();
        digest.word(u64::from_le_bytes(*b"foobarfo"));
        let mut expected = hash;
        for byte in b"fo" {
            expected = (expected ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        assert_eq!(digest.value(), expected);
    }
}
