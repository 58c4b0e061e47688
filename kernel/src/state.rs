//! [`State`]: everything about a simulation that changes, in memory that the caller lends.

use crate::element::{CellHistory, Corners};
use crate::energy::Ledger;
use crate::error::{ModelError, StepError};
use crate::impactor::ImpactorState;
use crate::lanes::{Deviator, load};
use crate::measurement::{Metrics, Sampler};
use crate::mesh::Grid;
use crate::model::Model;
use crate::real::Real;
use crate::storage::{StateMemory, split_row, take};

/// The numbers of a state that are not arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scalars {
    /// Steps completed.
    pub step_index: u64,
    /// Motion of the impactor.
    pub impactor: ImpactorState,
    /// Forces of the last step.
    pub force: Forces,
    /// Half of the width over which the face touches the surface, m.
    pub contact_half_width: Real,
    /// Force samples at [`crate::model::SAMPLING_INTERVAL`].
    pub sampler: Sampler,
    /// Numbers of the test so far.
    pub metrics: Metrics,
    /// Energies of the last step.
    pub energy: Ledger,
    /// Why no further step can be made.
    pub failure: Option<StepError>,
}

/// Forces of a step on the whole anvil, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forces {
    /// Contact force on the impactor, upwards.
    pub contact: Real,
    /// Force of the layer on the core, downwards.
    pub core_reaction: Real,
}

/// The arrays of the nodes, rows of [`Grid::stride`] from the core to the surface.
pub(crate) struct StateNodes<'a> {
    /// Displacement along x, m.
    pub displacement_x: &'a mut [Real],
    /// Displacement along y, m.
    pub displacement_y: &'a mut [Real],
    /// Velocity along x half a step back, m/s.
    pub velocity_x: &'a mut [Real],
    /// Velocity along y half a step back, m/s.
    pub velocity_y: &'a mut [Real],
    /// Force of the step along x, N.
    pub force_x: &'a mut [Real],
    /// Force of the step along y, N.
    pub force_y: &'a mut [Real],
    /// Contact force on the surface nodes, downwards, N.
    pub contact_normal: &'a mut [Real],
    /// Friction force on the surface nodes, outwards, N.
    pub contact_tangential: &'a mut [Real],
}

/// The changing part of a simulation.
pub struct State<'a> {
    /// The numbers that are not arrays.
    pub scalars: Scalars,
    pub(crate) nodes: StateNodes<'a>,
    pub(crate) cells: &'a mut [CellHistory],
    pub(crate) viscous: &'a mut [Deviator],
}

impl<'a> State<'a> {
    /// A state of `model` at the start of its drop, in `memory`.
    ///
    /// # Errors
    /// Too little memory.
    pub fn new(model: &Model, memory: StateMemory<'a>) -> Result<Self, ModelError> {
        let scalars = Scalars::start(model);
        let mut state = Self::view(model, scalars, memory)?;
        state.reset(model);
        Ok(state)
    }

    /// A state over memory that already holds one, with the `scalars` that belong to it.
    ///
    /// # Errors
    /// Too little memory.
    pub fn view(model: &Model, scalars: Scalars, memory: StateMemory<'a>) -> Result<Self, ModelError> {
        let size = &model.constants.size;
        let grid = &model.constants.grid;
        let mut nodes = take(memory.nodes, size.state_nodes, "state nodes")?;
        let mut row = |n| split_row(&mut nodes, n);
        let n = grid.n_node();
        Ok(Self {
            scalars,
            nodes: StateNodes {
                displacement_x: row(n),
                displacement_y: row(n),
                velocity_x: row(n),
                velocity_y: row(n),
                force_x: row(n),
                force_y: row(n),
                contact_normal: row(grid.stride()),
                contact_tangential: row(grid.stride()),
            },
            cells: take(memory.cells, size.state_cells, "state cells")?,
            viscous: take(memory.viscous, size.state_viscous, "state viscous history")?,
        })
    }

    /// Back to the start of the drop.
    pub fn reset(&mut self, model: &Model) {
        self.scalars = Scalars::start(model);
        for array in self.nodes.arrays_mut() {
            array.fill(0.0);
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
        [self.nodes.displacement_x, self.nodes.displacement_y]
    }

    /// Displacements of the nodes, m, to be changed: initial conditions, prescribed fields. Nodes beyond `n_u + 1` in a
    /// row are padding and stay at zero.
    pub fn displacement_mut(&mut self) -> [&mut [Real]; 2] {
        [self.nodes.displacement_x, self.nodes.displacement_y]
    }

    /// Velocities of the nodes half a step back, m/s, laid out alike.
    pub fn velocity(&self) -> [&[Real]; 2] {
        [self.nodes.velocity_x, self.nodes.velocity_y]
    }

    /// Velocities of the nodes half a step back, m/s, to be changed.
    pub fn velocity_mut(&mut self) -> [&mut [Real]; 2] {
        [self.nodes.velocity_x, self.nodes.velocity_y]
    }

    /// Total force on each node in the last step, N: contact and friction minus internal forces.
    pub fn force(&self) -> [&[Real]; 2] {
        [self.nodes.force_x, self.nodes.force_y]
    }

    /// Normal force of the face on each surface node in the last step, N, by column.
    pub fn contact_normal(&self) -> &[Real] {
        self.nodes.contact_normal
    }

    /// Friction force of the face on each surface node in the last step, N, outwards, by column.
    pub fn contact_tangential(&self) -> &[Real] {
        self.nodes.contact_tangential
    }

    /// Displacements of the corners of the cells of a block.
    #[inline(always)]
    pub(crate) fn corners(&self, grid: &Grid, block: usize) -> Corners {
        let (x, y) = (&*self.nodes.displacement_x, &*self.nodes.displacement_y);
        corner_indices(grid, block).map(|index| [load(x, index), load(y, index)])
    }
}

/// First node of each corner row of a block.
#[inline(always)]
pub(crate) fn corner_indices(grid: &Grid, block: usize) -> [usize; 4] {
    let per_row = grid.blocks_per_row().max(1);
    let first = (block / per_row) * grid.stride() + (block % per_row) * crate::lanes::LANES;
    [first, first + 1, first + grid.stride() + 1, first + grid.stride()]
}

impl StateNodes<'_> {
    /// Every array, in the order of storage.
    pub(crate) fn arrays_mut(&mut self) -> [&mut [Real]; 8] {
        [
            self.displacement_x,
            self.displacement_y,
            self.velocity_x,
            self.velocity_y,
            self.force_x,
            self.force_y,
            self.contact_normal,
            self.contact_tangential,
        ]
    }
}

impl Scalars {
    /// The start of the drop.
    fn start(model: &Model) -> Self {
        Self {
            step_index: 0,
            impactor: ImpactorState::start(model),
            force: Forces { contact: 0.0, core_reaction: 0.0 },
            contact_half_width: 0.0,
            sampler: Sampler::START,
            metrics: Metrics::START,
            energy: Ledger::start(model),
            failure: None,
        }
    }
}
