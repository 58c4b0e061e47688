//! `softanvil validate`: the paper's table, side by side.

use clap::{Args, ValueEnum};
use softanvil_kernel::preset::Preset;
use softanvil_kernel::scenario::Formulation;

use super::reading_options::ReadingOptions;
use crate::calibration::uncertainty::shipped;
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
    /// Simulate it as this, instead of what the preset is: a section, or a solid in three dimensions, of a hundred times the elements
    #[arg(long, value_enum)]
    formulation: Option<By>,
    #[command(flatten)]
    reading: ReadingOptions,
    /// Print JSON in SI units instead of the table
    #[arg(long)]
    json: bool,
}

/// Formulations of the paper's anvil, a cylinder.
#[derive(Clone, Copy, Debug, ValueEnum)]
#[value(rename_all = "snake_case")]
enum By {
    PlaneStrain,
    Solid,
}

/// Runs the drops; returns the table.
///
/// # Errors
/// A simulation that failed.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let formulation = match options.formulation {
        Some(By::PlaneStrain) => Formulation::PlaneStrain,
        Some(By::Solid) => Formulation::Solid,
        None => (options.preset.scenario)().geometry.formulation,
    };
    let validation = Validation::formulated(options.preset, formulation, options.reading.reading()?, |_, _| Ok(()))?;
    let validation = shipped::add_bands(validation);
    Ok(if options.json { json::text(&json::of_validation(&validation)) } else { table::of_validation(&validation) })
}
