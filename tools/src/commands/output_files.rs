//! The files that a command writes: their names, and whether they may replace what is there.

use std::path::Path;

use clap::Args;

use crate::failure::Failure;
use crate::plot::PlotError;
use crate::plot::picture_format::PictureFormat;

/// Whether files that are there are replaced.
#[derive(Clone, Copy, Debug, Args)]
pub struct Overwrite {
    /// Replace files of the same names that are there, whoever wrote them
    #[arg(long)]
    pub overwrite: bool,
}

impl Overwrite {
    /// Checks the names given with --plot and --csv.
    ///
    /// # Errors
    /// A picture that is neither SVG nor PNG by its name, one file for both, or a file that is there.
    pub fn check(self, plot: Option<&Path>, csv: Option<&Path>) -> Result<(), Failure> {
        if let Some(plot) = plot {
            let refuse = |legal: &str| Err(Failure::Input(format!("--plot {} is refused: {legal}", plot.display())));
            if PictureFormat::of(plot).is_none() {
                return refuse("expected a file name that ends in .svg or .png");
            }
            if csv == Some(plot) {
                return refuse("expected another file than that of --csv");
            }
        }
        for (option, path) in [("--plot", plot), ("--csv", csv)] {
            if let Some(path) = path {
                self.check_file(option, path)?;
            }
        }
        Ok(())
    }

    /// Checks that a file may be written to the `path` given with `option`.
    ///
    /// # Errors
    /// A file that is there, unless it is to be replaced.
    pub fn check_file(self, option: &str, path: &Path) -> Result<(), Failure> {
        match !self.overwrite && path.is_file() {
            true => Err(Failure::Input(format!(
                "{option} {} is refused: the file is there; --overwrite replaces it",
                path.display()
            ))),
            false => Ok(()),
        }
    }
}

/// The file of a picture with a checked name.
///
/// # Errors
/// What the drawing library refuses.
pub fn picture(path: &Path, svg: String) -> Result<Vec<u8>, PlotError> {
    PictureFormat::of(path).unwrap_or_default().file(svg)
}
