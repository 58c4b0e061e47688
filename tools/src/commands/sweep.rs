//! `softanvil sweep`: sensitivities and convergence.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use itertools::Itertools;
use softanvil_kernel::Scenario;

use super::drop_options::{DURATION, DropOptions};
use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::output::json;
use crate::output::subject::Subject;
use crate::plot::picture_format::PictureFormat;
use crate::run::{Until, element_updates};
use crate::scenario_file::names;
use crate::sweep::case::Case;
use crate::sweep::convergence::REFINEMENTS;
use crate::sweep::page::{Page, overview};
use crate::sweep::plan::plan;
use crate::sweep::run::{Journal, run};
use crate::sweep::{Sweep, columns, file};

/// Sweep parameters over values, in all combinations, and judge the convergence with the mesh.
///
/// Any parameter, by its name in the scenario file, over a list of values in its unit, a choice over its labels; the
/// scenario's own value is always among them:
/// `softanvil sweep silicone.c10=1e5,2e5 core.interface=bonded,frictional --convergence`. Or files that say what is changed and
/// why, as those of the folder `sweeps`, which make what the paper changed: `softanvil sweep sweeps/*.toml --out pages`.
/// Interrupt with Ctrl-C: what is done by then is shown and written, and the exit code is 130.
#[derive(Debug, Args)]
pub struct Options {
    /// Parameters with their values, or files of sweeps
    #[arg(value_name = "PARAMETER=LIST|FILE", allow_negative_numbers = true)]
    what: Vec<String>,
    #[command(flatten)]
    drop: DropOptions,
    /// Simulate every combination on meshes finer by these factors, and estimate order of convergence and discretisation error
    #[arg(long, value_name = "FACTORS", value_delimiter = ',', num_args = 0..=1, require_equals = true,
          default_missing_value = REFINEMENTS)]
    convergence: Vec<f64>,
    /// Write page, CSV (SI) and picture to this folder, beside what is in it; every simulation is a line of the CSV as soon as
    /// it is done
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Format of the picture in that folder
    #[arg(long, value_enum, default_value = "svg")]
    pictures: PictureFormat,
    /// Threads [default: one per core]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    threads: usize,
    /// Print JSON in SI units instead of the tables
    #[arg(long, conflicts_with = "markdown")]
    json: bool,
    /// Print the tables as Markdown
    #[arg(long)]
    markdown: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// The page of several sweeps.
const OVERVIEW: &str = "README.md";

/// Where the command was called otherwise.
pub const RENAMED: &str = "study is `sweep` now: expected `softanvil sweep PARAMETER=LIST`, or files, as those of the paper in \
                           the folder sweeps";

/// Simulates until `stop`, and evaluates; returns the tables.
///
/// # Errors
/// A scenario or value that is refused, or a file that cannot be written.
pub fn carry_out(options: &Options, stop: &AtomicBool) -> Result<String, Failure> {
    let mut subject = options.drop.subject()?;
    // Refused here, before anything is written; but a step that a trial will find too small, which is for each case to say.
    element_updates(&subject.scenario)?;
    let sweeps = options.sweeps(&subject.scenario)?;
    let mut levels = sweeps.iter().flat_map(|sweep| &sweep.axes).flat_map(|axis| &axis.levels);
    if levels.any(|level| level.settings.keys().eq([DURATION])) {
        // What is asked for is how long to simulate.
        subject.until = Until::Duration;
    }
    let planned = sweeps.into_iter().map(|sweep| Ok((plan(&sweep, &subject.scenario)?, sweep)));
    let planned = planned.collect::<Result<Vec<(Vec<Case>, Sweep)>, Failure>>()?;
    let mut folder = options.out.as_ref().map(|path| Folder::new(path, options.overwrite.overwrite));
    if let Some(folder) = &mut folder {
        options.claim(folder, &planned)?;
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|error| Failure::Failed(format!("threads: {error}")))?;
    let mut pages = Vec::new();
    for (cases, sweep) in planned {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        pages.push(pool.install(|| options.page(sweep, &subject, cases, folder.as_mut(), stop))?);
    }
    options.show(&pages, folder.as_mut())
}

impl Options {
    /// What is to be swept.
    fn sweeps(&self, scenario: &Scenario) -> Result<Vec<Sweep>, Failure> {
        file::check_refinements(&self.convergence).map_err(|error| Failure::Input(format!("--{error}")))?;
        let (parameters, files): (Vec<&String>, Vec<&String>) = self.what.iter().partition(|what| what.contains('='));
        if files.is_empty() {
            if parameters.is_empty() && self.convergence.is_empty() {
                let legal = "expected PARAMETER=LIST, such as silicone.c10=1e5,2e5, a file, or --convergence";
                return Err(Failure::Input(format!("nothing is changed: {legal}")));
            }
            return Ok(vec![Sweep::of_parameters(&parameters, &self.convergence, scenario)?]);
        }
        if let Some(parameter) = parameters.first() {
            return Err(Failure::Input(format!("{parameter} is refused beside files: expected parameters or files")));
        }
        if let Some(other) = files.iter().find(|file| !file.ends_with(".toml")) {
            let legal = "expected PARAMETER=LIST, such as silicone.c10=1e5,2e5, or a file that ends in .toml";
            return Err(Failure::Input(format!("{other} is refused: {legal}{}", names::suggestion(scenario, other))));
        }
        let sweeps = files.into_iter().map(|path| file::read(Path::new(path), scenario, &self.convergence));
        let sweeps = sweeps.collect::<Result<Vec<_>, _>>()?;
        match sweeps.iter().map(|sweep| &sweep.name).duplicates().next() {
            Some(name) => Err(Failure::Input(format!("two files are called {name}: their pages would be one"))),
            None => Ok(sweeps),
        }
    }

    /// Checks that the files of all sweeps may be written, and takes those that grow.
    fn claim(&self, folder: &mut Folder, planned: &[(Vec<Case>, Sweep)]) -> Result<(), Failure> {
        let sweeps = || planned.iter().map(|(_, sweep)| sweep);
        let pages = sweeps().flat_map(|sweep| ["md", self.pictures.extension()].map(|e| file_name(sweep, e)));
        let overview = (planned.len() > 1).then(|| OVERVIEW.to_string());
        let names: Vec<String> = pages.chain(overview).collect();
        folder.check(names.iter().map(String::as_str))?;
        for sweep in sweeps() {
            folder.take(&file_name(sweep, "csv"), &csv_line(&columns::header(sweep))?)?;
        }
        Ok(())
    }

    /// Simulates `cases`, and writes the files of the sweep.
    fn page(
        &self,
        sweep: Sweep,
        subject: &Subject,
        cases: Vec<Case>,
        folder: Option<&mut Folder>,
        stop: &AtomicBool,
    ) -> Result<Page, Failure> {
        let [csv, picture, markdown] =
            ["csv", self.pictures.extension(), "md"].map(|extension| file_name(&sweep, extension));
        let path = folder.as_ref().map(|folder| folder.path().join(&csv));
        let journal = path.as_deref().map(|path| Journal::new(path, &sweep)).transpose()?;
        let page = Page::new(run(sweep, subject, cases, stop, journal)?, subject.clone());
        if let (Some(folder), Some(path)) = (folder, path) {
            // In order now, whichever simulation ended first.
            let lines = page.csv().map_err(|error| Failure::writing(&path, error))?;
            folder.write(&[
                (csv, lines),
                (picture, self.pictures.file(page.svg()?)?),
                (markdown, page.markdown(self.pictures).into_bytes()),
            ])?;
        }
        Ok(page)
    }

    fn show(&self, pages: &[Page], folder: Option<&mut Folder>) -> Result<String, Failure> {
        if let (Some(folder), true) = (folder, pages.len() > 1) {
            let text = format!("{INTRODUCTION}\n{}", overview(pages));
            folder.write(&[(OVERVIEW.into(), text.into_bytes())])?;
        }
        if self.json {
            return Ok(match pages {
                [page] => json::text(&page.json()),
                _ => json::text(&serde_json::Value::Array(pages.iter().map(Page::json).collect())),
            });
        }
        let texts = pages.iter().map(|page| if self.markdown { page.markdown(self.pictures) } else { page.text() });
        let mut text = texts.collect::<Vec<_>>().join("\n");
        if let (Some(folder), false) = (&self.out, self.markdown) {
            let _ = writeln!(text, "written: {}", folder.display());
        }
        Ok(text)
    }
}

/// Head of the page of several sweeps.
const INTRODUCTION: &str = "\
# Sweeps

Each line is a change of the peak force, the largest deformation, the duration and the impulse, beside what the paper says of
it; the pages have the tables, the pictures and the CSV of every simulation. Made by `softanvil sweep FILES --out DIR`.
";

/// Name of a file of `sweep`.
fn file_name(sweep: &Sweep, extension: &str) -> String {
    format!("{}.{extension}", sweep.name)
}

/// `record` as a line of CSV.
fn csv_line(record: &[String]) -> Result<String, Failure> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    let failed = |error: &dyn std::fmt::Display| Failure::Failed(format!("a line of CSV: {error}"));
    csv.write_record(record).map_err(|error| failed(&error))?;
    let bytes = csv.into_inner().map_err(|error| failed(&error))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
