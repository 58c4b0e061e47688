//! A meshed solid whose internal forces are asked of the kernel at any displacement, as [`crate::body::Body`] does of a section.

use nalgebra::Vector3;
use softanvil_kernel::material::Material;
use softanvil_kernel::mesh::tetrahedra;
use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::{Formulation, Interface, StepBy};
use softanvil_kernel::{Scenario, Simulation, StepInput, step};

use crate::scenes::block;
use crate::solid::CELL;

/// A number triple per node, in the order of [`SolidBody::node`].
pub type SolidField = Vec<[f64; 3]>;

/// Distance of the face, m, which must not touch.
const GAP: f64 = 1.0;

/// A quarter of a block of `cells` along u, v and w, held at its base and far below the face, for bodies whose nodes are placed.
pub fn solid_grid(cells: [usize; 3], material: Material) -> Scenario {
    let [width, height, length] = [2.0, 1.0, 2.0];
    let [n_u, n_v, n_w] = cells.map(|n| n as f64 * CELL);
    let mut scenario = block(width * n_u, height * n_v, material);
    scenario.geometry.formulation = Formulation::Solid;
    scenario.geometry.length = length * n_w;
    scenario.impactor.face_diameter = scenario.impactor.face_diameter.max(1.5 * (width * n_u).hypot(length * n_w));
    scenario.mesh.element_size = CELL;
    (scenario.core.interface, scenario.impactor.gap) = (Interface::Bonded, GAP);
    scenario
}

/// Nodes and cells of a solid, in memory of its own.
pub struct SolidBody {
    simulation: Simulation,
    cells: [usize; 3],
    /// Distances between the numbers of nodes that are neighbours along u, v and w.
    strides: [usize; 3],
    rest: SolidField,
}

impl SolidBody {
    /// A body of `cells` along u, v and w with its nodes at `position`, m.
    ///
    /// # Panics
    /// If a tetrahedron has no volume.
    pub fn new(cells: [usize; 3], material: Material, position: &dyn Fn([usize; 3]) -> [f64; 3]) -> Self {
        let mut scenario = solid_grid(cells, material);
        // Time stands still: a step that no trial has to find.
        (scenario.time.step_by, scenario.time.step) = (StepBy::Given, SMALLEST_STEP);
        let simulation = Simulation::with_node_positions(&scenario, position).expect("a legal solid");
        let grid = simulation.constants().grid;
        assert_eq!([grid.n_u, grid.n_v, grid.n_w], cells, "cells of the nominal block");
        let mut body = Self { simulation, cells, strides: strides(cells), rest: Vec::new() };
        body.rest = vec![[0.0; 3]; body.n_node()];
        for node in body.nodes() {
            let index = body.node(node);
            body.rest[index] = position(node);
        }
        body
    }

    /// Cells along u, v and w.
    pub fn cells(&self) -> [usize; 3] {
        self.cells
    }

    /// Number of nodes.
    pub fn n_node(&self) -> usize {
        self.cells.iter().map(|n| n + 1).product()
    }

    /// Number of a node: the direction with the fewest cells runs first, which keeps neighbours close.
    pub fn node(&self, node: [usize; 3]) -> usize {
        (0..3).map(|i| node[i] * self.strides[i]).sum()
    }

    /// Columns, rows and slices of nodes.
    pub fn nodes(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        places(self.cells.map(|n| n + 1))
    }

    /// Columns, rows and slices of cells.
    pub fn cell_list(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        places(self.cells)
    }

    /// Positions of the nodes at rest, m.
    pub fn positions(&self) -> &SolidField {
        &self.rest
    }

    /// Internal forces at `displacement`, N, as a step of the kernel finds them.
    ///
    /// # Panics
    /// If a tetrahedron is inverted.
    pub fn internal_forces(&mut self, displacement: &SolidField) -> SolidField {
        let (nodes, strides) = (self.nodes(), self.strides);
        let mut internal = vec![[0.0; 3]; self.n_node()];
        let number = |node: [usize; 3]| -> usize { (0..3).map(|i| node[i] * strides[i]).sum() };
        let work = |model: &softanvil_kernel::Model, state: &mut softanvil_kernel::State| {
            let places: Vec<_> =
                nodes.map(|node| (number(node), model.constants.grid.node(node[0], node[1], node[2]))).collect();
            for (index, place) in &places {
                let [x, y] = state.displacement_mut();
                (x[*place], y[*place]) = (displacement[*index][0], displacement[*index][1]);
                state.along_z_mut(model)[0][*place] = displacement[*index][2];
            }
            state.velocity_mut().into_iter().for_each(|row| row.fill(0.0));
            state.along_z_mut(model)[1].fill(0.0);
            step(model, state, &StepInput { driven_position: Some(GAP), ..StepInput::default() }).expect("a step");
            let ([x, y], [_, _, z, _]) = (state.force(), state.as_view().along_z(model));
            for (index, place) in &places {
                internal[*index] = [-x[*place], -y[*place], -z[*place]];
            }
        };
        self.simulation.with(work).expect("memory of the right size");
        internal
    }

    /// Numbers of the nodes of the six tetrahedra of a cell.
    pub fn tetrahedra(&self, cell: [usize; 3]) -> [[usize; 4]; 6] {
        tetrahedra(&self.simulation.constants().grid, cell).map(|corners| corners.map(|corner| self.node(corner)))
    }

    /// Pressure of every cell, Pa, positive in compression, from its mean dilatation in the linear limit; in the order of
    /// [`Self::cell_list`].
    pub fn cell_pressures(&self, displacement: &SolidField) -> Vec<f64> {
        let bulk = self.simulation.constants().laws_of(0).volumetric.bulk_modulus;
        let volume_at = |cell: [usize; 3], scale: f64| -> f64 {
            let moved = |node: usize| core::array::from_fn(|i| self.rest[node][i] + scale * displacement[node][i]);
            self.tetrahedra(cell).iter().map(|corners| volume(corners.map(moved))).sum()
        };
        // Half the difference of both signs: what is left of the nonlinearity is of third order.
        let growth = |cell| 0.5 * (volume_at(cell, SMALL) - volume_at(cell, -SMALL)) / SMALL / volume_at(cell, 0.0);
        self.cell_list().map(|cell| -bulk * growth(cell)).collect()
    }
}

/// Scale of a displacement that is linear.
const SMALL: f64 = 1e-2;

fn strides(cells: [usize; 3]) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by_key(|direction| cells[*direction]);
    let (mut strides, mut next) = ([0; 3], 1);
    for direction in order {
        strides[direction] = next;
        next *= cells[direction] + 1;
    }
    strides
}

/// All places of a grid with so many along each direction.
fn places([n_u, n_v, n_w]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..n_w).flat_map(move |w| (0..n_v).flat_map(move |v| (0..n_u).map(move |u| [u, v, w])))
}

/// The difference b - a.
pub fn difference(b: [f64; 3], a: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| b[i] - a[i])
}

/// Volume of a tetrahedron.
fn volume([a, b, c, d]: [[f64; 3]; 4]) -> f64 {
    let [u, v, w] = [b, c, d].map(|corner| Vector3::from(difference(corner, a)));
    u.dot(&v.cross(&w)).abs() / 6.0
}
