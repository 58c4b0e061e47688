//! Which drop a reader of the page asks for.

use serde::{Deserialize, Serialize};
use softanvil_kernel::{Changes, Parameter, Scenario};

use crate::output::subject::Subject;
use crate::presets;
use crate::run::Until;
use crate::scenario_file::{self, assign, names};

/// A preset, a scenario file upon it, and values over both.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub struct Asked {
    /// Name of the preset.
    pub preset: String,
    /// Text of a scenario file; empty if there is none.
    #[serde(default)]
    pub toml: String,
    /// Names of parameters and their values as they were typed.
    #[serde(default)]
    pub given: Vec<(String, String)>,
}

/// Why no drop can be simulated.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Refusal {
    /// Names of the values that are refused, each with the reason.
    pub fields: Vec<(String, String)>,
    /// A reason that is of no single value.
    pub message: Option<String>,
}

impl Refusal {
    /// Of what speaks against the scenario as a whole: beside every parameter that `message` names.
    pub fn of(message: String) -> Self {
        let named = Parameter::all().map(|parameter| parameter.name().to_string());
        let fields = named.filter(|name| names_it(&message, name)).map(|name| (name, message.clone())).collect();
        Self { fields, message: Some(message) }
    }
}

/// Whether `text` has `name` as a word of its own.
fn names_it(text: &str, name: &str) -> bool {
    text.match_indices(name).any(|(at, _)| {
        let after = text[at + name.len()..].chars().next();
        !after.is_some_and(|next| next == '_' || next.is_ascii_alphanumeric())
    })
}

impl Asked {
    /// The drop that is asked for.
    ///
    /// # Errors
    /// Every value that is refused, or what speaks against all of them together.
    pub fn subject(&self) -> Result<Subject, Refusal> {
        let preset = presets::parse(&self.preset)
            .map_err(|legal| Refusal::of(format!("preset {} is unknown: {legal}", self.preset)))?;
        let start = (preset.scenario)();
        let base = scenario_file::parse(&self.toml, &start).map_err(|error| Refusal::of(error.to_string()))?;
        let mut changes = Changes::of(&base);
        let refused = self.given.iter().filter_map(|(name, text)| {
            let set = names::find(changes.values(), name)
                .and_then(|parameter| assign::set_bare(&mut changes, parameter, text));
            set.err().map(|reason| (name.clone(), reason))
        });
        let fields: Vec<_> = refused.collect();
        if !fields.is_empty() {
            return Err(Refusal { fields, message: None });
        }
        let scenario = changes.apply().map_err(|error| Refusal::of(error.to_string()))?;
        Ok(self.subject_of(scenario, &start, preset))
    }

    fn subject_of(
        &self,
        scenario: Scenario,
        start: &Scenario,
        preset: &'static softanvil_kernel::preset::Preset,
    ) -> Subject {
        let lasts = |scenario: &Scenario| scenario.time.duration;
        let own_duration =
            lasts(&scenario) != lasts(start) || self.given.iter().any(|(name, _)| name == "time.duration");
        Subject {
            until: if own_duration { Until::Duration } else { Until::Over },
            preset,
            scenario_file: None,
            material_file: None,
            set: self.given.iter().map(|(name, text)| format!("{name}={}", text.trim())).collect(),
            scenario,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(given: &[(&str, &str)]) -> Asked {
        let given = given.iter().map(|(name, text)| (name.to_string(), text.to_string())).collect();
        Asked { preset: "study".into(), given, ..Asked::default() }
    }

    #[test]
    fn every_refused_value_is_told_beside_its_field() {
        let refusal = asked(&[("impactor.mass", "-1"), ("layers[0].law", "cork"), ("mesh.element_size", "0.003")])
            .subject()
            .unwrap_err();
        let names: Vec<_> = refusal.fields.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["impactor.mass", "layers[0].law"]);
        assert_eq!(refusal.fields[0].1, "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg");
    }

    #[test]
    fn what_contradicts_is_told_beside_both() {
        let refusal = asked(&[("impactor.drop_height", "1"), ("impactor.drop_speed", "2")]).subject().unwrap_err();
        let names: Vec<_> = refusal.fields.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["impactor.drop_height", "impactor.drop_speed"]);
    }

    #[test]
    fn a_duration_of_ones_own_ends_the_run() {
        assert_eq!(asked(&[]).subject().unwrap().until, Until::Over);
        assert_eq!(asked(&[("time.duration", "0.005")]).subject().unwrap().until, Until::Duration);
        let file = Asked { toml: "[time]\nduration = 5e-3\n".into(), ..asked(&[]) };
        assert_eq!(file.subject().unwrap().until, Until::Duration);
    }
}
