//! Blocks of a solid whose nodes are put where a test wants them.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::{Formulation, StepBy};
use softanvil_kernel::{Model, Scenario, Simulation, State, StepError, StepInput, step};

use crate::scenes::block;

/// A deformation gradient.
pub type SolidGradient = [[f64; 3]; 3];

/// Side of a cell, m.
pub const CELL: f64 = 1e-3;

/// A block of `n` by `n` by `n` cells of a solid, a quarter of one, that nothing touches.
pub fn cube(n: usize, material: Material, dt: f64) -> Scenario {
    let side = n as f64 * CELL;
    let mut scenario = block(2.0 * side, side, material);
    scenario.geometry.formulation = Formulation::Solid;
    scenario.geometry.length = scenario.geometry.block_width;
    scenario.impactor.face_diameter = 10.0 * scenario.geometry.block_width;
    (scenario.mesh.element_size, scenario.impactor.gap) = (CELL, 0.9);
    (scenario.time.step_by, scenario.time.step) = (StepBy::Given, dt);
    scenario
}

/// Columns, rows and slices of nodes.
pub fn nodes(model: &Model) -> impl Iterator<Item = [usize; 3]> + use<> {
    let grid = model.constants.grid;
    let columns = 0..=grid.n_u;
    (0..grid.node_rows())
        .flat_map(move |v| (0..grid.node_slices()).map(move |w| (v, w)))
        .flat_map(move |(v, w)| columns.clone().map(move |u| [u, v, w]))
}

/// A solid with a state of its own.
pub struct Solid {
    simulation: Simulation,
}

impl Solid {
    /// # Panics
    /// If the scenario is illegal.
    pub fn new(scenario: &Scenario) -> Self {
        Self { simulation: Simulation::new(scenario).expect("a legal solid") }
    }

    /// With nodes that rest elsewhere.
    ///
    /// # Panics
    /// If the scenario is illegal, or a tetrahedron has no volume.
    pub fn with_positions(scenario: &Scenario, position: &dyn Fn([usize; 3]) -> [f64; 3]) -> Self {
        Self { simulation: Simulation::with_node_positions(scenario, position).expect("a legal solid") }
    }

    /// Runs `work` on model and state.
    ///
    /// # Panics
    /// Never: the memory has the right size.
    pub fn with<R>(&mut self, work: impl FnOnce(&Model, &mut State) -> R) -> R {
        self.simulation.with(work).expect("memory of the right size")
    }

    /// Makes a step from rest with every node at `place` of its position at rest, m; gives the forces on the nodes, N, in the
    /// order of [`nodes`].
    pub fn put(&mut self, place: &dyn Fn([f64; 3]) -> [f64; 3]) -> Vec<[f64; 3]> {
        self.with(|model, state| {
            put(model, state, place);
            forces(model, state)
        })
    }

    /// The same for a homogeneous deformation.
    pub fn deform(&mut self, gradient: SolidGradient) -> Vec<[f64; 3]> {
        self.put(&|x| core::array::from_fn(|i| (0..3).map(|j| gradient[i][j] * x[j]).sum()))
    }

    /// Mean of P over the volume after a homogeneous deformation, Pa: the moment of the nodal forces about the positions at rest.
    pub fn first_piola(&mut self, gradient: SolidGradient) -> SolidGradient {
        let forces = self.deform(gradient);
        self.with(|model, _| {
            let [x, y] = model.reference_position();
            let z = model.reference_z();
            let mut moment = [[0.0; 3]; 3];
            for ([u, v, w], force) in nodes(model).zip(&forces) {
                let node = model.constants.grid.node(u, v, w);
                let rest = [x[node], y[node], z[node]];
                for (i, row) in moment.iter_mut().enumerate() {
                    (0..3).for_each(|j| row[j] -= force[i] * rest[j] / model.reference_volume());
                }
            }
            moment
        })
    }
}

/// Height at which a solid floats above the core, below the face, m.
const LIFT: f64 = 0.45;

/// Makes a step from rest with every node at `place` of its position at rest, m.
///
/// # Panics
/// If the step fails.
pub fn put(model: &Model, state: &mut State, place: &dyn Fn([f64; 3]) -> [f64; 3]) {
    try_put(model, state, place).expect("a step");
}

/// The same.
///
/// # Errors
/// The step fails.
pub fn try_put(model: &Model, state: &mut State, place: &dyn Fn([f64; 3]) -> [f64; 3]) -> Result<(), StepError> {
    let ([x, y], z) = (model.reference_position(), model.reference_z());
    for [u, v, w] in nodes(model) {
        let node = model.constants.grid.node(u, v, w);
        let rest = [x[node], y[node], z[node]];
        let moved = place(rest);
        let [ux, uy] = state.displacement_mut();
        (ux[node], uy[node]) = (moved[0] - rest[0], moved[1] - rest[1] + LIFT);
        let [uz, _] = state.along_z_mut(model);
        uz[node] = moved[2] - rest[2];
    }
    state.velocity_mut().into_iter().for_each(|row| row.fill(0.0));
    let [_, along_z] = state.along_z_mut(model);
    along_z.fill(0.0);
    let input = StepInput { driven_position: Some(0.9), ..StepInput::default() };
    step(model, state, &input)
}

/// Forces on the nodes in the last step, N, in the order of [`nodes`].
pub fn forces(model: &Model, state: &State) -> Vec<[f64; 3]> {
    let [x, y] = state.force();
    let [_, _, z, _] = state.as_view().along_z(model);
    let at = |[u, v, w]: [usize; 3]| model.constants.grid.node(u, v, w);
    nodes(model).map(at).map(|node| [x[node], y[node], z[node]]).collect()
}
