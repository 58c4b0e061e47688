//! A sweep as a file has it: TOML with what is changed and why.

use std::path::Path;

use itertools::Itertools;
use serde::Deserialize;
use softanvil_kernel::Scenario;

use super::axis::{Axis, Level, Value};
use super::{Contrast, Sweep};
use crate::failure::Failure;
use crate::scenario_file;

/// The file, as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    title: String,
    #[serde(default)]
    about: String,
    #[serde(default)]
    axis: Vec<FileAxis>,
    #[serde(default)]
    convergence: Vec<f64>,
    #[serde(default)]
    contrast: Vec<Contrast>,
}

/// Parameters that have the same value, or levels of several settings each.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileAxis {
    name: Option<String>,
    #[serde(default)]
    parameters: Vec<String>,
    #[serde(default)]
    values: Vec<Value>,
    #[serde(default)]
    levels: Vec<Level>,
}

/// Reads the sweep at `path`, whose levels change `scenario`; `refinements` stand in place of the file's, unless there are none.
///
/// # Errors
/// A file that cannot be read, or what is refused in it, with its name.
pub fn read(path: &Path, scenario: &Scenario, refinements: &[f64]) -> Result<Sweep, Failure> {
    let refuse = |error: String| Failure::Input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(error.to_string()))?;
    let mut sweep = parse(&text, scenario).map_err(refuse)?;
    sweep.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    sweep.arguments = path.display().to_string();
    if !refinements.is_empty() {
        sweep.refinements = refinements.to_vec();
        sweep.contrasts.clear();
    }
    Ok(sweep)
}

/// The sweep in `text`, whose levels change `scenario`; without a name.
///
/// # Errors
/// The first thing that is refused.
pub fn parse(text: &str, scenario: &Scenario) -> Result<Sweep, String> {
    let File { title, about, axis, convergence, contrast } = scenario_file::from_toml(text)?;
    let axes = axis.into_iter().map(|axis| axis.read(scenario)).collect::<Result<Vec<_>, _>>()?;
    check_refinements(&convergence)?;
    if axes.is_empty() && convergence.is_empty() {
        return Err("nothing is changed: expected [[axis]] or convergence".into());
    }
    let names = axes.iter().map(|axis| &axis.name);
    let twice = names.duplicates().chain(axes.iter().flat_map(|axis| axis.levels.iter().map(|l| &l.name).duplicates()));
    if let Some(name) = twice.into_iter().next() {
        return Err(format!("axis: {name} stands twice"));
    }
    if !contrast.is_empty() && !convergence.is_empty() {
        return Err("contrast has no effect beside convergence".into());
    }
    let is_level = |(axis, name): (&Axis, &String)| axis.levels.iter().any(|level| level.name == *name);
    let is_case = |names: &&Vec<String>| names.len() == axes.len() && axes.iter().zip(*names).all(is_level);
    if let Some(names) = contrast.iter().flat_map(|c| [&c.from, &c.to]).find(|names| !is_case(names)) {
        return Err(format!("contrast: {names:?} is refused: expected a level of each axis"));
    }
    let (name, arguments) = (String::new(), String::new());
    Ok(Sweep { name, title, about, arguments, axes, refinements: convergence, contrasts: contrast })
}

/// Checks the parts into which a mesh is to divide an element.
///
/// # Errors
/// One that is out of range.
pub fn check_refinements(refinements: &[f64]) -> Result<(), String> {
    match refinements.iter().find(|factor| !(0.01..=100.0).contains(*factor)) {
        Some(factor) => {
            Err(format!("convergence: {factor} is refused: expected factors from 0.01 to 100, such as 1,2,4"))
        }
        None => Ok(()),
    }
}

impl FileAxis {
    fn read(self, scenario: &Scenario) -> Result<Axis, String> {
        match [self.levels.is_empty(), self.parameters.is_empty(), self.values.is_empty()] {
            [true, false, false] => Axis::of_values(self.name.as_deref(), &self.parameters, &self.values, scenario),
            [false, true, true] => Ok(Axis { name: self.name.unwrap_or("level".into()), levels: self.levels }),
            _ => Err("axis: expected parameters with values, or levels".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    const GOOD: &str = "title = \"Core\"\n[[axis]]\nname = \"core\"\nlevels = [{ name = \"as it is\" }, { name = \"bonded\", \
                        \"core.interface\" = \"bonded\" }]\n[[axis]]\nparameters = [\"face.friction_coefficient\"]\n\
                        values = [0, 0.2]\n[[contrast]]\nwhat = \"bond\"\nfrom = [\"as it is\", \"0\"]\nto = [\"bonded\", \"0\"]\n";

    /// The first sweep of the documentation, and that above.
    #[test]
    fn values_levels_and_contrasts_are_read() {
        let sweep = parse(GOOD, &preset::study()).unwrap();
        assert_eq!(sweep.headings(), ["core", "face.friction_coefficient"]);
        let names = |axis: &Axis| axis.levels.iter().map(|level| level.name.clone()).collect::<Vec<_>>().join(" ");
        assert_eq!(sweep.axes.iter().map(names).collect::<Vec<_>>(), ["as it is bonded", "0 0.2 0.3"]);
        assert_eq!((sweep.contrasts[0].from[0].as_str(), sweep.contrasts[0].to[0].as_str()), ("as it is", "bonded"));
        let page = include_str!("../../../docs/sweeps.md");
        let text = page.split("```toml\n").nth(1).unwrap().split("```").next().unwrap();
        let text = text.replace("convergence", "# convergence");
        assert_eq!(parse(&text, &preset::study()).unwrap().contrasts.len(), 1);
    }

    #[test]
    fn what_is_refused_says_what_is_legal() {
        for (from, to, message) in [
            ("title", "titel", "line 1: unknown field `titel`"),
            ("face.", "fase.", "fase.friction_coefficient is unknown (did you mean face.friction_coefficient?)"),
            ("[0, 0.2]", "[0, \"x\"]", "face.friction_coefficient = x is refused: expected a number"),
            ("values = [0, 0.2]", "", "axis: expected parameters with values, or levels"),
            ("\"as it is\"", "\"bonded\"", "axis: bonded stands twice"),
            ("\"core\"", "\"face.friction_coefficient\"", "axis: face.friction_coefficient stands twice"),
            ("\"0\"]\nto", "\"0.1\"]\nto", "contrast: [\"as it is\", \"0.1\"] is refused"),
            ("title = \"Core\"", "title = \"Core\"\nconvergence = [0]", "convergence: 0 is refused"),
            ("title = \"Core\"", "title = \"Core\"\nconvergence = [2]", "contrast has no effect beside convergence"),
        ] {
            let error = parse(&GOOD.replacen(from, to, 1), &preset::study()).unwrap_err();
            assert!(error.contains(message), "{error}");
        }
        assert!(parse("title = \"Nothing\"", &preset::study()).unwrap_err().contains("nothing is changed"));
    }
}
