//! Cook's membrane as a solid: two cells deep between held faces, in plane strain, nearly incompressible.

use crate::memo::Memo;
use crate::order::over_cells;
use crate::problems::cook::LINEAR_REFERENCE;
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid_body::SolidBody;
use crate::solid_statics::{SolidSupports, linear};

/// Cells per side.
pub const CELLS: [usize; 4] = [4, 8, 16, 32];

/// Cells through the depth: the nodes between the two faces are free.
const DEEP: usize = 2;

/// Displacement of (48, 52), m, under the loads of [`crate::problems::cook::linear_tip`].
pub fn linear_tip(n: usize) -> f64 {
    static KNOWN: Memo<usize, f64> = Memo::new();
    KNOWN.get(n, || computed_tip(n))
}

fn computed_tip(n: usize) -> f64 {
    let (lambda, shear, cell) = (7500.0, 0.375, 48e-3 / n as f64);
    let position = |[u, v, w]: [usize; 3]| {
        let (xi, eta) = (u as f64 / n as f64, v as f64 / n as f64);
        [48e-3 * xi, 44e-3 * xi + eta * (44e-3 - 28e-3 * xi), cell * w as f64]
    };
    let mut body = SolidBody::new([n, n, DEEP], neo_hookean(shear, lambda + 2.0 / 3.0 * shear), &position);
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
            supports.load[node] = [0.0, share(v, n) * share(w, DEEP) * cell / n as f64, 0.0];
        }
    }
    linear(&mut body, &supports).displacement[body.node([n, n / 2, DEEP / 2])][1]
}

/// Rows of the table over `cells` per side.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let errors: Vec<f64> = cells.iter().map(|n| linear_tip(*n) / LINEAR_REFERENCE - 1.0).collect();
    vec![Row {
        problem: "solid_cook",
        quantity: "linear deflection, faces held".into(),
        reference: format!("{LINEAR_REFERENCE}"),
        meshes: cells.iter().map(|n| format!("{n} x {n} x {DEEP}")).collect(),
        order: Some(over_cells(cells, &errors)),
        errors,
    }]
}
