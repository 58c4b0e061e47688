//! What the documents say of the presets' silicones, against the study's material tests.
//!
//! Source: the study's model (friction 0.3 on the core, Poisson's ratio up to 0.49) and its relaxation test, whose shear
//! modulus falls from about 0.6 to 0.33 MPa.

use softanvil_kernel::material::{Material, VolumetricBy};
use softanvil_kernel::preset::{PRESETS, study, study_14_7, study_incompressible};
use softanvil_kernel::scenario::{DropBy, Interface};
use softanvil_kernel::{SAMPLING_INTERVAL, Simulation};
use softanvil_verification::scenes::run;
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_RESIDUAL, relative_error};

/// Poisson's ratio of a shear modulus beside the bulk modulus of `material`.
fn poissons_ratio(material: &Material, shear_modulus: f64) -> f64 {
    let bulk = material.effective_bulk_modulus();
    (3.0 * bulk - 2.0 * shear_modulus) / (2.0 * (3.0 * bulk + shear_modulus))
}

/// To the digits that the documents give: shear modulus at rest in the long term and at once, MPa, and Poisson's ratios.
#[test]
fn moduli_are_those_of_the_documents() {
    for (scenario, moduli, ratios) in [
        (study(), ["0.50", "15.0"], ["0.490", "0.25"]),
        (study_14_7(), ["0.31", "2.9"], ["0.490", "0.41"]),
        (study_incompressible(), ["0.56", "11.2"], ["0.499", "0.47"]),
    ] {
        let silicone = &scenario.layers[0].material;
        let long_term = silicone.shear_modulus_inf();
        let at_once = long_term / silicone.prony_g_inf();
        assert_eq!([format!("{:.2}", 1e-6 * long_term), format!("{:.1}", 1e-6 * at_once)], moduli);
        let found = [poissons_ratio(silicone, long_term), poissons_ratio(silicone, at_once)];
        assert_eq!([format!("{:.3}", found[0]), format!("{:.2}", found[1])], ratios);
        assert!((0.3e6..=0.6e6).contains(&long_term));
        assert_eq!((scenario.core.interface, scenario.core.friction_coefficient), (Interface::Frictional, 0.3));
    }
}

/// Whatever states the same thing as another value says the same, so that naming one of them changes nothing.
#[test]
fn values_that_state_the_same_thing_agree() {
    for preset in PRESETS {
        let scenario = (preset.scenario)();
        let mut impactor = scenario.impactor;
        let speed = impactor.start_speed();
        for drop_by in [DropBy::Height, DropBy::Energy, DropBy::Speed] {
            impactor.drop_by = drop_by;
            assert!(relative_error(impactor.start_speed(), speed) < CLOSED_FORM, "{}: {drop_by:?}", preset.name);
        }
        for material in scenario.layers.iter().map(|layer| layer.material) {
            for volumetric_by in [VolumetricBy::BulkModulus, VolumetricBy::PoissonsRatio] {
                let other = Material { volumetric_by, ..material };
                let (other, own) = (other.effective_bulk_modulus(), material.effective_bulk_modulus());
                assert!(relative_error(other, own) < CLOSED_FORM, "{}: {other} Pa, {own} Pa", preset.name);
            }
        }
        let step = Simulation::new(&scenario).expect("a preset").constants().dt;
        assert_eq!(scenario.time.step, step, "{}: {}", preset.name, SAMPLING_INTERVAL / step);
    }
}

/// Every preset goes through its drop, and keeps its energy.
#[test]
fn every_preset_runs() {
    for preset in PRESETS {
        let scenario = (preset.scenario)();
        let simulation = run(&scenario);
        let energy = simulation.scalars().energy;
        let part = energy.residual().abs() / energy.external;
        assert!(part < ENERGY_RESIDUAL, "{}: {part}", preset.name);
        assert!(simulation.scalars().metrics.peak_force > 0.0, "{}", preset.name);
    }
}

/// What decides is not computed from what follows from it: the paper's energy is there to the last bit.
#[test]
fn the_value_that_decides_is_as_it_is_stated() {
    for scenario in [study(), study_14_7(), study_incompressible()] {
        let impactor = scenario.impactor;
        assert_eq!((impactor.drop_by, impactor.drop_energy, impactor.mass), (DropBy::Energy, 14.7, 5.0));
        // Of 9.81 m/s2.
        assert!(relative_error(impactor.drop_height, 14.7 / (5.0 * 9.81)) < CLOSED_FORM);
        assert!(relative_error(impactor.drop_speed, (2.0_f64 * 14.7 / 5.0).sqrt()) < CLOSED_FORM);
    }
}
