//! Cook's membrane as a solid: two cells deep between held faces, in plane strain, nearly incompressible.

use crate::memo::Memo;
use crate::order::over_cells;
use crate::problems::cook::{FINITE_REFERENCE, LINEAR_REFERENCE};
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid_body::SolidBody;
use crate::solid_statics::{SolidSupports, linear, solve};

/// Cells per side in the linear limit.
pub const CELLS: [usize; 4] = [4, 8, 16, 32];

/// The same at finite strain.
pub const FINITE_CELLS: [usize; 3] = [4, 8, 16];

/// Cells through the depth: the nodes between the two faces are free.
const DEEP: usize = 2;

/// Parts in which the load at finite strain comes.
const INCREMENTS: u32 = 4;

/// The membrane of `n` by `n` cells, its lengths in mm, under a total load of `load` N per m of depth.
fn membrane(n: usize, shear: f64, bulk: f64, load: f64) -> (SolidBody, SolidSupports) {
    let cell = 48e-3 / n as f64;
    let position = |[u, v, w]: [usize; 3]| {
        let (xi, eta) = (u as f64 / n as f64, v as f64 / n as f64);
        [48e-3 * xi, 44e-3 * xi + eta * (44e-3 - 28e-3 * xi), cell * w as f64]
    };
    let body = SolidBody::new([n, n, DEEP], neo_hookean(shear, bulk), &position);
    let mut supports = SolidSupports::none(&body);
    for [u, v, w] in body.nodes() {
        let node = body.node([u, v, w]);
        if w == 0 || w == DEEP {
            supports.prescribed[node][2] = Some(0.0);
        }
        if u == 0 {
            supports.prescribed[node] = [Some(0.0); 3];
        }
        if u == n {
            let share = |place: usize, last: usize| if place == 0 || place == last { 0.5 } else { 1.0 };
            supports.load[node] = [0.0, share(v, n) * share(w, DEEP) * cell * load / n as f64, 0.0];
        }
    }
    (body, supports)
}

/// Linear displacement of (48, 52), m, with the moduli and the load of [`crate::problems::cook::linear_tip`].
pub fn linear_tip(n: usize) -> f64 {
    static KNOWN: Memo<usize, f64> = Memo::new();
    KNOWN.get(n, || {
        let (lambda, shear) = (7500.0, 0.375);
        let (mut body, supports) = membrane(n, shear, lambda + 2.0 / 3.0 * shear, 1.0);
        linear(&mut body, &supports).displacement[body.node([n, n / 2, DEEP / 2])][1]
    })
}

/// Displacement of the upper corner (48, 60) at finite strain, mm, with those of [`crate::problems::cook::finite_tip`].
pub fn finite_tip(n: usize) -> f64 {
    static KNOWN: Memo<usize, f64> = Memo::new();
    KNOWN.get(n, || {
        let (young, nu) = (240.565e3, 0.4999);
        let (shear, bulk) = (young / (2.0 * (1.0 + nu)), young / (3.0 * (1.0 - 2.0 * nu)));
        let (mut body, supports) = membrane(n, shear, bulk, 6.25e3 * 16e-3);
        1e3 * solve(&mut body, &supports, INCREMENTS).displacement[body.node([n, n, DEEP / 2])][1]
    })
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |quantity: &str, reference: f64, cells: &[usize], tip: &dyn Fn(usize) -> f64| {
        let errors: Vec<f64> = cells.iter().map(|n| tip(*n) / reference - 1.0).collect();
        Row {
            problem: "solid_cook",
            quantity: format!("{quantity}, faces held"),
            reference: format!("{reference}"),
            meshes: cells.iter().map(|n| format!("{n} x {n} x {DEEP}")).collect(),
            order: Some(over_cells(cells, &errors)),
            errors,
        }
    };
    vec![
        row("linear deflection", LINEAR_REFERENCE, &CELLS, &linear_tip),
        row("finite strain deflection", FINITE_REFERENCE, &FINITE_CELLS, &finite_tip),
    ]
}
