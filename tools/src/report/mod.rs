//! The report folder: traces, pictures, table and numbers of the study's drops.

mod page;

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::failure::Failure;
use crate::picture_format::PictureFormat;
use crate::place::{Kind, Place};
use crate::plot::{self, Shown};
use crate::section::picture::{self, Shot};
use crate::section::{Film, SHADES};
use crate::validation::Validation;
use crate::{json, scenario_file, staging, table, trace};

/// The file that lists the others, and by which a report is known.
const SUMMARY: &str = "summary.json";
/// What the summary says about its maker.
const GENERATOR: &str = "softanvil report";

/// A report folder.
pub const KIND: Kind = Kind { option: "--out", what: "a report", listed_files };

/// The files that the summary in `folder` lists; none if it is not ours.
fn listed_files(folder: &Path) -> Vec<String> {
    let text = fs::read_to_string(folder.join(SUMMARY)).unwrap_or_default();
    let summary: Value = serde_json::from_str(&text).unwrap_or_default();
    if summary["generator"] != GENERATOR {
        return Vec::new();
    }
    let files = summary["files"].as_array().cloned().unwrap_or_default();
    files.iter().filter_map(|file| file.as_str().map(String::from)).collect()
}

/// What a report tells.
pub struct Content<'a> {
    /// The drops.
    pub validation: &'a Validation,
    /// The section of each.
    pub films: &'a [Film],
}

/// Writes the report at `place`, complete or not at all, its pictures in this format; returns the names of its files.
///
/// # Errors
/// A file that cannot be written.
pub fn write(content: &Content, pictures: PictureFormat, place: Place) -> Result<Vec<String>, Failure> {
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
    let validation = content.validation;
    let mut files = vec![("report.html".into(), page::html(content)?)];
    for (name, svg) in pictures(content)? {
        files.push((format!("{name}.{}", format.extension()), format.file(svg)?));
    }
    files.push(("table.txt".into(), table::of_validation(validation).into()));
    files.push(("scenario.toml".into(), scenario_file::to_toml(&(validation.preset.scenario)()).into()));
    for case in &validation.cases {
        files.push((format!("trace-{}J.csv", case.paper.energy), trace::csv(&case.run)?));
    }
    let names = files.iter().map(|(name, _)| name.as_str()).chain([SUMMARY]).collect::<Vec<_>>();
    let summary = summary(validation, &names);
    files.push((SUMMARY.to_string(), json::text(&summary).into()));
    Ok(files)
}

/// The drops as the plots show them.
fn shown(validation: &Validation) -> Vec<Shown<'_>> {
    let cases = validation.cases.iter();
    let shown = cases.map(|case| Shown {
        label: format!("Softanvil, {} J", case.paper.energy),
        run: &case.run,
        experiment: Some(case.paper.experiment),
    });
    shown.collect()
}

/// Names and SVG of the pictures.
fn pictures(content: &Content) -> Result<Vec<(&'static str, String)>, Failure> {
    let cases = &content.validation.cases;
    let shown = shown(content.validation);
    let shots: Vec<Shot> = cases
        .iter()
        .zip(content.films)
        .map(|(case, film)| Shot { label: format!("{} J", case.paper.energy), film })
        .collect();
    let mut pictures = vec![
        ("force-time", plot::force_time("Drops on the soft anvil: force over time", &shown)?),
        ("force-deformation", plot::force_deformation("Drops on the soft anvil: force over deformation", &shown)?),
        ("energy", plot::energy(&shown)?),
        ("maximum-compression", picture::maximum_compression(&shots)),
        ("deformed-mesh", picture::deformed_mesh(&shots)),
    ];
    if let Some(hardest) = shots.first() {
        pictures.extend(SHADES.iter().map(|shade| (shade.key, picture::moments(hardest, shade))));
    }
    Ok(pictures)
}

fn summary(validation: &Validation, files: &[&str]) -> Value {
    json!({
        "generator": GENERATOR,
        "version": env!("CARGO_PKG_VERSION"),
        "files": files,
        "validation": json::of_validation(validation),
    })
}
