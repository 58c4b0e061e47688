//! What a file says to its reader, and whether that is the material it was written from.

use softanvil_kernel::material::{Elastic, Material};

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
        let mut long_term = *material;
        let scale = material.long_term_scale();
        long_term.moduli = softanvil_kernel::material::Moduli::LongTerm;
        for c in [
            &mut long_term.c10,
            &mut long_term.c01,
            &mut long_term.c11,
            &mut long_term.c20,
            &mut long_term.c02,
            &mut long_term.c30,
        ] {
            *c *= scale;
        }
        long_term.ogden_mu.iter_mut().for_each(|mu| *mu *= scale);
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
    use crate::law::{LAWS, MODES};
    use softanvil_kernel::material::Moduli;

    fn states() -> Vec<States> {
        MODES.iter().map(|mode| (*mode, (0..40).map(|k| 0.4 + 0.05 * f64::from(k)).collect())).collect()
    }

    /// Every way in which a card is written and read.
    fn read_all(material: &Material) -> [(&'static str, Card); 4] {
        let layer = Layer::Silicone;
        [
            ("LS-DYNA", ls_dyna::read(&ls_dyna::text("rubber", "from\na test", material)).unwrap()),
            ("Abaqus", abaqus::read(&abaqus::text("rubber", "from\na test", material)).unwrap()),
            ("C", c_source::read(&c_source::text("from\na test", material, layer), layer).unwrap()),
            ("ssv", ssv::read(&ssv::text("rubber", material, layer).unwrap(), layer).unwrap()),
        ]
    }

    #[test]
    fn every_law_comes_back_from_every_file() {
        for law in &LAWS {
            let values: Vec<f64> = match law.unit(1.min(law.parameters.len() - 1)) {
                "1" => [-123_456.789, 1.234_567_8, 2.345_678_9e-3, 5.1, 3.3e5, 2.2][..law.parameters.len()].into(),
                _ => [1.234_567_8e5, 2.345_678_9e4, -345.678_912, 45.678_912_3, 5.678_912_34][..law.parameters.len()]
                    .into(),
            };
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
        assert!(card(|m| m.c20 *= 1.1).contains("stress at the stretch"));
        assert!(card(|m| m.prony_g[0] = 0.1).contains("it has 1 viscous terms instead of 0"));
    }
}
