//! Equilibrium of a [`Body`] by Newton's method: the forces are the kernel's, only the way to their balance is not.
//!
//! Reaching a static solution by explicit steps costs many periods of the slowest mode and leaves its convergence in
//! doubt; this gives the same discrete solution to round-off, so that orders of convergence can be measured.

use nalgebra::DVector;
use nalgebra_sparse::factorization::CscCholesky;
use nalgebra_sparse::{CooMatrix, CscMatrix};

use crate::body::{Body, Field};

/// What holds and loads the nodes.
pub struct Supports {
    /// Prescribed displacement of each node and direction, m; none where free.
    pub prescribed: Vec<[Option<f64>; 2]>,
    /// Forces from outside, N; ignored where prescribed.
    pub load: Field,
}

impl Supports {
    /// Nothing held, nothing loaded.
    pub fn none(body: &Body) -> Self {
        Self { prescribed: vec![[None; 2]; body.n_node()], load: vec![[0.0; 2]; body.n_node()] }
    }
}

/// A frictionless flat face that presses on the surface row of a body.
pub struct Face {
    /// Height of the face, m, in the coordinates of the nodes.
    pub height: f64,
}

/// An equilibrium.
pub struct Equilibrium {
    /// Displacements, m.
    pub displacement: Field,
    /// Internal forces, N: the reactions where nodes are held.
    pub force: Field,
}

/// Step of the difference quotient over the smallest edge: the two errors, round-off of a force and curvature of the
/// law, are both below one part in 10^9 of the stiffness.
const PERTURBATION: f64 = 1e-6;

/// Size of the last correction over the displacement: Newton's method nearly squares the error, so that this leaves
/// round-off.
const ACCURACY: f64 = 1e-7;

/// Iterations after which the balance counts as not found. Newton's method takes under ten; a moving contact adds some.
const ITERATIONS: usize = 60;

/// The equilibrium under `supports`, from rest, in `increments` equal parts.
///
/// # Panics
/// If there is none: an unstable body, or increments that are too large.
pub fn solve(body: &mut Body, supports: &Supports, increments: u32) -> Equilibrium {
    let rest = vec![[0.0; 2]; body.n_node()];
    let mut found = Equilibrium { displacement: rest.clone(), force: rest };
    for n in 1..=increments {
        let part = f64::from(n) / f64::from(increments);
        found = balance(body, found.displacement, &mut |_, _| scaled(supports, part));
    }
    found
}

/// The equilibrium of the linearised body under `supports`: no load is small enough to be exactly linear.
pub fn linear(body: &mut Body, supports: &Supports) -> Equilibrium {
    let rest = vec![[0.0; 2]; body.n_node()];
    let stiffness = Stiffness::new(body, &rest);
    let displacement = stiffness.correction(supports, &rest, &rest);
    let force = stiffness.forces(&displacement);
    Equilibrium { displacement, force }
}

/// The equilibria under `supports` and a face that comes down to `face` in equal increments, one for each.
///
/// A node is in contact while the face pushes it, or when it would pass the face.
///
/// # Panics
/// As [`solve`].
pub fn press(body: &mut Body, supports: &Supports, face: &Face, increments: u32) -> Vec<Equilibrium> {
    let position = body.positions();
    let [n_u, n_v] = body.cells();
    let surface: Vec<usize> = (0..=n_u).map(|u| body.node(u, n_v)).collect();
    let top = surface.iter().map(|node| position[*node][1]).fold(f64::MIN, f64::max);
    let mut displacement = vec![[0.0; 2]; body.n_node()];
    let mut equilibria = Vec::new();
    let mut touching = vec![false; body.n_node()];
    for n in 1..=increments {
        let part = f64::from(n) / f64::from(increments);
        let height = top + part * (face.height - top);
        let found = balance(body, displacement, &mut |displacement, force| {
            let mut constraints = scaled(supports, part);
            for node in &surface {
                let passes = position[*node][1] + displacement[*node][1] > height;
                touching[*node] = if touching[*node] { force[*node][1] <= 0.0 } else { passes };
                if touching[*node] {
                    constraints.prescribed[*node][1] = Some(height - position[*node][1]);
                }
            }
            constraints
        });
        displacement = found.displacement.clone();
        equilibria.push(found);
    }
    equilibria
}

fn scaled(supports: &Supports, part: f64) -> Supports {
    Supports {
        prescribed: supports.prescribed.iter().map(|p| p.map(|value| value.map(|v| part * v))).collect(),
        load: supports.load.iter().map(|f| f.map(|v| part * v)).collect(),
    }
}

/// Newton's method under constraints that may depend on displacement and internal force.
fn balance(
    body: &mut Body,
    mut displacement: Field,
    constraints: &mut dyn FnMut(&Field, &Field) -> Supports,
) -> Equilibrium {
    let mut force = body.internal_forces(&displacement);
    for _ in 0..ITERATIONS {
        let now = constraints(&displacement, &force);
        let correction = Stiffness::new(body, &displacement).correction(&now, &displacement, &force);
        for (u, d) in displacement.iter_mut().zip(&correction) {
            *u = [u[0] + d[0], u[1] + d[1]];
        }
        force = body.internal_forces(&displacement);
        if largest(&correction) <= ACCURACY * largest(&displacement) {
            return Equilibrium { displacement, force };
        }
    }
    panic!("no equilibrium after {ITERATIONS} iterations");
}

fn largest(field: &Field) -> f64 {
    field.iter().flatten().fold(0.0, |a, b| a.max(b.abs()))
}

/// The derivative of the internal forces, by central differences.
struct Stiffness {
    /// (row, column, value) with freedoms numbered along the shorter side of the mesh, which keeps the band narrow.
    entries: Vec<(usize, usize, f64)>,
    /// Freedom of each node along x; the one along y follows.
    first: Vec<usize>,
}

impl Stiffness {
    fn new(body: &mut Body, displacement: &Field) -> Self {
        let [n_u, n_v] = body.cells();
        let mut first = vec![0; body.n_node()];
        for v in 0..=n_v {
            for u in 0..=n_u {
                first[body.node(u, v)] = 2 * if n_v < n_u { u * (n_v + 1) + v } else { v * (n_u + 1) + u };
            }
        }
        let step = PERTURBATION * shortest_edge(body);
        let mut entries = Vec::new();
        // Nodes three apart share no cell, so one evaluation serves a ninth of them.
        for colour in 0..18 {
            let (cu, cv, direction) = (colour % 3, colour / 3 % 3, colour / 9);
            let mut shifted = [displacement.clone(), displacement.clone()];
            for v in (cv..=n_v).step_by(3) {
                for u in (cu..=n_u).step_by(3) {
                    shifted[0][body.node(u, v)][direction] -= step;
                    shifted[1][body.node(u, v)][direction] += step;
                }
            }
            let force = shifted.map(|field| body.internal_forces(&field));
            for v in (cv..=n_v).step_by(3) {
                for u in (cu..=n_u).step_by(3) {
                    let column = first[body.node(u, v)] + direction;
                    for (nu, nv) in neighbours(u, v, n_u, n_v) {
                        let node = body.node(nu, nv);
                        let ([x0, y0], [x1, y1]) = (force[0][node], force[1][node]);
                        for (i, difference) in [x1 - x0, y1 - y0].into_iter().enumerate() {
                            entries.push((first[node] + i, column, difference / (2.0 * step)));
                        }
                    }
                }
            }
        }
        Self { entries, first }
    }

    /// Linearised internal forces at `displacement`.
    fn forces(&self, displacement: &Field) -> Field {
        let mut force = vec![0.0; 2 * self.first.len()];
        let mut moved = force.clone();
        for (first, value) in self.first.iter().zip(displacement) {
            moved[*first..first + 2].copy_from_slice(value);
        }
        for (row, column, value) in &self.entries {
            force[*row] += value * moved[*column];
        }
        self.first.iter().map(|first| [force[*first], force[first + 1]]).collect()
    }

    /// The change of displacement that meets the constraints and balances the linearised forces.
    fn correction(&self, supports: &Supports, displacement: &Field, force: &Field) -> Field {
        let n = 2 * self.first.len();
        let mut held = vec![None; n];
        let mut residual = DVector::zeros(n);
        for (node, first) in self.first.iter().enumerate() {
            for i in 0..2 {
                held[first + i] = supports.prescribed[node][i].map(|value| value - displacement[node][i]);
                residual[first + i] = supports.load[node][i] - force[node][i];
            }
        }
        let mut matrix = CooMatrix::new(n, n);
        for (row, column, value) in &self.entries {
            match (held[*row], held[*column]) {
                // Both halves of the mean make the matrix symmetric, which differences do not.
                (None, None) => {
                    matrix.push(*row, *column, 0.5 * value);
                    matrix.push(*column, *row, 0.5 * value);
                }
                (None, Some(shift)) => residual[*row] -= value * shift,
                _ => {}
            }
        }
        for (freedom, shift) in held.iter().enumerate() {
            if let Some(shift) = shift {
                matrix.push(freedom, freedom, 1.0);
                residual[freedom] = *shift;
            }
        }
        let solution = stable_factor(matrix).solve(&residual);
        self.first.iter().map(|first| [solution[(*first, 0)], solution[(first + 1, 0)]]).collect()
    }
}

/// The factors of `matrix`, stiffened in proportion to its diagonal if it is not positive definite.
///
/// Far from balance, spurious pressures can make a stable body look unstable. The stiffening shortens the way there; it
/// cannot move the balance, and where the body is truly unstable none is found.
fn stable_factor(matrix: CooMatrix<f64>) -> CscCholesky<f64> {
    let matrix = CscMatrix::from(&matrix);
    let mut part = 0.0;
    loop {
        let mut stiffened = matrix.clone();
        for (row, column, value) in stiffened.triplet_iter_mut() {
            if row == column {
                *value *= 1.0 + part;
            }
        }
        match CscCholesky::factor(&stiffened) {
            Ok(factor) => return factor,
            Err(_) if part < 1.0 => part = (10.0 * part).max(1e-4),
            Err(error) => panic!("a body that is not held: {error}"),
        }
    }
}

fn neighbours(u: usize, v: usize, n_u: usize, n_v: usize) -> impl Iterator<Item = (usize, usize)> {
    let rows = v.saturating_sub(1)..=(v + 1).min(n_v);
    rows.flat_map(move |nv| (u.saturating_sub(1)..=(u + 1).min(n_u)).map(move |nu| (nu, nv)))
}

fn shortest_edge(body: &Body) -> f64 {
    let position = body.positions();
    let mut shortest = f64::MAX;
    for (u, v) in body.cell_list() {
        let a = position[body.corner(u, v, 0)];
        for corner in [1, 3] {
            let b = position[body.corner(u, v, corner)];
            shortest = shortest.min((a[0] - b[0]).hypot(a[1] - b[1]));
        }
    }
    shortest
}

/// The stiffness of a body at rest as a dense symmetric matrix, for its eigenvalues.
pub fn dense_stiffness(body: &mut Body) -> nalgebra::DMatrix<f64> {
    let rest = vec![[0.0; 2]; body.n_node()];
    let stiffness = Stiffness::new(body, &rest);
    let n = 2 * body.n_node();
    let mut matrix = nalgebra::DMatrix::zeros(n, n);
    for (row, column, value) in &stiffness.entries {
        matrix[(*row, *column)] += 0.5 * value;
        matrix[(*column, *row)] += 0.5 * value;
    }
    matrix
}
