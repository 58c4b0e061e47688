//! The posteriors that come with the program, one beside each preset that has one, written by
//! `softanvil calibrate calibration/PROBLEM.toml --uncertainty`.

use softanvil_kernel::preset::Preset;

use super::posterior::Posterior;
use crate::failure::Failure;
use crate::measurement::reading::Reading;
use crate::paper::validation::Validation;

/// Name of a preset, and its posterior.
const SHIPPED: [(&str, &str); 1] = [("study", include_str!("../../../assets/posteriors/study.json"))];

/// The posterior of `preset`.
///
/// # Errors
/// A preset that has none, with those that do.
pub fn of(preset: &Preset) -> Result<Posterior, Failure> {
    let found = SHIPPED.iter().find(|(name, _)| *name == preset.name);
    let Some((_, text)) = found else {
        let names = SHIPPED.map(|(name, _)| name).join(", ");
        return Err(Failure::Input(format!(
            "--uncertainty is refused: preset {} has no posterior (with one: {names}); give a file, as softanvil calibrate \
             --uncertainty writes it",
            preset.name
        )));
    };
    Posterior::parse(text).map_err(Failure::Failed)
}

/// `validation` with the bands of the posterior of its preset, where there is one of the preset as it is, and the drops are
/// simulated and read as its impacts were.
pub fn add_bands(validation: Validation) -> Validation {
    let scenario = (validation.preset.scenario)();
    let alike = validation.reading == Reading::PLAIN && validation.formulation == scenario.geometry.formulation;
    let posterior = of(validation.preset).ok().filter(|posterior| alike && posterior.check_belongs(&scenario).is_ok());
    match posterior {
        Some(posterior) => validation.with(&posterior.impacts),
        None => validation,
    }
}
