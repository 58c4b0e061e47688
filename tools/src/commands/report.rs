//! `softanvil` alone: the drops of the paper, its table, and a report folder; `softanvil report`: the same of a drop of one's
//! own.

use std::path::PathBuf;

use clap::Args;

use softanvil_kernel::Simulation;
use softanvil_kernel::preset::PRESETS;

use super::drop_options::DropOptions;
use super::output_files::Overwrite;
use super::run::{load, simulate_watched};
use crate::calibration::uncertainty::shipped;
use crate::failure::Failure;
use crate::files::own_folder::OwnFolder;
use crate::measurement::reading::Reading;
use crate::paper::TABLE_1;
use crate::paper::validation::Validation;
use crate::plot::picture_format::PictureFormat;
use crate::report::{self, Content};
use crate::section::Animation;

/// Where the report goes.
#[derive(Debug, Args)]
pub struct Options {
    /// Folder of the report; a report that stands there as it was written is replaced
    #[arg(long, value_name = "DIR", default_value = "softanvil-report")]
    out: PathBuf,
    /// Format of the pictures beside the report's page
    #[arg(long, value_enum, default_value = "svg")]
    pictures: PictureFormat,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Simulate one drop of your own and write every picture, the page with the animation, numbers and trace to a folder.
#[derive(Debug, Args)]
pub struct OwnOptions {
    #[command(flatten)]
    drop: DropOptions,
    #[command(flatten)]
    report: Options,
}

/// Runs the drops of the paper and writes the report; returns the table and where the report is.
///
/// # Errors
/// A folder that is not ours to replace, a simulation that failed, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    let place = OwnFolder::new(&options.out, &report::KIND, options.overwrite.overwrite)?;
    let mut animations: [Animation; TABLE_1.len()] = Default::default();
    let watch = |number: usize, simulation: &mut Simulation| Ok(animations[number].take(simulation)?);
    let validation = shipped::add_bands(Validation::watched(&PRESETS[0], Reading::PLAIN, watch)?);
    options.write(&Content::of_validation(&validation, &animations), place)
}

/// Runs one drop and writes the report; returns its numbers and where the report is.
///
/// # Errors
/// As [`carry_out`], and a scenario that is refused.
pub fn carry_out_own(options: &OwnOptions) -> Result<String, Failure> {
    let subject = options.drop.subject()?;
    let place = OwnFolder::new(&options.report.out, &report::KIND, options.report.overwrite.overwrite)?;
    let mut animation = Animation::default();
    let run = simulate_watched(&subject, |simulation| Ok(animation.take(simulation)?))?;
    options.report.write(&Content::of_run(&subject, load(&run), &run, &animation), place)
}

impl Options {
    fn write(&self, content: &Content, place: OwnFolder) -> Result<String, Failure> {
        let names = report::write(content, self.pictures, place)?;
        let files = names.iter().map(|name| format!("  {name}\n")).collect::<String>();
        Ok(format!("{}\nReport in {}:\n{files}", content.table(), self.out.display()))
    }
}
