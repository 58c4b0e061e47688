//! From a sweep to its cases.

use itertools::Itertools;
use softanvil_kernel::Scenario;

use super::axis::{Axis, Level, Refused, combined};
use super::case::Case;
use super::{Sweep, convergence};
use crate::failure::Failure;
use crate::run::element_updates;

/// The cases of `sweep` for `scenario`: every combination of the levels, but for those in which one has no effect.
///
/// # Errors
/// Values that do not fit together, a level that has no effect in any combination, or a scenario that cannot be simulated.
pub fn plan(sweep: &Sweep, scenario: &Scenario) -> Result<Vec<Case>, Failure> {
    let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("sweep {}: {error}", sweep.name));
    let mut planned: Vec<(Vec<String>, Scenario)> = Vec::new();
    let mut without_effect = Vec::new();
    for levels in sweep.axes.iter().map(|axis| &axis.levels).multi_cartesian_product() {
        let names: Vec<String> = levels.iter().map(|level| level.name.clone()).collect();
        match combined(scenario, &levels) {
            Ok(scenario) if sweep.refines() => {
                let meshes = convergence::meshes(&scenario, &sweep.refinements).map_err(|error| refuse(&error))?;
                planned.extend(meshes.into_iter().map(|(mesh, scenario)| ([&names[..], &mesh].concat(), scenario)));
            }
            Ok(scenario) => planned.push((names, scenario)),
            Err(Refused::NoEffect(error)) => without_effect.push((names, error)),
            Err(error) => return Err(refuse(&error)),
        }
    }
    for (axis, level) in levels(sweep) {
        if !planned.iter().any(|(settings, _)| settings[axis] == level.name)
            && let Some((_, error)) = without_effect.iter().find(|(names, _)| names[axis] == level.name)
        {
            return Err(refuse(error));
        }
    }
    let references = references(sweep, &planned);
    let case = |((settings, scenario), reference): ((Vec<String>, Scenario), usize)| {
        // One that will be pressed flat is a case that fails, beside others that do not.
        Ok(Case { settings, work: element_updates(&scenario)?, scenario, reference })
    };
    planned.into_iter().zip(references).map(case).collect()
}

/// All levels, each with the number of its axis.
fn levels(sweep: &Sweep) -> impl Iterator<Item = (usize, &Level)> {
    let numbered = sweep.axes.iter().enumerate();
    numbered.flat_map(|(number, axis)| axis.levels.iter().map(move |level| (number, level)))
}

/// For each case the one from which its changes are given: of its group, the finest mesh, the scenario's own value, or the
/// first.
fn references(sweep: &Sweep, planned: &[(Vec<String>, Scenario)]) -> Vec<usize> {
    let own = sweep.axes.last().and_then(Axis::own).map(|own| own.name.as_str());
    let common = sweep.common();
    let reference = |(settings, _): &(Vec<String>, Scenario)| {
        let group = || (0..planned.len()).filter(|number| planned[*number].0[..common] == settings[..common]);
        let found = match sweep.refines() {
            true => group().next_back(),
            false => group().find(|number| own.is_some() && planned[*number].0.last().map(String::as_str) == own),
        };
        found.or_else(|| group().next()).unwrap_or_default()
    };
    planned.iter().map(reference).collect()
}
