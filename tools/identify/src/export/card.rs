//! What a file says to its reader, and whether that is the material it was written from.

use softanvil_kernel::material::{Elastic, Material, Moduli};

use super::viscous;
use crate::law::fit::SMALLEST_RELATIVE;
use crate::law::{Mode, stress};

/// A material as a file has it.
#[derive(Clone, Debug)]
pub struct Card {
    /// The long-term law.
    pub elastic: Elastic,
    /// Density, kg/m3.
    pub density: f64,
    /// Bulk modulus, Pa.
    pub bulk_modulus: f64,
    /// (modulus in Pa, relaxation time in s) of the viscous terms beside the long-term law.
    pub viscous: Vec<(f64, f64)>,
    /// Stiffness and limit stress of the damping spring, Pa; none where a program has no such spring.
    pub slider: Option<(f64, f64)>,
}

/// Part of a stress, a modulus or a time by which a file may differ from the material that it was written from.
pub const LEGAL: f64 = 1e-3;

/// Stretches of the loaded direction in a test.
pub type States = (Mode, Vec<f64>);

impl Card {
    /// Of a material, exactly.
    pub fn of(material: &Material) -> Self {
        // The bits of the long-term law.
        let long_term = Material {
            moduli: Moduli::LongTerm,
            coefficients: material.coefficients.scaled(material.long_term_scale()),
            ..*material
        };
        Self {
            elastic: Elastic::new(&long_term),
            density: material.density,
            bulk_modulus: material.effective_bulk_modulus(),
            viscous: viscous(material).map(|(g, beta)| (g, 1.0 / beta)).collect(),
            slider: Some((material.slider_stiffness, material.slider_yield_stress)),
        }
    }

    /// Whether this is what `material` is, over `states`: stresses, moduli and times to [`LEGAL`]. A stress counts as no less
    /// than 1 % of the largest of its test.
    ///
    /// # Errors
    /// What differs most, in words.
    pub fn check(&self, material: &Material, states: &[States]) -> Result<(), String> {
        let own = Self::of(material);
        for (mode, stretches) in states {
            let (read, meant) =
                (stress::nominal(&self.elastic, *mode, stretches), stress::nominal(&own.elastic, *mode, stretches));
            let largest = meant.iter().fold(0.0, |largest, stress| f64::max(largest, stress.abs()));
            let error = |k: usize| (read[k] - meant[k]).abs() / meant[k].abs().max(SMALLEST_RELATIVE * largest);
            let worst = (0..stretches.len()).max_by(|a, b| error(*a).total_cmp(&error(*b)));
            if let Some(k) = worst.filter(|k| error(*k) > LEGAL || error(*k).is_nan()) {
                return Err(format!(
                    "its digits give the {} stress at the stretch {:.3} as {:.5e} Pa instead of {:.5e} Pa (expected a \
                     difference of {} %)",
                    mode.name(),
                    stretches[k],
                    read[k],
                    meant[k],
                    100.0 * LEGAL
                ));
            }
        }
        self.check_numbers(&own)
    }

    fn check_numbers(&self, own: &Self) -> Result<(), String> {
        let mut numbers =
            vec![("density", self.density, own.density), ("bulk modulus", self.bulk_modulus, own.bulk_modulus)];
        if let (Some(read), Some(meant)) = (self.slider, own.slider) {
            numbers.extend([("damping spring", read.0, meant.0), ("limit stress", read.1, meant.1)]);
        }
        if self.viscous.len() != own.viscous.len() {
            return Err(format!("it has {} viscous terms instead of {}", self.viscous.len(), own.viscous.len()));
        }
        for (read, meant) in self.viscous.iter().zip(&own.viscous) {
            numbers.extend([("viscous modulus", read.0, meant.0), ("relaxation time", read.1, meant.1)]);
        }
        let alike = |(_, read, meant): &&(&str, f64, f64)| (read - meant).abs() <= LEGAL * meant.abs();
        let wrong = numbers.iter().find(|number| !alike(number));
        wrong.map_or(Ok(()), |(name, read, meant)| {
            Err(format!(
                "its {name} is {read:.5e} instead of {meant:.5e} (expected a difference of {} %)",
                100.0 * LEGAL
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Layer, abaqus, c_source, ls_dyna, ssv};
    use super::*;
    use crate::law::{FOAMS, LAWS, MODES};
    use softanvil_kernel::material::Coefficient;

    fn states() -> Vec<States> {
        MODES.iter().map(|mode| (*mode, (0..40).map(|k| 0.4 + 0.05 * f64::from(k)).collect())).collect()
    }

    /// Every way in which a card is written and read.
    fn read_all(material: &Material) -> Vec<(&'static str, Card)> {
        let (layer, comment) = (&Layer::parse("silicone").unwrap(), "from\na test");
        let ls_dyna = ls_dyna::text("rubber", comment, material).map(|text| ("LS-DYNA", ls_dyna::read(&text).unwrap()));
        let abaqus = abaqus::text("rubber", comment, material).map(|text| ("Abaqus", abaqus::read(&text).unwrap()));
        let own = [
            ("C", c_source::read(&c_source::text(comment, material, layer), layer).unwrap()),
            ("ssv", ssv::read(&ssv::text("rubber", material, layer).unwrap(), layer).unwrap()),
        ];
        ls_dyna.into_iter().chain(abaqus).chain(own).collect()
    }

    #[test]
    fn every_law_comes_back_from_every_file() {
        for law in LAWS.iter().chain(FOAMS.iter()) {
            // Moduli with more digits than fit; shapes as they are, of which one is the root of a whole number.
            let modulus = |(parameter, value): (&Coefficient, &f64)| {
                if parameter.is_modulus() { 1.234_567_89 * value } else { *value }
            };
            let values: Vec<f64> = law.parameters.iter().zip(law.example()).map(modulus).collect();
            for moduli in [Moduli::LongTerm, Moduli::Instantaneous] {
                let mut material = Material { moduli, ..law.material(&values) };
                (material.prony_g[0], material.prony_tau[0]) = (0.3, 0.012_345_678_9);
                (material.prony_g[1], material.prony_tau[1]) = (0.2, 4.567_891_23);
                for (name, card) in read_all(&material) {
                    assert_eq!(card.check(&material, &states()), Ok(()), "{} {name}", law.name);
                }
            }
        }
    }

    /// mu of both signs that cancel to a few millionths of them: ten columns have too few digits, and say so.
    #[test]
    fn terms_that_cancel_do_not_survive_ten_columns() {
        let law = LAWS.iter().find(|law| law.name == "ogden_2").unwrap();
        let material = law.material(&[-1.267_812_345_6e6, 2.000_001, 1.267_912_345_6e6, 2.000_123_4]);
        for (name, card) in read_all(&material) {
            let checked = card.check(&material, &states());
            match name {
                "LS-DYNA" => assert!(checked.unwrap_err().contains("its digits give the uniaxial stress"), "{name}"),
                _ => assert_eq!(checked, Ok(()), "{name}"),
            }
        }
    }

    #[test]
    fn a_number_that_differs_is_named() {
        let law = LAWS.iter().find(|law| law.name == "yeoh_2").unwrap();
        let material = law.material(&[1e5, 1e4]);
        let card = |change: fn(&mut Material)| {
            let mut changed = material;
            change(&mut changed);
            Card::of(&changed).check(&material, &states()).unwrap_err()
        };
        assert!(card(|m| m.density *= 1.01).contains("density"));
        assert!(card(|m| m.poissons_ratio = 0.4).contains("bulk modulus"));
        assert!(card(|m| *m.coefficients.get_mut("c20").unwrap() *= 1.1).contains("stress at the stretch"));
        assert!(card(|m| m.prony_g[0] = 0.1).contains("it has 1 viscous terms instead of 0"));
    }
}
