//! The options of a prediction with bands.

use std::path::PathBuf;

use clap::Args;
use softanvil_kernel::scenario::Motion;

use crate::calibration::uncertainty::posterior::Posterior;
use crate::calibration::uncertainty::predict::expect;
use crate::calibration::uncertainty::shipped;
use crate::calibration::variable::Variable;
use crate::failure::Failure;
use crate::measurement::band::Expected;
use crate::measurement::reading::Reading;
use crate::output::subject::Subject;
use crate::progress;

/// Whether a drop is predicted with bands, and by what.
#[derive(Debug, Args)]
pub struct UncertaintyOptions {
    /// Predict with 90 % bands of the four numbers and of the force in --plot, by samples of this posterior, as `softanvil
    /// calibrate --uncertainty` writes it [without a file: that of the preset, which `study` has]
    #[arg(long, value_name = "FILE", num_args = 0..=1, conflicts_with = "impacts")]
    uncertainty: Option<Option<PathBuf>>,
    /// Samples that are simulated for them [default: all]
    #[arg(long, value_name = "N", requires = "uncertainty", value_parser = clap::value_parser!(u32).range(20..=2000))]
    samples: Option<u32>,
}

/// A posterior that belongs to a drop.
pub struct Prediction {
    posterior: Posterior,
    variables: Vec<Variable>,
    samples: usize,
}

impl UncertaintyOptions {
    /// The posterior that was asked for, if it belongs to the drop of `subject`.
    ///
    /// # Errors
    /// A file that is no posterior, one of another drop, or a press.
    pub fn posterior(&self, subject: &Subject) -> Result<Option<Prediction>, Failure> {
        let Some(file) = &self.uncertainty else { return Ok(None) };
        if subject.scenario.impactor.motion == Motion::Prescribed {
            let text = "--uncertainty is refused: impactor.motion = prescribed has no impact; expected drop";
            return Err(Failure::Input(text.into()));
        }
        let (posterior, name) = match file {
            Some(path) => (Posterior::read(path)?, path.display().to_string()),
            None => (shipped::of(subject.preset)?, format!("--uncertainty, preset {}", subject.preset.name)),
        };
        let belongs = posterior.check_belongs(&subject.scenario);
        let variables = belongs.map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        let samples = self.samples.map_or(posterior.count(), |samples| samples as usize);
        Ok(Some(Prediction { posterior, variables, samples }))
    }
}

impl Prediction {
    /// Simulates the samples, with progress.
    ///
    /// # Errors
    /// A sample that cannot be simulated.
    pub fn expect(&self, subject: &Subject) -> Result<Expected, Failure> {
        let samples = self.posterior.samples(self.samples);
        let bar = progress::evaluations(samples.len() as u64);
        let (errors, reading) = (self.posterior.errors(), Reading::PLAIN);
        let hear = || bar.inc(1);
        expect(&subject.scenario, subject.until, reading, &self.variables, (&errors, &samples), &hear)
    }
}
