//! Why no FMU was made.

use std::io;
use std::path::PathBuf;

/// A refusal to package.
///
/// ```
/// use softanvil_fmu::{Error, Options, Version, package};
///
/// let folder = tempfile::tempdir()?;
/// let script = folder.path().join("softanvil.so");
/// std::fs::write(&script, "#!/bin/sh\n")?;
/// let options = Options { version: Version::Fmi2, libraries: vec![script], out: folder.path().into() };
/// let refused = package(&options).unwrap_err();
/// assert!(matches!(refused, Error::NotALibrary { .. }));
/// assert!(refused.to_string().ends_with("expected a shared library for Linux on x86-64 or aarch64, or Windows on x86-64"));
/// assert!(!options.path().exists());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
    /// A file is no library of a platform that FMUs are made for.
    #[error("{} is refused: expected a shared library for Linux on x86-64 or aarch64, or Windows on x86-64", path.display())]
    NotALibrary {
        /// The file.
        path: PathBuf,
    },
    /// A library has no function of the standard.
    #[error("{} is refused: expected a library of Softanvil, and it has no {function}", path.display())]
    NoFmi {
        /// The library.
        path: PathBuf,
        /// What an importer would call first.
        function: &'static str,
    },
    /// Two libraries are for the same folder.
    #[error("{} is refused: expected one library per platform, and there is one for {platform} already", path.display())]
    Twice {
        /// The second library.
        path: PathBuf,
        /// The platform.
        platform: &'static str,
    },
    /// No library was given.
    #[error("an FMU needs at least one library")]
    NoLibrary,
    /// The sources are not there.
    #[error(
        "no sources of Softanvil to build the library from, in or above {} or this program's folder: start in a clone of the \
         repository, or give a library with --library FILE",
        root.display()
    )]
    NoSources {
        /// The working folder.
        root: PathBuf,
    },
    /// The library could not be built.
    #[error("the library for {target} cannot be built ({reason}): {hint}")]
    Build {
        /// Rust's name of the platform.
        target: &'static str,
        /// What the machine may lack.
        hint: &'static str,
        /// What the system or cargo says.
        reason: String,
    },
    /// The reference results could not be computed.
    #[error("the reference results cannot be computed: {0}")]
    Simulation(#[from] softanvil::instance::Error),
    /// The reference results could not be written.
    #[error("the reference results cannot be written: {0}")]
    Results(String),
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

impl From<csv::Error> for Error {
    fn from(error: csv::Error) -> Self {
        Self::Results(error.to_string())
    }
}
