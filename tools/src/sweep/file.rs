//! A sweep as a file has it: TOML with what is changed and why.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use softanvil_kernel::Scenario;

use super::axis::{self, Axis, Level, Value};
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
    contrast: Vec<FileContrast>,
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
    levels: Vec<FileLevel>,
}

#[derive(Deserialize)]
struct FileLevel {
    name: String,
    #[serde(flatten)]
    settings: BTreeMap<String, Value>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FileContrast {
    what: Option<String>,
    from: Vec<String>,
    to: Vec<String>,
    paper: Option<String>,
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

fn parse(text: &str, scenario: &Scenario) -> Result<Sweep, String> {
    let file: File = scenario_file::from_toml(text)?;
    let axes = file.axis.iter().map(|axis| axis.read(scenario)).collect::<Result<Vec<_>, _>>()?;
    check_refinements(&file.convergence)?;
    if axes.is_empty() && file.convergence.is_empty() {
        return Err("nothing is changed: expected [[axis]] or convergence".into());
    }
    if !file.contrast.is_empty() && !file.convergence.is_empty() {
        return Err("contrast has no effect beside convergence".into());
    }
    let contrasts = file.contrast.into_iter().map(|contrast| contrast.read(&axes)).collect::<Result<Vec<_>, _>>()?;
    let (name, arguments) = (String::new(), String::new());
    Ok(Sweep { name, title: file.title, about: file.about, arguments, axes, refinements: file.convergence, contrasts })
}

/// Checks the parts into which a mesh is to divide an element.
///
/// # Errors
/// One that is no positive number.
pub fn check_refinements(refinements: &[f64]) -> Result<(), String> {
    match refinements.iter().find(|factor| !(**factor >= 0.01 && **factor <= 100.0)) {
        Some(factor) => {
            Err(format!("convergence: {factor} is refused: expected factors from 0.01 to 100, such as 1,2,4"))
        }
        None => Ok(()),
    }
}

impl FileAxis {
    fn read(&self, scenario: &Scenario) -> Result<Axis, String> {
        let name = self.name.as_deref();
        match (self.levels.is_empty(), self.parameters.is_empty() || self.values.is_empty()) {
            (true, false) => Axis::of_values(name, &self.parameters, &self.values, scenario),
            (false, true) if self.parameters.len() + self.values.len() == 0 => {
                let levels = self.levels.iter().map(FileLevel::read).collect::<Result<_, _>>()?;
                Ok(Axis { name: name.unwrap_or("level").into(), about: String::new(), levels })
            }
            _ => Err("axis: expected parameters with values, or levels".into()),
        }
    }
}

impl FileLevel {
    fn read(&self) -> Result<Level, String> {
        let settings = self.settings.iter().map(|(name, value)| axis::named(name, value));
        Ok(Level { name: self.name.clone(), settings: settings.collect::<Result<_, _>>()? })
    }
}

impl FileContrast {
    fn read(self, axes: &[Axis]) -> Result<Contrast, String> {
        for names in [&self.from, &self.to] {
            let is_known = names.len() == axes.len()
                && names.iter().zip(axes).all(|(name, axis)| axis.position(Some(name)).is_some());
            if !is_known {
                return Err(format!("contrast: {names:?} is refused: expected a level of each axis"));
            }
        }
        let what = self.what.unwrap_or_else(|| format!("{} to {}", self.from.join(", "), self.to.join(", ")));
        Ok(Contrast { what, from: self.from, to: self.to, paper: self.paper })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    const GOOD: &str = "title = \"Core\"\n[[axis]]\nname = \"core\"\nlevels = [{ name = \"as it is\" }, { name = \"bonded\", \
                        \"core.interface\" = \"bonded\" }]\n[[axis]]\nparameters = [\"face.friction_coefficient\"]\n\
                        values = [0, 0.2]\n[[contrast]]\nfrom = [\"as it is\", \"0\"]\nto = [\"bonded\", \"0\"]\n";

    #[test]
    fn values_levels_and_contrasts_are_read() {
        let sweep = parse(GOOD, &preset::study()).unwrap();
        assert_eq!(sweep.headings(), ["core", "face.friction_coefficient"]);
        let names: Vec<Vec<&str>> =
            sweep.axes.iter().map(|axis| axis.levels.iter().map(|level| level.name.as_str()).collect()).collect();
        assert_eq!(names, [vec!["as it is", "bonded"], vec!["0", "0.2", "0.3"]]);
        assert_eq!(sweep.contrasts[0].what, "as it is, 0 to bonded, 0");
    }

    #[test]
    fn what_is_refused_says_what_is_legal() {
        for (from, to, message) in [
            ("title", "titel", "line 1: unknown field `titel`"),
            ("core.interface", "core.interfaces", "core.interfaces is unknown (did you mean core.interface?)"),
            ("= \"bonded\" }", "= \"glued\" }", "core.interface = glued is refused: expected \"bonded\""),
            ("[0, 0.2]", "[0, -0.2]", "face.friction_coefficient = -0.2 is refused"),
            ("values = [0, 0.2]", "", "axis: expected parameters with values, or levels"),
            ("\"0\"]\nto", "\"0.1\"]\nto", "contrast: [\"as it is\", \"0.1\"] is refused"),
            ("title = \"Core\"", "title = \"Core\"\nconvergence = [0]", "convergence: 0 is refused"),
            ("title = \"Core\"", "title = \"Core\"\nconvergence = [2]", "contrast has no effect beside convergence"),
        ] {
            let error = parse(&GOOD.replacen(from, to, 1), &preset::study()).err().unwrap();
            assert!(error.contains(message), "{error}");
        }
        assert!(parse("title = \"Nothing\"", &preset::study()).err().unwrap().contains("nothing is changed"));
    }
}
