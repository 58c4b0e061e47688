//! How a command ends badly: by its input, or by what it tried to do.

use std::fmt::Display;
use std::path::Path;

/// Exit code of a command that was interrupted, as shells have it: 128 and the number of the signal.
pub const INTERRUPTED: u8 = 130;

/// Why a command did not do what it was asked.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The input is wrong; nothing was started.
    #[error("{0}")]
    Input(String),
    /// The simulation failed, or a file could not be written.
    #[error("{0}")]
    Failed(String),
    /// It was interrupted before there was anything to show.
    #[error("interrupted before anything was done")]
    Interrupted,
}

impl Failure {
    /// The exit code of the process.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Failed(_) => 1,
            Self::Input(_) => 2,
            Self::Interrupted => INTERRUPTED,
        }
    }

    /// A file or folder that could not be written.
    pub fn writing(path: &Path, error: impl Display) -> Self {
        Self::Failed(format!("{} cannot be written: {error}", path.display()))
    }
}
