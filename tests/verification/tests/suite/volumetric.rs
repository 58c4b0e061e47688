//! The volumetric law of Simo: closed form, gradient of its energy, and extreme compression.
//!
//! Source: Simo and Miehe (1992): U = K/4 (J^2 - 1 - 2 ln J), so p = K/2 (J - 1/J), which has no bound at J = 0.

use softanvil_kernel::material::{Material, NeoHookean, Volumetric, VolumetricLaw};
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::scenario::{Interface, Motion, StepBy};
use softanvil_kernel::{Simulation, StepError, StepInput};
use softanvil_verification::problems::volumetric::{BULK, dilatation_error, gradient_error};
use softanvil_verification::scenes::{block, elastic};
use softanvil_verification::tolerance::{CLOSED_FORM, ENERGY_GRADIENT, ENERGY_RESIDUAL};

/// A pure dilatation has the Cauchy stress p in every direction: P = p l^2.
#[test]
fn pressure_of_a_dilatation() {
    let error = dilatation_error();
    assert!(error < CLOSED_FORM, "{error:e}");
}

#[test]
fn stress_is_the_gradient_of_the_energy() {
    for law in [VolumetricLaw::Quadratic, VolumetricLaw::Simo] {
        let volumetric = Volumetric { law, bulk_modulus: BULK };
        for j in [0.05_f64, 0.3, 0.99, 1.0, 1.01, 2.0] {
            let error = gradient_error(law, j);
            assert!(error < ENERGY_GRADIENT, "{law:?} at {j}: {error:e}");
            // The tangent bounds the slope of the stress against spatial strain.
            let step = 1e-5 * j;
            let slope = j * j * (volumetric.stress(j + step) - volumetric.stress(j - step)) / (2.0 * step);
            let tangent = volumetric.tangent(Scalar, j);
            assert!(tangent > slope * (1.0 - 1e-6), "{law:?} at {j}: {tangent}");
        }
    }
}

/// Drops on a block that is soft in shear and held at both ends 3/2 K times its volume, three times all the energy that the
/// quadratic law can take up before J = 0.
fn crush(law: VolumetricLaw) -> Result<Simulation, StepError> {
    let (width, height, bulk) = (48e-3, 12e-3, 1e5);
    let material = Material { volumetric_law: law, ..elastic(0.0, 0.0, bulk).with(NeoHookean { c10: 1e3 }) };
    let mut scenario = block(width, height, material);
    // Bonded below, and above as far as friction goes, so that the volume has to give way.
    scenario.core.interface = Interface::Bonded;
    scenario.face.friction_coefficient = 10.0;
    scenario.impactor.motion = Motion::Drop;
    scenario.impactor.gap = 0.0;
    let volume = width * height * scenario.geometry.length;
    scenario.impactor = scenario.impactor.with_energy(1.5 * bulk * volume);
    // Below the limit of cells that are nearly crushed, which is far below that of the design.
    scenario.time.step_by = StepBy::Given;
    scenario.time.step = 0.1e-6;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let steps = simulation.constants().steps_in(20e-3);
    simulation.step(steps, &StepInput::default())?;
    Ok(simulation)
}

/// Simo's pressure has no bound, so it holds where the quadratic law lets elements collapse beyond what the step bears.
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
