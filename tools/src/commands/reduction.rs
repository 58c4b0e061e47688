//! `softanvil reduction`: the section against the solid.

use std::path::PathBuf;

use clap::Args;

use super::drop_options::DropOptions;
use super::output_files::{self, Overwrite};
use crate::failure::Failure;
use crate::files::staging;
use crate::output::json;
use crate::reduction;
use crate::sweep::Sweep;
use crate::sweep::plan::plan;

/// Simulate the drop as a section and as a solid, and find the length with which the section bears what the solid does.
///
/// Over any parameters, as `softanvil sweep` takes them: `softanvil reduction impactor.drop_energy=4.9,9.8
/// silicone.poissons_ratio=0.48`, and `mesh.element_size=0.004` for another mesh of both. A solid takes seconds.
#[derive(Debug, Args)]
pub struct Options {
    /// Parameters with their values, in all combinations; the scenario's own value is always among them
    #[arg(value_name = "PARAMETER=LIST", allow_negative_numbers = true)]
    what: Vec<String>,
    #[command(flatten)]
    drop: DropOptions,
    /// Draw what differs to this file (.svg or .png): the four numbers over a parameter, if one alone changes and is a number, else
    /// the forces over time
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Print JSON in SI units instead of the table
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Simulates and compares; returns the table.
///
/// # Errors
/// A scenario or value that is refused, also as a solid, a simulation that failed, or a picture that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    options.overwrite.check(options.plot.as_deref(), None)?;
    let subject = options.drop.subject()?;
    let sweep = Sweep::of_parameters(&options.what, &[], &subject.scenario)?;
    let cases = plan(&sweep, &subject.scenario)?;
    let reduction = reduction::compare(&sweep, &cases, subject.until)?;
    let mut written = String::new();
    if let Some(path) = &options.plot {
        let picture = output_files::picture(path, reduction::picture::draw(&reduction)?)?;
        staging::write_files(&[(path.as_path(), picture)]).map_err(|(path, error)| Failure::writing(&path, error))?;
        written = format!("written: {}\n", path.display());
    }
    Ok(match options.json {
        true => json::text(&reduction::json::of_reduction(&reduction)),
        false => reduction::table::of_reduction(&reduction) + &written,
    })
}
