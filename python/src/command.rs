//! The command line, within the process.

use std::ffi::OsString;
use std::sync::Arc;

use pyo3::prelude::*;
use softanvil_tools::cli;

use crate::error;
use crate::interrupt::interruptible;

/// Carries out `softanvil ARGUMENTS`; returns what it prints.
///
/// Ctrl-C ends a search with what it has found so far.
#[pyfunction]
pub fn command(py: Python<'_>, arguments: Vec<OsString>) -> PyResult<String> {
    let arguments = std::iter::once("softanvil".into()).chain(arguments).collect::<Vec<_>>();
    let outcome = interruptible(py, |stop| cli::execute_with(arguments, &|| Arc::clone(stop)))?;
    match outcome.exit_code {
        0 => Ok(outcome.stdout),
        code => {
            let message = outcome.stderr.trim().trim_start_matches("error: ").to_string();
            Err(if code == 2 { error::file(py, message) } else { error::simulation(py, message) })
        }
    }
}

/// The options of a command of the command line: (long name, meaning).
#[pyfunction]
pub fn command_options(name: &str) -> Vec<(String, String)> {
    cli::options(name).unwrap_or_default()
}
