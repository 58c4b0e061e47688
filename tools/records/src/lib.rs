//! Measured data of test machines and drop towers, whatever the layout, in SI units.
//!
//! From the file to the numbers:
//!
//! 1. [`text`] decodes a file.
//! 2. [`sheet`] finds the tables of numbers with their titles (in [`cells`]), in text or in a spreadsheet, [`facts`] what stands around them.
//! 3. [`mod@column`] says what the columns are (with [`mod@unit`], [`measure`] and [`number`]); [`series`] tells specimens apart.
//! 4. [`trace`] makes a force over time of an impact (with [`impact`] and [`channel`]), and [`understood`] says how.
//!
//! Nothing is guessed from values alone; what has two meanings is refused with the option that decides.

pub mod cells;
pub mod channel;
pub mod column;
pub mod facts;
pub mod impact;
pub mod kind;
pub mod measure;
pub mod number;
pub mod robust;
pub mod series;
pub mod sheet;
pub mod text;
pub mod trace;
pub mod understood;
pub mod unit;

/// Why a file is refused.
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
