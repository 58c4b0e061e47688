//! What a user says of a scenario: values given over those of a base, most often a preset.
//!
//! Where one of several parameters that state the same thing is given, it decides; where two are, that is an error. A law that
//! is given anew starts from coefficients of zero, so that nothing of another material stays in it unseen.

use super::effect::{conditions, is_off_at_zero};
use super::{PARAMETERS, Parameter, ROWS};
use crate::error::{NoEffect, ParameterError, ScenarioError};
use crate::number::real::Real;
use crate::scenario::{Layers, Scenario};

/// Values given over those of a base.
///
/// ```
/// use softanvil_kernel::scenario::DropBy;
/// use softanvil_kernel::{Changes, Parameter, preset};
///
/// let study = preset::study();
/// let mut changes = Changes::of(&study);
/// changes.set(Parameter::find("impactor.drop_height").unwrap(), 0.2)?;
/// // The height is given, so it decides, and not the energy of the preset.
/// let scenario = changes.apply()?;
/// assert_eq!((study.impactor.drop_by, scenario.impactor.drop_by), (DropBy::Energy, DropBy::Height));
/// // A second number for the same drop contradicts it.
/// changes.set(Parameter::find("impactor.drop_speed").unwrap(), 2.0)?;
/// assert!(changes.apply().is_err());
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Changes {
    scenario: Scenario,
    given: [bool; ROWS.len()],
}

impl Changes {
    /// Nothing given: the scenario is `base`.
    pub fn of(base: &Scenario) -> Self {
        Self { scenario: *base, given: [false; ROWS.len()] }
    }

    /// What `scenario` says over `base`, where no more is known: the values that differ.
    pub fn between(base: &Scenario, scenario: &Scenario) -> Self {
        let mut changes = Self::of(scenario);
        for (given, parameter) in changes.given.iter_mut().zip(PARAMETERS) {
            *given = parameter.get(base).to_bits() != parameter.get(scenario).to_bits();
        }
        changes
    }

    /// Gives a value.
    ///
    /// # Errors
    /// A value that is not legal is refused and changes nothing.
    pub fn set(&mut self, parameter: &Parameter, value: Real) -> Result<(), ParameterError> {
        parameter.set(&mut self.scenario, value)?;
        for (given, row) in self.given.iter_mut().zip(PARAMETERS) {
            *given |= row.name == parameter.name;
        }
        Ok(())
    }

    /// The values as they stand, before any follows from another.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The scenario that the values make, in which each of them acts.
    ///
    /// # Errors
    /// Values that contradict each other, the first that has no effect, or what [`Scenario::validate`] refuses.
    pub fn apply(&self) -> Result<Scenario, ScenarioError> {
        let scenario = self.resolve()?;
        match self.without_effect(&scenario).next() {
            Some(no_effect) => Err(ScenarioError::NoEffect(no_effect)),
            None => scenario.validate().map(|()| scenario),
        }
    }

    /// The scenario that the values make, in which some may have no effect.
    ///
    /// # Errors
    /// Values that contradict each other.
    pub fn resolve(&self) -> Result<Scenario, ScenarioError> {
        let mut scenario = self.scenario;
        self.choose(&mut scenario)?;
        self.start_laws(&mut scenario);
        if self.is_given("geometry.layers") && !self.is_given("geometry.silicone_thickness") {
            let (layers, thickness) = (scenario.geometry.layers, scenario.geometry.silicone_thickness);
            return Err(ScenarioError::LayerThickness { two: layers == Layers::Two, thickness });
        }
        Ok(scenario)
    }

    /// The given values that have no effect in `scenario`, which they make.
    pub fn without_effect(&self, scenario: &Scenario) -> impl Iterator<Item = NoEffect> {
        self.given_rows().filter_map(move |parameter| parameter.without_effect(scenario))
    }

    /// Makes the choices that are made by giving a value, where nothing else makes them.
    fn choose(&self, scenario: &mut Scenario) -> Result<(), ScenarioError> {
        let made =
            || conditions().filter(|made| made.choice().is_some() && self.is_given(made.of) && !self.is_given(made.by));
        for condition in made() {
            if let Some(other) = made().find(|other| other.by == condition.by && other.of != condition.of) {
                return Err(ScenarioError::Contradiction { names: [condition.of, other.of] });
            }
            if let (Some(row), Some(choice)) = (Parameter::find(condition.by), condition.choice()) {
                row.set(scenario, choice as Real)?;
            }
        }
        Ok(())
    }

    /// Sets the coefficients of the laws that are given anew to zero, but for those that are given.
    fn start_laws(&self, scenario: &mut Scenario) {
        for group in ["silicone.", "skin."] {
            let is_law = |row: &Parameter| row.name.strip_prefix(group) == Some("law");
            if !self.given_rows().any(is_law) {
                continue;
            }
            for (row, given) in PARAMETERS.iter().zip(self.given) {
                if !given && row.name.starts_with(group) && is_off_at_zero(row.name) {
                    // Zero is legal for every coefficient.
                    let _ = row.set(scenario, 0.0);
                }
            }
        }
    }

    fn is_given(&self, name: &str) -> bool {
        self.given_rows().any(|row| row.name == name)
    }

    fn given_rows(&self) -> impl Iterator<Item = &'static Parameter> {
        PARAMETERS.iter().zip(self.given).filter(|(_, given)| *given).map(|(row, _)| row)
    }
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    extern crate alloc;
    use alloc::string::{String, ToString};

    use super::*;
    use crate::scenario::parameter::Kind;
    use crate::scenario::preset;

    /// What becomes of `given` over `base`, or why it is refused. A label stands for a choice.
    fn apply(base: Scenario, given: &[(&str, &str)]) -> Result<Scenario, String> {
        let mut changes = Changes::of(&base);
        for (name, value) in given {
            let row = Parameter::find(name).unwrap();
            let value = match row.kind {
                Kind::Real { .. } => value.parse().unwrap(),
                Kind::Choice { labels, .. } => labels.iter().position(|label| label == value).unwrap() as Real,
            };
            changes.set(row, value).unwrap();
        }
        changes.apply().map_err(|error| error.to_string())
    }

    #[test]
    fn one_of_several_that_state_the_same_thing_decides() {
        let height = apply(preset::study(), &[("impactor.drop_height", "0.1")]).unwrap();
        assert_eq!(height.impactor.start_speed(), crate::number::math::sqrt(2.0 * 9.81 * 0.1));
        let bulk = apply(preset::study(), &[("silicone.bulk_modulus", "1e6")]).unwrap();
        assert_eq!(bulk.silicone.effective_bulk_modulus(), 1e6);
        let step = apply(preset::study(), &[("time.step", "1e-6")]).unwrap();
        assert_eq!(step.time.step_by, crate::scenario::StepBy::Given);
    }

    #[test]
    fn what_contradicts_or_has_no_effect_is_refused() {
        for (given, message) in [
            (
                &[("impactor.drop_height", "0.1"), ("impactor.drop_energy", "9.8")][..],
                "impactor.drop_height and impactor.drop_energy state the same thing: expected one of them",
            ),
            (
                &[("impactor.drop_by", "energy"), ("impactor.drop_height", "0.1")],
                "impactor.drop_height = 0.1 m has no effect: impactor.drop_by is energy",
            ),
            (
                &[("core.interface", "bonded"), ("core.friction_coefficient", "0.2")],
                "core.friction_coefficient = 0.2 has no effect: core.interface is bonded",
            ),
            (
                &[("silicone.law", "neo_hookean"), ("silicone.c10", "1e5"), ("silicone.c01", "1e5")],
                "silicone.c01 = 100000 Pa has no effect: silicone.law is neo_hookean",
            ),
            (&[("silicone.prony_tau_2", "0.1")], "silicone.prony_tau_2 = 0.1 s has no effect: silicone.prony_g_2 is 0"),
            (&[("skin.density", "900")], "skin.density = 900 kg/m3 has no effect: geometry.layers is one"),
            (
                &[("impactor.motion", "driven"), ("impactor.drop_speed", "2")],
                "impactor.drop_speed = 2 m/s has no effect: impactor.motion is driven",
            ),
            (
                &[("geometry.layers", "two")],
                "geometry.layers = two needs geometry.silicone_thickness as well: 0.015 m is that of the whole layer",
            ),
        ] {
            assert_eq!(apply(preset::study(), given).unwrap_err(), message);
        }
    }

    #[test]
    fn a_law_that_is_given_starts_from_zero() {
        let study = preset::study();
        let given = [("silicone.law", "mooney_rivlin"), ("silicone.c10", "1e5"), ("silicone.prony_g_2", "0.5")];
        let material = apply(study, &given).unwrap().silicone;
        assert_eq!(["c10", "c01", "c20"].map(|name| material.coefficient(name)), [Some(1e5), Some(0.0), Some(0.0)]);
        assert_eq!(material.prony_g, [0.0, 0.5, 0.0, 0.0, 0.0]);
        assert_eq!(material.density, study.silicone.density);
        assert_eq!(
            apply(study, &[("silicone.c10", "1e5")]).unwrap().silicone.coefficient("c20"),
            study.silicone.coefficient("c20")
        );
    }

    #[test]
    fn a_zero_says_that_there_is_nothing() {
        let given = [("silicone.law", "neo_hookean"), ("silicone.c10", "1e5"), ("silicone.c01", "0")];
        assert!(apply(preset::study(), &given).is_ok());
    }

    #[test]
    fn what_differs_counts_as_given() {
        let study = preset::study();
        let mut other = study;
        other.impactor.drop_height = 0.1;
        assert_eq!(Changes::between(&study, &other).apply().unwrap().impactor.drop_by, crate::scenario::DropBy::Height);
        assert_eq!(Changes::between(&study, &study).apply().unwrap(), study);
    }

    /// Every name of a condition is that of a parameter, or of a group.
    #[test]
    fn conditions_are_of_parameters() {
        for condition in conditions() {
            assert!(Parameter::find(condition.by).is_some(), "{}", condition.by);
            assert!(PARAMETERS.iter().any(|row| condition.concerns(row.name)), "{}", condition.of);
        }
        assert_eq!(conditions().filter(|condition| condition.choice().is_some()).count(), 9);
    }
}
