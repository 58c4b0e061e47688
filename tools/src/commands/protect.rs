//! `softanvil protect`: pads beside the bare anvil, and the verdict of a standard.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use softanvil_records::unit::{Dimension, parse_quantity};

use super::drop_options::DropOptions;
use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::output::json as text_json;
use crate::plot::picture_format::PictureFormat;
use crate::protect::trial::{self, Trial};
use crate::protect::{json, picture, table};

/// Simulate a drop on a pad and on the bare anvil, and judge the pad by a standard
///
/// The pad is the layer called pad and all layers above it, or the topmost layer. A preset that is the set-up of a standard brings
/// its limits; `softanvil fit --layer pad` makes a file of a foam's test data that lays it into any of them.
#[derive(Debug, Args)]
pub struct Options {
    #[command(flatten)]
    drop: DropOptions,
    /// Scenario or material files with a pad each, to be compared
    #[arg(long, value_name = "FILE", num_args = 1..)]
    compare: Vec<PathBuf>,
    /// Thicknesses of the pad's lowest layer, such as 5mm 8mm 10mm
    #[arg(long, value_name = "LENGTH", num_args = 1.., value_delimiter = ',', value_parser = length)]
    thickness: Vec<f64>,
    /// Write pictures and numbers (JSON, SI) to this folder, beside what is in it
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Format of the pictures in that folder
    #[arg(long, value_enum, default_value = "svg")]
    pictures: PictureFormat,
    /// Print JSON in SI units instead of the tables
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Name of the file of numbers.
const NUMBERS: &str = "protect.json";
/// Names of the pictures, as far as there may be any.
const PICTURES: [&str; 3] = ["forces", "sections", "thickness"];

/// Simulates and judges; returns the tables.
///
/// # Errors
/// Input that is refused, no pad that can be simulated, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let subject = options.drop.subject()?;
    let cases = trial::cases(&subject, &options.compare, &options.thickness)?;
    let mut folder = options.out.as_ref().map(|path| Folder::new(path, options.overwrite.overwrite));
    let picture_name = |name: &str| format!("{name}.{}", options.pictures.extension());
    if let Some(folder) = &folder {
        let names: Vec<String> = PICTURES.map(picture_name).into_iter().chain([NUMBERS.into()]).collect();
        folder.check(names.iter().map(String::as_str))?;
    }
    let trial = Trial::new(subject, cases, folder.is_some())?;
    let numbers = json::of_trial(&trial);
    let mut text = if options.json { text_json::text(&numbers) } else { table::of_trial(&trial) };
    if let Some(folder) = &mut folder {
        let mut files = vec![(NUMBERS.to_string(), text_json::text(&numbers).into_bytes())];
        for (name, svg) in picture::pictures(&trial)? {
            files.push((picture_name(name), options.pictures.file(svg)?));
        }
        // One of an earlier trial would be taken for one of this.
        let stale = PICTURES.map(picture_name).into_iter().filter(|name| files.iter().all(|(other, _)| other != name));
        folder.remove(stale.collect::<Vec<_>>().iter().map(String::as_str))?;
        folder.write(&files)?;
        for (name, _) in files.iter().filter(|_| !options.json) {
            let _ = writeln!(text, "written: {}", folder.path().join(name).display());
        }
    }
    Ok(text)
}

fn length(text: &str) -> Result<f64, String> {
    parse_quantity(text, Dimension::Length)
}
