//! A meshed body whose internal forces are asked of the kernel at any displacement: the bridge from the kernel's step to
//! the static solver, and to triangles without the patch.

use softanvil_kernel::element::{
    Block, CellConstants, CellHistory, Corners, ElementEnergy, HoopConstants, internal_force,
};
use softanvil_kernel::mesh::triangles;
use softanvil_kernel::number::pack::{LANES, ZERO};
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::sampling::SMALLEST_STEP;
use softanvil_kernel::scenario::StepBy;
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{Constants, Model, ModelMemory, Scalars, Scenario, Size, State, StateMemory, StepInput, step};

/// A number pair per node (u, v), at index `u + v (n_u + 1)`.
pub type Field = Vec<[f64; 2]>;

/// How the pressure of a triangle is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pressure {
    /// The kernel's: from the mean dilatation of the two triangles of a cell.
    Patch,
    /// From the triangle's own Jacobian, for comparison: the plain linear triangle.
    Triangle,
}

/// Nodes, cells and laws of a body, and memory for a state.
pub struct Body {
    constants: Constants,
    nodes: Vec<f64>,
    /// Sets of cells whose forces add up: one for the patch, two with one triangle of each cell for plain triangles.
    cells: Vec<Vec<CellConstants>>,
    hoops: Vec<HoopConstants>,
    state: (Vec<f64>, Vec<CellHistory>, Vec<Deviator>),
}

impl Body {
    /// The body of `scenario` with its nodes at `position(u, v)`, m.
    pub fn new(scenario: &Scenario, position: &dyn Fn(usize, usize) -> [f64; 2], pressure: Pressure) -> Self {
        // Time stands still: a step that no trial has to find.
        let mut scenario = scenario.clone();
        (scenario.time.step_by, scenario.time.step) = (StepBy::Given, SMALLEST_STEP);
        let size = Size::of(&scenario).expect("a legal scenario");
        let mut nodes = vec![0.0; size.model_nodes];
        let mut cells = vec![CellConstants::ZERO; size.model_cells];
        let mut hoops = vec![HoopConstants::ZERO; size.model_hoops];
        let mut constants = None;
        let memory = ModelMemory { constants: &mut constants, nodes: &mut nodes, cells: &mut cells, hoops: &mut hoops };
        let mut state = (
            vec![0.0; size.state_nodes],
            vec![CellHistory::REST; size.state_cells],
            vec![Deviator::ZERO; size.state_viscous],
        );
        let (scalars, (lent, histories, viscous)) = (&mut Scalars::BLANK.clone(), &mut state);
        let mut lent = StateMemory { scalars, nodes: lent, cells: histories, viscous };
        let model = Model::with_positions(&scenario, position, memory, &mut lent).expect("a legal mesh");
        let constants = model.constants.clone();
        State::new(&model, lent).expect("memory of the right size");
        let cells = match pressure {
            Pressure::Patch => vec![cells],
            Pressure::Triangle => (0..2).map(|t| alone(&cells, t)).collect(),
        };
        Self { constants, nodes, cells, hoops, state }
    }

    /// The scalar constants of the model.
    pub fn constants(&self) -> &Constants {
        &self.constants
    }

    /// Cells along u and v.
    pub fn cells(&self) -> [usize; 2] {
        [self.constants.grid.n_u, self.constants.grid.n_v]
    }

    /// Number of nodes.
    pub fn n_node(&self) -> usize {
        let [n_u, n_v] = self.cells();
        (n_u + 1) * (n_v + 1)
    }

    /// Index of node (u, v).
    pub fn node(&self, u: usize, v: usize) -> usize {
        u + v * (self.constants.grid.n_u + 1)
    }

    /// Positions of the nodes at rest, m.
    pub fn positions(&self) -> Field {
        let model = Model::view(&self.constants, &self.nodes, &self.cells[0], &self.hoops);
        let [x, y] = model.reference_position();
        self.packed(|index| [x[index], y[index]])
    }

    fn packed(&self, value: impl Fn(usize) -> [f64; 2]) -> Field {
        let [n_u, n_v] = self.cells();
        let stride = self.constants.grid.stride();
        (0..=n_v).flat_map(|v| (0..=n_u).map(move |u| v * stride + u)).map(value).collect()
    }

    /// (u, v) of every cell.
    pub fn cell_list(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let [n_u, n_v] = self.cells();
        (0..n_v).flat_map(move |v| (0..n_u).map(move |u| (u, v)))
    }

    /// Node at corner 0 to 3 of cell (u, v).
    pub fn corner(&self, u: usize, v: usize, corner: usize) -> usize {
        let [du, dv] = [[0, 0], [1, 0], [1, 1], [0, 1]][corner];
        self.node(u + du, v + dv)
    }

    /// Internal forces at `displacement`, N, as a step of the kernel finds them, far from the face.
    pub fn internal_forces(&mut self, displacement: &Field) -> Field {
        let input = StepInput { driven_position: Some(self.constants.scenario.impactor.gap), ..StepInput::default() };
        let mut total = vec![[0.0; 2]; self.n_node()];
        for set in 0..self.cells.len() {
            let force = self.with(set, displacement, |model, state| {
                step(model, state, &input).expect("a step");
                state.force().map(<[f64]>::to_vec)
            });
            for (sum, force) in total.iter_mut().zip(self.packed(|index| [force[0][index], force[1][index]])) {
                *sum = [sum[0] - force[0], sum[1] - force[1]];
            }
        }
        total
    }

    /// Runs `work` on the model of one set of cells and a state at rest with the given displacement.
    fn with<R>(&mut self, set: usize, displacement: &Field, work: impl FnOnce(&Model, &mut State) -> R) -> R {
        let [n_u, n_v] = self.cells();
        let stride = self.constants.grid.stride();
        let model = Model::view(&self.constants, &self.nodes, &self.cells[set], &self.hoops);
        let (nodes, cells, viscous) = &mut self.state;
        let mut scalars = Scalars::BLANK;
        let memory = StateMemory { scalars: &mut scalars, nodes, cells, viscous };
        let mut state = State::new(&model, memory).expect("memory of the right size");
        let [x, y] = state.displacement_mut();
        for v in 0..=n_v {
            for u in 0..=n_u {
                let value = displacement[u + v * (n_u + 1)];
                (x[v * stride + u], y[v * stride + u]) = (value[0], value[1]);
            }
        }
        work(&model, &mut state)
    }

    /// Runs `work` on model and state at rest with the given displacement, for instance to see the contact there.
    ///
    /// # Panics
    /// For plain triangles, which are two models.
    pub fn at<R>(&mut self, displacement: &Field, work: impl FnOnce(&Model, &mut State) -> R) -> R {
        assert_eq!(self.cells.len(), 1, "plain triangles are not one model");
        self.with(0, displacement, work)
    }

    /// Internal forces on the corners of cell (u, v), N, at their displacements, m, from rest.
    pub fn cell_forces(&self, corners: &Corners<f64>, u: usize, v: usize) -> Corners<f64> {
        let (block, lane) = (v * self.constants.grid.blocks_per_row() + u / LANES, u % LANES);
        let mut energy = ElementEnergy::ZERO;
        let force = internal_force(
            Scalar,
            lane,
            &Block {
                laws: self.constants.laws_of(block),
                constants: &self.cells[0][block],
                hoop: self.hoops.get(block),
            },
            corners,
            &mut CellHistory::REST.clone(),
            &mut vec![Deviator::ZERO; 2 * self.constants.n_history_entry()],
            &mut energy,
        );
        assert_eq!(energy.inverted, ZERO, "a positive Jacobian");
        force
    }

    /// Mean first Piola-Kirchhoff stress of cell (u, v), Pa, from its forces: components 11, 22, 21 and 33 (hoop).
    ///
    /// In plane strain 33 does no work and is NaN.
    pub fn cell_stress(&self, displacement: &Field, u: usize, v: usize) -> [f64; 4] {
        let position = self.positions();
        let (block, lane) = (v * self.constants.grid.blocks_per_row() + u / LANES, u % LANES);
        let mut corners: Corners<f64> = [[0.0; 2]; 4];
        for (corner, value) in corners.iter_mut().enumerate() {
            *value = displacement[self.corner(u, v, corner)];
        }
        let constants = &self.cells[0][block];
        let force = self.cell_forces(&corners, u, v);
        // sum f (x) X = V P, in which the hoop stress adds to xx; the radial forces alone add up to V P33 / R.
        let volume: f64 = constants.triangle.iter().map(|t| t.reference_volume[lane]).sum();
        let mut moment = [[0.0; 2]; 2];
        let mut radial = 0.0;
        for (corner, force) in force.iter().enumerate() {
            let reference = position[self.corner(u, v, corner)];
            radial += force[0];
            for i in 0..2 {
                for j in 0..2 {
                    moment[i][j] += force[i] * reference[j] / volume;
                }
            }
        }
        let hoop = match self.hoops.get(block) {
            None => return [moment[0][0], moment[1][1], moment[1][0], f64::NAN],
            Some(hoop) => {
                let weights = (0..2).map(|t| {
                    let weight: f64 = hoop.weight[t].iter().map(|w| w[lane]).sum();
                    constants.triangle[t].reference_volume[lane] * weight
                });
                radial / weights.sum::<f64>()
            }
        };
        [moment[0][0] - hoop, moment[1][1], moment[1][0], hoop]
    }

    /// Pressure of every cell, Pa, positive in compression, from its mean dilatation; row by row.
    pub fn cell_pressures(&self, displacement: &Field) -> Vec<f64> {
        let bulk = self.constants.laws_of(0).volumetric.bulk_modulus;
        let position = self.positions();
        self.cell_list()
            .map(|(u, v)| {
                let [mut before, mut after] = [0.0; 2];
                for corners in triangles(&self.constants.grid, u, v) {
                    let nodes = corners.map(|corner| self.corner(u, v, corner));
                    let area = |p: [[f64; 2]; 3]| {
                        let [a, b, c] = p;
                        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
                    };
                    before += area(nodes.map(|n| position[n]));
                    after +=
                        area(nodes.map(|n| [position[n][0] + displacement[n][0], position[n][1] + displacement[n][1]]));
                }
                bulk * (1.0 - after / before)
            })
            .collect()
    }
}

/// The cells with triangle `t` alone, its pressure its own.
fn alone(cells: &[CellConstants], t: usize) -> Vec<CellConstants> {
    let mut alone = vec![CellConstants::ZERO; cells.len()];
    for (to, from) in alone.iter_mut().zip(cells) {
        to.diagonal = from.diagonal;
        to.triangle[t] = from.triangle[t];
        to.triangle[t].volume_fraction = [1.0; LANES];
    }
    alone
}
