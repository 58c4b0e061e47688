//! `softanvil golden`: does this machine compute the same bits?

use std::fmt::Write;
use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::output_files::Overwrite;
use crate::failure::Failure;
use crate::files::staging;
use crate::golden::{self, Played};

/// Check this build on this machine against the golden traces, bit by bit.
#[derive(Debug, Args)]
#[command(arg_required_else_help = false)]
pub struct Options {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Run the scenes and compare each with its trace: force, position and every number of the state, every 0.25 ms
    Check(CheckOptions),
    /// Run the scenes and write their traces, for a change of the results that is meant
    Write(WriteOptions),
}

#[derive(Debug, Args)]
struct CheckOptions {
    /// Scenes to check [default: all]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
}

#[derive(Debug, Args)]
struct WriteOptions {
    /// Folder for the traces, which must exist
    #[arg(value_name = "DIR")]
    out: PathBuf,
    /// Scenes to write [default: all]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Checks or writes; returns a line per scene.
///
/// # Errors
/// A scene that is unknown, fails or differs, or a file that cannot be written.
pub fn carry_out(options: &Options) -> Result<String, Failure> {
    match &options.action {
        Action::Check(check) => check.carry_out(),
        Action::Write(write) => write.carry_out(),
    }
}

impl CheckOptions {
    fn carry_out(&self) -> Result<String, Failure> {
        let played = golden::play(&golden::scenes(&self.scenes)?)?;
        let differences: Vec<_> = played
            .iter()
            .filter_map(|played| played.difference().map(|text| format!("{}: {text}", played.scene.name)))
            .collect();
        if differences.is_empty() {
            let count = played.len();
            let digest = golden::kernel_digest(&played)
                .map_or_else(String::new, |digest| format!("kernel digest {digest:016x}\n"));
            return Ok(format!(
                "{}{digest}{count} of {count} scenes have the bits of their golden trace\n",
                table(&played)
            ));
        }
        let (different, count) = (differences.len(), played.len());
        Err(Failure::Failed(format!(
            "{different} of {count} scenes differ from their golden trace: {}",
            differences.join("; ")
        )))
    }
}

impl WriteOptions {
    fn carry_out(&self) -> Result<String, Failure> {
        let scenes = golden::scenes(&self.scenes)?;
        for scene in &scenes {
            let path = self.out.join(format!("{}.txt", scene.name));
            if !golden::is_trace(&path, scene) {
                self.overwrite.check_file("DIR", &path)?;
            }
        }
        let played = golden::play(&scenes)?;
        let paths: Vec<_> = played.iter().map(|played| self.out.join(format!("{}.txt", played.scene.name))).collect();
        let files: Vec<_> =
            paths.iter().zip(&played).map(|(path, played)| (path.as_path(), played.text().into_bytes())).collect();
        staging::write_files(&files).map_err(|(path, error)| Failure::writing(&path, error))?;
        Ok(format!("{}{} traces in {}\n", table(&played), files.len(), self.out.display()))
    }
}

fn table(played: &[Played]) -> String {
    let mut text = format!("{:<16} {:>6}  {}\n", "scene", "steps", "final state");
    for played in played {
        let end = played.end();
        let _ = writeln!(text, "{:<16} {:>6}  {:016x}", played.scene.name, end.step, end.state);
    }
    text
}
