//! `softanvil calibrate`: parameters from measured impacts.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use super::output_files::Overwrite;
use crate::calibration::front::{self, Point};
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
/// was found so far is written, the exit code is 130, and the same command continues. Every evaluation is a line of
/// evaluations.csv; the log of another problem is refused.
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
    /// Search once for each of these weights of the material tests, in folders of their own, and show what impacts and tests
    /// cost each other: front.csv, front.svg and front.txt
    #[arg(long, value_name = "W", num_args = 1.., value_delimiter = ',')]
    material_weights: Vec<f64>,
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
    if options.material_weights.is_empty() {
        return Ok(search_in(&mut problem, &options.out, options, stop)?.0);
    }
    show_front(&mut problem, options, stop)
}

/// A search for each weight of the material tests.
fn show_front(problem: &mut Problem, options: &Options, stop: &AtomicBool) -> Result<String, Failure> {
    if problem.material_tests.iter().all(|test| test.predict) {
        return Err(Failure::Input("--material-weights has no effect: no [[material_test]] counts".into()));
    }
    if !problem.has_numbers() {
        let reason =
            "--material-weights is refused: traces alone were measured; expected numbers, whose mean error it shows";
        return Err(Failure::Input(reason.into()));
    }
    let mut folder = Folder::new(&options.out, options.overwrite.overwrite);
    folder.check(front::FILES)?;
    let mut points = Vec::new();
    for weight in &options.material_weights {
        problem.objective.material_weight = *weight;
        problem.objective.check().map_err(Failure::Input)?;
        let out = options.out.join(format!("weight-{weight}"));
        match search_in(problem, &out, options, stop) {
            // The points until then.
            Err(Failure::Interrupted) if !points.is_empty() => break,
            found => points.push(Point::of(problem, &found?.1)),
        }
    }
    let picture = front::picture(&points).map_err(|error| Failure::Failed(error.to_string()))?;
    let text = front::text(&points);
    let contents = [front::csv(&points), picture, text.clone()].map(String::into_bytes);
    folder.write(&front::FILES.map(String::from).into_iter().zip(contents).collect::<Vec<_>>())?;
    Ok(format!("{text}Written: {} in {}\n", front::FILES.join(", "), options.out.display()))
}

/// Searches with the results in the folder `out`; returns them as a text, too.
fn search_in(
    problem: &mut Problem,
    out: &Path,
    options: &Options,
    stop: &AtomicBool,
) -> Result<(String, Found), Failure> {
    let mut folder = Folder::new(out, options.overwrite.overwrite);
    folder.check(result::FILES.into_iter().chain([log::PROBLEM, posterior::NAME]))?;
    let mut log = Log::open(&mut folder, problem, options.overwrite.overwrite)?;
    let bar = progress::evaluations(problem.search.evaluations as u64);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(options.threads).build();
    let pool = pool.map_err(|error| Failure::Failed(format!("threads: {error}")))?;
    let descents = pool.install(|| {
        search(problem, &mut log, stop, &|done, best| {
            bar.set_position(done as u64);
            // Of traces alone there is no mean.
            let mean =
                if best.mean_error.is_nan() { String::new() } else { format!(", mean error {:.2} %", best.mean_error) };
            bar.set_message(format!("score {:.3}{mean}", best.score));
        })
    })?;
    bar.finish_and_clear();
    let found = Found::new(problem, &log.entries, descents).ok_or(Failure::Interrupted)?;
    let warnings = warnings_of(&problem.scenario).unwrap_or_default();
    let outcome = match options.uncertainty {
        true => Some(pool.install(|| infer(problem, &found, &mut folder, stop))?),
        false => None,
    };
    let mut text = warning_lines(&warnings) + &found.write(problem, outcome.as_ref(), &mut folder)?;
    if let Some(Outcome::Posterior(posterior, _)) = &outcome {
        folder.write(&[(posterior::NAME.into(), posterior.text().into_bytes())])?;
        text += &format!("Written: {} and {}\n", posterior::NAME, runs::NAME);
    }
    if found.evaluations < problem.search.evaluations {
        text += "Interrupted: the same command continues.\n";
    }
    let text = format!(
        "{text}Written: {}, {} and {} in {}\n",
        result::FILES.join(", "),
        log::NAME,
        log::PROBLEM,
        out.display()
    );
    Ok((text, found))
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
