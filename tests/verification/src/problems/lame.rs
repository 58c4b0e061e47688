//! Lame's thick cylinder (plane strain) and thick sphere (axisymmetric) under internal pressure.

use std::f64::consts::{FRAC_PI_2, PI};

use softanvil_kernel::scenario::Formulation;

use crate::body::{Body, Field, Pressure};
use crate::memo::Memo;
use crate::order::over_cells;
use crate::row::{Row, name};
use crate::scenes::{grid, neo_hookean};
use crate::statics::{Supports, linear};

const INNER: f64 = 10e-3;
const OUTER: f64 = 20e-3;
const SHEAR_MODULUS: f64 = 1e6;
const PRESSURE: f64 = 1e3;

/// Cells through the wall of the regular study.
pub const CELLS: [usize; 4] = [4, 8, 16, 32];

/// Relative errors on one mesh.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Largest error of a displacement over the largest displacement.
    pub displacement: f64,
    /// Root mean square error of the radial and hoop stress at the cells' centres over the internal pressure.
    pub stress: f64,
}

/// Radial displacement, radial stress and hoop stress at radius `r`.
///
/// Source: Timoshenko and Goodier, Theory of Elasticity (1970).
fn exact(formulation: Formulation, nu: f64, r: f64) -> [f64; 3] {
    let young = 2.0 * SHEAR_MODULUS * (1.0 + nu);
    match formulation {
        Formulation::PlaneStrain | Formulation::Solid => {
            let scale = PRESSURE * INNER.powi(2) / (OUTER.powi(2) - INNER.powi(2));
            let ratio = (OUTER / r).powi(2);
            let displacement = scale * (1.0 + nu) / young * r * (1.0 - 2.0 * nu + ratio);
            [displacement, scale * (1.0 - ratio), scale * (1.0 + ratio)]
        }
        Formulation::Axisymmetric => {
            let scale = PRESSURE * INNER.powi(3) / (OUTER.powi(3) - INNER.powi(3));
            let ratio = (OUTER / r).powi(3);
            let displacement = scale / young * r * (1.0 - 2.0 * nu + 0.5 * (1.0 + nu) * ratio);
            [displacement, scale * (1.0 - ratio), scale * (1.0 + 0.5 * ratio)]
        }
    }
}

/// Errors with Poisson's ratio `nu` and `n` cells through the wall.
pub fn errors(formulation: Formulation, nu: f64, n: usize) -> Errors {
    static KNOWN: Memo<(Formulation, u64, usize), Errors> = Memo::new();
    KNOWN.get((formulation, nu.to_bits(), n), || computed_errors(formulation, nu, n))
}

fn computed_errors(formulation: Formulation, nu: f64, n: usize) -> Errors {
    let bulk = 2.0 * SHEAR_MODULUS * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
    let around = 2 * n;
    let mut scenario = grid(around, n, neo_hookean(SHEAR_MODULUS, bulk));
    scenario.geometry.formulation = formulation;
    let position = |u: usize, v: usize| {
        let radius = INNER + (OUTER - INNER) * v as f64 / n as f64;
        let angle = FRAC_PI_2 * u as f64 / around as f64;
        [if u == 0 { 0.0 } else { radius * angle.sin() }, if u == around { 0.0 } else { radius * angle.cos() }]
    };
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let mut supports = Supports::none(&body);
    for v in 0..=n {
        supports.prescribed[body.node(0, v)][0] = Some(0.0);
        supports.prescribed[body.node(around, v)][1] = Some(0.0);
    }
    for u in 0..around {
        load_edge(&mut supports.load, formulation, [(u, position(u, 0)), (u + 1, position(u + 1, 0))]);
    }
    let displacement = linear(&mut body, &supports).displacement;
    Errors {
        displacement: displacement_error(&body, formulation, nu, &displacement),
        stress: stress_error(&body, formulation, nu, &displacement),
    }
}

/// The pressure on the edge between two nodes of the inner surface, shared out by the linear shape functions.
fn load_edge(load: &mut Field, formulation: Formulation, edge: [(usize, [f64; 2]); 2]) {
    let [(_, a), (_, b)] = edge;
    let normal = [-(b[1] - a[1]), b[0] - a[0]];
    for (node, x, other) in [(edge[0].0, a[0], b[0]), (edge[1].0, b[0], a[0])] {
        let share = match formulation {
            Formulation::PlaneStrain | Formulation::Solid => 0.5,
            Formulation::Axisymmetric => 2.0 * PI * (2.0 * x + other) / 6.0,
        };
        for i in 0..2 {
            load[node][i] += PRESSURE * share * normal[i];
        }
    }
}

fn displacement_error(body: &Body, formulation: Formulation, nu: f64, displacement: &Field) -> f64 {
    let largest = exact(formulation, nu, INNER)[0];
    let errors = body.positions().into_iter().zip(displacement).map(|(x, u)| {
        let r = x[0].hypot(x[1]);
        let radial = exact(formulation, nu, r)[0];
        (u[0] - radial * x[0] / r).hypot(u[1] - radial * x[1] / r)
    });
    errors.fold(0.0, f64::max) / largest
}

/// Scale of the displacement at which the kernel is asked for stresses, small enough to be linear.
const SMALL: f64 = 1e-2;

fn stress_error(body: &Body, formulation: Formulation, nu: f64, displacement: &Field) -> f64 {
    let position = body.positions();
    // Half the difference of both signs: what is left of the nonlinearity is of third order.
    let small =
        [SMALL, -SMALL].map(|scale| displacement.iter().map(|u| u.map(|value| scale * value)).collect::<Field>());
    let (mut sum, mut count) = (0.0, 0.0);
    for (u, v) in body.cell_list() {
        let centre = [0, 1].map(|i| (0..4).map(|c| position[body.corner(u, v, c)][i]).sum::<f64>() / 4.0);
        let r = centre[0].hypot(centre[1]);
        let [c, s] = [centre[0] / r, centre[1] / r];
        let [pull, push] = [0, 1].map(|sign| body.cell_stress(&small[sign], u, v));
        let [xx, yy, xy, _] = [0, 1, 2, 3].map(|i| 0.5 * (pull[i] - push[i]) / SMALL);
        let radial = c * c * xx + s * s * yy + 2.0 * c * s * xy;
        let hoop = s * s * xx + c * c * yy - 2.0 * c * s * xy;
        let [_, exact_radial, exact_hoop] = exact(formulation, nu, r);
        sum += (radial - exact_radial).powi(2) + (hoop - exact_hoop).powi(2);
        count += 2.0;
    }
    (sum / count).sqrt() / PRESSURE
}

/// Formulations and Poisson's ratios of the study.
pub const CASES: [(Formulation, f64); 6] = [
    (Formulation::PlaneStrain, 0.3),
    (Formulation::PlaneStrain, 0.49),
    (Formulation::PlaneStrain, 0.4999),
    (Formulation::Axisymmetric, 0.3),
    (Formulation::Axisymmetric, 0.49),
    (Formulation::Axisymmetric, 0.4999),
];

/// Rows of the table over `cells` through the wall.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (formulation, nu) in CASES {
        let all: Vec<Errors> = cells.iter().map(|n| errors(formulation, nu, *n)).collect();
        for (what, errors) in [
            ("displacement", all.iter().map(|e| e.displacement).collect::<Vec<f64>>()),
            ("stress", all.iter().map(|e| e.stress).collect()),
        ] {
            rows.push(Row {
                problem: "lame",
                quantity: format!("{what}, {}, nu = {nu}", name(formulation)),
                reference: "closed form".into(),
                meshes: cells.iter().map(|n| format!("{n} cells")).collect(),
                order: Some(over_cells(cells, &errors)),
                errors,
            });
        }
    }
    rows
}
