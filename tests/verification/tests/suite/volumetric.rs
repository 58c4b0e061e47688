//! The volumetric law of Simo: closed form, gradient of its energy, and extreme compression.
//!
//! Source: Simo and Miehe (1992): U = K/4 (J^2 - 1 - 2 ln J), so p = K/2 (J - 1/J), which has no bound at J = 0.

use softanvil_kernel::material::Volumetric;
use softanvil_kernel::scenario::{ElasticLaw, Formulation, Interface, Material, Motion, VolumetricLaw};
use softanvil_kernel::{Simulation, StepError, StepInput};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::{block, elastic};
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_GRADIENT, ENERGY_RESIDUAL};

const BULK: f64 = 1e6;

fn simo() -> Material {
    Material { volumetric_law: VolumetricLaw::Simo, ..elastic(0.1e6, 0.05e6, BULK) }
}

/// A pure dilatation has the Cauchy stress p in every direction: P = p l^2.
#[test]
fn pressure_of_a_dilatation() {
    for l in [0.1_f64, 0.3, 0.9, 0.999_999, 1.000_001, 1.1, 2.0] {
        let j = l.powi(3);
        let p = Cell::new(simo(), Formulation::Axisymmetric, 1e-6).deform([[l, 0.0], [0.0, l]]);
        // The round-off of J is that of l^3, which the stress near rest is a difference from 1 of.
        let error = (p[1][1] - 0.5 * BULK * (j - 1.0 / j) * l * l).abs();
        assert!(error < CLOSED_FORM * p[1][1].abs().max(1e-3 * BULK), "dilatation {l}: {} Pa", p[1][1]);
    }
}

#[test]
fn stress_is_the_gradient_of_the_energy() {
    for law in [VolumetricLaw::Quadratic, VolumetricLaw::Simo] {
        let volumetric = Volumetric { law, bulk_modulus: BULK };
        for j in [0.05_f64, 0.3, 0.99, 1.0, 1.01, 2.0] {
            let step = 1e-5 * j;
            let energy = |j: f64| volumetric.strain_energy_density(&[j; 8])[0];
            let difference = (energy(j + step) - energy(j - step)) / (2.0 * step);
            let stress = volumetric.stress(&[j; 8])[0];
            assert!((stress - difference).abs() < ENERGY_GRADIENT * (stress.abs() + BULK), "{law:?} at {j}");
            // The tangent bounds the slope of the stress against spatial strain.
            let slope =
                j * j * (volumetric.stress(&[j + step; 8])[0] - volumetric.stress(&[j - step; 8])[0]) / (2.0 * step);
            assert!(volumetric.tangent(j) > slope * (1.0 - 1e-6), "{law:?} at {j}: {}", volumetric.tangent(j));
        }
    }
}

/// Drops on a block that is soft in shear and held at both ends K/2 times its volume, which is all the energy that the
/// quadratic law can take up before J = 0.
fn crush(law: VolumetricLaw) -> Result<Simulation, StepError> {
    let (width, height, bulk) = (48e-3, 12e-3, 1e5);
    let material = Material { law: ElasticLaw::NeoHookean, volumetric_law: law, ..elastic(1e3, 0.0, bulk) };
    let mut scenario = block(width, height, material);
    // Bonded below, and above as far as friction goes, so that the volume has to give way.
    scenario.core.interface = Interface::Bonded;
    scenario.face.friction_coefficient = 10.0;
    scenario.impactor.motion = Motion::Drop;
    scenario.impactor.gap = 0.0;
    let volume = width * height * scenario.geometry.length;
    scenario.impactor = scenario.impactor.with_energy(0.5 * bulk * volume);
    scenario.time.safety_factor = 0.01;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(20e-3);
    simulation.step(steps, &StepInput::default())?;
    Ok(simulation)
}

/// Simo's pressure has no bound, so it holds where the quadratic law lets elements collapse.
#[test]
fn simo_holds_under_extreme_compression() {
    let simulation = crush(VolumetricLaw::Simo).expect("a stable run");
    let (ledger, metrics) = (simulation.scalars().energy, simulation.scalars().metrics);
    let residual = ledger.residual().abs() / ledger.external;
    assert!(residual < ENERGY_RESIDUAL, "{residual:e} of {} J", ledger.external);
    assert!(metrics.max_deformation > 0.7 * 12e-3, "{} m", metrics.max_deformation);
    let failure = crush(VolumetricLaw::Quadratic).err();
    assert!(failure.is_some(), "the quadratic law held");
}
