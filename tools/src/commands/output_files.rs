//! The names of the files that a command writes.

use std::path::Path;

use crate::failure::Failure;

/// Checks the names given with --plot and --csv.
///
/// # Errors
/// A picture that is no SVG by its name, or one file for both.
pub fn check(plot: Option<&Path>, csv: Option<&Path>) -> Result<(), Failure> {
    let Some(plot) = plot else { return Ok(()) };
    let refuse = |legal: &str| Err(Failure::Input(format!("--plot {} is refused: {legal}", plot.display())));
    if !plot.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg")) {
        return refuse("legal is a file name that ends in .svg");
    }
    if csv == Some(plot) {
        return refuse("legal is another file than that of --csv");
    }
    Ok(())
}
