//! Which numbers an impact can have, by its energy and momentum: what is outside was typed in another unit.

use softanvil_kernel::Scenario;

use super::target::Target;
use super::variable::{Variable, apply};

/// Impulse over the momentum at the start: 1 of an impactor that stays down, 2 of one that comes back as fast; rails and a threshold
/// take some of it.
const IMPULSE_OF_MOMENTUM: (f64, f64) = (0.9, 2.5);
/// Longest duration of an impact, s. A press takes longer, and has no energy.
const LONGEST: f64 = 1.0;
/// Peak force over the mean that stops the impactor on its way, or turns it in its time: at least half of it, since rails take
/// some, and less than a spike has.
const PEAK_OF_MEAN: (f64, f64) = (0.5, 50.0);
/// How much less than the thickness of all layers the deformation may be, where it was not measured.
const UNKNOWN_WAY: f64 = 20.0;

/// What the impacts of a problem have in common.
pub struct Possible {
    /// Thickness of the layers and of the gaps between them, m: the largest that is searched.
    thickness: f64,
    /// Mass and gravity of the impactor; none if the mass is searched for.
    weight: Option<(f64, f64)>,
}

impl Possible {
    /// Of the impacts on the anvil of `scenario`, in which `variables` are searched.
    ///
    /// # Errors
    /// A value of a variable that is refused.
    pub fn new(scenario: &Scenario, variables: &[Variable]) -> Result<Self, String> {
        let mut thickest = scenario.clone();
        let largest = |variable: &Variable| match variable.name.rsplit_once('.') {
            Some((_, "thickness" | "gap")) => variable.value(1.0),
            _ => variable.start(scenario),
        };
        apply(variables, &variables.iter().map(largest).collect::<Vec<_>>(), &mut thickest)?;
        let gaps = (0..thickest.layers.len()).map(|place| thickest.gap_below(place)).sum::<f64>();
        let is_mass = |variable: &Variable| variable.name == "impactor.mass";
        let impactor = &scenario.impactor;
        let weight = (!variables.iter().any(is_mass)).then_some((impactor.mass, impactor.gravity));
        Ok(Self { thickness: thickest.thickness() + gaps, weight })
    }

    /// Whether the impact of `target` can have its measured numbers.
    ///
    /// # Errors
    /// The first that it cannot have, with its SI unit and what is possible.
    pub fn check(&self, target: &Target) -> Result<(), String> {
        let energy = target.energy;
        let [force, deformation, duration, impulse] = target.measured;
        let momentum = self.weight.map(|(mass, _)| (2.0 * mass * energy).sqrt());
        let refuse = |key: &str, unit: &str, value: f64, (min, max): (f64, f64), why: &str| {
            if (min..=max).contains(&value) {
                return Ok(());
            }
            let round = |bound: f64| if bound == 0.0 { bound } else { format!("{bound:.2e}").parse().unwrap_or(bound) };
            Err(format!(
                "impact of {energy} J: {key} = {value} {unit} is refused: expected {} to {} {unit}, {why}; numbers are in SI units",
                round(min),
                round(max)
            ))
        };
        if let Some(deformation) = deformation {
            let why = "the thickness of the layers and their gaps";
            refuse("max_deformation", "m", deformation, (0.0, self.thickness), why)?;
        }
        if let Some(duration) = duration {
            refuse("impact_duration", "s", duration, (0.0, LONGEST), "the longest impact")?;
        }
        if let (Some(impulse), Some(momentum), Some((mass, gravity))) = (impulse, momentum, self.weight) {
            let (low, high) = IMPULSE_OF_MOMENTUM;
            let weight = mass * gravity * duration.unwrap_or(0.1 * LONGEST);
            let why = "the momentum at the start to a little more than twice that and the weight over the impact";
            refuse("impulse", "N s", impulse, (low * momentum, high * momentum + weight), why)?;
        }
        let Some(force) = force else { return Ok(()) };
        let on_its_way = energy / deformation.unwrap_or(self.thickness);
        let in_its_time = momentum.zip(duration).map_or(0.0, |(momentum, duration)| momentum / duration);
        let (low, high) = PEAK_OF_MEAN;
        let mean = f64::max(on_its_way, in_its_time);
        let high = if deformation.is_some() { high } else { UNKNOWN_WAY * high };
        let why = "as it takes to stop the impactor within its deformation and its duration";
        refuse("peak_force", "N", force, (low * mean, high * mean), why)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::calibration::problem::Problem;

    /// What is refused of an impact of 14.7 J, 12.1 N s, on 15 mm with these numbers.
    fn refused(numbers: &str) -> Option<String> {
        let text = format!(
            "[search]\nevaluations = 1\n[parameters]\n\"silicone.c10\" = {{ min = 1e4, max = 1e6 }}\n[[impact]]\nenergy = 14.7\n\
             {numbers}\n"
        );
        Problem::parse(&text, Path::new(".")).err()
    }

    #[test]
    fn numbers_of_other_units_are_refused_with_what_is_possible() {
        for (numbers, message) in [
            ("max_deformation = 5.2", "impact of 14.7 J: max_deformation = 5.2 m is refused: expected 0 to 0.015 m"),
            ("impact_duration = 7", "impact_duration = 7 s is refused: expected 0 to 1 s"),
            ("impulse = 0.016", "impulse = 0.016 N s is refused: expected 10.9 to 35.2 N s"),
            ("impulse = 16000", "impulse = 16000 N s is refused: expected 10.9 to 35.2 N s"),
            ("peak_force = 5", "peak_force = 5 N is refused: expected 490 to "),
            (
                "peak_force = 5e6\nmax_deformation = 5.2e-3",
                "peak_force = 5000000 N is refused: expected 1410 to 141000 N",
            ),
            ("peak_force = 700\nimpact_duration = 7e-3", "peak_force = 700 N is refused: expected 866 to "),
        ] {
            let error = refused(numbers).unwrap();
            assert!(error.contains(message) && error.ends_with("numbers are in SI units"), "{numbers}: {error}");
        }
    }

    #[test]
    fn numbers_that_an_impact_has_are_taken() {
        for numbers in [
            "peak_force = 5499\nmax_deformation = 4.3e-3\nimpact_duration = 7.7e-3\nimpulse = 16",
            // A dead blow, and one on a soft pad.
            "impulse = 12.1",
            "peak_force = 1100\nmax_deformation = 0.0149\nimpact_duration = 0.02",
        ] {
            assert_eq!(refused(numbers), None, "{numbers}");
        }
    }
}
