//! What a user says of a scenario: values given over those of a base, most often a preset.
//!
//! Where one of several parameters that state the same thing is given, it decides; where two are, that is an error. A law that
//! is given anew starts from coefficients of zero, so that nothing of another material stays in it unseen.

use super::Parameter;
use super::effect::conditions;
use super::number::NUMBERS;
use super::values::Values;
use crate::error::{Name, NoEffect, ParameterError, ScenarioError};
use crate::number::real::Real;
use crate::scenario::Scenario;

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
#[derive(Clone, Debug)]
pub struct Changes {
    values: Values,
    given: Given,
}

impl Changes {
    /// Nothing given: the scenario is `base`.
    pub fn of(base: &Scenario) -> Self {
        Self { values: Values::of(base), given: Given::default() }
    }

    /// Gives a value.
    ///
    /// # Errors
    /// A value that is not legal is refused and changes nothing.
    pub fn set(&mut self, parameter: Parameter, value: Real) -> Result<(), ParameterError> {
        self.values.set(parameter, value)?;
        self.given.add(parameter);
        Ok(())
    }

    /// Gives a value of which no more is known than that it stands there: it counts as given if it differs.
    ///
    /// # Errors
    /// A value that differs and is not legal is refused and changes nothing.
    pub fn set_if_other(&mut self, parameter: Parameter, value: Real) -> Result<(), ParameterError> {
        let same = value.to_bits() == self.values.get(parameter).to_bits();
        if same { Ok(()) } else { self.set(parameter, value) }
    }

    /// Calls a layer `name`; see [`Values::name_layer`].
    pub fn name_layer(&mut self, layer: usize, name: &str) {
        self.values.name_layer(layer, name);
    }

    /// The values as they stand, before any follows from another.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// The scenario that the values make, in which each of them acts.
    ///
    /// # Errors
    /// Values that contradict each other, the first that has no effect, or what [`Scenario::validate`] refuses.
    pub fn apply(&self) -> Result<Scenario, ScenarioError> {
        self.clone().take_scenario()
    }

    /// The same, of changes that nobody needs any more: it works on them, and takes less of the stack.
    ///
    /// # Errors
    /// As [`Changes::apply`].
    pub fn take_scenario(&mut self) -> Result<Scenario, ScenarioError> {
        self.settle()?;
        let Values { whole, layers } = &self.values;
        let idle = |given: Parameter| given.refused(self.values.get(given), whole, *layers);
        if let Some(no_effect) = self.given().find_map(idle) {
            return Err(ScenarioError::NoEffect(no_effect));
        }
        self.values.whole.set_layer_count(self.values.layers);
        self.values.whole.validate()?;
        Ok(self.values.whole.clone())
    }

    /// The scenario that the values make, in which some may have no effect.
    ///
    /// # Errors
    /// Values that contradict each other.
    pub fn resolve(&self) -> Result<Scenario, ScenarioError> {
        let mut settled = self.clone();
        settled.settle()?;
        Ok(settled.values.into_scenario())
    }

    /// The given values that have no effect in `scenario`, which they make.
    pub fn without_effect(&self, scenario: &Scenario) -> impl Iterator<Item = NoEffect> {
        let layers = scenario.layers.len();
        self.given().filter_map(move |parameter| parameter.refused(self.values.get(parameter), scenario, layers))
    }

    /// Makes of the values what follows from those that are given, which stay.
    fn settle(&mut self) -> Result<(), ScenarioError> {
        self.choose()?;
        self.start_laws();
        Ok(())
    }

    /// Makes the choices that are made by giving a value, where nothing else makes them.
    fn choose(&mut self) -> Result<(), ScenarioError> {
        let Self { values, given } = self;
        let made =
            || conditions().filter(|made| made.is_choice() && given.has_name(made.of()) && !given.has_name(made.by()));
        for condition in made() {
            if let Some(other) = made().find(|other| other.by() == condition.by() && other.of() != condition.of()) {
                return Err(ScenarioError::Contradiction { names: [condition.of(), other.of()] });
            }
            if let (Some(decider), Some(choice)) = (condition.decider(), condition.choice()) {
                values.set(decider, choice as Real)?;
            }
        }
        Ok(())
    }

    /// Sets the coefficients of the laws that are given anew to zero, but for those that are given.
    fn start_laws(&mut self) {
        let Self { values, given } = self;
        for law in given.all().filter(|parameter| parameter.name().field() == "law") {
            for parameter in law.layer().into_iter().flat_map(Parameter::of_layer) {
                if !given.has(parameter) && parameter.is_off_at_zero() {
                    // Zero is legal for every coefficient.
                    let _ = values.set(parameter, 0.0);
                }
            }
        }
    }

    fn given(&self) -> impl Iterator<Item = Parameter> {
        self.given.all()
    }
}

/// A set of parameters: a bit for the number of each.
#[derive(Clone, Debug, Default)]
struct Given([u32; NUMBERS.div_ceil(WORD)]);

/// Bits of a word.
const WORD: usize = u32::BITS as usize;

impl Given {
    fn add(&mut self, parameter: Parameter) {
        let number = parameter.number() as usize;
        if let Some(word) = self.0.get_mut(number / WORD) {
            *word |= 1 << (number % WORD);
        }
    }

    fn has(&self, parameter: Parameter) -> bool {
        let number = parameter.number() as usize;
        self.0.get(number / WORD).is_some_and(|word| word & 1 << (number % WORD) != 0)
    }

    fn all(&self) -> impl Iterator<Item = Parameter> {
        Parameter::all().filter(|parameter| self.has(*parameter))
    }

    fn has_name(&self, name: Name) -> bool {
        self.all().any(|parameter| parameter.name() == name)
    }
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    extern crate alloc;
    use alloc::string::{String, ToString};

    use super::*;
    use crate::scenario::{Layer, MAX_LAYERS, preset};

    /// What becomes of `given` over `base`, or why it is refused. A label stands for a choice.
    fn apply(base: Scenario, given: &[(&str, &str)]) -> Result<Scenario, String> {
        let mut changes = Changes::of(&base);
        for (name, value) in given {
            let parameter = Parameter::find_in(&base, name).unwrap();
            let label = parameter.labels().iter().position(|label| label == value);
            let value = label.map_or_else(|| value.parse().unwrap(), |choice| choice as Real);
            changes.set(parameter, value).unwrap();
        }
        changes.apply().map_err(|error| error.to_string())
    }

    #[test]
    fn one_of_several_that_state_the_same_thing_decides() {
        let height = apply(preset::study(), &[("impactor.drop_height", "0.1")]).unwrap();
        assert_eq!(height.impactor.start_speed(), crate::number::math::sqrt(2.0 * 9.81 * 0.1));
        let bulk = apply(preset::study(), &[("silicone.bulk_modulus", "1e6")]).unwrap();
        assert_eq!(bulk.layers[0].material.effective_bulk_modulus(), 1e6);
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
                "layers[0].c01 = 100000 Pa has no effect: layers[0].law is neo_hookean",
            ),
            (
                &[("silicone.prony_tau_2", "0.1")],
                "layers[0].prony_tau_2 = 0.1 s has no effect: layers[0].prony_g_2 is 0",
            ),
            (&[("layers[1].density", "900")], "layers[1].density = 900 kg/m3 has no effect: layers.count is 1"),
            (&[("layers[3].law", "yeoh")], "layers[3].law = 2 has no effect: layers.count is 1"),
            (
                &[("impactor.motion", "driven"), ("impactor.drop_speed", "2")],
                "impactor.drop_speed = 2 m/s has no effect: impactor.motion is driven",
            ),
            (
                &[("layers.count", "2"), ("layers[1].density", "900")],
                "layers[1].thickness = 0 m is refused: expected at least 0.00001 m",
            ),
        ] {
            assert_eq!(apply(preset::study(), given).unwrap_err(), message);
        }
    }

    #[test]
    fn a_law_that_is_given_starts_from_zero() {
        let study = preset::study();
        let given = [("silicone.law", "mooney_rivlin"), ("silicone.c10", "1e5"), ("silicone.prony_g_2", "0.5")];
        let material = apply(study.clone(), &given).unwrap().layers.remove(0).material;
        assert_eq!(["c10", "c01", "c20"].map(|name| material.coefficient(name)), [Some(1e5), Some(0.0), Some(0.0)]);
        assert_eq!(material.prony_g, [0.0, 0.5, 0.0, 0.0, 0.0]);
        let silicone = study.layers[0].material;
        assert_eq!(material.density, silicone.density);
        let changed = apply(study, &[("silicone.c10", "1e5")]).unwrap().layers[0].material;
        assert_eq!(changed.coefficient("c20"), silicone.coefficient("c20"));
    }

    #[test]
    fn a_zero_says_that_there_is_nothing() {
        let given = [("silicone.law", "neo_hookean"), ("silicone.c10", "1e5"), ("silicone.c01", "0")];
        assert!(apply(preset::study(), &given).is_ok());
    }

    #[test]
    fn what_differs_counts_as_given() {
        let study = preset::study();
        let height = Parameter::find("impactor.drop_height").unwrap();
        let mut changes = Changes::of(&study);
        for parameter in Parameter::all() {
            let value = changes.values().get(parameter);
            changes.set_if_other(parameter, value).unwrap();
        }
        assert_eq!(changes.apply().unwrap(), study);
        changes.set_if_other(height, 0.1).unwrap();
        assert_eq!(changes.apply().unwrap().impactor.drop_by, crate::scenario::DropBy::Height);
        assert!(changes.set_if_other(height, -1.0).is_err());
    }

    #[test]
    fn a_new_layer_starts_as_plain_silicone() {
        let given = [("layers[2].thickness", "0.001"), ("layers[1].thickness", "0.002"), ("layers.count", "3")];
        let stack = apply(preset::study(), &given).unwrap();
        assert_eq!(stack.thickness(), 0.015 + 0.002 + 0.001);
        for (layer, thickness) in stack.layers[1..].iter().zip([2e-3, 1e-3]) {
            assert_eq!(*layer, Layer { thickness, ..preset::spare_layer() });
        }
        let given = [("layers[1].law", "yeoh"), ("layers[1].c20", "1e5"), ("layers[1].thickness", "1e-3")];
        let refused = apply(preset::study(), &[&given[..], &[("layers.count", "2")]].concat()).unwrap_err();
        assert_eq!(refused, "layers[1].c10 gives a shear modulus of 0 Pa: expected above 0 Pa");
        let one = apply(stack, &[("layers.count", "1")]).unwrap();
        assert_eq!(one, preset::study());
    }

    #[test]
    fn what_is_said_of_one_layer_leaves_the_others() {
        let mut base = preset::study();
        base.add_layer(preset::chamois()).unwrap();
        let given = [("skin.law", "yeoh"), ("skin.c10", "1e5"), ("skin.bulk_modulus", "1e6")];
        let changed = apply(base.clone(), &given).unwrap();
        assert_eq!(changed.layers[0], base.layers[0]);
        assert_eq!(changed.layers[1].material.effective_bulk_modulus(), 1e6);
        let two = [("skin.bulk_modulus", "1e6"), ("layers[1].poissons_ratio", "0.4")];
        let refused = apply(base, &two).unwrap_err();
        assert!(refused.starts_with("layers[1].bulk_modulus and layers[1].poissons_ratio state the same"), "{refused}");
    }

    /// Every name of a condition is that of a parameter.
    #[test]
    fn conditions_are_of_parameters() {
        for condition in conditions() {
            assert!(condition.decider().is_some(), "{}", condition.by());
            assert!(Parameter::all().any(|parameter| parameter.name() == condition.of()), "{}", condition.of());
        }
        assert_eq!(
            conditions().filter(|condition| condition.is_choice() && condition.choice().is_some()).count(),
            5 + 2 * MAX_LAYERS
        );
    }
}
