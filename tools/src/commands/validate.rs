//! `softanvil validate`: the paper's table, side by side.

use clap::Args;
use softanvil_kernel::preset::Preset;

use super::reading_options::ReadingOptions;
use crate::failure::Failure;
use crate::output::{json, table};
use crate::paper::validation::Validation;
use crate::presets;

/// Simulate the drops of the paper and print its table side by side with ours.
#[derive(Debug, Args)]
pub struct Options {
    /// Preset to validate
    #[arg(long, value_name = "NAME", default_value = "study", value_parser = presets::parse)]
    preset: &'static Preset,
    #[command(flatten)]
    reading: ReadingOptions,
    /// Print JSON in SI units instead of the table
    #[arg(long)]
    json: bool,
}

/// Runs the drops; returns the table.
///
/// # Errors
/// A simulation that failed.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let validation = Validation::new(options.preset, options.reading.reading()?)?;
    Ok(if options.json { json::text(&json::of_validation(&validation)) } else { table::of_validation(&validation) })
}
