//! `softanvil run`: one drop, or one slow press.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use softanvil_kernel::Scenario;
use softanvil_kernel::scenario::Motion;

use super::drop_options::DropOptions;
use super::output_files;
use crate::failure::Failure;
use crate::plot::{self, Shown};
use crate::run::{Drop, Run};
use crate::{json, progress, staging, table, trace};

/// Simulate one drop, or a press at a prescribed speed, and print its results.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    drop: DropOptions,
    /// Write the trace, a line per 50 us force sample, in SI units
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write force over time and over deformation as an SVG picture
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Print JSON in SI units instead of the table
    #[arg(long)]
    json: bool,
}

/// Runs the drop and writes the files asked for; returns its results.
///
/// # Errors
/// A scenario or file name that is refused, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let scenario = options.drop.scenario()?;
    output_files::check(options.plot.as_deref(), options.csv.as_deref())?;
    let run = simulate(&scenario)?;
    let files = options.files(&run)?;
    staging::write_files(&files).map_err(|(path, error)| Failure::writing(&path, error))?;
    if options.json {
        return Ok(json::text(&json::of_run(&run)));
    }
    let mut text = format!("{}{}\n", table::of_run(&run), table::settings(&run));
    for (path, _) in &files {
        let _ = writeln!(text, "written: {}", path.display());
    }
    Ok(text)
}

impl Options {
    fn files(&self, run: &Run) -> Result<Vec<(&Path, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        if let Some(path) = &self.csv {
            files.push((path.as_path(), trace::csv(run)?));
        }
        if let Some(path) = &self.plot {
            let shown = Shown { label: label(run), run, experiment: None };
            files.push((path.as_path(), plot::force_time_and_deformation(&[shown])?.into_bytes()));
        }
        Ok(files)
    }
}

/// The energy at the start, to a tenth of a millijoule, or the speed of a press.
fn label(run: &Run) -> String {
    let impactor = &run.constants.scenario.impactor;
    if impactor.motion == Motion::Prescribed {
        return format!("Softanvil, {} m/s", impactor.prescribed_speed);
    }
    let energy = run.samples().first().map_or(0.0, |start| start.energy.impactor_kinetic);
    format!("Softanvil, {} J", (energy * 1e4).round() / 1e4)
}

/// Runs `scenario`, with progress.
pub(super) fn simulate(scenario: &Scenario) -> Result<Run, Failure> {
    let drop = Drop::new(scenario)?;
    let bar = progress::bar(drop.steps());
    bar.set_message("drop");
    Ok(drop.run(|steps| bar.inc(steps))?)
}
