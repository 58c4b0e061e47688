//! What quasi-static tests of the material say about its silicone, as a soft demand on the values of a search.
//!
//! Impacts alone do not tell the long-term law from the fast overstress. The prior compares three numbers of a simple
//! compression of an incompressible cylinder with measured ones, and adds the mean square of their logarithms to the
//! score: a factor e between model and measurement costs one weight, the same in both directions.

use serde::{Deserialize, Serialize};
use softanvil_kernel::Scenario;
use softanvil_kernel::material::{Elastic, Material};
use softanvil_kernel::tensor::stretch::IsochoricStretch;

/// The demand, as the problem file states it; moduli in Pa. Numbers left out demand nothing.
#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Prior {
    /// Points of score for a factor e.
    pub weight: f64,
    /// Initial Young's modulus in a slow compression.
    pub youngs_modulus: Option<f64>,
    /// Duration of that compression up to where the modulus was read, s: overstress that relaxes faster does not count.
    #[serde(default = "one_second")]
    pub time: f64,
    /// Strain at which the relaxation was measured.
    #[serde(default = "one_half")]
    pub relaxation_strain: f64,
    /// Secant shear modulus (a third of nominal stress over strain) at that strain, fully relaxed.
    pub relaxed_shear_modulus: Option<f64>,
    /// The same at the start of the relaxation, after a ramp of [`Prior::time`].
    pub initial_shear_modulus: Option<f64>,
}

fn one_second() -> f64 {
    1.0
}

fn one_half() -> f64 {
    0.5
}

/// One number of the prior.
pub struct Demand {
    /// Name for people.
    pub label: &'static str,
    /// Measured, Pa.
    pub measured: f64,
    /// Of the material, Pa.
    pub model: f64,
}

impl Prior {
    /// Whether the numbers make sense.
    ///
    /// # Errors
    /// What is refused, and an anvil of several layers, of which it does not say which was tested, or one that does not keep its volume.
    pub fn check(&self, scenario: &Scenario) -> Result<(), String> {
        const INSTEAD: &str = "[[material_test]] takes a layer";
        if scenario.layers.len() > 1 {
            let count = scenario.layers.len();
            return Err(format!(
                "prior: the anvil has {count} layers, which may all be meant: expected one; {INSTEAD}"
            ));
        }
        if scenario.layers.iter().any(|layer| layer.material.law.is_compressible()) {
            return Err(
                "prior: the law of the layer is compressible; expected one that keeps its volume, as the cylinder does"
                    .into(),
            );
        }
        let moduli = [self.youngs_modulus, self.relaxed_shear_modulus, self.initial_shear_modulus];
        let positive = |value: f64| value > 0.0 && value.is_finite();
        if !moduli.iter().flatten().all(|modulus| positive(*modulus)) || !positive(self.time) || !positive(self.weight)
        {
            return Err("prior: weight, time and moduli have to be above 0".into());
        }
        if !(self.relaxation_strain > 0.0 && self.relaxation_strain < 1.0) {
            return Err("prior: relaxation_strain has to be between 0 and 1".into());
        }
        Ok(())
    }

    /// The numbers, measured and of `material`.
    pub fn demands(&self, material: &Material) -> Vec<Demand> {
        let slow = 1.0 + slow_overstress(material, self.time);
        let secant = secant_shear_modulus(material, self.relaxation_strain);
        let rows = [
            ("Young's modulus, slow compression", self.youngs_modulus, 3.0 * material.shear_modulus_inf() * slow),
            ("secant shear modulus, relaxed", self.relaxed_shear_modulus, secant),
            ("secant shear modulus, after the ramp", self.initial_shear_modulus, secant * slow),
        ];
        rows.into_iter()
            .filter_map(|(label, measured, model)| Some(Demand { label, measured: measured?, model }))
            .collect()
    }

    /// What the score grows by.
    pub fn penalty(&self, material: &Material) -> f64 {
        let demands = self.demands(material);
        let squares = demands.iter().map(|demand| (demand.model / demand.measured).ln().powi(2)).sum::<f64>();
        self.weight * squares / (demands.len().max(1) as f64)
    }
}

/// Overstress, over the long-term stress, that is left of a ramp of `time` s at constant rate: of a term with the
/// relaxation time tau, the part tau / t (1 - exp(-t / tau)).
fn slow_overstress(material: &Material, time: f64) -> f64 {
    let terms = material.prony_g.iter().zip(material.prony_tau);
    terms.map(|(g, tau)| g / material.prony_g_inf() * tau / time * (1.0 - (-time / tau).exp())).sum()
}

/// A third of nominal stress over strain of the long-term law in simple compression to `strain`, Pa.
fn secant_shear_modulus(material: &Material, strain: f64) -> f64 {
    /// Step of the derivative of the energy: error of order 1e-8.
    const STEP: f64 = 1e-4;
    let law = Elastic::new(material);
    let energy = |stretch: f64| {
        let across = 1.0 / stretch.sqrt();
        law.strain_energy_density(&IsochoricStretch { u11: across, u22: stretch, u12: 0.0, u33: across })
    };
    let stretch = 1.0 - strain;
    (energy(stretch - STEP) - energy(stretch + STEP)) / (2.0 * STEP) / (3.0 * strain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use softanvil_kernel::material::NeoHookean;
    use softanvil_kernel::{Parameter, preset};

    #[test]
    fn a_neo_hookean_cylinder_has_the_secant_of_the_textbook() {
        let material = preset::study().layers[0].material.with(NeoHookean { c10: 1e5 });
        // Nominal stress 2 C10 (l - l^-2) at l = 0.5 is -7 C10.
        assert!((secant_shear_modulus(&material, 0.5) - 7e5 / 1.5).abs() < 1.0);
    }

    /// It does not say which layer was tested, and the cylinder keeps its volume.
    #[test]
    fn several_layers_and_foams_are_refused() {
        let prior = Prior {
            weight: 1.0,
            youngs_modulus: Some(1e5),
            time: 1.0,
            relaxation_strain: 0.5,
            relaxed_shear_modulus: None,
            initial_shear_modulus: None,
        };
        let mut scenario = preset::study();
        assert_eq!(prior.check(&scenario), Ok(()));
        let law = Parameter::find("layers[0].law").unwrap();
        let foam = law.labels().iter().position(|label| *label == "hyperfoam").unwrap();
        law.set(&mut scenario, foam as f64).unwrap();
        assert!(prior.check(&scenario).unwrap_err().contains("the law of the layer is compressible"));
        let mut scenario = preset::study();
        scenario.add_layer(preset::chamois()).unwrap();
        let error = prior.check(&scenario).unwrap_err();
        assert!(error.contains("the anvil has 2 layers") && error.contains("[[material_test]]"), "{error}");
    }

    #[test]
    fn a_factor_costs_the_same_in_both_directions() {
        let material = preset::study().layers[0].material;
        let model = secant_shear_modulus(&material, 0.5);
        let prior = |measured: f64| Prior {
            weight: 2.0,
            youngs_modulus: None,
            time: 1.0,
            relaxation_strain: 0.5,
            relaxed_shear_modulus: Some(measured),
            initial_shear_modulus: None,
        };
        let e = std::f64::consts::E;
        for measured in [model * e, model / e] {
            assert!((prior(measured).penalty(&material) - 2.0).abs() < 1e-9);
        }
    }

    #[test]
    fn only_what_relaxes_slowly_is_left_of_a_ramp() {
        let mut material = preset::study().layers[0].material;
        material.prony_g = [0.5, 0.25, 0.0, 0.0, 0.0];
        material.prony_tau = [1e-4, 1e4, 1.0, 1.0, 1.0];
        assert!((slow_overstress(&material, 1.0) - 1.0).abs() < 1e-3);
    }
}
