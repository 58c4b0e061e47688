//! `softanvil fmu`: packages the shared library as an FMU.

use std::path::PathBuf;

use clap::Args;
use softanvil_fmu::{Error, find_library, package};

use crate::failure::Failure;

/// Package the simulation as an FMU for FMI 2.0 co-simulation.
#[derive(Debug, Args)]
pub struct Options {
    /// Folder for the FMU; made if it does not exist
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Shared library to package, once per platform [default: the one that was built with this program]
    #[arg(long = "library", value_name = "FILE")]
    libraries: Vec<PathBuf>,
}

/// Packages; tells where the FMU is.
///
/// # Errors
/// A library that cannot be found, read or used, and a folder that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let libraries = match options.libraries.as_slice() {
        [] => vec![find_library().map_err(failure)?],
        given => given.to_vec(),
    };
    let path = package(&softanvil_fmu::Options { libraries, out: options.out.clone() }).map_err(failure)?;
    Ok(format!("FMU in {}\n", path.display()))
}

fn failure(error: Error) -> Failure {
    match error {
        Error::Archive(_) | Error::Write { .. } => Failure::Failed(error.to_string()),
        _ => Failure::Input(error.to_string()),
    }
}
