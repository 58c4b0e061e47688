//! `softanvil study`: sensitivities and convergence.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use serde_json::Value;
use softanvil_kernel::{Scenario, preset};

use super::drop_options::{DURATION, DropOptions};
use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::interrupt;
use crate::output::json;
use crate::output::subject::Subject;
use crate::plot::picture_format::PictureFormat;
use crate::run::{Drop, Until};
use crate::scenario_file::names;
use crate::studies::case::Case;
use crate::studies::page::{Page, overview};
use crate::studies::sweep::{Journal, sweep};
use crate::studies::{STUDIES, Study, columns};

/// Change one thing of a drop at a time, and put what the paper says of it beside.
///
/// mesh: order of convergence and discretisation error. friction: under the face and at the core, and what hides it.
/// poisson: the bulk modulus. damping: spring and slider. law: hyperelastic laws fitted to the same data. thickness,
/// diameter: of the anvil. all: every one of them. Or any parameter, by its name in the scenario file, with --values in its
/// unit: `softanvil study silicone.c10 --values 1e5,2e5`. Interrupt with Ctrl-C: what is done by then is shown and written.
#[derive(Debug, Args)]
pub struct Options {
    /// mesh, friction, poisson, damping, law, thickness, diameter, all, or the name of a parameter
    #[arg(value_parser = known)]
    study: String,
    #[command(flatten)]
    drop: DropOptions,
    /// Values to sweep instead of the study's, in the unit of its table or of the parameter, such as 0.2,0.4 (law: names of
    /// laws; a choice: its labels)
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_negative_numbers = true)]
    values: Vec<String>,
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

/// Stands for every study.
const ALL: &str = "all";

/// The page of all studies.
const OVERVIEW: &str = "README.md";

/// A name that is one of a study, for clap.
fn known(name: &str) -> Result<String, String> {
    let is_study = name == ALL || STUDIES.iter().any(|study| study.name == name);
    if is_study || names::may_be(name) {
        return Ok(name.into());
    }
    let studies = STUDIES.iter().map(|study| study.name).chain([ALL]).collect::<Vec<_>>().join(", ");
    let reason = names::unknown(&preset::study(), name);
    Err(format!("expected {studies}, or a parameter such as silicone.c10: {reason}"))
}

/// Simulates and evaluates; returns the tables.
///
/// # Errors
/// A scenario or value that is refused, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let mut subject = options.drop.subject()?;
    let studies: Vec<&'static Study> = match Study::find(&options.study, &subject.scenario) {
        Some(study) => vec![study],
        None if options.study == ALL => STUDIES.to_vec(),
        None => return Err(Failure::Input(names::unknown(&subject.scenario, &options.study))),
    };
    if studies.len() > 1 && !options.values.is_empty() {
        return Err(Failure::Input("--values is refused with all: expected one study".into()));
    }
    if options.study == DURATION {
        // What is asked for is how long to simulate.
        subject.until = Until::Duration;
    }
    // Refused here, before anything is written.
    Drop::new(&subject.scenario)?;
    let plans = studies.iter().map(|study| options.plan(study, &subject.scenario)).collect::<Result<Vec<_>, _>>()?;
    let mut folder = options.out.as_ref().map(|path| Folder::new(path, options.overwrite.overwrite));
    if let Some(folder) = &mut folder {
        options.claim(folder, &studies)?;
    }
    let stop = interrupt::flag();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|error| Failure::Failed(format!("threads: {error}")))?;
    let mut pages = Vec::new();
    for (study, cases) in studies.iter().zip(plans) {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        pages.push(pool.install(|| options.page(study, &subject, cases, folder.as_mut(), &stop))?);
    }
    options.show(&pages, folder.as_mut())
}

impl Options {
    /// The cases of `study`, none of which is refused.
    fn plan(&self, study: &Study, scenario: &Scenario) -> Result<Vec<Case>, Failure> {
        let defaults = study.default_values.iter().map(|value| (*value).to_string()).collect();
        let values: Vec<String> = if self.values.is_empty() { defaults } else { self.values.clone() };
        if values.is_empty() {
            let legal = format!("expected a list of values of {}, such as --values 1,2.5", study.values);
            return Err(Failure::Input(format!("study {} without --values is refused: {legal}", study.name)));
        }
        let cases = (study.plan)(study, scenario, &values)?;
        for scenario in cases.iter().filter_map(|case| case.scenario.as_ref().ok()) {
            Drop::new(scenario)?;
        }
        Ok(cases)
    }

    /// Checks that the files of all `studies` may be written, and takes those that grow.
    fn claim(&self, folder: &mut Folder, studies: &[&'static Study]) -> Result<(), Failure> {
        let pages = studies.iter().flat_map(|study| ["md", self.pictures.extension()].map(|e| file(study, e)));
        let overview = (self.study == ALL).then(|| OVERVIEW.to_string());
        let names: Vec<String> = pages.chain(overview).collect();
        folder.check(names.iter().map(String::as_str))?;
        for study in studies {
            folder.take(&file(study, "csv"), &csv_line(&columns::header(study))?)?;
        }
        Ok(())
    }

    /// Simulates `cases`, evaluates them, and writes the files of the study.
    fn page(
        &self,
        study: &'static Study,
        subject: &Subject,
        cases: Vec<Case>,
        folder: Option<&mut Folder>,
        stop: &AtomicBool,
    ) -> Result<Page, Failure> {
        let csv = folder.as_ref().map(|folder| folder.path().join(file(study, "csv")));
        let journal = csv.as_deref().map(|path| Journal::new(path, study)).transpose()?;
        let page = Page::new(sweep(study, subject, cases, stop, journal)?, subject.clone());
        if let Some(folder) = folder {
            self.write(folder, study, &page)?;
        }
        Ok(page)
    }

    /// Writes the files of a study.
    fn write(&self, folder: &mut Folder, study: &Study, page: &Page) -> Result<(), Failure> {
        let picture = self.pictures.extension();
        // In order now, whichever simulation ended first.
        let csv = page.csv().map_err(|error| Failure::writing(&folder.path().join(file(study, "csv")), error))?;
        folder.write(&[
            (file(study, "csv"), csv),
            (file(study, picture), self.pictures.file(page.svg()?)?),
            (file(study, "md"), page.markdown(self.pictures).into_bytes()),
        ])
    }

    fn show(&self, pages: &[Page], folder: Option<&mut Folder>) -> Result<String, Failure> {
        if let (Some(folder), true) = (folder, self.study == ALL) {
            let text = format!("{INTRODUCTION}\n{}", overview(pages));
            folder.write(&[(OVERVIEW.into(), text.into_bytes())])?;
        }
        if self.json {
            return Ok(match pages {
                [page] if self.study != ALL => json::text(&page.json()),
                _ => json::text(&Value::Array(pages.iter().map(Page::json).collect())),
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

/// Head of the page of all studies.
const INTRODUCTION: &str = "\
# Studies: the paper beside this model

Each line is a figure of the paper, or a question to it, beside what is simulated here; the pages have the tables, the
pictures and the CSV of every simulation. Made by `softanvil study all --out DIR`.
";

/// Name of a file of `study`.
fn file(study: &Study, extension: &str) -> String {
    format!("{}.{extension}", study.name)
}

/// `record` as a line of CSV.
fn csv_line(record: &[String]) -> Result<String, Failure> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    let failed = |error: &dyn std::fmt::Display| Failure::Failed(format!("a line of CSV: {error}"));
    csv.write_record(record).map_err(|error| failed(&error))?;
    let bytes = csv.into_inner().map_err(|error| failed(&error))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
