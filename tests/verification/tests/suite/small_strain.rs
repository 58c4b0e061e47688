//! Work on a Prony series at small strain, through the kernel's own steps, against closed forms.
//!
//! Source: a branch at small strain is a spring G_k and a dashpot G_k tau_k in series (Maxwell). Under a strain that rises at a
//! constant rate its shear stress is G_k tau_k r (1 - e^(-t/tau_k)), whose work until T is G_k tau_k r^2 (T - tau_k (1 -
//! e^(-T/tau_k))) per volume; a strain that is held takes no more. For an isochoric stretch along the axis, e, the stress is
//! three times the shear modulus times e. The volumes are those of a box and of a cylinder.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{Formulation, Interface, StepBy};
use softanvil_kernel::{Simulation, StepInput, step};
use softanvil_verification::scenes::{elastic, grid};
use softanvil_verification::tolerance::{PRONY_WORK, relative_error};

/// Long-term shear modulus, Pa, and the terms: g_k and tau_k, s.
const SHEAR_MODULUS: f64 = 0.2e6;
const TERMS: [(f64, f64); 2] = [(0.5, 20e-6), (0.2, 500e-6)];
/// Step, s, steps of the ramp and of the hold.
const STEP: f64 = 0.1e-6;
const RAMP: u32 = 1000;
const HOLD: u32 = 500;
/// Strain at the end of the ramp.
const STRAIN: f64 = 1e-4;
/// Cells of 1 mm along and across.
const CELLS: [usize; 2] = [11, 3];

fn material() -> Material {
    let mut material = elastic(0.5 * SHEAR_MODULUS, 0.0, 1e6);
    for (k, (g, tau)) in TERMS.into_iter().enumerate() {
        (material.prony_g[k], material.prony_tau[k]) = (g, tau);
    }
    material
}

/// Work per volume on branches that resist with `times` their shear modulus, J/m3.
fn closed_form(times: f64) -> f64 {
    let end = f64::from(RAMP) * STEP;
    let g_inf = 1.0 - TERMS.iter().map(|(g, _)| g).sum::<f64>();
    let rate = STRAIN / end;
    let term = |(g, tau): (f64, f64)| g / g_inf * tau * rate * rate * (end - tau * (1.0 - (-end / tau).exp()));
    times * SHEAR_MODULUS * TERMS.into_iter().map(term).sum::<f64>()
}

/// The viscous work in the ledger after the ramp, and after the hold, J; the nodes go where `displacement` of their place and
/// of the strain says.
fn booked(formulation: Formulation, displacement: fn([f64; 2], f64) -> [f64; 2]) -> [f64; 2] {
    let mut scenario = grid(CELLS[0], CELLS[1], material());
    scenario.geometry.formulation = formulation;
    (scenario.core.interface, scenario.core.friction_coefficient) = (Interface::Frictional, 0.0);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, STEP);
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let work = simulation.with(|model, state| {
        let input = StepInput::default();
        let stride = model.constants.grid.stride();
        let mut after = [0.0; 2];
        for n in 1..=RAMP + HOLD {
            let strain = STRAIN * f64::from(n.min(RAMP)) / f64::from(RAMP);
            for (u, v) in (0..=CELLS[1]).flat_map(|v| (0..=CELLS[0]).map(move |u| (u, v))) {
                let node = v * stride + u;
                let [x, y] = model.reference_position();
                let moved = displacement([x[node], y[node]], strain);
                let [x, y] = state.displacement_mut();
                (x[node], y[node]) = (moved[0], moved[1]);
            }
            state.velocity_mut().into_iter().for_each(|row| row.fill(0.0));
            step(model, state, &input).expect("a stable step");
            // Held for a step: the ledger carries energies on by half of their last change.
            after[usize::from(n > RAMP + 1)] = state.scalars.energy.viscous;
        }
        after
    });
    work.expect("memory of the right size")
}

/// The half section of [`grid`] is as wide as its cells; the ledger has both halves, a metre long.
#[test]
fn work_on_a_prony_series_in_simple_shear() {
    let volume = 2.0 * 1e-3 * CELLS[0] as f64 * 1e-3 * CELLS[1] as f64;
    let expected = volume * closed_form(1.0);
    let found = booked(Formulation::PlaneStrain, |[_, y], shear| [shear * y, 0.5]);
    for found in found {
        assert!(relative_error(found, expected) < PRONY_WORK, "{found} J against {expected} J");
    }
}

#[test]
fn work_on_a_prony_series_in_a_stretched_cylinder() {
    let radius = 1e-3 * CELLS[0] as f64;
    let expected = std::f64::consts::PI * radius * radius * 1e-3 * CELLS[1] as f64 * closed_form(3.0);
    let found =
        booked(Formulation::Axisymmetric, |[x, y], e| [((-0.5 * e).exp() - 1.0) * x, (e.exp() - 1.0) * y + 0.5]);
    for found in found {
        assert!(relative_error(found, expected) < PRONY_WORK, "{found} J against {expected} J");
    }
}
