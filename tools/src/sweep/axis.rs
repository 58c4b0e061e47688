//! What a sweep changes: axes of levels, each of which sets some parameters.

use serde::Deserialize;
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::{Changes, NoEffect, Parameter, Scenario, ScenarioError};

use crate::scenario_file::assign::{self, Written};

/// A value of a parameter as a file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number, in the parameter's unit.
    Number(f64),
    /// The label of a choice.
    Label(String),
}

/// A parameter and its value; of a choice, the index.
pub type Setting = (&'static Parameter, f64);

/// What an axis is at in some of the cases.
#[derive(Clone)]
pub struct Level {
    /// Name in tables; of a value, the value.
    pub name: String,
    /// What it sets; nothing where the scenario stays as it is.
    pub settings: Vec<Setting>,
}

/// Something that is changed.
#[derive(Clone)]
pub struct Axis {
    /// Name, with the unit of its numbers.
    pub name: String,
    /// What it is, for people.
    pub about: String,
    /// What it is changed to.
    pub levels: Vec<Level>,
}

impl Axis {
    /// An axis of one `parameter`, over `values` of a command line and the value of `scenario`.
    ///
    /// # Errors
    /// A value that is refused.
    pub fn of_texts(parameter: &'static Parameter, values: &str, scenario: &Scenario) -> Result<Self, String> {
        let number = |text: &str| setting(parameter, Written::Bare(text.trim()), text.trim());
        let values = values.split(',').map(|text| Ok(number(text)?.1)).collect::<Result<Vec<_>, String>>()?;
        Self::of_numbers(parameter.name, &[parameter], values, scenario)
    }

    /// An axis called `name` of `parameters` that have the same value, over `values` and the value of `scenario`.
    ///
    /// # Errors
    /// A parameter that is unknown, or a value that is refused.
    pub fn of_values(
        name: Option<&str>,
        parameters: &[String],
        values: &[Value],
        scenario: &Scenario,
    ) -> Result<Self, String> {
        let parameters = parameters.iter().map(|name| assign::find(name)).collect::<Result<Vec<_>, _>>()?;
        let Some(first) = parameters.first() else { return Err("an axis needs parameters or levels".into()) };
        let values = values.iter().map(|value| Ok(written(first, value)?.1)).collect::<Result<Vec<_>, String>>()?;
        Self::of_numbers(name.unwrap_or(first.name), &parameters, values, scenario)
    }

    fn of_numbers(
        name: &str,
        parameters: &[&'static Parameter],
        mut values: Vec<f64>,
        scenario: &Scenario,
    ) -> Result<Self, String> {
        let parameter = parameters[0];
        let own = parameter.get(scenario);
        for (parameter, value) in parameters.iter().flat_map(|parameter| values.iter().map(move |v| (*parameter, *v))) {
            parameter.set(&mut scenario.clone(), value).map_err(|error| error.to_string())?;
        }
        values.push(own);
        values.sort_by(f64::total_cmp);
        values.dedup_by(|a, b| is_same(*a, *b));
        let level = |value: f64| {
            let set = parameters.iter().map(|parameter| (*parameter, value));
            let settings = if is_same(value, own) { Vec::new() } else { set.collect() };
            Level { name: text(parameter, value), settings }
        };
        let name = match parameter.kind {
            Kind::Real { unit, .. } if unit != "1" => format!("{name} [{unit}]"),
            _ => name.into(),
        };
        let levels = values.into_iter().map(level).collect();
        Ok(Self { name, about: parameter.description.into(), levels })
    }

    /// The level called `name`, or without a name that of the scenario as it is; its number.
    pub fn position(&self, name: Option<&str>) -> Option<usize> {
        self.levels.iter().position(|level| name.map_or(level.settings.is_empty(), |name| level.name == name))
    }

    /// Whether its levels are numbers.
    pub fn is_of_numbers(&self) -> bool {
        self.levels.iter().all(|level| level.name.parse::<f64>().is_ok())
    }
}

/// What a file says of the parameter called `name`.
///
/// # Errors
/// A name that is unknown, or a value that is refused.
pub fn named(name: &str, value: &Value) -> Result<Setting, String> {
    written(assign::find(name)?, value)
}

fn written(parameter: &'static Parameter, value: &Value) -> Result<Setting, String> {
    match value {
        Value::Number(number) => setting(parameter, Written::Number(*number), &number.to_string()),
        Value::Label(label) => setting(parameter, Written::Label(label), label),
    }
}

fn setting(parameter: &'static Parameter, written: Written, text: &str) -> Result<Setting, String> {
    let number = assign::number(parameter, written);
    number
        .map(|number| (parameter, number))
        .map_err(|legal| format!("{} = {text} is refused: expected {legal}", parameter.name))
}

/// Whether two values are the same but for rounding.
fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs()
}

/// A value as it is written in a scenario file; twelve digits leave out the noise of rounding.
fn text(parameter: &Parameter, value: f64) -> String {
    match parameter.kind {
        Kind::Choice { labels, .. } => labels.get(value as usize).copied().unwrap_or_default().into(),
        Kind::Real { .. } => format!("{value:.11e}").parse().unwrap_or(value).to_string(),
    }
}

/// Why a combination of levels makes no scenario.
#[derive(Debug, thiserror::Error)]
pub enum Refused {
    /// A level has no effect beside the others.
    #[error("{0}")]
    NoEffect(NoEffect),
    /// A value is refused, or the values do not fit together.
    #[error("{0}")]
    Scenario(#[from] ScenarioError),
}

/// The scenario that `levels` make of `base`. Of several parameters that a level sets, one has to act.
///
/// # Errors
/// A level without effect, or values that do not fit together.
pub fn combined(base: &Scenario, levels: &[&Level]) -> Result<Scenario, Refused> {
    let mut changes = Changes::of(base);
    for (parameter, value) in levels.iter().flat_map(|level| &level.settings) {
        changes.set(parameter, *value).map_err(ScenarioError::from)?;
    }
    let scenario = changes.resolve()?;
    for level in levels {
        let idle =
            |(parameter, _): &Setting| changes.without_effect(&scenario).find(|idle| idle.name == parameter.name);
        let mut idle = level.settings.iter().map(idle);
        if let Some(Some(first)) = idle.next()
            && idle.all(|idle| idle.is_some())
        {
            return Err(Refused::NoEffect(first));
        }
    }
    scenario.validate()?;
    Ok(scenario)
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    #[test]
    fn values_are_sorted_stand_once_and_the_scenario_s_own_is_among_them() {
        let parameter = assign::find("face.friction_coefficient").unwrap();
        let axis = Axis::of_texts(parameter, "0.6, 0.2,0.30000000000000004,0.6", &preset::study()).unwrap();
        assert_eq!(axis.levels.iter().map(|level| level.name.as_str()).collect::<Vec<_>>(), ["0.2", "0.3", "0.6"]);
        assert_eq!((axis.position(None), axis.position(Some("0.6"))), (Some(1), Some(2)));
        assert!(Axis::of_texts(parameter, "x", &preset::study()).err().unwrap().contains("= x is refused"));
    }

    /// Friction at a bonded core has no effect, but that under the face has.
    #[test]
    fn one_parameter_of_a_level_has_to_act() {
        let level = |settings: &[(&str, Value)]| Level {
            name: String::new(),
            settings: settings.iter().map(|(name, value)| named(name, value).unwrap()).collect(),
        };
        let bonded = level(&[("core.interface", Value::Label("bonded".into()))]);
        let core = ("core.friction_coefficient", Value::Number(0.1));
        let face = ("face.friction_coefficient", Value::Number(0.1));
        let refused = combined(&preset::study(), &[&bonded, &level(std::slice::from_ref(&core))]).unwrap_err();
        assert!(refused.to_string().contains("core.friction_coefficient = 0.1 has no effect"), "{refused}");
        let scenario = combined(&preset::study(), &[&bonded, &level(&[core, face])]).unwrap();
        assert_eq!(scenario.face.friction_coefficient, 0.1);
    }
}
