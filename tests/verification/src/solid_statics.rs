//! Equilibrium of a [`SolidBody`] by Newton's method, as [`crate::statics`] finds that of a section: the forces are the kernel's.

use nalgebra::{DMatrix, Vector3};

use crate::band::Band;
use crate::solid_body::{SolidBody, SolidField, difference};
use crate::statics::stable_factor;

/// What holds and loads the nodes of a solid.
pub struct SolidSupports {
    /// Prescribed displacement of each node and direction, m; none where free.
    pub prescribed: Vec<[Option<f64>; 3]>,
    /// Forces from outside, N; ignored where prescribed.
    pub load: SolidField,
}

impl SolidSupports {
    /// Nothing held, nothing loaded.
    pub fn none(body: &SolidBody) -> Self {
        Self { prescribed: vec![[None; 3]; body.n_node()], load: vec![[0.0; 3]; body.n_node()] }
    }
}

/// An equilibrium.
pub struct SolidEquilibrium {
    /// Displacements, m.
    pub displacement: SolidField,
    /// Internal forces, N: the reactions where nodes are held.
    pub force: SolidField,
}

/// Step of the difference quotient over the smallest edge, as in [`crate::statics`].
const PERTURBATION: f64 = 1e-6;

/// Size of a correction over the displacement at which a balance is found: Newton's method nearly squares the error.
const ACCURACY: f64 = 1e-6;

/// Iterations after which it counts as not found.
const ITERATIONS: usize = 30;

/// The derivative of the internal forces, by central differences: (row, column, value), three freedoms a node.
struct Stiffness(Vec<(usize, usize, f64)>);

impl Stiffness {
    fn new(body: &mut SolidBody, displacement: &SolidField) -> Self {
        let step = PERTURBATION * shortest_edge(body);
        let mut entries = Vec::new();
        // Nodes three apart share no cell, so one evaluation serves a twenty-seventh of them.
        for number in 0..81 {
            let (colour, direction) = ([number % 3, number / 3 % 3, number / 9 % 3], number / 27);
            let ends = body.cells();
            let shifted: Vec<_> = body.nodes().filter(|node| (0..3).all(|i| node[i] % 3 == colour[i])).collect();
            let force = [-step, step].map(|step| {
                let mut displacement = displacement.clone();
                shifted.iter().for_each(|node| displacement[body.node(*node)][direction] += step);
                body.internal_forces(&displacement)
            });
            for node in shifted {
                let column = 3 * body.node(node) + direction;
                for neighbour in neighbours(node, ends).map(|neighbour| body.node(neighbour)) {
                    let change = difference(force[1][neighbour], force[0][neighbour]);
                    for (i, change) in change.into_iter().enumerate() {
                        entries.push((3 * neighbour + i, column, change / (2.0 * step)));
                    }
                }
            }
        }
        Self(entries)
    }

    /// Linearised internal forces.
    fn forces(&self, displacement: &[f64]) -> Vec<f64> {
        let mut force = vec![0.0; displacement.len()];
        for (row, column, value) in &self.0 {
            force[*row] += value * displacement[*column];
        }
        force
    }

    /// The change of displacement that meets `part` of the supports and balances the linearised forces.
    fn correction(
        &self,
        supports: &SolidSupports,
        part: f64,
        displacement: &SolidField,
        force: &SolidField,
    ) -> SolidField {
        let prescribed = supports.prescribed.as_flattened();
        let held: Vec<bool> = prescribed.iter().map(Option::is_some).collect();
        let moved = prescribed.iter().zip(displacement.as_flattened());
        let shift: Vec<f64> = moved.map(|(value, u)| value.map_or(0.0, |value| part * value - u)).collect();
        let reaction = self.forces(&shift);
        let residual = supports.load.as_flattened().iter().zip(force.as_flattened()).zip(&reaction);
        let mut x: Vec<f64> = residual.map(|((load, force), reaction)| part * load - force - reaction).collect();
        for (x, shift) in x.iter_mut().zip(&shift).zip(&held).filter_map(|(both, held)| held.then_some(both)) {
            *x = *shift;
        }
        stable_factor(&self.matrix(&held)).solve(&mut x);
        triples(&x)
    }

    /// The symmetric matrix, in which held freedoms stand alone.
    fn matrix(&self, held: &[bool]) -> Band {
        let width = self.0.iter().map(|(row, column, _)| row.abs_diff(*column)).max().unwrap_or(0);
        let mut matrix = Band::new(held.len(), width);
        for (row, column, value) in self.0.iter().filter(|(row, column, _)| !held[*row] && !held[*column]) {
            let part = if row == column { *value } else { 0.5 * value };
            matrix.add(*row.max(column), *row.min(column), part);
        }
        (0..held.len()).filter(|row| held[*row]).for_each(|row| matrix.add(row, row, 1.0));
        matrix
    }
}

/// The equilibrium of the linearised body under `supports`.
///
/// # Panics
/// If the body is not held.
pub fn linear(body: &mut SolidBody, supports: &SolidSupports) -> SolidEquilibrium {
    let rest = vec![[0.0; 3]; body.n_node()];
    let stiffness = Stiffness::new(body, &rest);
    let displacement = stiffness.correction(supports, 1.0, &rest, &rest);
    let force = triples(&stiffness.forces(displacement.as_flattened()));
    SolidEquilibrium { displacement, force }
}

/// The equilibrium under `supports`, from rest, in `increments` equal parts.
///
/// # Panics
/// If there is none: an unstable body, or increments that are too large.
pub fn solve(body: &mut SolidBody, supports: &SolidSupports, increments: u32) -> SolidEquilibrium {
    let mut displacement = vec![[0.0; 3]; body.n_node()];
    for n in 1..=increments {
        let part = f64::from(n) / f64::from(increments);
        let found = (0..ITERATIONS).any(|_| {
            let force = body.internal_forces(&displacement);
            let correction = Stiffness::new(body, &displacement).correction(supports, part, &displacement, &force);
            for (u, d) in displacement.as_flattened_mut().iter_mut().zip(correction.as_flattened()) {
                *u += d;
            }
            largest(&correction) <= ACCURACY * largest(&displacement)
        });
        assert!(found, "no equilibrium after {ITERATIONS} iterations");
    }
    let force = body.internal_forces(&displacement);
    SolidEquilibrium { displacement, force }
}

fn triples(values: &[f64]) -> SolidField {
    values.as_chunks::<3>().0.to_vec()
}

fn largest(field: &SolidField) -> f64 {
    field.as_flattened().iter().fold(0.0, |a, b| a.max(b.abs()))
}

/// The stiffness of a body at rest as a dense symmetric matrix, for its eigenvalues.
pub fn dense_stiffness(body: &mut SolidBody) -> DMatrix<f64> {
    let (n, rest) = (3 * body.n_node(), vec![[0.0; 3]; body.n_node()]);
    let mut matrix = DMatrix::zeros(n, n);
    for (row, column, value) in Stiffness::new(body, &rest).0 {
        matrix[(row, column)] += 0.5 * value;
        matrix[(column, row)] += 0.5 * value;
    }
    matrix
}

fn neighbours(node: [usize; 3], ends: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    let [u, v, w] = core::array::from_fn(|i| node[i].saturating_sub(1)..=(node[i] + 1).min(ends[i]));
    w.flat_map(move |w| v.clone().map(move |v| (v, w))).flat_map(move |(v, w)| u.clone().map(move |u| [u, v, w]))
}

fn shortest_edge(body: &SolidBody) -> f64 {
    let position = body.positions();
    let mut shortest = f64::MAX;
    for corners in body.cell_list().flat_map(|cell| body.tetrahedra(cell)) {
        for pair in corners.windows(2) {
            let edge = difference(position[pair[1]], position[pair[0]]);
            shortest = shortest.min(Vector3::from(edge).norm());
        }
    }
    shortest
}
