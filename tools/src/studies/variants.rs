//! Variants of a drop that several studies need.

use softanvil_kernel::Scenario;
use softanvil_kernel::material::VolumetricBy;
use softanvil_kernel::scenario::Motion;

use super::values::set;
use crate::failure::Failure;

/// Depth of the press in thicknesses of the layer.
pub const DEPTH: f64 = 1.0 / 3.0;
/// Its speed, m/s.
pub const SPEED: f64 = 0.1;
/// Time over which the speed rises and falls, s.
const RISE: f64 = 0.01;
/// Time of the hold, over which the force is the mean, s.
const HOLD: f64 = 0.01;

/// `scenario` pressed to [`DEPTH`] and held.
pub fn press(mut scenario: Scenario) -> Scenario {
    let depth = DEPTH * scenario.thickness();
    let impactor = &mut scenario.impactor;
    impactor.motion = Motion::Prescribed;
    impactor.gap = 0.0;
    impactor.prescribed_speed = SPEED;
    impactor.prescribed_depth = depth;
    impactor.prescribed_rise = RISE.min(0.5 * impactor.prescribed_depth / SPEED);
    scenario.time.duration = impactor.prescribed_depth / SPEED + impactor.prescribed_rise + HOLD;
    scenario
}

/// `scenario` without Prony series, Maxwell terms and damping spring: its long-term law alone.
pub fn undamped(mut scenario: Scenario) -> Scenario {
    for material in scenario.layers.iter_mut().map(|layer| &mut layer.material) {
        let scale = material.long_term_scale();
        for coefficient in [
            &mut material.c10,
            &mut material.c01,
            &mut material.c11,
            &mut material.c20,
            &mut material.c02,
            &mut material.c30,
        ] {
            *coefficient *= scale;
        }
        material.ogden_mu.iter_mut().for_each(|mu| *mu *= scale);
        material.prony_g = [0.0; 5];
        material.maxwell_g = [0.0; 5];
        material.slider_stiffness = 0.0;
    }
    scenario
}

/// Gives the silicone another Poisson's ratio.
///
/// # Errors
/// A ratio that is refused.
pub fn set_ratio(scenario: &mut Scenario, ratio: f64) -> Result<(), Failure> {
    scenario.layers[0].material.volumetric_by = VolumetricBy::PoissonsRatio;
    set(scenario, "layers[0].poissons_ratio", ratio)
}

/// Poisson's ratio of the scenario's silicone, also where its bulk modulus is given.
pub fn ratio_of(scenario: &Scenario) -> f64 {
    let (bulk, shear) =
        (scenario.layers[0].material.effective_bulk_modulus(), scenario.layers[0].material.shear_modulus_inf());
    (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))
}
