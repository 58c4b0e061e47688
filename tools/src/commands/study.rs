//! `softanvil study`: sensitivities and convergence.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use clap::builder::PossibleValuesParser;
use serde_json::Value;
use softanvil_kernel::Scenario;

use super::drop_options::DropOptions;
use crate::failure::Failure;
use crate::picture_format::PictureFormat;
use crate::run::Drop;
use crate::studies::case::Case;
use crate::studies::page::{Page, overview};
use crate::studies::sweep::{Journal, sweep};
use crate::studies::values::short;
use crate::studies::{STUDIES, Study};
use crate::{interrupt, json, staging};

/// Change one thing of a drop at a time, and put what the paper says of it beside.
///
/// mesh: order of convergence and discretisation error. friction: under the face and at the core, and what hides it.
/// poisson: the bulk modulus. damping: spring and slider. law: hyperelastic laws fitted to the same data. thickness,
/// diameter: of the anvil. all: every one of them. Interrupt with Ctrl-C: what is done by then is shown and written.
#[derive(Debug, Args)]
pub struct Options {
    /// The study
    #[arg(value_parser = PossibleValuesParser::new(names()))]
    study: String,
    #[command(flatten)]
    drop: DropOptions,
    /// Values to sweep instead of the study's, in the unit of its table, such as 0.2,0.4 (law: names of laws)
    #[arg(long, value_name = "LIST", value_delimiter = ',', allow_negative_numbers = true)]
    values: Vec<String>,
    /// Write table, CSV and picture to this folder; every simulation is a line of the CSV as soon as it is done
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
}

/// Stands for every study.
const ALL: &str = "all";

fn names() -> Vec<&'static str> {
    STUDIES.iter().map(|study| study.name).chain([ALL]).collect()
}

/// Simulates and evaluates; returns the tables.
///
/// # Errors
/// A scenario or value that is refused, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let studies: Vec<&'static Study> = match Study::find(&options.study) {
        Some(study) => vec![study],
        None => STUDIES.to_vec(),
    };
    if studies.len() > 1 && !options.values.is_empty() {
        return Err(Failure::Input("--values is refused with all: legal is one study".into()));
    }
    let scenario = options.drop.scenario()?;
    // Refused here, before anything is written.
    Drop::new(&scenario)?;
    let plans = studies.iter().map(|study| options.plan(study, &scenario)).collect::<Result<Vec<_>, _>>()?;
    if let Some(folder) = &options.out {
        std::fs::create_dir_all(folder).map_err(|error| Failure::writing(folder, error))?;
    }
    let stop = interrupt::flag();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|error| Failure::Failed(format!("threads: {error}")))?;
    let mut pages = Vec::new();
    for (study, cases) in studies.iter().zip(plans) {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        pages.push(pool.install(|| options.page(study, &scenario, cases, &stop))?);
    }
    options.show(&pages)
}

impl Options {
    /// The cases of `study`, none of which is refused.
    fn plan(&self, study: &Study, scenario: &Scenario) -> Result<Vec<Case>, Failure> {
        let defaults = study.default_values.iter().map(|value| (*value).to_string()).collect();
        let values = if self.values.is_empty() { defaults } else { self.values.clone() };
        let cases = (study.plan)(scenario, &values)?;
        for scenario in cases.iter().filter_map(|case| case.scenario.as_ref().ok()) {
            Drop::new(scenario)?;
        }
        Ok(cases)
    }

    /// Simulates `cases`, evaluates them, and writes the files of the study.
    fn page(
        &self,
        study: &'static Study,
        scenario: &Scenario,
        cases: Vec<Case>,
        stop: &AtomicBool,
    ) -> Result<Page, Failure> {
        let csv = self.out.as_ref().map(|folder| folder.join(format!("{}.csv", study.name)));
        let journal = csv.as_deref().map(|path| Journal::new(path, study)).transpose()?;
        let page = Page::new(sweep(study, scenario, cases, stop, journal)?, subject(scenario));
        if let Some(folder) = &self.out {
            write(folder, &page, self.pictures)?;
        }
        Ok(page)
    }

    fn show(&self, pages: &[Page]) -> Result<String, Failure> {
        if let (Some(folder), true) = (&self.out, self.study == ALL) {
            let text = format!("{INTRODUCTION}\n{}", overview(pages));
            put(&folder.join("README.md"), text.into_bytes())?;
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

/// The drop in words.
fn subject(scenario: &Scenario) -> String {
    let speed = scenario.impactor.start_speed();
    let energy = 0.5 * scenario.impactor.mass * speed * speed;
    let mass = scenario.impactor.mass;
    let layer = 1e3 * scenario.geometry.layer_thickness();
    format!("The drop: {} kg with {} J on a layer of {} mm.", short(mass), short(energy), short(layer))
}

/// Writes the files of a study.
fn write(folder: &Path, page: &Page, pictures: PictureFormat) -> Result<(), Failure> {
    let name = |extension: &str| folder.join(format!("{}.{extension}", page.name()));
    let csv = page.csv().map_err(|error| Failure::writing(&name("csv"), error))?;
    // In order now, whichever simulation ended first.
    put(&name("csv"), csv)?;
    put(&name(pictures.extension()), pictures.file(page.svg()?)?)?;
    put(&name("md"), page.markdown(pictures).into_bytes())
}

fn put(path: &Path, content: Vec<u8>) -> Result<(), Failure> {
    staging::write_files(&[(path, content)]).map_err(|(path, error)| Failure::writing(&path, error))
}
