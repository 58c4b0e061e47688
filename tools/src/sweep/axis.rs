//! What a sweep changes: axes of levels, each of which sets some parameters.

use std::collections::BTreeMap;

use itertools::Itertools;
use serde::Deserialize;
use softanvil_kernel::parameter::{Kind, Values};
use softanvil_kernel::{Changes, NoEffect, Parameter, Scenario, ScenarioError};

use crate::scenario_file::assign::{self, Written};
use crate::scenario_file::names;

/// A value of a parameter as it is written.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Value {
    /// A number, in the parameter's unit.
    Number(f64),
    /// The label of a choice, or the text of a number.
    Text(String),
}

/// What an axis is at in some of the cases.
#[derive(Clone, Debug, Deserialize)]
pub struct Level {
    /// Name in tables; of a value, the value.
    pub name: String,
    /// What it sets, by name of the parameter; nothing where the scenario stays as it is.
    #[serde(flatten)]
    pub settings: BTreeMap<String, Value>,
}

/// Something that is changed.
#[derive(Clone, Debug)]
pub struct Axis {
    /// Name, with the unit of its numbers.
    pub name: String,
    /// What it is changed to.
    pub levels: Vec<Level>,
}

impl Axis {
    /// An axis of `parameters` that have the same value, over `values` and the value of `scenario`; called as the first of
    /// them without a `name`.
    ///
    /// # Errors
    /// A parameter that is unknown, or a value of the wrong kind.
    pub fn of_values(
        name: Option<&str>,
        parameters: &[String],
        values: &[Value],
        scenario: &Scenario,
    ) -> Result<Self, String> {
        let Some(first) = parameters.first() else { return Err("an axis needs parameters or levels".into()) };
        let parameter = names::find(&Values::of(scenario), first)?;
        let own = parameter.get(scenario);
        let numbers = values.iter().map(|value| number(&parameter, first, value)).collect::<Result<Vec<_>, _>>()?;
        let mut numbers = [&numbers[..], &[own]].concat();
        numbers.sort_by(f64::total_cmp);
        // The same but for rounding.
        let is_same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        numbers.dedup_by(|a, b| is_same(*a, *b));
        let level = |value: f64| {
            let name = text(&parameter, value);
            let set = match parameter.kind() {
                Kind::Choice { .. } => Value::Text(name.clone()),
                Kind::Quantity | Kind::Count => Value::Number(value),
            };
            let changed = parameters.iter().filter(|_| !is_same(value, own));
            Level { name, settings: changed.map(|changed| (changed.clone(), set.clone())).collect() }
        };
        let name = name.unwrap_or(first);
        let name = match parameter.unit() {
            "1" => name.into(),
            unit => format!("{name} [{unit}]"),
        };
        Ok(Self { name, levels: numbers.into_iter().map(level).collect() })
    }

    /// The first level that leaves the scenario as it is.
    pub fn own(&self) -> Option<&Level> {
        self.levels.iter().find(|level| level.settings.is_empty())
    }

    /// Whether its levels are numbers.
    pub fn is_of_numbers(&self) -> bool {
        self.levels.iter().all(|level| level.name.parse::<f64>().is_ok())
    }
}

/// The number that `value` gives to `parameter`, which goes by `name`; of a choice, the index.
fn number(parameter: &Parameter, name: &str, value: &Value) -> Result<f64, String> {
    let (written, text) = match value {
        Value::Number(number) => (Written::Number(*number), &number.to_string()),
        Value::Text(text) => (Written::Bare(text.trim()), text),
    };
    assign::number(parameter, written).map_err(|legal| format!("{name} = {text} is refused: expected {legal}"))
}

/// A value as it is written in a scenario file; twelve digits leave out the noise of rounding.
fn text(parameter: &Parameter, value: f64) -> String {
    match parameter.kind() {
        Kind::Choice { labels } => labels.get(value as usize).copied().unwrap_or_default().into(),
        Kind::Quantity | Kind::Count => format!("{value:.11e}").parse().unwrap_or(value).to_string(),
    }
}

/// Why a combination of levels makes no scenario.
#[derive(Debug, thiserror::Error)]
pub enum Refused {
    /// A level has no effect beside the others.
    #[error("{0}")]
    NoEffect(NoEffect),
    /// Values that do not fit together.
    #[error("{0}")]
    Scenario(#[from] ScenarioError),
    /// A parameter that is unknown, or a value of the wrong kind.
    #[error("{0}")]
    Setting(String),
}

/// The scenario that `levels` make of `base`. Of several parameters that a level sets, one has to act.
///
/// # Errors
/// What is refused, a level without effect, or values that do not fit together.
pub fn combined(base: &Scenario, levels: &[&Level]) -> Result<Scenario, Refused> {
    if let Some(name) = levels.iter().flat_map(|level| level.settings.keys()).duplicates().next() {
        return Err(Refused::Setting(format!("{name} is set by two of the levels")));
    }
    let mut changes = Changes::of(base);
    for (name, value) in levels.iter().flat_map(|level| &level.settings) {
        let parameter = names::find(changes.values(), name).map_err(Refused::Setting)?;
        let value = number(&parameter, name, value).map_err(Refused::Setting)?;
        changes.set(parameter, value).map_err(ScenarioError::from)?;
    }
    let scenario = changes.resolve()?;
    for level in levels {
        let set = level.settings.keys().filter_map(|name| changes.values().find(name));
        let mut idle = set.map(|set| changes.without_effect(&scenario).find(|idle| idle.name == set.name()));
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
        let values = [0.6, 0.2, 0.1 + 0.2, 0.6].map(Value::Number);
        let parameters = ["face.friction_coefficient".to_string()];
        let axis = Axis::of_values(None, &parameters, &values, &preset::study()).unwrap();
        assert_eq!(axis.levels.iter().map(|level| level.name.as_str()).collect::<Vec<_>>(), ["0.2", "0.3", "0.6"]);
        assert_eq!(axis.own().unwrap().name, "0.3");
    }

    /// Friction at a bonded core has no effect, but that under the face has.
    #[test]
    fn one_parameter_of_a_level_has_to_act() {
        let level = |settings: &[(&str, &str)]| Level {
            name: String::new(),
            settings: settings.iter().map(|(name, text)| (name.to_string(), Value::Text(text.to_string()))).collect(),
        };
        let (core, face) = (("core.friction_coefficient", "0.1"), ("face.friction_coefficient", "0.1"));
        let with_bonded = |settings: &[(&str, &str)]| {
            combined(&preset::study(), &[&level(&[("core.interface", "bonded")]), &level(settings)])
        };
        let refused = with_bonded(&[core]).unwrap_err().to_string();
        assert!(refused.contains("core.friction_coefficient = 0.1 has no effect"), "{refused}");
        assert_eq!(with_bonded(&[core, face]).unwrap().face.friction_coefficient, 0.1);
    }
}
