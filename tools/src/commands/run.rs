//! `softanvil run`: one drop, or one slow press.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use softanvil_kernel::scenario::Motion;
use softanvil_kernel::state::LONGEST_REST;
use softanvil_kernel::{SAMPLING_INTERVAL, Simulation};

use super::drop_options::DropOptions;
use super::output_files::{self, Overwrite};
use super::uncertainty_options::UncertaintyOptions;
use crate::failure::Failure;
use crate::files::own_folder::OwnFolder;
use crate::files::staging;
use crate::measurement::band::Expected;
use crate::output::subject::{Subject, warning_lines, warnings};
use crate::output::{bands, json, table, trace};
use crate::plot::{self, Shown};
use crate::progress;
use crate::run;
use crate::run::{Drop, Run};
use crate::section::paraview::{self, Series};

/// Simulate one drop, or a press at a prescribed speed, and print its results.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    drop: DropOptions,
    /// Write the trace, a line per 50 us force sample, in SI units
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write force over time and over deformation as a picture, SVG or PNG by the name
    #[arg(long, value_name = "FILE.svg|FILE.png")]
    plot: Option<PathBuf>,
    /// Write the section as a series for ParaView into this folder, impact.pvd and its VTU files, in SI units; a series that
    /// stands there is replaced
    #[arg(long, value_name = "DIR")]
    vtu: Option<PathBuf>,
    /// Time from one frame of the series to the next in s, a whole multiple of 50e-6
    #[arg(long, value_name = "S", default_value = "250e-6", allow_negative_numbers = true, value_parser = frame_samples)]
    vtu_interval: usize,
    /// Drop again and again on the same anvil, which keeps its damage; files and the table of results are those of the last
    /// impact
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000),
        conflicts_with = "vtu")]
    impacts: u32,
    /// Time between one impact and the next in s
    #[arg(long, value_name = "S", default_value = "60", allow_negative_numbers = true, value_parser = rest,
        requires = "impacts")]
    rest: f64,
    #[command(flatten)]
    uncertainty: UncertaintyOptions,
    /// Print JSON in SI units instead of the table
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Runs the drop and writes the files asked for; returns its results.
///
/// # Errors
/// A scenario or file name that is refused, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let subject = options.drop.subject()?;
    options.overwrite.check(options.plot.as_deref(), options.csv.as_deref())?;
    let posterior = options.uncertainty.posterior(&subject)?;
    let mut series = options.series()?;
    let (earlier, run) = options.simulate(&subject, &mut series)?;
    let expected = posterior.map(|posterior| posterior.expect(&subject)).transpose()?;
    let files = options.files(&run, expected.as_ref())?;
    staging::write_files(&files).map_err(|(path, error)| Failure::writing(&path, error))?;
    let series = series.map(Series::finish).transpose()?;
    if options.json {
        let mut value = json::of_impacts(&earlier, &run, &subject);
        if let Some(expected) = &expected {
            value["bands"] = json::of_bands(expected);
        }
        return Ok(json::text(&value));
    }
    let head = subject.text() + &warning_lines(&warnings(&run.constants, run.end())) + &run::remark(&run);
    let impacts = if earlier.is_empty() { String::new() } else { table::of_impacts(&earlier, &run, options.rest) };
    let bands = expected.as_ref().map_or(String::new(), bands::of_drop);
    let mut text = format!("{head}{impacts}{}{bands}{}\n", table::of_run(&run), table::settings(&run));
    for (path, _) in &files {
        let _ = writeln!(text, "written: {}", path.display());
    }
    if let Some((path, frames)) = series {
        let _ = writeln!(text, "written: {}, {frames} frames", path.display());
    }
    Ok(text)
}

impl Options {
    /// Runs the impacts, with progress: those before the last, and the last.
    fn simulate(&self, subject: &Subject, series: &mut Option<Series>) -> Result<(Vec<Run>, Run), Failure> {
        let drop = progress::set_up(|| Drop::until(&subject.scenario, subject.until))?;
        let bar = progress::bar(u64::from(self.impacts) * drop.steps());
        bar.set_message("drop");
        let (earlier, run, _) = drop.run_impacts(self.impacts, self.rest, |steps, simulation| {
            bar.inc(steps);
            series.iter_mut().try_for_each(|series| series.take(simulation))
        })?;
        Ok((earlier, run))
    }

    fn series(&self) -> Result<Option<Series>, Failure> {
        let Some(folder) = &self.vtu else { return Ok(None) };
        Series::new(OwnFolder::new(folder, &paraview::KIND, self.overwrite.overwrite)?, self.vtu_interval).map(Some)
    }

    fn files(&self, run: &Run, expected: Option<&Expected>) -> Result<Vec<(&Path, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        if let Some(path) = &self.csv {
            files.push((path.as_path(), trace::csv(run)?));
        }
        if let Some(path) = &self.plot {
            let shown =
                Shown { label: label(run), run, experiment: None, band: expected.map(|expected| &expected.force) };
            files.push((path.as_path(), output_files::picture(path, plot::force_time_and_deformation(&[shown])?)?));
        }
        Ok(files)
    }
}

/// The energy at the start, to a tenth of a millijoule, or the speed of a press; and whether it was cut off.
fn label(run: &Run) -> String {
    format!("Softanvil, {}{}", load(run), run::suffix(run))
}

/// The energy at the start, to a tenth of a millijoule, or the speed of a press.
pub(super) fn load(run: &Run) -> String {
    let impactor = &run.constants.scenario.impactor;
    if impactor.motion == Motion::Prescribed {
        return format!("{} m/s", impactor.prescribed_speed);
    }
    let energy = run.samples().first().map_or(0.0, |start| start.energy.impactor_kinetic);
    format!("{} J", (energy * 1e4).round() / 1e4)
}

/// Runs the drop of `subject`, with progress.
pub(super) fn simulate(subject: &Subject) -> Result<Run, Failure> {
    simulate_watched(subject, |_| Ok(()))
}

/// The same; `watch` sees the simulation at the start and after every sample.
pub(super) fn simulate_watched(
    subject: &Subject,
    mut watch: impl FnMut(&mut Simulation) -> Result<(), Failure>,
) -> Result<Run, Failure> {
    let drop = progress::set_up(|| Drop::until(&subject.scenario, subject.until))?;
    let bar = progress::bar(drop.steps());
    bar.set_message("drop");
    drop.run_watched(|steps, simulation| {
        bar.inc(steps);
        watch(simulation)
    })
}

/// A time between impacts in s.
fn rest(text: &str) -> Result<f64, String> {
    let rest = text.parse().ok().filter(|rest| (0.0..=LONGEST_REST).contains(rest));
    rest.ok_or_else(|| format!("expected 0 to {LONGEST_REST} s"))
}

/// Longest time between frames, s.
const LONGEST_INTERVAL: f64 = 1.0;

/// A time in s as a number of samples.
fn frame_samples(text: &str) -> Result<usize, String> {
    let samples = text.parse::<f64>().map_or(f64::NAN, |time| time / SAMPLING_INTERVAL);
    let whole = samples.round();
    if (1.0..=LONGEST_INTERVAL / SAMPLING_INTERVAL).contains(&whole) && (samples - whole).abs() < 1e-6 * whole {
        return Ok(whole as usize);
    }
    Err(format!("expected a whole multiple of {SAMPLING_INTERVAL} s up to {LONGEST_INTERVAL} s"))
}
