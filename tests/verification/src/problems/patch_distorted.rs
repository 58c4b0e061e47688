//! Patch test on a distorted mesh: the inner nodes are free and must find the homogeneous deformation of the boundary.

use softanvil_kernel::scenario::Formulation;

use crate::body::{Body, Field, Pressure};
use crate::row::{Row, name};
use crate::scenes::{elastic, grid};
use crate::statics::{Supports, solve};

/// Cells per side.
const CELLS: usize = 6;
/// Side of the body, m.
const SIDE: f64 = 30e-3;
/// Displacement of the inner nodes of the mesh over the cell size.
const DISTORTION: f64 = 0.25;

/// What is left of the homogeneous state, relative.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Largest error of an inner node's displacement over the largest displacement.
    pub displacement: f64,
    /// Largest difference of a stress between two cells over the largest stress.
    pub stress: f64,
}

/// Node (u, v): inner nodes are shifted by the sines of large arguments, a fixed pattern without a pattern.
fn position(u: usize, v: usize) -> [f64; 2] {
    let cell = SIDE / CELLS as f64;
    let inside = |i: usize| i > 0 && i < CELLS;
    let shift = |a: f64, b: f64| {
        if inside(u) && inside(v) { DISTORTION * cell * (a * u as f64 + b * v as f64).sin() } else { 0.0 }
    };
    [cell * u as f64 + shift(12.9898, 78.233), cell * v as f64 + shift(39.346, 11.135)]
}

/// Errors under the deformation gradient `gradient`.
pub fn errors(formulation: Formulation, gradient: [[f64; 2]; 2]) -> Errors {
    let mut scenario = grid(CELLS, CELLS, elastic(0.1e6, 0.05e6, 5e6));
    scenario.geometry.formulation = formulation;
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let homogeneous: Field =
        body.positions().iter().map(|x| [0, 1].map(|i| gradient[i][0] * x[0] + gradient[i][1] * x[1] - x[i])).collect();
    let mut supports = Supports::none(&body);
    for v in 0..=CELLS {
        for u in 0..=CELLS {
            if u == 0 || u == CELLS || v == 0 || v == CELLS {
                let node = body.node(u, v);
                supports.prescribed[node] = homogeneous[node].map(Some);
            }
        }
    }
    let found = solve(&mut body, &supports, 4).displacement;
    let largest = homogeneous.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    let differences = found.iter().flatten().zip(homogeneous.iter().flatten()).map(|(a, b)| (a - b).abs());
    Errors { displacement: differences.fold(0.0, f64::max) / largest, stress: stress_spread(&body, &found) }
}

fn stress_spread(body: &Body, displacement: &Field) -> f64 {
    let stresses: Vec<_> = body.cell_list().map(|(u, v)| body.cell_stress(displacement, u, v)).collect();
    let components = 0..if stresses[0][3].is_nan() { 3 } else { 4 };
    let (mut spread, mut largest) = (0.0_f64, 0.0_f64);
    for i in components {
        let (low, high) = stresses.iter().fold((f64::MAX, f64::MIN), |(low, high), s| (low.min(s[i]), high.max(s[i])));
        spread = spread.max(high - low);
        largest = largest.max(high.abs()).max(low.abs());
    }
    spread / largest
}

/// Deformation gradients of the test. A body of revolution has no other homogeneous states than the same stretch along
/// radius and hoop.
pub const CASES: [(Formulation, [[f64; 2]; 2]); 5] = [
    (Formulation::PlaneStrain, [[1.1, 0.0], [0.0, 0.95]]),
    (Formulation::PlaneStrain, [[1.0, 0.2], [0.0, 1.0]]),
    (Formulation::PlaneStrain, [[1.1, 0.3], [-0.2, 0.9]]),
    (Formulation::Axisymmetric, [[1.1, 0.0], [0.0, 0.9]]),
    (Formulation::Axisymmetric, [[0.8, 0.0], [0.0, 1.3]]),
];

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |formulation: Formulation| {
        let errors = CASES.iter().filter(|case| case.0 == formulation).map(|case| errors(case.0, case.1));
        Row {
            problem: "patch_distorted",
            quantity: format!("displacement and stress, {}", name(formulation)),
            reference: "homogeneous state".into(),
            meshes: vec![format!("{CELLS} x {CELLS}")],
            errors: vec![errors.fold(0.0, |largest, e| e.displacement.max(e.stress).max(largest))],
            order: None,
        }
    };
    vec![row(Formulation::PlaneStrain), row(Formulation::Axisymmetric)]
}
