//! The report folder: traces, pictures, table and numbers of the paper's drops, or of one of the user's own.

use std::fs;
use std::path::Path;

use serde_json::{Map, Value, json};
use softanvil_kernel::Scenario;

use crate::failure::Failure;
use crate::files::folder::digest;
use crate::files::own_folder::{Kind, Listed, OwnFolder};
use crate::files::staging;
use crate::measurement::band::Expected;
use crate::output::subject::{Subject, warning_lines, warnings};
use crate::output::{json, table, trace};
use crate::page;
use crate::page::html::{self, Start};
use crate::paper;
use crate::paper::validation::Validation;
use crate::plot::picture_format::PictureFormat;
use crate::plot::{self, Shown};
use crate::run;
use crate::run::Run;
use crate::scenario_file;
use crate::section::picture::{self, Shot};
use crate::section::{Animation, SHADES};

/// The file that lists the others, and by which a report is known.
const SUMMARY: &str = "summary.json";
/// What the summary says about its maker.
const GENERATOR: &str = "softanvil report";

/// A report folder.
pub const KIND: Kind = Kind { option: "--out", what: "a report", listed_files };

/// The files that the summary in `folder` lists; none if it is not ours.
fn listed_files(folder: &Path) -> Vec<Listed> {
    let text = fs::read_to_string(folder.join(SUMMARY)).unwrap_or_default();
    let summary: Value = serde_json::from_str(&text).unwrap_or_default();
    if summary["generator"] != GENERATOR {
        return Vec::new();
    }
    let files = summary["files"].as_array().cloned().unwrap_or_default();
    let listed = files
        .iter()
        .filter_map(|file| file.as_str())
        .map(|name| Listed { name: name.into(), digest: summary["digests"][name].as_str().map(String::from) });
    listed.collect()
}

/// What a report tells.
pub struct Content<'a> {
    /// The drops, the hardest first.
    pub drops: Vec<Reported<'a>>,
    /// What they are.
    pub about: About<'a>,
}

/// A drop of a report.
pub struct Reported<'a> {
    /// Energy, or the speed of a press.
    pub label: String,
    /// Name of the file with its trace.
    pub trace: String,
    /// The run.
    pub run: &'a Run,
    /// Its section.
    pub animation: &'a Animation,
    /// What was measured, if it is one of the paper's drops.
    pub paper: Option<&'static paper::Case>,
    /// What a posterior expects of it.
    pub expected: Option<&'a Expected>,
}

/// What the drops of a report are.
#[derive(Clone, Copy)]
pub enum About<'a> {
    /// Those of the paper, beside its table.
    Validation(&'a Validation),
    /// One of the user's own.
    Own(&'a Subject),
}

impl<'a> Content<'a> {
    /// The drops of the paper with their sections.
    pub fn of_validation(validation: &'a Validation, animations: &'a [Animation]) -> Self {
        let drops = validation.cases.iter().zip(animations).map(|(case, animation)| Reported {
            label: format!("{} J", case.paper.energy),
            trace: format!("trace-{}J.csv", case.paper.energy),
            run: &case.run,
            animation,
            paper: Some(case.paper),
            expected: case.expected.as_ref(),
        });
        Self { drops: drops.collect(), about: About::Validation(validation) }
    }

    /// One drop with its section.
    pub fn of_run(subject: &'a Subject, label: String, run: &'a Run, animation: &'a Animation) -> Self {
        let drop = Reported { label, trace: "trace.csv".into(), run, animation, paper: None, expected: None };
        Self { drops: vec![drop], about: About::Own(subject) }
    }

    /// The scenario that a reader can run again.
    fn scenario(&self) -> Scenario {
        match self.about {
            About::Validation(validation) => (validation.preset.scenario)(),
            About::Own(subject) => subject.scenario.clone(),
        }
    }

    /// What stands above a table: which drop, what speaks against it, how it ended. Nothing of the paper's drops, whose
    /// table says so.
    fn head(&self) -> String {
        match self.about {
            About::Validation(_) => String::new(),
            About::Own(subject) => self.drops.iter().fold(subject.text(), |text, drop| {
                text + &warning_lines(&warnings(&drop.run.constants, drop.run.end())) + &run::remark(drop.run)
            }),
        }
    }

    /// The numbers, for people, without their head.
    fn numbers(&self) -> String {
        match self.about {
            About::Validation(validation) => table::of_validation(validation),
            About::Own(_) => {
                let drops = self.drops.iter();
                drops.map(|drop| format!("{}{}\n", table::of_run(drop.run), table::settings(drop.run))).collect()
            }
        }
    }

    /// The numbers, for people, and what a reader has to know of them.
    pub fn table(&self) -> String {
        self.head() + &self.numbers()
    }
}

/// Writes the report at `place`, complete or not at all, its pictures in this format; returns the names of its files.
///
/// # Errors
/// A file that cannot be written.
pub fn write(content: &Content, pictures: PictureFormat, place: OwnFolder) -> Result<Vec<String>, Failure> {
    let files = files(content, pictures)?;
    let failed = |error: std::io::Error| Failure::writing(place.path(), error);
    let staged = staging::stage_folder(place.path()).map_err(failed)?;
    for (name, content) in &files {
        fs::write(staged.path().join(name), content).map_err(failed)?;
    }
    staging::replace_folder(staged, place.path()).map_err(failed)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}

/// Names and contents of the files.
fn files(content: &Content, format: PictureFormat) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let mut files = vec![("report.html".into(), page_of(content)?)];
    for (name, svg) in pictures(content)? {
        files.push((format!("{name}.{}", format.extension()), format.file(svg)?));
    }
    files.push(("table.txt".into(), content.table().into()));
    files.push(("scenario.toml".into(), scenario_file::to_toml(&content.scenario()).into()));
    for drop in &content.drops {
        files.push((drop.trace.clone(), trace::csv(drop.run)?));
    }
    let names = files.iter().map(|(name, _)| name.as_str()).chain([SUMMARY]).collect::<Vec<_>>();
    let digests: Map<String, Value> =
        files.iter().map(|(name, content)| (name.clone(), digest(content).into())).collect();
    let summary = summary(content, &names, digests);
    files.push((SUMMARY.to_string(), json::text(&summary).into()));
    Ok(files)
}

/// The page, on which each drop can be changed.
fn page_of(content: &Content) -> Result<Vec<u8>, Failure> {
    let of = |drop: &Reported| {
        let (preset, toml, about) = match content.about {
            About::Validation(validation) => {
                let energy = drop.paper.map_or(0.0, |case| case.energy);
                let about =
                    Subject { scenario: drop.run.constants.scenario.clone(), ..Subject::of_preset(validation.preset) };
                (validation.preset.name, format!("[impactor]\ndrop_energy = {energy:?}\n"), about.text())
            }
            About::Own(subject) => (subject.preset.name, scenario_file::to_toml(&subject.scenario), subject.text()),
        };
        let data = page::drop::of(&drop.label, &about, drop.run, drop.animation);
        json!({ "preset": preset, "toml": toml, "name": drop.label, "data": data })
    };
    let own = matches!(content.about, About::Own(_));
    let start = Start {
        title: "Drops on the soft anvil",
        head: content.head(),
        numbers: if own { content.numbers() } else { String::new() },
        scenario: scenario_file::to_toml(&content.scenario()),
        drops: content.drops.iter().map(of).collect(),
    };
    let validation = match content.about {
        About::Validation(validation) => Some(validation),
        About::Own(_) => None,
    };
    html::html(&start, validation)
}

/// The drops as the plots show them.
fn shown<'a>(content: &'a Content) -> Vec<Shown<'a>> {
    let shown = content.drops.iter().map(|drop| Shown {
        label: format!("Softanvil, {}{}", drop.label, run::suffix(drop.run)),
        run: drop.run,
        experiment: drop.paper.map(|case| case.experiment),
        band: drop.expected.map(|expected| &expected.force),
    });
    shown.collect()
}

/// Names and SVG of the pictures.
fn pictures(content: &Content) -> Result<Vec<(&'static str, String)>, Failure> {
    let shown = shown(content);
    let shots = content.drops.iter().map(|drop| Shot { label: drop.label.clone(), animation: drop.animation });
    let shots: Vec<Shot> = shots.collect();
    let mut pictures = vec![
        ("force-time", plot::force_time("Drops on the soft anvil: force over time", &shown)?),
        ("force-deformation", plot::force_deformation("Drops on the soft anvil: force over deformation", &shown)?),
        ("energy", plot::energy(&shown)?),
        ("maximum-compression", picture::maximum_compression(&shots)),
        ("deformed-mesh", picture::deformed_mesh(&shots)),
    ];
    if let Some(hardest) = shots.first() {
        pictures.extend(SHADES.iter().map(|shade| (shade.key, picture::instants(hardest, shade))));
    }
    Ok(pictures)
}

fn summary(content: &Content, files: &[&str], digests: Map<String, Value>) -> Value {
    let mut summary = json!({
        "generator": GENERATOR,
        "version": env!("CARGO_PKG_VERSION"),
        "files": files,
        "digests": digests,
    });
    let (key, value) = match content.about {
        About::Validation(validation) => ("validation", json::of_validation(validation)),
        About::Own(subject) => {
            ("run", content.drops.first().map_or(Value::Null, |drop| json::of_run(drop.run, subject)))
        }
    };
    summary[key] = value;
    summary
}
