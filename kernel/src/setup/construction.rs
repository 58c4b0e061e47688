//! How a [`Model`] is made.

use crate::error::ModelError;
use crate::mesh::Grid;
use crate::model::{Model, ModelArrays, ModelMemory, Size};
use crate::number::real::Real;
use crate::scenario::Scenario;
use crate::setup::time_step::{place_of, with_chosen_step};
use crate::state::StateMemory;

impl<'a> Model<'a> {
    /// Builds the model of `scenario` in `memory`, whose size [`Size::of`] tells.
    ///
    /// Where the scenario leaves the step to be found, a trial of it runs in `state`, the memory of a state of this model
    /// that is not in use yet, and leaves it changed; a given step leaves it as it is.
    ///
    /// # Errors
    /// A refused scenario, a mesh or step out of bounds, or too little memory; see [`ModelError`].
    pub fn new(scenario: &Scenario, memory: ModelMemory<'a>, state: &mut StateMemory) -> Result<Self, ModelError> {
        scenario.validate()?;
        let grid = Grid::new(scenario)?;
        Self::with_node_positions(scenario, &|node| place_of(scenario, &grid, node), memory, state)
    }

    /// Builds a model whose nodes rest at `position(u, v)`, m, instead of on the scenario's shape: distorted or graded
    /// meshes, other domains. The corners of each cell must run counter-clockwise from (u, v). A trial on a coarse mesh
    /// takes the scenario's shape.
    ///
    /// # Errors
    /// As [`Model::new`], and a cell without area.
    pub fn with_positions(
        scenario: &Scenario,
        position: &dyn Fn(usize, usize) -> [Real; 2],
        memory: ModelMemory<'a>,
        state: &mut StateMemory,
    ) -> Result<Self, ModelError> {
        let flat = |[u, v, _]: [usize; 3]| {
            let [x, y] = position(u, v);
            [x, y, 0.0]
        };
        Self::with_node_positions(scenario, &flat, memory, state)
    }

    /// The same for a solid whose nodes rest at `position([u, v, w])`, m, of column, row and slice.
    ///
    /// # Errors
    /// As [`Model::new`], and a tetrahedron without volume.
    pub fn with_node_positions(
        scenario: &Scenario,
        position: &dyn Fn([usize; 3]) -> [Real; 3],
        memory: ModelMemory<'a>,
        state: &mut StateMemory,
    ) -> Result<Self, ModelError> {
        let size = Size::of(scenario)?;
        let ModelMemory { constants, nodes, cells, hoops } = memory;
        let mut arrays = ModelArrays { nodes, cells, hoops };
        // Before the work of a trial.
        arrays.first(&size)?;
        let constants = with_chosen_step(scenario, position, &mut arrays, state, constants)?;
        let ModelArrays { nodes, cells, hoops } = arrays;
        Ok(Self::view(
            constants,
            nodes.get(..size.model_nodes).unwrap_or_default(),
            cells.get(..size.model_cells).unwrap_or_default(),
            hoops.get(..size.model_hoops).unwrap_or_default(),
        ))
    }
}
