//! Properties of every material under any admissible history of deformation: finite, dissipating, conserving.
//!
//! Source: the second law (Clausius-Duhem) for each mechanism by itself, and the first law for their sum. The histories
//! are drawn by proptest from a fixed seed, so that a failure comes back.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use softanvil_kernel::material::{Coefficients, ElasticLaw, Material, N_COEFFICIENT, Ogden, VolumetricLaw};
use softanvil_kernel::scenario::Formulation;
use softanvil_verification::deformation::Gradient;
use softanvil_verification::deformation::{product, rotation};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{HISTORY_ENERGY, NO_GAIN};

const DT: f64 = 1e-5;

/// A state on the way: logarithms of two stretches, shear of the stretch, angle of rotation.
type Waypoint = [f64; 4];

fn waypoints() -> impl Strategy<Value = Vec<Waypoint>> {
    // The determinant e^(a + b) - c^2 stays above 0.16.
    let waypoint = (-0.7..0.7_f64, -0.7..0.7_f64, -0.3..0.3_f64, -7.0..7.0_f64).prop_map(|(a, b, c, d)| [a, b, c, d]);
    vec(waypoint, 1..5)
}

/// The deformation at a waypoint. A body of revolution stays homogeneous where the radius is stretched as the circumference is,
/// and where it turns into the axis: there is no rotation but that of this shear.
fn gradient(formulation: Formulation, [a, b, c, angle]: Waypoint) -> Gradient {
    match formulation {
        Formulation::PlaneStrain | Formulation::Solid => product(rotation(angle), [[a.exp(), c], [c, b.exp()]]),
        Formulation::Axisymmetric => [[a.exp(), 0.0], [angle / 7.0, b.exp()]],
    }
}

/// Coefficients of 0 to 0.1 MPa, with W > 0 for every deformation.
fn elasticity() -> impl Strategy<Value = Material> {
    let volumetric = prop_oneof![Just(VolumetricLaw::Quadratic), Just(VolumetricLaw::Simo)];
    (prop_oneof![4 => plausible(), 1 => exponents()], volumetric, 0.2e6..5e6_f64).prop_map(
        |((law, coefficients), volumetric_law, bulk)| Material {
            law,
            coefficients,
            volumetric_law,
            ..elastic(0.0, 0.0, bulk)
        },
    )
}

/// Any law with coefficients where they are plausible, none of which softens it.
fn plausible() -> impl Strategy<Value = (ElasticLaw, Coefficients)> {
    (0..ElasticLaw::ALL.len(), vec(0.0..1.0_f64, N_COEFFICIENT)).prop_map(|(law, parts)| {
        let law = ElasticLaw::ALL[law];
        let values = law.description().coefficients.iter().zip(parts).map(|(coefficient, part)| {
            let (low, high) = coefficient.plausible;
            let (low, unit) = if coefficient.is_modulus() && high > 0.0 {
                (low.max(0.0), 0.1e6)
            } else if coefficient.is_modulus() {
                (low, 0.1e6)
            } else {
                (low, 1.0)
            };
            unit * (low + part * (high - low))
        });
        (law, Coefficients::of_values(law, &values.collect::<Vec<_>>()))
    })
}

/// Ogden's law with exponents of both signs and next to 0.
fn exponents() -> impl Strategy<Value = (ElasticLaw, Coefficients)> {
    let alpha = [0.3..8.0_f64, -8.0..-0.3_f64, -1e-3..1e-3_f64];
    (vec(0.0..0.1e6_f64, 3), alpha).prop_map(|(c, alpha)| {
        let mu = core::array::from_fn(|k| (if k == 0 { 1e3 } else { 0.0 } + c[k]).copysign(alpha[k]));
        (ElasticLaw::Ogden, Coefficients::of(&Ogden::new(mu, alpha)))
    })
}

/// Any of the mechanisms on top, each on or off.
fn material() -> impl Strategy<Value = Material> {
    let term = (prop_oneof![Just(0.0), 0.01..0.3_f64], 1e-5..1e-1_f64);
    let maxwell = (prop_oneof![Just(0.0), 1e3..1e6_f64], 10.0..1e5_f64);
    let slider = (prop_oneof![Just(0.0), 1e5..6e7_f64], 0.0..0.2e6_f64);
    let tear = (prop_oneof![Just(0.0), 1.0..1.8_f64], 0.1..0.5_f64, 0.0..1.0_f64);
    (elasticity(), vec(term, 3), vec(maxwell, 2), slider, tear).prop_map(|(base, prony, maxwell, slider, tear)| {
        let mut material = base;
        for (k, (g, tau)) in prony.into_iter().enumerate() {
            (material.prony_g[k], material.prony_tau[k]) = (g, tau);
        }
        for (k, (g, beta)) in maxwell.into_iter().enumerate() {
            (material.maxwell_g[k], material.maxwell_beta[k]) = (g, beta);
        }
        (material.slider_stiffness, material.slider_yield_stress) = slider;
        (material.tear_stretch, material.tear_width, material.tear_residual) = tear;
        material
    })
}

/// Work of the nodal forces, and the sum of its sizes, J/m3.
#[derive(Default)]
struct Work {
    net: f64,
    gross: f64,
}

/// Drives a cell along the waypoints in `steps` steps each; checks every step.
fn drive(
    formulation: Formulation,
    material: Material,
    path: &[Waypoint],
    steps: u32,
) -> Result<(Cell, Work), TestCaseError> {
    let gradient = |waypoint| gradient(formulation, waypoint);
    let mut cell = Cell::new(material, formulation, DT);
    let mut work = Work::default();
    let (mut from, mut dissipated) = ([0.0; 4], [0.0_f64; 2]);
    let mut before = (gradient(from), cell.deform(gradient(from)));
    for to in path {
        for n in 1..=steps {
            let part = f64::from(n) / f64::from(steps);
            let gradient = gradient(core::array::from_fn(|i| from[i] + part * (to[i] - from[i])));
            let stress = cell.deform(gradient);
            let mut increment = 0.0;
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                prop_assert!(stress[i][j].is_finite(), "stress {stress:?} at {gradient:?}");
                increment += 0.5 * (stress[i][j] + before.1[i][j]) * (gradient[i][j] - before.0[i][j]);
            }
            work.net += increment;
            work.gross += increment.abs();
            before = (gradient, stress);
            let now = [cell.slider_dissipation, cell.tear];
            for (k, (now, before)) in now.into_iter().zip(dissipated).enumerate() {
                prop_assert!(now >= before - NO_GAIN * before.abs(), "mechanism {k}: {now} J/m3 after {before} J/m3");
            }
            dissipated = now;
        }
        from = *to;
    }
    Ok((cell, work))
}

/// Both formulations, as many `cases` of each.
fn for_all(cases: u32, check: impl Fn(Formulation, Material, Vec<Waypoint>) -> Result<(), TestCaseError>) {
    for formulation in [Formulation::PlaneStrain, Formulation::Axisymmetric] {
        for_all_of(cases, |material, path| check(formulation, material, path));
    }
}

fn for_all_of(cases: u32, check: impl Fn(Material, Vec<Waypoint>) -> Result<(), TestCaseError>) {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let mut runner = TestRunner::new_with_rng(config, rng);
    runner.run(&(material(), waypoints()), |(material, path)| check(material, path)).unwrap();
}

#[test]
fn histories_are_finite_and_dissipate() {
    for_all(2000, |formulation, material, path| drive(formulation, material, &path, 7).map(drop));
}

/// Whole histories in single steps: as far as any step can go without turning an element inside out.
#[test]
fn jumps_are_finite_and_dissipate() {
    for_all(2000, |formulation, material, path| drive(formulation, material, &path, 1).map(drop));
}

#[test]
fn energy_closes() {
    for_all(200, |formulation, material, path| {
        let (cell, work) = drive(formulation, material, &path, 1000)?;
        let booked = cell.elastic_energy + cell.viscous_work + cell.slider_stored + cell.slider_dissipation + cell.tear;
        let error = (booked - work.net).abs() / work.gross;
        prop_assert!(error < HISTORY_ENERGY, "{booked} J/m3 against {} J/m3: {error:e}", work.net);
        Ok(())
    });
}

/// Springs and dashpots beside the rest take work in every history; a quasi-linear branch need not (`viscoelastic`).
#[test]
fn additive_terms_give_back_no_more_than_they_took() {
    for_all(200, |formulation, material, path| {
        let additive = Material {
            prony_g: [0.0; 5],
            maxwell_g: [0.2e6, 0.05e6, 0.0, 0.0, 0.0],
            slider_stiffness: 0.0,
            tear_stretch: 0.0,
            ..material
        };
        let mut there_and_back = path.clone();
        there_and_back.push([0.0; 4]);
        let (cell, work) = drive(formulation, additive, &there_and_back, 1000)?;
        prop_assert!(cell.viscous_work > -HISTORY_ENERGY * work.gross, "{} J/m3", cell.viscous_work);
        Ok(())
    });
}
