//! [`Settings`]: a scenario on its way, a preset with texts upon it and the values given over them.

use pyo3::prelude::*;
use pyo3::types::PyBool;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::preset::Preset;
use softanvil_kernel::scenario::Impactor;
use softanvil_kernel::{Changes, Parameter, ParameterError, Scenario, ScenarioError};
use softanvil_tools::output::subject::Subject;
use softanvil_tools::presets;
use softanvil_tools::run::Until;
use softanvil_tools::scenario_file::{self, names};

use crate::error::{self, IntoPython, OrRaise};
use crate::quantity;

/// Names that people use for parameters of the start, as the options of the command line.
const SHORT: [(&str, &str); 3] = [
    ("impactor.energy", "impactor.drop_energy"),
    ("impactor.height", "impactor.drop_height"),
    ("impactor.speed", "impactor.drop_speed"),
];

/// A TOML text that was read upon a preset.
#[derive(Clone, PartialEq)]
struct Text {
    content: String,
    /// Whether it is of a material alone.
    material: bool,
}

/// A preset, texts upon it, and values given over them.
#[pyclass(module = "softanvil._softanvil", from_py_object)]
#[derive(Clone)]
pub struct Settings {
    preset: &'static Preset,
    texts: Vec<Text>,
    layer_names: Vec<(usize, String)>,
    given: Vec<(Parameter, f64)>,
    /// The preset with the texts.
    base: Scenario,
    /// With the values, some of which may have no effect.
    resolved: Scenario,
}

/// All that makes [`Settings`]: preset, texts with whether they are of a material, names of layers, values by name.
type Content = (String, Vec<(String, bool)>, Vec<(usize, String)>, Vec<(String, f64)>);

impl Settings {
    /// The values as they stand.
    pub fn resolved(&self) -> &Scenario {
        &self.resolved
    }

    /// The scenario, in which every given value acts.
    ///
    /// # Errors
    /// Values that have no effect or do not fit together.
    pub fn scenario(&self) -> Result<Scenario, ScenarioError> {
        self.changes().apply()
    }

    /// What is simulated: with a duration of its own until that, otherwise until the contact has ended.
    ///
    /// # Errors
    /// As [`Settings::scenario`].
    pub fn subject(&self) -> Result<Subject, ScenarioError> {
        let scenario = self.scenario()?;
        let is_duration = |(parameter, _): &(Parameter, f64)| parameter.name() == "time.duration";
        let own =
            self.given.iter().any(is_duration) || self.base.time.duration != (self.preset.scenario)().time.duration;
        let set =
            self.given.iter().map(|(parameter, value)| format!("{} = {}", parameter.name(), shown(parameter, *value)));
        Ok(Subject {
            scenario,
            until: if own { Until::Duration } else { Until::Over },
            preset: self.preset,
            scenario_file: None,
            material_file: None,
            set: set.collect(),
        })
    }

    fn changes(&self) -> Changes {
        let mut changes = Changes::of(&self.base);
        for (layer, name) in &self.layer_names {
            changes.name_layer(*layer, name);
        }
        for (parameter, value) in &self.given {
            // It was checked when it was given.
            let _ = changes.set(*parameter, *value);
        }
        changes
    }

    /// The parameter that `name` means.
    ///
    /// # Errors
    /// That there is none, with the nearest one.
    pub fn find(&self, name: &str) -> Result<Parameter, String> {
        let long = SHORT.iter().find(|(short, _)| *short == name).map_or(name, |(_, long)| long);
        names::find(self.changes().values(), long)
    }

    /// Gives `value` to `parameter`; of what states the same thing, the last that is given counts. Returns what counts no more.
    ///
    /// # Errors
    /// A value that is out of its range; nothing changes then.
    pub fn give(&mut self, parameter: Parameter, value: f64) -> Result<Vec<Parameter>, ParameterError> {
        parameter.check(value)?;
        let mut dropped = Vec::new();
        self.given.retain(|(known, _)| *known != parameter);
        self.given.push((parameter, value));
        if parameter.name() == "layers.count" {
            self.given.retain(|(known, _)| known.layer().is_none_or(|layer| (layer as f64) < value));
            self.layer_names.retain(|(layer, _)| (*layer as f64) < value);
        }
        loop {
            match self.changes().resolve() {
                Ok(scenario) => {
                    self.resolved = scenario;
                    return Ok(dropped);
                }
                Err(ScenarioError::Contradiction { names }) => {
                    let is_other =
                        |known: &Parameter| *known != parameter && names.iter().any(|name| known.name() == *name);
                    dropped.extend(self.given.iter().map(|(known, _)| *known).filter(is_other));
                    let before = self.given.len();
                    self.given.retain(|(known, _)| !is_other(known));
                    if self.given.len() == before {
                        return Ok(dropped);
                    }
                }
                Err(_) => return Ok(dropped),
            }
        }
    }

    /// The number that `value` gives to `parameter`; of a choice its index.
    ///
    /// # Errors
    /// A value of another kind.
    pub fn number(&self, parameter: &Parameter, value: &Bound<'_, PyAny>) -> PyResult<f64> {
        let py = value.py();
        let refuse = |legal: String| {
            let name = parameter.name().to_string();
            let written = value.repr().map_or_else(|_| "a value".into(), |text| text.to_string());
            let message = format!("{name} = {written} is refused: expected {legal}");
            error::kind(py, message, name, value.clone().unbind(), parameter.unit(), parameter.range())
        };
        let (min, max) = parameter.range();
        let text = value.extract::<String>().ok();
        match (parameter.kind(), text) {
            (Kind::Choice { labels }, Some(text)) if labels.contains(&text.as_str()) => {
                Ok(labels.iter().position(|label| *label == text).unwrap_or_default() as f64)
            }
            (Kind::Choice { labels }, _) => {
                let quoted: Vec<_> = labels.iter().map(|label| format!("\"{label}\"")).collect();
                Err(refuse(quoted.join(" or ")))
            }
            (kind, text) => {
                let unit = parameter.unit();
                let legal = match (kind, unit) {
                    (Kind::Count, _) => format!("a whole number, {min} to {max}"),
                    (_, "1") => format!("a number, {min} to {max}"),
                    _ => format!("a number, {min} to {max} {unit}, or a text with a unit, such as \"1 {unit}\""),
                };
                let number = match (kind, text) {
                    (Kind::Quantity, Some(text)) => quantity::parse(&text, unit),
                    (_, None) if !is_bool(value) => plain(value, unit),
                    _ => None,
                };
                number.ok_or_else(|| refuse(legal))
            }
        }
    }

    /// Renews what follows from the texts.
    fn set_base(&mut self, base: Scenario) {
        self.base = base;
        self.resolved = self.changes().resolve().unwrap_or_else(|_| self.base.clone());
    }
}

/// Whether `value` is a truth value, of Python or of numpy, which would pass for 0 or 1.
fn is_bool(value: &Bound<'_, PyAny>) -> bool {
    value.is_instance_of::<PyBool>() || value.get_type().name().is_ok_and(|name| name == "bool" || name == "bool_")
}

/// The number that `value` is; of a quantity with a unit (one of pint), in `unit`.
fn plain(value: &Bound<'_, PyAny>, unit: &str) -> Option<f64> {
    if !(value.hasattr("magnitude").ok()? && value.hasattr("to").ok()?) {
        return value.extract().ok();
    }
    let spelling = match unit {
        "1" => "dimensionless".into(),
        unit => unit.replace('.', "*").replace("m3", "m**3").replace("s2", "s**2"),
    };
    value.call_method1("to", (spelling,)).ok()?.getattr("magnitude").ok()?.extract().ok()
}

/// The value of a parameter for people: a label, or a number.
fn shown(parameter: &Parameter, value: f64) -> String {
    parameter.labels().get(value as usize).map_or_else(|| value.to_string(), |label| (*label).to_string())
}

/// The start of a fall by its short name, whatever states it, in SI units.
fn start(impactor: &Impactor, name: &str) -> Option<f64> {
    let speed = impactor.start_speed();
    let (long, follows) = match name {
        "impactor.energy" => (impactor.drop_energy, 0.5 * impactor.mass * speed * speed),
        "impactor.height" => (impactor.drop_height, speed * speed / (2.0 * impactor.gravity)),
        "impactor.speed" => (impactor.drop_speed, speed),
        _ => return None,
    };
    let states = Parameter::find("impactor.drop_by")?.labels().get(impactor.drop_by as usize)?;
    Some(if name.ends_with(states) { long } else { follows })
}

#[pymethods]
impl Settings {
    /// Those of the preset called `name`.
    #[new]
    fn new(py: Python<'_>, name: &str) -> PyResult<Self> {
        let refuse = |legal| error::scenario(py, format!("preset = {name:?} is refused: {legal}"));
        let preset = presets::parse(name).map_err(refuse)?;
        let base = (preset.scenario)();
        let (texts, layer_names, given) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Self { preset, texts, layer_names, given, resolved: base.clone(), base })
    }

    /// Another one like it, by what `content` gives.
    #[staticmethod]
    fn of_content(py: Python<'_>, content: Content) -> PyResult<Self> {
        let (preset, texts, layer_names, given) = content;
        let mut settings = Self::new(py, &preset)?;
        for (text, material) in texts {
            settings.read(py, text, material)?;
        }
        settings.layer_names = layer_names;
        for (name, value) in given {
            let parameter = Parameter::find(&name).ok_or_else(|| error::scenario(py, format!("{name} is unknown")))?;
            settings.give(parameter, value).map_err(|error| error::parameter(py, &error))?;
        }
        settings.set_base(settings.base.clone());
        Ok(settings)
    }

    /// All that makes it, for [`Settings::of_content`].
    fn content(&self) -> Content {
        let texts = self.texts.iter().map(|text| (text.content.clone(), text.material)).collect();
        let given = self.given.iter().map(|(parameter, value)| (parameter.name().to_string(), *value)).collect();
        (self.preset.name.into(), texts, self.layer_names.clone(), given)
    }

    fn __reduce__(&self, py: Python<'_>) -> PyResult<(Py<PyAny>, (Content,))> {
        Ok((py.get_type::<Self>().getattr("of_content")?.unbind(), (self.content(),)))
    }

    /// A copy that goes its own way.
    fn copy(&self) -> Self {
        self.clone()
    }

    fn __eq__(&self, other: &Self) -> bool {
        let until = |settings: &Self| settings.subject().map(|subject| subject.until).ok();
        self.resolved == other.resolved && until(self) == until(other)
    }

    /// Reads a scenario, or a `material` alone, upon what there is; the given values stay over it.
    fn read(&mut self, py: Python<'_>, text: String, material: bool) -> PyResult<()> {
        let parse = if material { scenario_file::parse_material } else { scenario_file::parse };
        let base = parse(&text, &self.base).or_raise(py)?;
        self.texts.push(Text { content: text, material });
        self.set_base(base);
        Ok(())
    }

    /// The name of the parameter called `name` that does not depend on how layers are called.
    fn full_name(&self, py: Python<'_>, name: &str) -> PyResult<String> {
        let parameter = self.find(name).map_err(|reason| error::scenario(py, reason))?;
        Ok(parameter.name().to_string())
    }

    /// The value of the parameter called `name`: a number, or the label of a choice.
    fn get(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        if let Some(start) = start(&self.resolved.impactor, name) {
            return Ok(start.into_pyobject(py)?.into_any().unbind());
        }
        let parameter = self.find(name).map_err(|reason| error::scenario(py, reason))?;
        if let Some(layer) = parameter.layer().filter(|layer| *layer >= self.resolved.layers.len()) {
            let count = self.resolved.layers.len();
            return Err(error::index(format!("layers[{layer}] is not there: layers.count is {count}")));
        }
        let value = parameter.get(&self.resolved);
        Ok(match parameter.kind() {
            Kind::Quantity => value.into_pyobject(py)?.into_any().unbind(),
            Kind::Count => (value as i64).into_pyobject(py)?.into_any().unbind(),
            Kind::Choice { .. } => shown(&parameter, value).into_pyobject(py)?.into_any().unbind(),
        })
    }

    /// Gives a value; of what states the same thing (energy, height, speed), the last that is given counts.
    fn set(&mut self, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let py = value.py();
        let parameter = self.find(name).map_err(|reason| error::scenario(py, reason))?;
        let number = self.number(&parameter, value)?;
        self.give(parameter, number).map(|_| ()).map_err(|error| error::parameter(py, &error))
    }

    /// Takes a given value back.
    fn unset(&mut self, py: Python<'_>, name: &str) -> PyResult<()> {
        let parameter = self.find(name).map_err(|reason| error::scenario(py, reason))?;
        let before = self.given.len();
        self.given.retain(|(known, _)| *known != parameter);
        if self.given.len() == before {
            return Err(error::scenario(
                py,
                format!("{name} was not given: its value is that of the preset or the text"),
            ));
        }
        self.set_base(self.base.clone());
        Ok(())
    }

    /// Calls a layer `name`.
    fn name_layer(&mut self, py: Python<'_>, layer: usize, name: String) -> PyResult<()> {
        let refuse = |legal: String| {
            error::scenario(py, format!("layers[{layer}].name = {name:?} is refused: expected {legal}"))
        };
        names::check_layer_name(self.changes().values(), layer, &name).map_err(refuse)?;
        self.layer_names.retain(|(known, _)| *known != layer);
        self.layer_names.push((layer, name));
        self.set_base(self.base.clone());
        Ok(())
    }

    /// Names of the layers, from the core to the surface.
    #[getter]
    fn layers(&self) -> Vec<String> {
        self.resolved.layers.iter().map(|layer| layer.name.to_string()).collect()
    }

    /// Name of the preset.
    #[getter]
    fn preset(&self) -> &'static str {
        self.preset.name
    }

    /// Names of the given values.
    #[getter]
    fn given(&self) -> Vec<String> {
        self.given.iter().map(|(parameter, _)| parameter.name().to_string()).collect()
    }

    /// Names of the parameters that have no effect beside the others.
    fn without_effect(&self) -> Vec<String> {
        let idle = Parameter::of(&self.resolved).filter(|parameter| parameter.without_effect(&self.resolved).is_some());
        idle.map(|parameter| parameter.name().to_string()).collect()
    }

    /// Checks that every given value acts, and that they fit together.
    fn validate(&self, py: Python<'_>) -> PyResult<()> {
        self.scenario().map(|_| ()).map_err(|error| error.into_python(py))
    }

    /// The scenario as a TOML text with unit, range and meaning of every line.
    fn to_toml(&self) -> String {
        scenario_file::to_toml(&self.resolved)
    }

    /// What is simulated, in lines.
    fn text(&self, py: Python<'_>) -> PyResult<String> {
        Ok(self.subject().or_raise(py)?.text())
    }
}
