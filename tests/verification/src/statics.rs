//! Equilibrium of a [`Body`] by Newton's method: the forces are the kernel's, only the way to their balance is not.
//!
//! Reaching a static solution by explicit steps costs many periods of the slowest mode and leaves its convergence in
//! doubt; this gives the same discrete solution to round-off, so that orders of convergence can be measured.

use crate::band::{Band, Factor};
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

/// Size of a correction by a new stiffness over the displacement: Newton's method nearly squares the error, so that this
/// leaves round-off.
const ACCURACY: f64 = 1e-7;

/// What a correction by an old stiffness may leave over the displacement, from how much it is smaller than the one before.
const REST: f64 = 1e-12;

/// Size of a correction over the displacement from which on a stiffness is kept: farther away it can mislead.
const NEAR: f64 = 0.02;

/// A correction that is not smaller than the one before by this calls for a new stiffness, which costs as much as some
/// forty corrections.
const SLOW: f64 = 0.3;

/// Iterations after which the balance counts as not found. It takes about ten; a moving contact adds some.
const ITERATIONS: usize = 100;

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
    let tangent = Tangent::new(body, &rest, supports);
    let displacement = tangent.correction(supports, &rest, &rest);
    let force = tangent.stiffness.forces(&displacement);
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

/// Newton's method under constraints that may depend on displacement and internal force. It keeps a stiffness while the
/// same nodes are held and the corrections shrink fast.
fn balance(
    body: &mut Body,
    mut displacement: Field,
    constraints: &mut dyn FnMut(&Field, &Field) -> Supports,
) -> Equilibrium {
    let mut force = body.internal_forces(&displacement);
    let mut known: Option<Tangent> = None;
    let mut before = f64::INFINITY;
    for _ in 0..ITERATIONS {
        let now = constraints(&displacement, &force);
        let old = known.take().filter(|tangent| tangent.holds(&now));
        let (tangent, new) = match old {
            Some(tangent) => (tangent, false),
            None => (Tangent::new(body, &displacement, &now), true),
        };
        let correction = tangent.correction(&now, &displacement, &force);
        for (u, d) in displacement.iter_mut().zip(&correction) {
            *u = [u[0] + d[0], u[1] + d[1]];
        }
        force = body.internal_forces(&displacement);
        let (size, whole) = (largest(&correction), largest(&displacement));
        let shrinks = size / before;
        if size <= ACCURACY * whole && (new || size * shrinks <= REST * whole) {
            return Equilibrium { displacement, force };
        }
        known = (size <= NEAR * whole && (new || shrinks < SLOW)).then_some(tangent);
        before = size;
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

    /// Which freedoms are held.
    fn held(&self, supports: &Supports) -> Vec<bool> {
        let mut held = vec![false; 2 * self.first.len()];
        for (first, prescribed) in self.first.iter().zip(&supports.prescribed) {
            for i in 0..2 {
                held[first + i] = prescribed[i].is_some();
            }
        }
        held
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

    /// The symmetric matrix, in which held freedoms stand alone: the mean of both halves, which differences do not make
    /// equal.
    fn matrix(&self, held: &[bool]) -> Band {
        let free = |row: usize, column: usize| !held[row] && !held[column];
        let width = self.entries.iter().map(|(row, column, _)| row.abs_diff(*column)).max().unwrap_or(0);
        let mut matrix = Band::new(held.len(), width);
        for (row, column, value) in self.entries.iter().filter(|(row, column, _)| free(*row, *column)) {
            let part = if row == column { *value } else { 0.5 * value };
            matrix.add(*row.max(column), *row.min(column), part);
        }
        for row in (0..held.len()).filter(|row| held[*row]) {
            matrix.add(row, row, 1.0);
        }
        matrix
    }
}

/// A stiffness with the factors for the freedoms that are held.
struct Tangent {
    stiffness: Stiffness,
    held: Vec<bool>,
    factor: Factor,
}

impl Tangent {
    fn new(body: &mut Body, displacement: &Field, supports: &Supports) -> Self {
        let stiffness = Stiffness::new(body, displacement);
        let held = stiffness.held(supports);
        let factor = stable_factor(&stiffness.matrix(&held));
        Self { stiffness, held, factor }
    }

    /// Whether the same freedoms are held.
    fn holds(&self, supports: &Supports) -> bool {
        self.held == self.stiffness.held(supports)
    }

    /// The change of displacement that meets the constraints and balances the linearised forces.
    fn correction(&self, supports: &Supports, displacement: &Field, force: &Field) -> Field {
        let Stiffness { entries, first } = &self.stiffness;
        let mut shift = vec![0.0; self.held.len()];
        let mut residual = shift.clone();
        for (node, first) in first.iter().enumerate() {
            for i in 0..2 {
                match supports.prescribed[node][i] {
                    Some(value) => shift[first + i] = value - displacement[node][i],
                    None => residual[first + i] = supports.load[node][i] - force[node][i],
                }
            }
        }
        for (row, column, value) in entries.iter().filter(|(_, column, _)| shift[*column] != 0.0) {
            residual[*row] -= value * shift[*column];
        }
        for (residual, shift) in
            residual.iter_mut().zip(&shift).zip(&self.held).filter_map(|(both, held)| held.then_some(both))
        {
            *residual = *shift;
        }
        self.factor.solve(&mut residual);
        first.iter().map(|first| [residual[*first], residual[first + 1]]).collect()
    }
}

/// The factors of `matrix`, stiffened in proportion to its diagonal if it is not positive definite.
///
/// Far from balance, spurious pressures can make a stable body look unstable. The stiffening shortens the way there; it
/// cannot move the balance, and where the body is truly unstable none is found.
pub(crate) fn stable_factor(matrix: &Band) -> Factor {
    let mut part = 0.0;
    loop {
        let mut stiffened = matrix.clone();
        stiffened.scale_diagonal(1.0 + part);
        match stiffened.factor() {
            Some(factor) => return factor,
            None if part < 1.0 => part = (10.0_f64 * part).max(1e-4),
            None => panic!("a body that is not held"),
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
