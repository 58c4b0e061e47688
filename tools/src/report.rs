//! The report folder: traces, pictures, table and numbers of the study's drops.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::failure::Failure;
use crate::plot::{self, Shown};
use crate::validation::Validation;
use crate::{json, scenario_file, staging, table, trace};

/// The file that lists the others, and by which a report is known.
const SUMMARY: &str = "summary.json";
/// What the summary says about its maker.
const GENERATOR: &str = "softanvil report";

/// A folder that may be written: it does not exist, is empty, or holds a report and nothing else.
pub struct Place(PathBuf);

impl Place {
    /// Checks `folder`.
    ///
    /// # Errors
    /// Anything there that is not a report of ours, or no place for a folder.
    pub fn new(folder: &Path) -> Result<Self, Failure> {
        let refuse = |reason: String| Err(Failure::Input(format!("--out {} is refused: {reason}", folder.display())));
        if folder.file_name().is_none() {
            return refuse("legal is the name of a folder".into());
        }
        if fs::symlink_metadata(folder).is_err() {
            let parent = staging::parent(folder);
            return match parent.is_dir() {
                true => Ok(Self(folder.into())),
                false => refuse(format!("there is no folder {}", parent.display())),
            };
        }
        match foreign_entry(folder) {
            Ok(None) => Ok(Self(fs::canonicalize(folder).unwrap_or_else(|_| folder.into()))),
            Ok(Some(name)) => refuse(format!("it holds {name}, which is no part of a report and will not be deleted")),
            Err(error) => refuse(format!("it is there and is no folder that can be read ({error})")),
        }
    }
}

/// The name of something in `folder` that no report of ours put there.
fn foreign_entry(folder: &Path) -> std::io::Result<Option<String>> {
    let ours = listed_files(folder);
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if !ours.contains(&name) || !entry.file_type()?.is_file() {
            return Ok(Some(name));
        }
    }
    Ok(None)
}

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

/// Writes the report at `place`, complete or not at all; returns the names of its files.
///
/// # Errors
/// A file that cannot be written.
pub fn write(validation: &Validation, place: Place) -> Result<Vec<String>, Failure> {
    let files = files(validation)?;
    let failed = |error: std::io::Error| Failure::writing(&place.0, error);
    let staged = staging::stage_folder(&place.0).map_err(failed)?;
    for (name, content) in &files {
        fs::write(staged.path().join(name), content).map_err(failed)?;
    }
    staging::replace_folder(staged, &place.0).map_err(failed)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}

/// Names and contents of the files.
fn files(validation: &Validation) -> Result<Vec<(String, Vec<u8>)>, Failure> {
    let shown: Vec<Shown> = validation
        .cases
        .iter()
        .map(|case| Shown {
            label: format!("Softanvil, {} J", case.paper.energy),
            run: &case.run,
            experiment: Some(case.paper.experiment),
        })
        .collect();
    let mut files = vec![
        ("force-time.svg".to_string(), plot::force_time("Drops on the soft anvil: force over time", &shown)?.into()),
        (
            "force-deformation.svg".to_string(),
            plot::force_deformation("Drops on the soft anvil: force over deformation", &shown)?.into(),
        ),
        ("table.txt".to_string(), table::of_validation(validation).into()),
        ("scenario.toml".to_string(), scenario_file::to_toml(&(validation.preset.scenario)()).into()),
    ];
    for case in &validation.cases {
        files.push((format!("trace-{}J.csv", case.paper.energy), trace::csv(&case.run)?));
    }
    let names = files.iter().map(|(name, _)| name.as_str()).chain([SUMMARY]).collect::<Vec<_>>();
    let summary = summary(validation, &names);
    files.push((SUMMARY.to_string(), json::text(&summary).into()));
    Ok(files)
}

fn summary(validation: &Validation, files: &[&str]) -> Value {
    json!({
        "generator": GENERATOR,
        "version": env!("CARGO_PKG_VERSION"),
        "files": files,
        "validation": json::of_validation(validation),
    })
}
