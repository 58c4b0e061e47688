//! What the study printed: Table 1, of its experiment and its LS-DYNA model, and the sensitivities of that model.
//!
//! "Finite element model to simulate impact on a soft tissue simulant", Sports Engineering (2023),
//! doi 10.1007/s12283-023-00407-7. Only values are taken from it; its percentages have misprints, so that errors are
//! always recomputed.

use softanvil_kernel::Scenario;
use softanvil_kernel::preset::{Fitted, study};

pub mod validation;

use crate::measurement::quantity::COUNT;

/// Where the numbers come from.
pub const SOURCE: &str = "Table 1 of doi 10.1007/s12283-023-00407-7";

/// One impact energy of the table, in SI; the four numbers are in the order of [`crate::measurement::quantity::QUANTITIES`].
#[derive(Debug)]
pub struct Case {
    /// Impact energy, J.
    pub energy: f64,
    /// Measured.
    pub experiment: [f64; COUNT],
    /// Computed by the study's LS-DYNA model.
    pub ls_dyna: [f64; COUNT],
}

/// Digits after the point with which the table prints the four numbers, in their display units.
pub const DECIMALS: [usize; COUNT] = [0, 1, 1, 0];

/// The table: peak force in N, deformation in m, duration in s, impulse in N s.
pub static TABLE_1: [Case; 3] = [
    Case { energy: 14.7, experiment: [5499.0, 5.1e-3, 6.8e-3, 16.0], ls_dyna: [5538.0, 4.7e-3, 6.3e-3, 13.0] },
    Case { energy: 9.8, experiment: [4071.0, 3.5e-3, 8.1e-3, 13.0], ls_dyna: [4040.0, 3.8e-3, 6.8e-3, 11.0] },
    Case { energy: 4.9, experiment: [2399.0, 2.9e-3, 10.5e-3, 11.0], ls_dyna: [2460.0, 3.1e-3, 9.0e-3, 9.0] },
];

/// A parameter that the study changed within a range, and how little came of it.
#[derive(Debug)]
pub struct Sensitivity {
    /// The range.
    pub range: [f64; 2],
    /// Its results changed by less than this part, %.
    pub below_percent: f64,
}

/// Coulomb friction, and the force trace in parts of the peak.
pub static FRICTION: Sensitivity = Sensitivity { range: [0.2, 0.6], below_percent: 0.3 };
/// The same in N.
pub const FRICTION_FORCE: f64 = 15.0;
/// Poisson's ratio, and all four numbers.
pub static POISSON: Sensitivity = Sensitivity { range: [0.48, 0.49], below_percent: 0.05 };

/// Diameter of the steel anvil of the test standard, m, to which the paper likens its own.
pub const STANDARD_DIAMETER: f64 = 115e-3;

/// Element size that its mesh convergence gave, m.
pub const ELEMENT_SIZE: f64 = 3e-3;

/// Young's modulus, Pa, from which its damping modulus was computed by mu = E / (2 (1 + nu)).
pub const DAMPING_YOUNGS_MODULUS: f64 = 140e6;
/// A damping modulus with which the peak at [`TUNED_ENERGY`] was too low by more than [`LOW_DAMPING_PERCENT`], Pa.
pub const LOW_DAMPING_MODULUS: f64 = 0.06e6;
/// See [`LOW_DAMPING_MODULUS`], %.
pub const LOW_DAMPING_PERCENT: f64 = 30.0;

/// Impact energy at which the model was tuned, J.
pub const TUNED_ENERGY: f64 = 14.7;

/// What of the table went into its model.
pub const FITTED: Fitted = Fitted { parameters: 1, numbers: 1 };
/// How, as far as the paper says.
pub const FITTED_HOW: &str = "the damping modulus, to the peak force of 14.7 J";

/// Whether the anvil and the impactor of `scenario` are those of the paper, whatever the silicone and the speed, so that its
/// figures have a place beside ours.
pub fn is_its_model(scenario: &Scenario) -> bool {
    let study = study();
    let (ours, its) = (&scenario.impactor, &study.impactor);
    scenario.geometry == study.geometry
        && ours.motion == its.motion
        && [ours.mass, ours.face_diameter, ours.offset] == [its.mass, its.face_diameter, its.offset]
}

/// A law that was tried beside the chosen Mooney-Rivlin 5, with the same Prony series and damping.
#[derive(Debug)]
pub struct Alternative {
    /// Name of the law in `softanvil_identify`.
    pub law: &'static str,
    /// Error of the peak force at [`TUNED_ENERGY`] against the experiment, %.
    pub peak_error_percent: f64,
}

/// The laws that under-predicted.
pub static ALTERNATIVES: [Alternative; 2] = [
    Alternative { law: "ogden_3", peak_error_percent: -27.0 },
    Alternative { law: "yeoh_3", peak_error_percent: -35.0 },
];

/// Residuals of its fits, whose unit is not printed: the chosen Mooney-Rivlin 5, then the [`ALTERNATIVES`].
pub const RESIDUALS: [(&str, f64); 3] = [("mooney_rivlin_5", 8.0), ("ogden_3", 22.0), ("yeoh_3", 24.0)];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::errors::{errors_percent, mean_absolute};

    #[test]
    fn ls_dyna_deviates_from_the_experiment_by_9_8_percent() {
        let errors = TABLE_1.iter().map(|case| errors_percent(&case.ls_dyna, &case.experiment));
        let means: Vec<f64> = errors.clone().map(|errors| mean_absolute(errors.into_iter())).collect();
        for (mean, expected) in means.iter().zip([8.7, 10.2, 10.5]) {
            assert!((mean - expected).abs() < 0.05, "{means:?}");
        }
        assert!((mean_absolute(errors.flatten()) - 9.8).abs() < 0.05);
    }
}
