//! `softanvil page`: the page in a browser that simulates drops.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;
use softanvil_kernel::preset::PRESETS;

use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::staging;
use crate::measurement::reading::Reading;
use crate::page::html::{self, Start};
use crate::paper::validation::Validation;

/// Write the page that simulates drops in a browser while you change them: one file, which needs no network and no server.
#[derive(Debug, Args)]
pub struct Options {
    /// File to write
    #[arg(long, value_name = "FILE.html", default_value = "softanvil.html")]
    out: PathBuf,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Writes the page, with the paper's table; returns where it is.
///
/// # Errors
/// A file that is there and is not to be replaced, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    options.overwrite.check_file("--out", &options.out)?;
    let validation = Validation::new(&PRESETS[0], Reading::PLAIN)?;
    let start = Start {
        title: "A drop on a soft anvil",
        drops: vec![json!({ "preset": validation.preset.name })],
        ..Start::default()
    };
    let page = html::html(&start, Some(&validation))?;
    staging::write_files(&[(options.out.as_path(), page)]).map_err(|(path, error)| Failure::writing(&path, error))?;
    Ok(format!("written: {}\n", options.out.display()))
}
