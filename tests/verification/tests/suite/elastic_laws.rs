//! What every hyperelastic law must satisfy, through the element: its stress is the gradient of its energy, turns with the
//! body, vanishes at rest, and starts with the modulus that the material states.
//!
//! Source: the definition of a hyperelastic material, P = dW/dF, and of objectivity, P(Q F) = Q P(F), e.g. Holzapfel,
//! Nonlinear Solid Mechanics (2000).

use softanvil_kernel::material::{Elastic, Material, VolumetricLaw};
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::preset;
use softanvil_kernel::scenario::Formulation;
use softanvil_kernel::tensor::stretch::IsochoricStretch;
use softanvil_verification::deformation::{Gradient, Samples, product, rotation};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::{laws, run};
use softanvil_verification::tolerance::{
    CLOSED_FORM, ENERGY_GRADIENT, ENERGY_RESIDUAL, SHEAR_TANGENT, SMALL_SHEAR, relative_error,
};

const BULK: f64 = 1e6;

fn cell(material: Material, formulation: Formulation) -> Cell {
    Cell::new(material, formulation, 1e-6)
}

fn energy(material: Material, formulation: Formulation, gradient: Gradient) -> f64 {
    let mut cell = cell(material, formulation);
    cell.deform(gradient);
    cell.elastic_energy
}

fn scale(stress: &Gradient) -> f64 {
    stress.iter().flatten().fold(0.0_f64, |largest, p| largest.max(p.abs()))
}

/// Compares the stress with central differences of the energy along the `entries` of the gradient.
fn check_gradient(what: &str, material: Material, f: Formulation, gradient: Gradient, entries: &[(usize, usize)]) {
    let step = 1e-5;
    let stress = cell(material, f).deform(gradient);
    for &(i, j) in entries {
        let at = |offset: f64| {
            let mut moved = gradient;
            moved[i][j] += offset;
            energy(material, f, moved)
        };
        let difference = (at(step) - at(-step)) / (2.0 * step);
        let error = (stress[i][j] - difference).abs() / scale(&stress).max(BULK);
        assert!(error < ENERGY_GRADIENT, "{what} P{i}{j} at {gradient:?}: {} against {difference}", stress[i][j]);
    }
}

#[test]
fn stress_is_the_gradient_of_the_energy() {
    let mut samples = Samples::new(1);
    for (name, material) in laws(BULK) {
        for _ in 0..20 {
            let gradient = samples.gradient(0.4);
            let entries = [(0, 0), (0, 1), (1, 0), (1, 1)];
            check_gradient(name, material, Formulation::PlaneStrain, gradient, &entries);
            // Homogeneous in a body of revolution: no shear of the radius along the axis.
            let turned = [[gradient[0][0].abs().max(0.5), 0.0], [0.3 * samples.number(), 1.0 + 0.4 * samples.number()]];
            check_gradient(name, material, Formulation::Axisymmetric, turned, &[(0, 0), (1, 0), (1, 1)]);
        }
    }
}

#[test]
fn stress_turns_with_the_body() {
    let mut samples = Samples::new(2);
    for (name, material) in laws(BULK) {
        for _ in 0..20 {
            let gradient = samples.gradient(0.4);
            let turn = rotation(std::f64::consts::PI * samples.number());
            let still = product(turn, cell(material, Formulation::PlaneStrain).deform(gradient));
            let turned = cell(material, Formulation::PlaneStrain).deform(product(turn, gradient));
            for (a, b) in still.iter().flatten().zip(turned.iter().flatten()) {
                assert!((a - b).abs() < CLOSED_FORM * scale(&still).max(BULK), "{name} at {gradient:?}: {a} {b}");
            }
        }
    }
}

#[test]
fn no_stress_and_no_energy_at_rest() {
    for (name, material) in laws(BULK) {
        for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
            let mut cell = cell(material, formulation);
            let stress = cell.deform([[1.0, 0.0], [0.0, 1.0]]);
            assert_eq!((scale(&stress), cell.elastic_energy), (0.0, 0.0), "{name}");
        }
    }
}

/// Source: linear elasticity, shear stress = G times shear.
#[test]
fn the_shear_modulus_at_rest_is_the_one_stated() {
    let shear = 1e-4;
    for (name, material) in laws(BULK) {
        let stress = cell(material, Formulation::PlaneStrain).deform([[1.0, shear], [0.0, 1.0]])[0][1];
        let stated = material.shear_modulus_inf();
        assert!(relative_error(stress / shear, stated) < SMALL_SHEAR, "{name}: {} against {stated}", stress / shear);
    }
}

/// Source: pure shear by e along the principal axes, where W'' = 4 G with the tangent G, by central differences of W. It is
/// that of a neo-Hookean material, and a bound for the others, whose stress adds more.
#[test]
fn the_shear_tangent_bounds_that_of_a_plane_compression() {
    for (name, material) in laws(BULK).into_iter().filter(|(_, material)| !material.law.description().compressible) {
        let law = Elastic::new(&material);
        for stretch in [0.4_f64, 0.56, 0.9, 1.0, 1.3] {
            let energy = |e: f64| law.strain_energy_density(&IsochoricStretch::plane_compression(stretch * e.exp()));
            let step = 1e-3;
            let tangent = 0.25 * (energy(step) - 2.0 * energy(0.0) + energy(-step)) / (step * step);
            let bound = law.shear_tangent(Scalar, &IsochoricStretch::plane_compression(stretch));
            assert!(bound > tangent * (1.0 - SHEAR_TANGENT), "{name} at {stretch}: {bound} Pa, {tangent} Pa");
            if matches!(law, Elastic::NeoHookean(_)) {
                assert!(
                    relative_error(bound, tangent) < SHEAR_TANGENT,
                    "{name} at {stretch}: {bound} Pa, {tangent} Pa"
                );
            }
        }
    }
}

/// Source: conservation of energy, in the study's drop on a silicone of each law with the study's memory, and a slider.
#[test]
fn energy_closes_in_a_drop_with_every_law() {
    let study = preset::study();
    for (name, law) in laws(study.layers[0].material.bulk_modulus) {
        // A foam that bears this drop; it has no volumetric law beside it.
        let compressible = law.law.description().compressible;
        let stiffer = if compressible { 20.0 } else { 1.0 };
        let law = Material { coefficients: law.coefficients.scaled(stiffer), ..law };
        for volumetric_law in [VolumetricLaw::Quadratic, VolumetricLaw::Simo] {
            let mut scenario = study.clone();
            scenario.layers[0].material = Material {
                volumetric_law,
                prony_g: study.layers[0].material.prony_g,
                slider_stiffness: 1e6,
                slider_yield_stress: 10e3,
                ..law
            };
            let ledger = run(&scenario).scalars().energy;
            let error = ledger.residual().abs() / ledger.external;
            assert!(error < ENERGY_RESIDUAL, "{name}, {volumetric_law:?}: {error:e}");
            assert!(ledger.elastic > 0.0 && ledger.viscous > 0.0, "{name}: {ledger:?}");
        }
    }
}
