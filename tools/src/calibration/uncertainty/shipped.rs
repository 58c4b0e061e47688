//! The posteriors that come with the program, one beside each preset that has one, written by
//! `softanvil calibrate calibration/PROBLEM.toml --uncertainty`.

use softanvil_kernel::preset::Preset;

use super::posterior::Posterior;
use crate::failure::Failure;

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
