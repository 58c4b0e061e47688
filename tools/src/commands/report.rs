//! `softanvil` alone: the drops of the study, its table, and a report folder.

use std::path::PathBuf;

use clap::Args;

use softanvil_kernel::Simulation;
use softanvil_kernel::preset::PRESETS;

use crate::failure::Failure;
use crate::paper::TABLE_1;
use crate::picture_format::PictureFormat;
use crate::place::Place;
use crate::reading::Reading;
use crate::report::{self, Content};
use crate::section::Film;
use crate::table;
use crate::validation::Validation;

/// What to do without a command.
#[derive(Debug, Args)]
pub struct Options {
    /// Folder of the report; a report that stands there is replaced
    #[arg(long, value_name = "DIR", default_value = "softanvil-report")]
    out: PathBuf,
    /// Format of the pictures beside the report's page
    #[arg(long, value_enum, default_value = "svg")]
    pictures: PictureFormat,
}

/// Runs the drops and writes the report; returns the table and where the report is.
///
/// # Errors
/// A folder that is not ours to replace, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let place = Place::new(&options.out, &report::KIND)?;
    let mut films: [Film; TABLE_1.len()] = Default::default();
    let watch = |number: usize, simulation: &mut Simulation| Ok(films[number].take(simulation)?);
    let validation = Validation::watched(&PRESETS[0], Reading::PLAIN, watch)?;
    let names = report::write(&Content { validation: &validation, films: &films }, options.pictures, place)?;
    let files = names.iter().map(|name| format!("  {name}\n")).collect::<String>();
    Ok(format!("{}\nReport in {}:\n{files}", table::of_validation(&validation), options.out.display()))
}
