//! From the files of a test machine to curves in SI units.
//!
//! [`text`] decodes a file, [`sheet`] finds its table of numbers, [`mod@column`] says what the columns are (with [`mod@unit`]
//! and [`number`]), [`series`] tells specimens apart, [`curve`] makes stretches and nominal stresses of them (with
//! [`specimen`]), [`volume`] reads how it changes beside them, [`cycles`] tells loading from unloading, [`repeats`] makes one curve of several specimens, and [`thinned`]
//! fewer points of very many.

pub mod column;
pub mod curve;
pub mod cycles;
pub mod number;
pub mod repeats;
pub mod series;
pub mod sheet;
pub mod specimen;
pub mod text;
pub mod thinned;
pub mod unit;
pub mod volume;

/// Why a file is refused.
///
/// ```
/// use softanvil_identify::data::curve;
///
/// let file = b"strain,stress\n0.1,0.2\n0.2,0.3\n0.3,0.4\n";
/// let refused = curve::read("tension.csv", file, &curve::Options::default()).unwrap_err();
/// assert!(refused.to_string().contains("has no unit"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReadError {
    /// One line is wrong.
    #[error("line {line}: {reason}")]
    Line {
        /// Line, from 1.
        line: usize,
        /// What is wrong there, and what is legal.
        reason: String,
    },
    /// The whole is wrong, or has two meanings.
    #[error("{0}")]
    File(String),
}

impl ReadError {
    /// `line` is refused for `reason`.
    pub fn line(line: usize, reason: impl Into<String>) -> Self {
        Self::Line { line, reason: reason.into() }
    }

    /// The file is refused for `reason`.
    pub fn file(reason: impl Into<String>) -> Self {
        Self::File(reason.into())
    }
}
