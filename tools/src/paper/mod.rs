//! What the paper printed: Table 1, of its experiment and its LS-DYNA model.
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
    /// Computed by the paper's LS-DYNA model.
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
        && [ours.motion as usize, ours.shape as usize] == [its.motion as usize, its.shape as usize]
        && [ours.rail_friction, ours.rail_damping] == [its.rail_friction, its.rail_damping]
        && [ours.mass, ours.face_diameter, ours.offset] == [its.mass, its.face_diameter, its.offset]
}

/// The case of the table that `scenario` is a drop of, on one layer of the paper's thickness, if it is one.
pub fn case_of(scenario: &Scenario) -> Option<&'static Case> {
    if scenario.layers.len() != 1 || scenario.thickness() != study().thickness() {
        return None;
    }
    let energy = 0.5 * scenario.impactor.mass * scenario.impactor.start_speed().powi(2);
    is_its_model(scenario).then(|| TABLE_1.iter().find(|case| (case.energy - energy).abs() < 1e-9))?
}

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
