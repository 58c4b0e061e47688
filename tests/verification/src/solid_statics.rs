//! Equilibrium of a [`SolidBody`] in the linear limit: the stiffness is the derivative of the kernel's forces.

use nalgebra::DMatrix;

use crate::band::Band;
use crate::solid_body::{SolidBody, SolidField, difference, dot};

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

/// The derivative of the internal forces at rest, by central differences: (row, column, value), three freedoms a node.
struct Stiffness(Vec<(usize, usize, f64)>);

impl Stiffness {
    fn new(body: &mut SolidBody) -> Self {
        let step = PERTURBATION * shortest_edge(body);
        let mut entries = Vec::new();
        // Nodes three apart share no cell, so one evaluation serves a twenty-seventh of them.
        for number in 0..81 {
            let (colour, direction) = ([number % 3, number / 3 % 3, number / 9 % 3], number / 27);
            let ends = body.cells();
            let shifted: Vec<_> = body.nodes().filter(|node| (0..3).all(|i| node[i] % 3 == colour[i])).collect();
            let force = [-step, step].map(|step| {
                let mut displacement = vec![[0.0; 3]; body.n_node()];
                shifted.iter().for_each(|node| displacement[body.node(*node)][direction] = step);
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
    let stiffness = Stiffness::new(body);
    let prescribed: Vec<Option<f64>> = supports.prescribed.iter().flatten().copied().collect();
    let held: Vec<bool> = prescribed.iter().map(Option::is_some).collect();
    let shift: Vec<f64> = prescribed.iter().map(|value| value.unwrap_or(0.0)).collect();
    let reaction = stiffness.forces(&shift);
    let load = supports.load.iter().flatten();
    let mut x: Vec<f64> = (load.zip(&reaction).zip(&prescribed))
        .map(|((load, reaction), prescribed)| prescribed.unwrap_or(load - reaction))
        .collect();
    stiffness.matrix(&held).factor().expect("a body that is held").solve(&mut x);
    let force = stiffness.forces(&x);
    let triples = |values: &[f64]| values.as_chunks::<3>().0.to_vec();
    SolidEquilibrium { displacement: triples(&x), force: triples(&force) }
}

/// The stiffness of a body at rest as a dense symmetric matrix, for its eigenvalues.
pub fn dense_stiffness(body: &mut SolidBody) -> DMatrix<f64> {
    let n = 3 * body.n_node();
    let mut matrix = DMatrix::zeros(n, n);
    for (row, column, value) in Stiffness::new(body).0 {
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
            shortest = shortest.min(dot(edge, edge));
        }
    }
    shortest.sqrt()
}
