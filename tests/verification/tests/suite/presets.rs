//! What the documents say of the presets' silicones, against the study's material tests.
//!
//! Source: the study's model (friction 0.3 on the core, Poisson's ratio up to 0.49) and its relaxation test, whose shear
//! modulus falls from about 0.6 to 0.33 MPa.

use softanvil_kernel::preset::{self, study, study_14_7, study_incompressible};
use softanvil_kernel::scenario::{Interface, Material};

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
        let silicone = &scenario.silicone;
        let long_term = silicone.shear_modulus_inf();
        let at_once = long_term / silicone.prony_g_inf();
        assert_eq!([format!("{:.2}", 1e-6 * long_term), format!("{:.1}", 1e-6 * at_once)], moduli);
        let found = [poissons_ratio(silicone, long_term), poissons_ratio(silicone, at_once)];
        assert_eq!([format!("{:.3}", found[0]), format!("{:.2}", found[1])], ratios);
        assert!((0.3e6..=0.6e6).contains(&long_term));
        assert_eq!((scenario.core.interface, scenario.core.friction_coefficient), (Interface::Frictional, 0.3));
    }
    assert_eq!(preset::PRESETS.len(), 3);
}

/// The bulk modulus that stands beside Poisson's ratio is its own, rounded.
#[test]
fn bulk_modulus_and_poissons_ratio_agree() {
    for scenario in [study(), study_14_7()] {
        let (stated, own) = (scenario.silicone.bulk_modulus, scenario.silicone.effective_bulk_modulus());
        assert!((stated / own - 1.0).abs() < 5e-3, "{stated} Pa beside {own} Pa");
    }
}
