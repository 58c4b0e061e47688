//! Lame's thick cylinder between held ends and thick sphere under internal pressure, as solids.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use nalgebra::Vector3;

use crate::memo::Memo;
use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::neo_hookean;
use crate::solid_body::{SolidBody, SolidField, difference};
use crate::solid_statics::{SolidSupports, linear};

const INNER: f64 = 10e-3;
const OUTER: f64 = 20e-3;
const SHEAR_MODULUS: f64 = 1e6;
const PRESSURE: f64 = 1e3;

/// Poisson's ratios of the study.
pub const POISSONS_RATIOS: [f64; 2] = [0.3, 0.4999];

/// A thick-walled body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wall {
    /// A quarter of a cylinder between held ends, two cells long, whose cells are as long as they are thick.
    Cylinder,
    /// Of a sphere what lies between the planes x = 0, z = 0, x = y and z = y; moved by the exact displacements on the last two.
    Sphere,
}

impl Wall {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Cylinder, Self::Sphere];

    /// Cells through the wall.
    pub fn cells(self) -> &'static [usize] {
        match self {
            Self::Cylinder => &[8, 16, 32],
            Self::Sphere => &[3, 6, 12],
        }
    }

    /// Cells with `n` through the wall.
    fn mesh(self, n: usize) -> [usize; 3] {
        match self {
            Self::Cylinder => [2 * n, n, 2],
            Self::Sphere => [n, n, n],
        }
    }

    fn position(self, n: usize, node: [usize; 3]) -> [f64; 3] {
        let mesh = self.mesh(n);
        let [u, v, w] = [0, 1, 2].map(|i| node[i] as f64 / mesh[i] as f64);
        let radius = INNER + (OUTER - INNER) * v;
        match self {
            Self::Cylinder => {
                let [x, y] = if u == 1.0 { [1.0, 0.0] } else { [(FRAC_PI_2 * u).sin(), (FRAC_PI_2 * u).cos()] };
                [radius * x, radius * y, (OUTER - INNER) / n as f64 * node[2] as f64]
            }
            Self::Sphere => {
                let direction = [(FRAC_PI_4 * u).tan(), 1.0, (FRAC_PI_4 * w).tan()];
                let part = radius / Vector3::from(direction).norm();
                direction.map(|component| part * component)
            }
        }
    }

    /// What points away from the axis or the centre.
    fn outwards(self, x: [f64; 3]) -> [f64; 3] {
        if self == Self::Cylinder { [x[0], x[1], 0.0] } else { x }
    }

    /// Radial displacement, m, at radius `r`, and the pressure of the wall, Pa, the same everywhere.
    ///
    /// Source: Timoshenko and Goodier, Theory of Elasticity (1970).
    fn exact(self, nu: f64, r: f64) -> [f64; 2] {
        let young = 2.0 * SHEAR_MODULUS * (1.0 + nu);
        match self {
            Self::Cylinder => {
                let scale = PRESSURE * INNER.powi(2) / (OUTER.powi(2) - INNER.powi(2));
                let displacement = scale * (1.0 + nu) / young * r * (1.0 - 2.0 * nu + (OUTER / r).powi(2));
                [displacement, -scale * 2.0 * (1.0 + nu) / 3.0]
            }
            Self::Sphere => {
                let scale = PRESSURE * INNER.powi(3) / (OUTER.powi(3) - INNER.powi(3));
                let displacement = scale / young * r * (1.0 - 2.0 * nu + 0.5 * (1.0 + nu) * (OUTER / r).powi(3));
                [displacement, -scale]
            }
        }
    }

    /// The exact displacement at `x`, m.
    fn displacement(self, nu: f64, x: [f64; 3]) -> [f64; 3] {
        let outwards = self.outwards(x);
        let radius = Vector3::from(outwards).norm();
        outwards.map(|component| self.exact(nu, radius)[0] * component / radius)
    }

    /// What is known of the displacement of a node.
    fn held(self, n: usize, node: [usize; 3], exact: [f64; 3]) -> [Option<f64>; 3] {
        let [last_u, _, last_w] = self.mesh(n);
        let [u, _, w] = node;
        match self {
            Self::Cylinder => {
                [(u == 0).then_some(0.0), (u == last_u).then_some(0.0), (w == 0 || w == last_w).then_some(0.0)]
            }
            Self::Sphere if u == last_u || w == last_w => exact.map(Some),
            Self::Sphere => [(u == 0).then_some(0.0), None, (w == 0).then_some(0.0)],
        }
    }
}

/// Relative errors on one mesh.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// Root mean square error of the displacement of the nodes over the largest displacement.
    pub displacement: f64,
    /// Largest error of a displacement over the largest displacement.
    pub largest: f64,
    /// Root mean square error of the pressure of the cells over the internal pressure.
    pub pressure: f64,
}

/// Errors with Poisson's ratio `nu` and `n` cells through the wall.
pub fn errors(wall: Wall, nu: f64, n: usize) -> Errors {
    static KNOWN: Memo<(Wall, u64, usize), Errors> = Memo::new();
    KNOWN.get((wall, nu.to_bits(), n), || computed_errors(wall, nu, n))
}

fn computed_errors(wall: Wall, nu: f64, n: usize) -> Errors {
    let bulk = 2.0 * SHEAR_MODULUS * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu));
    let position = |node| wall.position(n, node);
    let mut body = SolidBody::new(wall.mesh(n), neo_hookean(SHEAR_MODULUS, bulk), &position);
    let exact: SolidField = body.positions().iter().map(|x| wall.displacement(nu, *x)).collect();
    let mut supports = SolidSupports::none(&body);
    for node in body.nodes() {
        let index = body.node(node);
        supports.prescribed[index] = wall.held(n, node, exact[index]);
    }
    load_inner_surface(&body, wall, &mut supports.load);
    let found = linear(&mut body, &supports).displacement;
    let [at_most, pressure] = wall.exact(nu, INNER);
    let distances: Vec<f64> =
        found.iter().zip(&exact).map(|(a, b)| difference(*a, *b)).map(|d| Vector3::from(d).norm()).collect();
    let misses: Vec<f64> = body.cell_pressures(&found).iter().map(|p| p - pressure).collect();
    Errors {
        displacement: root_mean_square(&distances) / at_most,
        largest: distances.iter().fold(0.0, |a: f64, b| a.max(*b)) / at_most,
        pressure: root_mean_square(&misses) / PRESSURE,
    }
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

/// The pressure on the faces of the tetrahedra in the inner surface, a third for each corner.
fn load_inner_surface(body: &SolidBody, wall: Wall, load: &mut SolidField) {
    let x = body.positions();
    let mut inner = vec![false; body.n_node()];
    body.nodes().filter(|[_, v, _]| *v == 0).for_each(|node| inner[body.node(node)] = true);
    for corners in body.cell_list().filter(|[_, v, _]| *v == 0).flat_map(|cell| body.tetrahedra(cell)) {
        let face: Vec<usize> = corners.into_iter().filter(|node| inner[*node]).collect();
        let [a, b, c] = face[..] else { continue };
        let [along, across] = [b, c].map(|corner| Vector3::from(difference(x[corner], x[a])));
        let twice_area = along.cross(&across);
        let sign = twice_area.dot(&Vector3::from(wall.outwards(x[a]))).signum();
        for node in face {
            load[node] = core::array::from_fn(|i| load[node][i] + sign * PRESSURE * twice_area[i] / 6.0);
        }
    }
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let of = |wall: Wall, nu: f64| {
        let all: Vec<Errors> = wall.cells().iter().map(|n| errors(wall, nu, *n)).collect();
        let row = |what: &str, errors: Vec<f64>| Row {
            problem: "solid_lame",
            quantity: format!("{what}, {wall:?}, nu = {nu}").to_lowercase(),
            reference: "closed form".into(),
            meshes: wall.cells().iter().map(|n| format!("{n} cells")).collect(),
            order: Some(over_cells(wall.cells(), &errors)),
            errors,
        };
        [
            row("displacement", all.iter().map(|e| e.displacement).collect()),
            row("largest error of a displacement", all.iter().map(|e| e.largest).collect()),
            row("pressure", all.iter().map(|e| e.pressure).collect()),
        ]
    };
    Wall::ALL.into_iter().flat_map(|wall| POISSONS_RATIOS.into_iter().flat_map(move |nu| of(wall, nu))).collect()
}
