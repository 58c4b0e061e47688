//! The whole of it: from a converged search to the posterior with its bands.

use std::sync::atomic::AtomicBool;

use serde_json::json;

use super::error_model::ErrorModel;
use super::outcome::Outcome;
use super::posterior::{Posterior, rounded};
use super::predict::expect;
use super::runs::Runs;
use super::summary;
use super::waves::{Ended, Inference, Inferred};
use crate::calibration::problem::Problem;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::measurement::band::{Band, Expected};
use crate::measurement::reading::Reading;

/// Infers the posterior of `problem` about the `best` values of its search; `progress` hears of simulated points.
///
/// # Errors
/// A problem without measured numbers, or a file that cannot be written.
pub fn infer(
    problem: &mut Problem,
    best: &[f64],
    folder: &mut Folder,
    stop: &AtomicBool,
    progress: &dyn Fn(usize, &str),
) -> Result<Outcome, Failure> {
    let errors = ErrorModel::new(problem).map_err(Failure::Input)?;
    let digest_of = problem.digest();
    let mut runs = Runs::open(folder, problem)?;
    // What a search leaves out for the sake of speed is as likely as the rest.
    let most = std::mem::take(&mut problem.objective.steps_per_sample);
    let inference = Inference { problem, errors: &errors, seed: problem.search.seed, stop, progress };
    let ended = inference.run(best, &mut runs);
    problem.objective.steps_per_sample = most;
    debug_assert_eq!(digest_of, problem.digest());
    let inferred = match ended? {
        Ended::Inferred(inferred) => inferred,
        Ended::Refused(why) => return Ok(Outcome::Refused(why)),
        Ended::Interrupted => return Ok(Outcome::Interrupted),
    };
    progress(0, "bands");
    let posterior = with_bands(problem, &errors, &inferred)?;
    let text = summary::text(&posterior, &inferred);
    Ok(Outcome::Posterior(Box::new(posterior), text))
}

/// The posterior with the bands of all impacts of the problem.
fn with_bands(problem: &Problem, errors: &ErrorModel, inferred: &Inferred) -> Result<Posterior, Failure> {
    let diagnostics = json!({ "chains": inferred.diagnostics, "emulator": inferred.emulation });
    let mut posterior = Posterior::new(problem, errors, &inferred.samples, diagnostics);
    let samples = posterior.samples(posterior.count());
    let reading = Reading { sensor: problem.objective.force, channel_class: problem.objective.cfc, ..Reading::PLAIN };
    for target in &problem.targets {
        let mut scenario = problem.scenario.clone();
        scenario.impactor = scenario.impactor.with_energy(target.energy);
        let variables = posterior.variables(&scenario).map_err(Failure::Failed)?;
        let expected = expect(&scenario, problem.until, reading, &variables, (errors, &samples), &|| {})?;
        posterior.impacts.push(short(expected, target.energy));
    }
    Ok(posterior)
}

/// With as many digits as the file has.
fn short(expected: Expected, energy: f64) -> Expected {
    let band = |band: Band| Band { low: rounded(band.low), median: rounded(band.median), high: rounded(band.high) };
    let whole = |forces: Vec<f64>| forces.iter().map(|force| force.round()).collect();
    let mut force = expected.force;
    (force.low, force.high) = (whole(force.low), whole(force.high));
    Expected {
        energy,
        samples: expected.samples,
        parameters: expected.parameters.map(band),
        measured: expected.measured.map(band),
        force,
    }
}
