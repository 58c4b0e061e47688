//! Tests of the material by itself as data beside the impacts: a modulus or a stress with its standard deviation.
//!
//! Impacts alone do not tell the long-term law from the overstress. A test compares the material of a layer, by
//! [`super::uniaxial`], with what was measured. Its distance is in standard deviations, ln(model / value) / (standard deviation
//! / value): a factor is as far in both directions, because moduli scatter by factors. The score grows by
//! `objective.material_weight` times the mean square of the distances that count.

use serde::{Deserialize, Serialize};
use softanvil_kernel::Scenario;

use super::uniaxial::{Course, nominal_stress};

/// A test as the problem file states it, in SI.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct MaterialTest {
    /// What it is called in results.
    pub name: String,
    /// The layer whose material was tested; the one next to the core.
    pub layer: Option<String>,
    /// How it was loaded.
    #[serde(default)]
    pub load: Load,
    /// What `value` is.
    pub quantity: Quantity,
    /// Nominal strain at the end of the ramp, above 0 in tension and in compression.
    pub strain: f64,
    /// Rate of nominal strain in the ramp, 1/s; without it the ramp is so slow that all overstress has relaxed.
    pub rate: Option<f64>,
    /// Time for which the strain has been held when the value was read, s.
    #[serde(default)]
    pub hold: f64,
    /// Measured, Pa.
    pub value: f64,
    /// Standard deviation of it, Pa.
    pub standard_deviation: f64,
    /// Whether the test is reported and does not count.
    #[serde(default)]
    pub predict: bool,
}

/// How a specimen is loaded.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum Load {
    /// Between frictionless plates.
    #[default]
    Compression,
    /// Pulled.
    Tension,
}

/// What is read of a test.
#[derive(Clone, Copy, Debug, Deserialize, Serialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Nominal stress over nominal strain.
    YoungsModulus,
    /// A third of that.
    ShearModulus,
    /// Nominal stress.
    Stress,
}

/// Where a material that carries no stress, or one of the wrong sign, is put: as far as one with this part of the value.
const LEAST: f64 = 1e-6;

impl MaterialTest {
    /// Whether the test makes sense for the layers of `scenario`.
    ///
    /// # Errors
    /// What is refused.
    pub fn check(&self, scenario: &Scenario) -> Result<(), String> {
        let refuse = |what: String| Err(format!("material_test \"{}\": {what}", self.name));
        let positive = [
            ("value", Some(self.value), "Pa"),
            ("standard_deviation", Some(self.standard_deviation), "Pa"),
            ("strain", Some(self.strain), "1"),
            ("rate", self.rate, "1/s"),
        ];
        for (key, value, unit) in positive {
            if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
                return refuse(format!("{key} = {value} {unit} is refused: expected more than 0"));
            }
        }
        if self.load == Load::Compression && self.strain >= 1.0 {
            return refuse(format!("strain = {} is refused: expected less than 1 in compression", self.strain));
        }
        if !(self.hold >= 0.0 && self.hold.is_finite()) {
            return refuse(format!("hold = {} s is refused: expected 0 or more", self.hold));
        }
        if self.hold > 0.0 && self.rate.is_none() {
            return refuse("hold has no effect without a rate".into());
        }
        let Some(layer) = self.layer_of(scenario) else {
            let names = scenario.layers.iter().map(|layer| layer.name.as_str()).collect::<Vec<_>>().join(", ");
            return refuse(format!("no layer is called {}; expected {names}", self.layer.as_deref().unwrap_or("")));
        };
        if scenario.layers[layer].material.law.is_compressible() {
            return refuse("the law of the layer is compressible; expected one that keeps its volume".into());
        }
        Ok(())
    }

    fn layer_of(&self, scenario: &Scenario) -> Option<usize> {
        match &self.layer {
            None => Some(0),
            Some(name) => scenario.layers.iter().position(|layer| layer.name == name.as_str()),
        }
    }

    /// What the test gives for the material of `scenario`, Pa.
    pub fn model(&self, scenario: &Scenario) -> f64 {
        let sign = if self.load == Load::Compression { -1.0 } else { 1.0 };
        let ramp = self.rate.map(|rate| self.strain / rate);
        let course = Course { stretch: 1.0 + sign * self.strain, ramp, hold: self.hold };
        // The layer is there: the problem has been checked.
        let material = &scenario.layers[self.layer_of(scenario).unwrap_or(0)].material;
        let stress = sign * nominal_stress(material, &course);
        match self.quantity {
            Quantity::Stress => stress,
            Quantity::YoungsModulus => stress / self.strain,
            Quantity::ShearModulus => stress / (3.0 * self.strain),
        }
    }

    /// How far `model` is from what was measured, in standard deviations.
    pub fn distance(&self, model: f64) -> f64 {
        (model / self.value).max(LEAST).ln() / (self.standard_deviation / self.value)
    }

    /// The test in a few words.
    pub fn course(&self) -> String {
        let load = match self.load {
            Load::Compression => "compression",
            Load::Tension => "tension",
        };
        let percent = 100.0 * self.strain;
        let rate = self.rate.map_or("relaxed".into(), |rate| format!("at {rate} 1/s"));
        let hold = if self.hold > 0.0 { format!(", held for {} s", self.hold) } else { String::new() };
        format!("{load} to {percent:.3} % {rate}{hold}").replace(".000 %", " %")
    }

    /// What is read, in words.
    pub fn read(&self) -> &'static str {
        match self.quantity {
            Quantity::YoungsModulus => "E",
            Quantity::ShearModulus => "G",
            Quantity::Stress => "stress",
        }
    }
}

/// Distances of the tests that count, in standard deviations.
pub fn distances(tests: &[MaterialTest], scenario: &Scenario) -> impl Iterator<Item = f64> {
    tests.iter().filter(|test| !test.predict).map(|test| test.distance(test.model(scenario)))
}

/// Mean square of the distances that count, in squares of standard deviations; 0 of none.
pub fn mean_square(tests: &[MaterialTest], scenario: &Scenario) -> f64 {
    let (sum, count) =
        distances(tests, scenario).fold((0.0, 0), |(sum, count), distance| (sum + distance * distance, count + 1));
    sum / f64::from(count.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::preset;

    fn test() -> MaterialTest {
        MaterialTest {
            name: "slow".into(),
            layer: None,
            load: Load::Compression,
            quantity: Quantity::ShearModulus,
            strain: 0.5,
            rate: None,
            hold: 0.0,
            value: 0.33e6,
            standard_deviation: 0.033e6,
            predict: false,
        }
    }

    #[test]
    fn the_numbers_of_a_test_belong_together() {
        let scenario = preset::elastic();
        let of = |quantity| MaterialTest { quantity, ..test() }.model(&scenario);
        let stress = of(Quantity::Stress);
        assert!((stress - 7e5).abs() < 1.0, "{stress}");
        assert!((of(Quantity::YoungsModulus) - 2.0 * stress).abs() < 1e-6);
        assert!((of(Quantity::ShearModulus) - 2.0 * stress / 3.0).abs() < 1e-6);
        let pulled = MaterialTest { load: Load::Tension, strain: 1.0, ..test() };
        assert!((pulled.model(&scenario) - 3.5e5 / 3.0).abs() < 1.0);
    }

    #[test]
    fn a_factor_is_as_far_in_both_directions() {
        let test = test();
        let e = 0.1f64.exp();
        assert!((test.distance(0.33e6 * e) - 1.0).abs() < 1e-12);
        assert!((test.distance(0.33e6 / e) + 1.0).abs() < 1e-12);
        assert!(test.distance(-1.0) < -100.0 && test.distance(-1.0).is_finite());
    }

    #[test]
    fn what_is_predicted_does_not_count() {
        let scenario = preset::elastic();
        let far = test().distance(test().model(&scenario));
        assert!((mean_square(&[test()], &scenario) - far * far).abs() < 1e-12);
        assert_eq!(mean_square(&[MaterialTest { predict: true, ..test() }], &scenario), 0.0);
        let both = [test(), MaterialTest { value: test().model(&scenario), ..test() }];
        assert!((mean_square(&both, &scenario) - 0.5 * far * far).abs() < 1e-12);
    }

    #[test]
    fn a_refused_test_says_what_is_legal() {
        let refused = |test: MaterialTest| test.check(&preset::study()).unwrap_err();
        assert!(
            refused(MaterialTest { value: 0.0, ..test() }).contains("value = 0 Pa is refused: expected more than 0")
        );
        assert!(refused(MaterialTest { strain: 1.0, ..test() }).contains("less than 1 in compression"));
        assert!(refused(MaterialTest { hold: 1.0, ..test() }).contains("no effect without a rate"));
        assert!(refused(MaterialTest { layer: Some("skin".into()), ..test() }).contains("expected silicone"));
        assert!(test().check(&preset::study()).is_ok());
    }
}
