//! A thin ring that grows: nothing stretches but its circumference, so all that it does is hoop.
//!
//! Source: neo-Hooke, W = C10 (I1 J^(-2/3) - 3) + K/2 (J - 1)^2, at the stretches (1, 1, h) with J = h: the Cauchy stress has
//! sigma_33 - sigma_11 = 2 C10 h^(-5/3) (h^2 - 1), a mean of K (h - 1), and P33 = h^(-1) J sigma_33, which pulls a ring of the
//! section A inwards with 2 pi A P33.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{Formulation, Interface, StepBy};
use softanvil_kernel::{Field, Simulation, StepInput, step};
use softanvil_verification::scenes::{elastic, grid};
use softanvil_verification::tolerance::{THIN_RING, relative_error};

const C10: f64 = 0.1e6;
const BULK: f64 = 0.2e6;
const RESIDUAL: f64 = 0.25;
/// Radius, and side of the square section, m; cells along a side.
const RADIUS: f64 = 1.0;
const SIDE: f64 = 1e-3;
const CELLS: usize = 3;
/// Step that needs no care, s.
const STEP: f64 = 1e-9;

/// What the fields show of a ring, and what its ledger holds.
struct Ring {
    /// sigma_33 - sigma_11, and the mean stress, Pa.
    difference: f64,
    mean: f64,
    /// Sum of the radial forces of the nodes, N.
    force: f64,
    /// Elastic energy, and what tearing has dissipated, J.
    elastic: f64,
    tear: f64,
}

/// A ring after its radius has grown by the factors `stretches`, one after the other.
fn ring(material: Material, stretches: &[f64]) -> Ring {
    let mut scenario = grid(CELLS, CELLS, material);
    scenario.geometry.formulation = Formulation::Axisymmetric;
    // Nothing holds the ring: it floats above the core.
    (scenario.core.interface, scenario.core.friction_coefficient) = (Interface::Frictional, 0.0);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, STEP);
    let cell = SIDE / CELLS as f64;
    let position = |u: usize, v: usize| [RADIUS - 0.5 * SIDE + cell * u as f64, cell * v as f64];
    let mut simulation = Simulation::with_positions(&scenario, &position).expect("a legal ring");
    let ring = simulation.with(|model, state| {
        let input = StepInput::default();
        let stride = model.constants.grid.stride();
        // Held for a step at the end: the ledger carries energies on by half of their last change.
        for stretch in stretches.iter().chain(stretches.last()) {
            let [x, y] = state.displacement_mut();
            for node in (0..=CELLS).flat_map(|v| (0..=CELLS).map(move |u| v * stride + u)) {
                (x[node], y[node]) = ((stretch - 1.0) * RADIUS, 0.5);
            }
            state.velocity_mut().into_iter().for_each(|row| row.fill(0.0));
            step(model, state, &input).expect("a stable step");
        }
        let view = state.as_view();
        let stress =
            |c| Field::find("element.cauchy_stress").and_then(|f| f.value(model, &view, 1, 2, c)).expect("a stress");
        let force = state.force()[0];
        let energy = state.scalars.energy;
        Ring {
            difference: stress(3) - stress(0),
            mean: (stress(0) + stress(1) + stress(3)) / 3.0,
            force: (0..=CELLS).flat_map(|v| (0..=CELLS).map(move |u| v * stride + u)).map(|node| force[node]).sum(),
            elastic: energy.elastic,
            tear: energy.tear,
        }
    });
    ring.expect("memory of the right size")
}

/// Compares a ring whose circumference is `stretch` times as long with the closed form, of which `part` of the deviator is left.
fn check(ring: &Ring, stretch: f64, part: f64) {
    let difference = part * 2.0 * C10 * stretch.powf(-5.0 / 3.0) * (stretch * stretch - 1.0);
    let mean = BULK * (stretch - 1.0);
    let force = -2.0 * std::f64::consts::PI * SIDE * SIDE * (mean + 2.0 / 3.0 * difference);
    let isochoric = C10 * (stretch.powf(-2.0 / 3.0) * (2.0 + stretch * stretch) - 3.0);
    let energy = part * isochoric + 0.5 * BULK * (stretch - 1.0) * (stretch - 1.0);
    let elastic = 2.0 * std::f64::consts::PI * RADIUS * SIDE * SIDE * energy;
    for (what, found, expected) in [
        ("force", ring.force, force),
        ("difference", ring.difference, difference),
        ("mean", ring.mean, mean),
        ("energy", ring.elastic, elastic),
    ] {
        assert!(relative_error(found, expected) < THIN_RING, "{what} at {stretch}: {found} against {expected}");
    }
}

#[test]
fn a_ring_resists_with_its_hoop_stress() {
    for stretch in [0.6, 0.9, 1.1, 1.5] {
        check(&ring(elastic(C10, 0.0, BULK), &[stretch]), stretch, 1.0);
    }
}

/// The circumference alone passes the limit: what is left is the residual, also after the way back.
#[test]
fn a_ring_tears_along_its_circumference() {
    let material = Material { tear_stretch: 1.2, tear_width: 0.2, tear_residual: RESIDUAL, ..elastic(C10, 0.0, BULK) };
    for (path, stretch, part) in [(&[1.15] as &[f64], 1.15, 1.0), (&[1.5], 1.5, RESIDUAL), (&[1.5, 1.1], 1.1, RESIDUAL)]
    {
        let ring = ring(material, path);
        check(&ring, stretch, part);
        assert!((ring.tear > 0.0) == (part < 1.0), "{} J", ring.tear);
    }
}
