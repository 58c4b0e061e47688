//! A model and its state in memory of their own, for hosts that can allocate (feature `alloc`).

use alloc::vec::Vec;

use crate::element::{CellConstants, CellHistory, HoopConstants};
use crate::error::{MemoryError, ModelError, StepError};
use crate::input::StepInput;
use crate::lanes::Deviator;
use crate::model::{Constants, Model};
use crate::real::Real;
use crate::scenario::Scenario;
use crate::state::{Scalars, State};
use crate::step::steps;
use crate::storage::{ModelMemory, Size, StateMemory};

/// An owned simulation.
pub struct Simulation {
    constants: Constants,
    scalars: Scalars,
    model_nodes: Vec<Real>,
    model_cells: Vec<CellConstants>,
    model_hoops: Vec<HoopConstants>,
    state_nodes: Vec<Real>,
    state_cells: Vec<CellHistory>,
    state_viscous: Vec<Deviator>,
}

impl Simulation {
    /// Allocates and builds the model of `scenario`, at the start of its drop.
    ///
    /// # Errors
    /// A refused scenario, or no memory; see [`ModelError`].
    pub fn new(scenario: &Scenario) -> Result<Self, ModelError> {
        Self::build(scenario, |memory, state| Model::new(scenario, memory, state))
    }

    /// The same with nodes that rest at `position(u, v)`, m; see [`Model::with_positions`].
    ///
    /// # Errors
    /// As [`Simulation::new`], and a cell without area.
    pub fn with_positions(
        scenario: &Scenario,
        position: &dyn Fn(usize, usize) -> [Real; 2],
    ) -> Result<Self, ModelError> {
        Self::build(scenario, |memory, state| Model::with_positions(scenario, position, memory, state))
    }

    fn build(
        scenario: &Scenario,
        model: impl for<'m> FnOnce(ModelMemory<'m>, &mut StateMemory) -> Result<Model<'m>, ModelError>,
    ) -> Result<Self, ModelError> {
        let size = Size::of(scenario)?;
        let mut model_nodes = filled(0.0, size.model_nodes, "model nodes")?;
        let mut model_cells = filled(CellConstants::ZERO, size.model_cells, "model cells")?;
        let mut model_hoops = filled(HoopConstants::ZERO, size.model_hoops, "model hoops")?;
        let mut state_nodes = filled(0.0, size.state_nodes, "state nodes")?;
        let mut state_cells = filled(CellHistory::REST, size.state_cells, "state cells")?;
        let mut state_viscous = filled(Deviator::ZERO, size.state_viscous, "state viscous history")?;
        let (mut constants, mut scalars) = (None, Scalars::BLANK);
        let (nodes, cells, viscous) = (&mut state_nodes, &mut state_cells, &mut state_viscous);
        let mut state = StateMemory { scalars: &mut scalars, nodes, cells, viscous };
        let (nodes, cells, hoops) = (&mut model_nodes, &mut model_cells, &mut model_hoops);
        let model = model(ModelMemory { constants: &mut constants, nodes, cells, hoops }, &mut state)?;
        State::new(&model, state)?;
        let constants = *model.constants;
        Ok(Self { constants, scalars, model_nodes, model_cells, model_hoops, state_nodes, state_cells, state_viscous })
    }

    /// The scalar constants of the model.
    pub fn constants(&self) -> &Constants {
        &self.constants
    }

    /// The numbers of the state that are not arrays.
    pub fn scalars(&self) -> &Scalars {
        &self.scalars
    }

    /// Simulated time, s.
    pub fn time(&self) -> Real {
        self.constants.time(self.scalars.step_index)
    }

    /// Runs `work` on model and state.
    ///
    /// # Errors
    /// Never in practice: the memory was sized for this model.
    #[inline(always)]
    pub fn with<R>(&mut self, work: impl FnOnce(&Model, &mut State) -> R) -> Result<R, MemoryError> {
        let model = Model::view(&self.constants, &self.model_nodes, &self.model_cells, &self.model_hoops);
        let memory = StateMemory {
            scalars: &mut self.scalars,
            nodes: &mut self.state_nodes,
            cells: &mut self.state_cells,
            viscous: &mut self.state_viscous,
        };
        Ok(work(&model, &mut State::view(&model, memory)?))
    }

    /// Makes `n` steps. The external force is held; a driven face is where the input says, and moves as it says, at the end of
    /// the last of them.
    ///
    /// # Errors
    /// As [`steps`]; the steps before a failure stay done.
    pub fn step(&mut self, n: u64, input: &StepInput) -> Result<(), StepError> {
        self.with(|model, state| steps(model, state, n, input))?
    }

    /// Back to the start of the drop.
    ///
    /// # Errors
    /// As [`Simulation::with`].
    pub fn reset(&mut self) -> Result<(), MemoryError> {
        self.with(|model, state| state.reset(model))
    }
}

/// `n` copies of `value`.
///
/// # Errors
/// The heap has no room for them.
fn filled<T: Copy>(value: T, n: usize, what: &'static str) -> Result<Vec<T>, ModelError> {
    let mut items = Vec::new();
    items.try_reserve_exact(n).map_err(|_| MemoryError { what, given: 0, needed: n })?;
    items.resize(n, value);
    Ok(items)
}
