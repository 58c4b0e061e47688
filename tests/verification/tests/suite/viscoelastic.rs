//! Prony series: relaxation after a step and response to a ramp, against closed forms, through the element.
//!
//! Source: the relaxation function G(t)/G_inf = 1 + sum (g_k/g_inf) e^(-t/tau_k) and its convolution with a ramp,
//! sigma = 2 edot (G_inf t + sum G_k tau_k (1 - e^(-t/tau_k))), e.g. Simo and Hughes, Computational Inelasticity (1998).

use softanvil_kernel::scenario::Formulation;
use softanvil_verification::deformation::Gradient;
use softanvil_verification::element::Cell;
use softanvil_verification::problems::viscoelastic::{DT, material, ramp_error, step_error};
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{CLOSED_FORM, PRONY_RAMP};

#[test]
fn relaxation_after_a_finite_step() {
    let error = step_error();
    assert!(error < CLOSED_FORM, "{error:e}");
}

#[test]
fn ramp_in_simple_shear() {
    let error = ramp_error();
    assert!(error < PRONY_RAMP, "{error:e}");
}

/// A deformation held for long leaves the long-term stress, and all the viscous work is the sum of stress times strain.
#[test]
fn full_relaxation_leaves_the_long_term_law() {
    let gradient = [[1.0, 0.4], [0.0, 1.0]];
    let long_term = Cell::new(elastic(0.1e6, 0.05e6, 1e9), Formulation::PlaneStrain, DT).deform(gradient);
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-3);
    let mut stress = cell.deform(gradient);
    for _ in 0..2000 {
        stress = cell.deform(gradient);
    }
    let error = (stress[0][1] - long_term[0][1]).abs() / long_term[0][1];
    assert!(error < CLOSED_FORM, "{} Pa against {} Pa", stress[0][1], long_term[0][1]);
    assert!(cell.viscous_work > 0.0);
}

/// What leaves no room for a dissipated part of the viscous work: a relaxed branch, driven around a loop of stretches in
/// less time than it relaxes, gives back more than it ever took; the other way round it takes the same.
#[test]
fn a_loop_at_finite_strain_gives_work_back() {
    let (forth, back) = (after_loops(1.0), after_loops(-1.0));
    assert!(forth[0] > 0.0 && forth[0] == back[0], "held: {} J/m3, {} J/m3", forth[0], back[0]);
    assert!(forth[1] < 0.0, "{} J/m3 after {} J/m3", forth[1], forth[0]);
    assert!(back[1] > back[0], "{} J/m3 after {} J/m3", back[1], back[0]);
}

/// Viscous work of a branch that relaxes in 1 s, J/m3: held for 10 s, and after ten loops of 10 ms in the direction `turn`.
fn after_loops(turn: f64) -> [f64; 2] {
    let mut material = elastic(0.1e6, 0.0, 1e6);
    (material.prony_g[0], material.prony_tau[0]) = (0.5, 1.0);
    let mut cell = Cell::new(material, Formulation::PlaneStrain, 1e-4);
    for _ in 0..100_000 {
        cell.deform(on_loop(0.0));
    }
    let held = cell.viscous_work;
    for n in 1..=1000 {
        cell.deform(on_loop(turn * f64::from(n) / 100.0));
    }
    [held, cell.viscous_work]
}

/// A stretch without rotation whose logarithm, [[a, s], [s, -a]], runs once around a circle as `part` goes to 1.
fn on_loop(part: f64) -> Gradient {
    let (sine, cosine) = (2.0 * std::f64::consts::PI * part).sin_cos();
    let (a, s) = (0.4 - 0.3 * sine, 0.3 * cosine);
    let size = a.hypot(s);
    let (even, odd) = (size.cosh(), size.sinh() / size);
    [[even + odd * a, odd * s], [odd * s, even - odd * a]]
}
