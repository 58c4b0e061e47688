//! Cook's membrane: a tapered panel, clamped on one side, sheared on the other, nearly incompressible in plane strain.

use crate::body::{Body, Pressure};
use crate::memo::Memo;
use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::{grid, neo_hookean};
use crate::statics::{Supports, linear, solve};

/// Linear reference: vertical displacement of (48, 52) with lambda = 7500, G = 0.375 and total load 1.
pub const LINEAR_REFERENCE: f64 = 16.4326;

/// Finite strain reference: vertical displacement of (48, 60), mm, with E = 240.565, nu = 0.4999 and shear traction 6.25;
/// see the test.
pub const FINITE_REFERENCE: f64 = 6.932;

/// Cells per side of the regular study.
pub const CELLS: [usize; 4] = [4, 8, 16, 32];

/// The membrane of `n` by `n` cells, its lengths in mm, under a total load of `load` N per m of thickness.
fn membrane(n: usize, shear: f64, bulk: f64, load: f64, pressure: Pressure) -> (Body, Supports) {
    let position = |u: usize, v: usize| {
        let (xi, eta) = (u as f64 / n as f64, v as f64 / n as f64);
        [48e-3 * xi, 44e-3 * xi + eta * (44e-3 - 28e-3 * xi)]
    };
    let body = Body::new(&grid(n, n, neo_hookean(shear, bulk)), &position, pressure);
    let mut supports = Supports::none(&body);
    for v in 0..=n {
        supports.prescribed[body.node(0, v)] = [Some(0.0); 2];
        let share = if v == 0 || v == n { 0.5 } else { 1.0 };
        supports.load[body.node(n, v)] = [0.0, share * load / n as f64];
    }
    (body, supports)
}

/// Linear displacement of (48, 52), m.
pub fn linear_tip(n: usize, pressure: Pressure) -> f64 {
    let (lambda, shear) = (7500.0, 0.375);
    let (mut body, supports) = membrane(n, shear, lambda + 2.0 / 3.0 * shear, 1.0, pressure);
    linear(&mut body, &supports).displacement[body.node(n, n / 2)][1]
}

/// Displacement of the upper corner (48, 60) and of (48, 52) at finite strain, mm: E = 240.565, nu = 0.4999, shear
/// traction 6.25 (here in kPa).
pub fn finite_tip(n: usize, pressure: Pressure) -> [f64; 2] {
    static KNOWN: Memo<(usize, Pressure), [f64; 2]> = Memo::new();
    KNOWN.get((n, pressure), || computed_tip(n, pressure))
}

fn computed_tip(n: usize, pressure: Pressure) -> [f64; 2] {
    let (young, nu) = (240.565e3, 0.4999);
    let (shear, bulk) = (young / (2.0 * (1.0 + nu)), young / (3.0 * (1.0 - 2.0 * nu)));
    let (mut body, supports) = membrane(n, shear, bulk, 6.25e3 * 16e-3, pressure);
    let solution = solve(&mut body, &supports, 30);
    [n, n / 2].map(|v| 1e3 * solution.displacement[body.node(n, v)][1])
}

/// Rows of the table over `cells` per side.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let row = |pressure: Pressure, element: &str| {
        let errors: Vec<f64> = cells.iter().map(|n| linear_tip(*n, pressure) / LINEAR_REFERENCE - 1.0).collect();
        Row {
            problem: "cook",
            quantity: format!("linear deflection, {element}"),
            reference: format!("{LINEAR_REFERENCE}"),
            meshes: cells.iter().map(|n| format!("{n} x {n}")).collect(),
            order: Some(over_cells(cells, &errors)),
            errors,
        }
    };
    let finite = |pressure: Pressure, element: &str| {
        let errors: Vec<f64> = cells.iter().map(|n| finite_tip(*n, pressure)[0] / FINITE_REFERENCE - 1.0).collect();
        Row {
            problem: "cook",
            quantity: format!("finite strain deflection, {element}"),
            reference: format!("{FINITE_REFERENCE}"),
            meshes: cells.iter().map(|n| format!("{n} x {n}")).collect(),
            errors,
            order: None,
        }
    };
    vec![
        row(Pressure::Patch, "mean dilatation"),
        row(Pressure::Triangle, "plain triangle"),
        finite(Pressure::Patch, "mean dilatation"),
        finite(Pressure::Triangle, "plain triangle"),
    ]
}
