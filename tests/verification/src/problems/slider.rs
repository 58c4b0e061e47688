//! The spring-slider: area of a closed loop, and the stress that ten turns leave.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

/// Shear modulus of the spring, Pa.
pub const STIFFNESS: f64 = 60e6;
const YIELD_STRESS: f64 = 0.12e6;
const AMPLITUDE: f64 = 0.01;

/// The slider, on as good as nothing.
pub fn material() -> Material {
    Material {
        slider_stiffness: STIFFNESS,
        slider_yield_stress: YIELD_STRESS,
        // As good as no elasticity, so that the loop is the slider's alone.
        ..elastic(1.0, 0.0, 100.0)
    }
}

/// Work per volume of the nodal forces and dissipation in the ledger over the second of two cycles.
pub fn cycle(steps: u32) -> (f64, f64) {
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

/// Area of the loop, J/m3: 4 tau_y (g - tau_y / G) with tau_y = SIGF / sqrt 3.
pub fn area() -> f64 {
    let yield_shear = YIELD_STRESS / 3.0_f64.sqrt();
    4.0 * yield_shear * (AMPLITUDE - yield_shear / STIFFNESS)
}

/// Largest change of a stress by ten turns of `steps_per_turn` steps at a shear, over the stiffness of the spring.
pub fn drift(steps_per_turn: u32, shear: f64) -> f64 {
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, 1e-6);
    let start = cell.deform([[1.0, shear], [0.0, 1.0]]);
    let mut end = start;
    for n in 1..=10 * steps_per_turn {
        let angle = 2.0 * std::f64::consts::PI * f64::from(n) / f64::from(steps_per_turn);
        let (s, c) = if n % steps_per_turn == 0 { (0.0, 1.0) } else { angle.sin_cos() };
        end = cell.deform([[c, c * shear - s], [s, s * shear + c]]);
    }
    start.iter().flatten().zip(end.iter().flatten()).fold(0.0, |a, (x, y)| a.max((x - y).abs() / STIFFNESS))
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let (work, dissipation) = cycle(40_000);
    let check =
        |quantity: &str, reference, error| Check { problem: "slider", quantity: quantity.into(), reference, error };
    vec![
        check("work of a closed loop", "area of the loop", (work / area() - 1.0).abs()),
        check("dissipation of a closed loop", "area of the loop", (dissipation / area() - 1.0).abs()),
        check("dissipation at ten times the rate", "that at the rate", (cycle(4_000).1 / dissipation - 1.0).abs()),
        check("stress left by ten turns, over the stiffness", "none", drift(100, 0.001)),
    ]
}
