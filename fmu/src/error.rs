//! Why no FMU was made.

use std::io;
use std::path::PathBuf;

/// A refusal to package.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A library cannot be read.
    #[error("library {} cannot be read: {source}", path.display())]
    Read {
        /// The library.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A file is no library of a platform that FMI 2.0 has a folder for.
    #[error("{} is refused: legal is a shared library for Linux or Windows on x86-64", path.display())]
    NotALibrary {
        /// The file.
        path: PathBuf,
    },
    /// Two libraries are for the same platform.
    #[error("{} is refused: legal is one library per platform, and there is one for {platform} already", path.display())]
    Twice {
        /// The second library.
        path: PathBuf,
        /// The platform.
        platform: &'static str,
    },
    /// No library was given.
    #[error("an FMU needs at least one library: give one with --library FILE")]
    NoLibrary,
    /// Cargo's library is not where it should be.
    #[error(
        "no library {name} in {}: build it with `cargo build --release -p softanvil-ffi`, or give one with --library FILE",
        searched.iter().map(|folder| folder.display().to_string()).collect::<Vec<_>>().join(" or ")
    )]
    LibraryNotFound {
        /// File name of the library.
        name: String,
        /// Folders that were searched.
        searched: Vec<PathBuf>,
    },
    /// The zip file could not be made.
    #[error("the archive cannot be made: {0}")]
    Archive(#[from] zip::result::ZipError),
    /// The FMU cannot be written.
    #[error("{} cannot be written: {source}", path.display())]
    Write {
        /// The FMU.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}
