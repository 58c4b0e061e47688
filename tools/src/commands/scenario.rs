//! `softanvil scenario`: a preset as a scenario file.

use clap::Args;
use softanvil_kernel::preset::Preset;

use crate::failure::Failure;
use crate::presets;
use crate::scenario_file;

/// Print a preset as a scenario file, with unit, legal range and meaning of every line.
#[derive(Debug, Args)]
pub struct Options {
    /// Preset to print
    #[arg(long, value_name = "NAME", default_value = "study", value_parser = presets::parse)]
    preset: &'static Preset,
}

/// Prints the preset.
///
/// # Errors
/// Never.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    Ok(scenario_file::to_toml(&(options.preset.scenario)()))
}
