//! The names of the files that a command writes.

use std::path::Path;

use crate::failure::Failure;
use crate::picture_format::PictureFormat;
use crate::plot::PlotError;

/// Checks the names given with --plot and --csv.
///
/// # Errors
/// A picture that is neither SVG nor PNG by its name, or one file for both.
pub fn check(plot: Option<&Path>, csv: Option<&Path>) -> Result<(), Failure> {
    let Some(plot) = plot else { return Ok(()) };
    let refuse = |legal: &str| Err(Failure::Input(format!("--plot {} is refused: {legal}", plot.display())));
    if PictureFormat::of(plot).is_none() {
        return refuse("legal is a file name that ends in .svg or .png");
    }
    if csv == Some(plot) {
        return refuse("legal is another file than that of --csv");
    }
    Ok(())
}

/// The file of a picture with a checked name.
///
/// # Errors
/// What the drawing library refuses.
pub fn picture(path: &Path, svg: String) -> Result<Vec<u8>, PlotError> {
    PictureFormat::of(path).unwrap_or_default().file(svg)
}
