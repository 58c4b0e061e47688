//! [`State`]: everything about a simulation that changes, in memory that the caller lends.

use crate::element::{CellHistory, Corners};
use crate::error::MemoryError;
use crate::mesh::Grid;
use crate::model::{Model, NodeArrays, split_row, take};
use crate::number::real::Real;
use crate::number::vector::Simd;
use crate::state::{Scalars, SolidState, StateMemory, StateNodes, corners};
use crate::tensor::deviator::Deviator;

/// The changing part of a simulation.
///
/// ```
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// anvil.with(|model, state| {
///     // The first node of the last row: the top of the anvil on its centre line, which touches the face.
///     let top = model.constants.grid.n_v * model.constants.grid.stride();
///     let [_, along_y] = state.displacement();
///     assert!((along_y[top] - state.scalars.impactor.position).abs() < 1e-12);
/// })?;
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct State<'a> {
    /// The numbers that are not arrays.
    pub scalars: &'a mut Scalars,
    pub(crate) nodes: StateNodes<&'a mut [Real]>,
    pub(crate) cells: &'a mut [CellHistory],
    pub(crate) viscous: &'a mut [Deviator],
}

impl<'a> State<'a> {
    /// A state of `model` at the start of its drop, in `memory`.
    ///
    /// # Errors
    /// Too little memory.
    pub fn new(model: &Model, memory: StateMemory<'a>) -> Result<Self, MemoryError> {
        let mut state = Self::view(model, memory)?;
        state.reset(model);
        Ok(state)
    }

    /// A state over memory that already holds one.
    ///
    /// # Errors
    /// Too little memory.
    // Of every call on a simulation: not inlined, the state would be written twice.
    #[inline(always)]
    pub fn view(model: &Model, memory: StateMemory<'a>) -> Result<Self, MemoryError> {
        let size = &model.constants.size;
        let constants = model.constants;
        let lengths = NodeArrays::new(&constants.grid, &constants.outline, constants.solid_history_packs);
        let given = memory.nodes.len();
        let mut nodes = take(memory.nodes, size.state_nodes, "state nodes")?;
        let nodes = StateNodes::of(&lengths, |n| split_row(&mut nodes, n));
        Ok(Self {
            scalars: memory.scalars,
            nodes: nodes.ok_or(MemoryError { what: "state nodes", given, needed: size.state_nodes })?,
            cells: take(memory.cells, size.state_cells, "state cells")?,
            viscous: take(memory.viscous, size.state_viscous, "state viscous history")?,
        })
    }

    /// Back to the start of the drop.
    pub fn reset(&mut self, model: &Model) {
        *self.scalars = Scalars::start(model);
        for row in self.nodes.all() {
            row.fill(0.0);
        }
        self.cells.fill(CellHistory::REST);
        self.viscous.fill(Deviator::ZERO);
    }

    /// Simulated time, s.
    pub fn time(&self, model: &Model) -> Real {
        model.constants.time(self.scalars.step_index)
    }

    /// Displacements of the nodes, m, laid out as [`Model::reference_position`].
    pub fn displacement(&self) -> [&[Real]; 2] {
        self.nodes.as_read().displacement
    }

    /// Displacements of the nodes, m, to be changed: initial conditions, prescribed fields. Nodes beyond `n_u + 1` in a
    /// row are padding and stay at zero.
    pub fn displacement_mut(&mut self) -> [&mut [Real]; 2] {
        self.nodes.displacement.each_mut().map(|row| &mut **row)
    }

    /// Displacements of the nodes of a solid along z, m, then velocities half a step back, m/s, to be changed; nothing of a section.
    pub fn along_z_mut(&mut self, model: &Model) -> [&mut [Real]; 2] {
        let constants = model.constants;
        let solid = SolidState::of(&constants.grid, constants.solid_history_packs, self.nodes.solid);
        [solid.displacement, solid.velocity]
    }

    /// Velocities of the nodes half a step back, m/s, laid out alike.
    pub fn velocity(&self) -> [&[Real]; 2] {
        self.nodes.as_read().velocity
    }

    /// Velocities of the nodes half a step back, m/s, to be changed.
    pub fn velocity_mut(&mut self) -> [&mut [Real]; 2] {
        self.nodes.velocity.each_mut().map(|row| &mut **row)
    }

    /// Total force on each node in the last step, N: contact and friction minus internal forces.
    pub fn force(&self) -> [&[Real]; 2] {
        self.nodes.as_read().force
    }

    /// Normal force of the face on each surface node in the last step, N, by column.
    pub fn contact_normal(&self) -> &[Real] {
        self.nodes.contact[0]
    }

    /// Friction force of the face on each surface node in the last step, N, outwards, by column.
    pub fn contact_tangential(&self) -> &[Real] {
        self.nodes.contact[1]
    }

    /// Displacements of the corners of neighbouring cells of a block.
    #[inline(always)]
    pub(crate) fn corners<S: Simd>(&self, simd: S, chunk: usize, grid: &Grid, block: usize) -> Corners<S::Vector> {
        corners(simd, chunk, &self.nodes.rows(grid.first_nodes(grid.place(block))))
    }
}
