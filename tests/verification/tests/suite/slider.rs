//! The spring-slider: area of a closed loop, independence of rate, and no stress from rotation.
//!
//! Source: elastic-perfectly plastic cycle of amplitude g in simple shear, area 4 tau_y (g - tau_y / G) with
//! tau_y = SIGF / sqrt 3 (von Mises), e.g. Simo and Hughes, Computational Inelasticity (1998).

use softanvil_kernel::scenario::{Formulation, Material};
use softanvil_verification::element::Cell;
use softanvil_verification::scenes::elastic;
use softanvil_verification::tolerance::{ROTATION_DRIFT, SLIDER_LOOP, relative_error};

const STIFFNESS: f64 = 60e6;
const YIELD_STRESS: f64 = 0.12e6;
const AMPLITUDE: f64 = 0.01;

fn material() -> Material {
    Material {
        slider_stiffness: STIFFNESS,
        slider_yield_stress: YIELD_STRESS,
        // As good as no elasticity, so that the loop is the slider's alone.
        ..elastic(1.0, 0.0, 100.0)
    }
}

/// Work per volume of the nodal forces and dissipation in the ledger over the second of two cycles.
fn cycle(steps: u32) -> (f64, f64) {
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-6);
    let (mut work, mut before) = (0.0, (0.0, 0.0));
    let mut dissipated = 0.0;
    for n in 0..=2 * steps {
        if n == steps {
            (work, dissipated) = (0.0, cell.slider_dissipation);
        }
        // A triangle wave from 0 over +g and -g back to 0.
        let phase = f64::from(n % steps) / f64::from(steps);
        let wave = if phase < 0.25 {
            4.0 * phase
        } else if phase < 0.75 {
            2.0 - 4.0 * phase
        } else {
            4.0 * phase - 4.0
        };
        let shear = AMPLITUDE * wave;
        let stress = cell.deform([[1.0, shear], [0.0, 1.0]])[0][1];
        work += 0.5 * (stress + before.1) * (shear - before.0);
        before = (shear, stress);
    }
    (work, cell.slider_dissipation - dissipated)
}

#[test]
fn a_cycle_dissipates_the_area_of_its_loop() {
    let yield_shear = YIELD_STRESS / 3.0_f64.sqrt();
    let area = 4.0 * yield_shear * (AMPLITUDE - yield_shear / STIFFNESS);
    let (work, dissipation) = cycle(40_000);
    assert!(relative_error(work, area) < SLIDER_LOOP, "work {work} J/m3 against {area} J/m3");
    assert!(relative_error(dissipation, area) < SLIDER_LOOP, "dissipation {dissipation} J/m3 against {area} J/m3");
}

#[test]
fn the_loop_does_not_depend_on_the_rate() {
    let (slow, fast) = (cycle(40_000).1, cycle(4_000).1);
    assert!(relative_error(fast, slow) < SLIDER_LOOP, "{fast} J/m3 against {slow} J/m3");
}

/// Ten turns at several speeds, unstressed and with a stress that must turn with the material.
#[test]
fn rotation_leaves_the_stress_alone() {
    for steps_per_turn in [7, 100, 10_000] {
        for shear in [0.0, 0.001] {
            let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-6);
            let start = cell.deform([[1.0, shear], [0.0, 1.0]]);
            let mut end = start;
            for n in 1..=10 * steps_per_turn {
                let angle = 2.0 * std::f64::consts::PI * f64::from(n) / f64::from(steps_per_turn);
                let (s, c) = if n % steps_per_turn == 0 { (0.0, 1.0) } else { angle.sin_cos() };
                end = cell.deform([[c, c * shear - s], [s, s * shear + c]]);
            }
            for (a, b) in start.iter().flatten().zip(end.iter().flatten()) {
                let drift = (a - b).abs() / STIFFNESS;
                assert!(drift < ROTATION_DRIFT, "{steps_per_turn} steps a turn, shear {shear}: drift {drift:e}");
            }
        }
    }
}
