//! `softanvil measure`: one impact, as a laboratory's instruments see it, and beside a measured trace.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use softanvil_kernel::Scenario;

use super::drop_options::DropOptions;
use super::output_files::{self, Overwrite};
use super::reading_options::ReadingOptions;
use super::run::{load, simulate};
use super::trace_options::TraceOptions;
use crate::failure::Failure;
use crate::files::staging;
use crate::measurement::measured::Measured;
use crate::measurement::quantity::MAX_DEFORMATION;
use crate::measurement::reading::{Reading, Record};
use crate::output::subject::{warning_lines, warnings};
use crate::output::trace_comparison::{self, TraceComparison};
use crate::output::{json, trace};
use crate::plot;
use crate::run;
use crate::run::Run;

/// Simulate one impact and print its numbers as load cells, filters and camera give them; with a measured trace, beside it.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    drop: DropOptions,
    #[command(flatten)]
    reading: ReadingOptions,
    /// Measured trace of force or acceleration over time: text or a workbook of any layout (docs/measured-data.md), with units;
    /// it is read as the simulated one
    #[arg(long, value_name = "FILE")]
    trace: Option<PathBuf>,
    #[command(flatten)]
    layout: TraceOptions,
    /// The measured trace has been filtered already: --cfc is for the simulated force alone
    #[arg(long, requires = "trace", requires = "cfc")]
    filtered: bool,
    /// Write the force as it is read, in SI units
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write the force over time, and the measured one over it, as a picture, SVG or PNG by the name
    #[arg(long, value_name = "FILE.svg|FILE.png")]
    plot: Option<PathBuf>,
    /// Print JSON in SI units instead of the tables
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Simulates, reads, compares, and writes the files asked for; returns the tables.
///
/// # Errors
/// Input that is refused, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let reading = options.reading.reading()?;
    let subject = options.drop.subject()?;
    options.overwrite.check(options.plot.as_deref(), options.csv.as_deref())?;
    let measured = options.measured(&reading, &subject.scenario)?;
    let run = simulate(&subject)?;
    let scenario = &subject.scenario;
    let record = reading.take(&run).map_err(|error| Failure::Input(error.to_string()))?;
    let comparison = match &measured {
        Some(measured) => {
            let threshold = scenario.measurement.force_threshold;
            let mut comparison = TraceComparison::new(&measured.series, &record, &reading, threshold)?;
            comparison.values[MAX_DEFORMATION] = measured.deformation;
            Some(comparison)
        }
        None => None,
    };
    let files = options.files(&run, &reading, &record, comparison.as_ref())?;
    staging::write_files(&files).map_err(|(path, error)| Failure::writing(&path, error))?;
    if options.json {
        let mut object = trace_comparison::json(&run, &subject, &reading, &record, comparison.as_ref());
        if let Some(measured) = &measured {
            object["trace"] = measured.understood.json();
        }
        return Ok(json::text(&object));
    }
    let head = subject.text() + &warning_lines(&warnings(&run.constants, run.end())) + &run::remark(&run);
    let mut text = head + &trace_comparison::channels(&run, &reading, &record);
    if let Some(comparison) = &comparison {
        let understood = measured.iter().map(|measured| measured.understood.to_string()).collect::<String>();
        let _ = write!(text, "\nMeasured trace:\n{understood}\n{}", comparison.text(&record, run.ending()));
    }
    for (path, _) in &files {
        let _ = writeln!(text, "written: {}", path.display());
    }
    Ok(text)
}

impl Options {
    /// The measured trace, filtered if it has to be and has not been.
    fn measured(&self, reading: &Reading, scenario: &Scenario) -> Result<Option<Measured>, Failure> {
        let Some(path) = &self.trace else { return Ok(None) };
        let mut measured = Measured::read(path, &self.layout.options(), &scenario.impactor).map_err(Failure::Input)?;
        measured.compare_filters(reading.channel_class);
        match reading.channel_class {
            Some(class) if !self.filtered && !measured.is_filtered() => {
                let refuse = |error: crate::measurement::series::SeriesError| Failure::Input(error.to_string());
                measured.series = measured.series.filtered(class).map_err(refuse)?;
                Ok(Some(measured))
            }
            _ => Ok(Some(measured)),
        }
    }

    fn files(
        &self,
        run: &Run,
        reading: &Reading,
        record: &Record,
        comparison: Option<&TraceComparison>,
    ) -> Result<Vec<(&Path, Vec<u8>)>, Failure> {
        let mut files = Vec::new();
        if let Some(path) = &self.csv {
            files.push((path.as_path(), trace::of_forces(record, comparison)?));
        }
        if let Some(path) = &self.plot {
            let load = load(run);
            let cut = run::suffix(run);
            // The axis has the name of the force.
            let filter = reading.channel_class.map_or("unfiltered".into(), |class| format!("CFC {class}"));
            let (ours, lag) = (&record.series, comparison.map_or(0.0, |comparison| comparison.score.alignment.lag));
            let onset = ours.onset(record.threshold).unwrap_or(ours.start);
            // From the earlier of the two, so that none loses its rise.
            let measured = comparison.and_then(|comparison| comparison.measured.onset(comparison.threshold));
            let zero = measured.map_or(onset, |measured| onset.min(measured + lag));
            let mut curves = vec![(format!("Softanvil, {load}, {filter}{cut}"), ours.since(zero, record.threshold))];
            if let Some(comparison) = comparison {
                curves.push(("measured".into(), comparison.measured.since(zero - lag, comparison.threshold)));
            }
            let svg = plot::forces("Force over time", reading.sensor.axis(), curves)?;
            files.push((path.as_path(), output_files::picture(path, svg)?));
        }
        Ok(files)
    }
}
