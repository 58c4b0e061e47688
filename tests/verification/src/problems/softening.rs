//! Softening in cycles of uniaxial and of confined loading: stress and what a cycle loses.
//!
//! Source: Ogden and Roxburgh, Proceedings of the Royal Society A 455 (1999): eta = 1 - erf((W_max - W) / (m + beta W_max)) / r
//! times the stress of the law, with W_max the largest energy before.

use softanvil_kernel::material::{Hyperfoam, Material};
use softanvil_kernel::scenario::Formulation;

use crate::deformation::Gradient;
use crate::element::Cell;
use crate::order;
use crate::row::{Check, Row};
use crate::scenes::elastic;

const R: f64 = 1.4;
const M: f64 = 8e3;
const BETA: f64 = 0.15;
const C10: f64 = 0.1e6;
/// Modulus, Pa, and exponent of a foam without a Poisson's ratio.
const MU: f64 = 0.2e6;
const ALPHA: f64 = 6.0;

/// What is loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// A neo-Hookean bar that keeps its volume.
    Solid,
    /// A confined foam.
    Foam,
}

/// Both cases, with their names for people.
pub const CASES: [(Case, &str); 2] = [(Case::Solid, "neo-Hooke, uniaxial"), (Case::Foam, "foam, confined")];

impl Case {
    fn material(self) -> Material {
        let blank = elastic(C10, 0.0, 1e6);
        match self {
            Self::Solid => blank,
            Self::Foam => blank.with(Hyperfoam::new([MU, 0.0, 0.0], [ALPHA, 1.0, 1.0], [0.0; 3])),
        }
    }

    /// A cell that softens.
    pub fn cell(self) -> Cell {
        let softening = Material { softening_r: R, softening_m: M, softening_beta: BETA, ..self.material() };
        Cell::new(softening, Formulation::Axisymmetric, 1e-5)
    }

    /// The deformation with the stretch `l` along the axis.
    pub fn gradient(self, l: f64) -> Gradient {
        match self {
            Self::Solid => [[l.powf(-0.5), 0.0], [0.0, l]],
            Self::Foam => [[1.0, 0.0], [0.0, l]],
        }
    }

    /// W of the law, J/m3, at the stretch `l`.
    pub fn energy(self, l: f64) -> f64 {
        match self {
            Self::Solid => C10 * (l * l + 2.0 / l - 3.0),
            Self::Foam => 2.0 * MU / (ALPHA * ALPHA) * (l.powf(ALPHA) - 1.0 - ALPHA * l.ln()),
        }
    }

    /// dW/dl, Pa: the work of a cell over the growth of l.
    fn slope(self, l: f64) -> f64 {
        match self {
            Self::Solid => 2.0 * C10 * (l - 1.0 / (l * l)),
            Self::Foam => 2.0 * MU / ALPHA * (l.powf(ALPHA - 1.0) - 1.0 / l),
        }
    }

    /// Largest stretch of a cycle.
    pub fn deepest(self) -> f64 {
        match self {
            Self::Solid => 2.0,
            Self::Foam => 0.3,
        }
    }

    /// The stress of `cell` at the stretch `l` as the work over the growth of l, Pa.
    fn stress(self, cell: &mut Cell, l: f64) -> f64 {
        let p = cell.deform(self.gradient(l));
        match self {
            Self::Solid => p[1][1] - 0.5 * p[0][0] * l.powf(-1.5),
            Self::Foam => p[1][1],
        }
    }
}

/// erf by Simpson's rule.
fn erf(x: f64) -> f64 {
    2.0 / std::f64::consts::PI.sqrt() * simpson(0.0, x, |t| (-t * t).exp())
}

/// eta by its definition.
fn factor(w: f64, largest: f64) -> f64 {
    1.0 - erf((largest - w) / (M + BETA * largest)) / R
}

fn simpson(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (n, mut sum) = (400, 0.0);
    let h = (to - from) / f64::from(n);
    for i in 0..n {
        let a = from + h * f64::from(i);
        sum += h / 6.0 * (f(a) + 4.0 * f(a + 0.5 * h) + f(a + h));
    }
    sum
}

/// Largest error of the stress in loading, unloading, reloading and going beyond, over the modulus.
pub fn stress_error(case: Case) -> f64 {
    let (mut cell, mut largest, mut error) = (case.cell(), 0.0_f64, 0.0_f64);
    let path: &[f64] = match case {
        Case::Solid => &[1.2, 1.7, 1.5, 1.1, 1.0, 1.3, 1.7, 2.0, 1.9, 0.8, 1.4, 2.3, 1.0, 2.2],
        Case::Foam => &[0.8, 0.4, 0.5, 0.9, 1.0, 0.6, 0.4, 0.3, 0.35, 1.1, 0.7, 0.15, 1.0, 0.2],
    };
    for l in path {
        let w = case.energy(*l);
        largest = largest.max(w);
        let expected = factor(w, largest) * case.slope(*l);
        error = error.max((case.stress(&mut cell, *l) - expected).abs() / (C10 + expected.abs()));
    }
    error
}

/// Errors of what a cycle in so many steps each way loses: of the ledger, and of the work of the forces by the trapezoidal
/// rule, against the integral of (1 - eta) dW to the largest energy.
pub fn cycle_errors(case: Case, steps: usize) -> [f64; 2] {
    let mut cell = case.cell();
    let (mut work, mut before) = (0.0, [1.0, case.stress(&mut cell, 1.0)]);
    for n in 1..=2 * steps {
        let part = 1.0 - (n as f64 / steps as f64 - 1.0).abs();
        let l = 1.0 + (case.deepest() - 1.0) * part;
        let stress = case.stress(&mut cell, l);
        work += 0.5 * (stress + before[1]) * (l - before[0]);
        before = [l, stress];
    }
    let largest = case.energy(case.deepest());
    let expected = simpson(0.0, largest, |w| 1.0 - factor(w, largest));
    [cell.softening, work].map(|found| (found / expected - 1.0).abs())
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |quantity: String, reference, error| Check { problem: "softening", quantity, reference, error };
    CASES
        .into_iter()
        .flat_map(|(case, name)| {
            [
                check(format!("{name}: stress of loading, unloading, reloading"), "closed form", stress_error(case)),
                check(format!("{name}: dissipation of a cycle"), "closed form", cycle_errors(case, 50)[0]),
            ]
        })
        .collect()
}

/// Steps each way of the cycles.
const STEPS: [usize; 4] = [50, 100, 200, 400];

/// Rows of the table: the work of a cycle over steps.
pub fn rows() -> Vec<Row> {
    let row = |(case, name): (Case, &str)| {
        let errors: Vec<f64> = STEPS.iter().map(|steps| cycle_errors(case, *steps)[1]).collect();
        Row {
            problem: "softening",
            quantity: format!("{name}: work of a cycle"),
            reference: "closed form".into(),
            meshes: STEPS.iter().map(|steps| format!("{steps} steps")).collect(),
            order: Some(order::over_cells(&STEPS, &errors)),
            errors,
        }
    };
    CASES.into_iter().map(row).collect()
}
