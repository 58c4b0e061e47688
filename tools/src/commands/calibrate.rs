//! `softanvil calibrate`: parameters from measured impacts.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use super::output_files::Overwrite;
use crate::calibration::log::{self, Log};
use crate::calibration::problem::Problem;
use crate::calibration::result::{self, Found};
use crate::calibration::search::search;
use crate::calibration::uncertainty::{self, Outcome, posterior, runs};
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::output::subject::{warning_lines, warnings_of};
use crate::progress;

/// Search for the parameters with which simulated impacts come closest to measured ones.
///
/// The problem file names the parameters with their ranges, the impacts (lines of the paper's table, your own numbers, or
/// force traces) and the score; `calibration/` in the repository holds those of the presets. Interrupt with Ctrl-C: what
/// was found so far is written, and the same command continues. Every evaluation is a line of evaluations.csv; the log of
/// another problem is refused.
#[derive(Debug, Args)]
pub struct Options {
    /// Problem file (TOML)
    problem: PathBuf,
    /// Folder for evaluations.csv, best.toml and the summary; a search that stands there is continued
    #[arg(long, value_name = "DIR", default_value = "softanvil-calibration")]
    out: PathBuf,
    /// Evaluations to spend in all, instead of the problem's
    #[arg(long, value_name = "N")]
    evaluations: Option<usize>,
    /// Seed, instead of the problem's
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Threads [default: one per core]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    threads: usize,
    /// After the search has converged, infer the posterior of the parameters, posterior.json, by which `softanvil run
    /// --uncertainty` draws bands
    #[arg(long)]
    uncertainty: bool,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// Searches until `stop`; returns what was found.
///
/// # Errors
/// A problem that is refused, a log of another problem, or a file that cannot be written.
pub fn carry_out(options: &Options, stop: &AtomicBool) -> Result<String, Failure> {
    let mut problem = Problem::read(&options.problem)?;
    problem.search.evaluations = options.evaluations.unwrap_or(problem.search.evaluations);
    problem.search.seed = options.seed.unwrap_or(problem.search.seed);
    let mut folder = Folder::new(&options.out, options.overwrite.overwrite);
    folder.check(result::FILES.into_iter().chain([log::PROBLEM, posterior::NAME]))?;
    let mut log = Log::open(&mut folder, &problem, options.overwrite.overwrite)?;
    let bar = progress::evaluations(problem.search.evaluations as u64);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|error| Failure::Failed(format!("threads: {error}")))?;
    let descents = pool.install(|| {
        search(&problem, &mut log, stop, &|done, best| {
            bar.set_position(done as u64);
            bar.set_message(format!("score {:.3}, mean error {:.2} %", best.score, best.mean_error));
        })
    })?;
    bar.finish_and_clear();
    let failed = || Failure::Failed("interrupted at once".into());
    let found = Found::new(&problem, &log.entries, descents).ok_or_else(failed)?;
    let warnings = warnings_of(&problem.scenario).unwrap_or_default();
    let outcome = match options.uncertainty {
        true => Some(pool.install(|| infer(&mut problem, &found, &mut folder, stop))?),
        false => None,
    };
    let mut text = warning_lines(&warnings) + &found.write(&problem, outcome.as_ref(), &mut folder)?;
    if let Some(Outcome::Posterior(posterior, _)) = &outcome {
        folder.write(&[(posterior::NAME.into(), posterior.text().into_bytes())])?;
        text += &format!("Written: {} and {}\n", posterior::NAME, runs::NAME);
    }
    if found.evaluations < problem.search.evaluations {
        text += "Interrupted: the same command continues.\n";
    }
    Ok(format!(
        "{text}Written: {}, {} and {} in {}\n",
        result::FILES.join(", "),
        log::NAME,
        log::PROBLEM,
        options.out.display()
    ))
}

/// The posterior, with progress; refused where the search has not converged.
fn infer(problem: &mut Problem, found: &Found, folder: &mut Folder, stop: &AtomicBool) -> Result<Outcome, Failure> {
    if stop.load(Ordering::Relaxed) {
        return Ok(Outcome::Interrupted);
    }
    if !found.convergence.is_reached() {
        return Ok(Outcome::Refused("the search has not converged; more --evaluations continue it".into()));
    }
    let bar = progress::evaluations(0);
    let outcome = uncertainty::infer(problem, &found.entry.values, folder, stop, &|count, what| {
        bar.inc_length(count as u64);
        bar.inc(count as u64);
        bar.set_message(what.to_string());
    });
    bar.finish_and_clear();
    outcome
}
