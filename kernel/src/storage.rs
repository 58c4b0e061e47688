//! Sizes of the memory that the caller lends to a model and a state, known before anything is built.

use crate::element::{CellConstants, CellHistory, HoopConstants};
use crate::error::{MemoryError, ModelError};
use crate::lanes::Deviator;
use crate::mesh::Grid;
use crate::model::Constants;
use crate::real::Real;
use crate::scenario::Scenario;
use crate::state::Scalars;

/// Numbers per node in a model: height of rest, inverse masses along x and y, mass, and x of rest.
pub(crate) const MODEL_NODE_FIELDS: usize = 5;
/// Numbers per node in a state: displacement, velocity and force, two components each.
pub(crate) const STATE_NODE_FIELDS: usize = 6;
/// Numbers per surface node in a state: normal and tangential contact force.
pub(crate) const SURFACE_FIELDS: usize = 2;

/// Items of each kind that a model and its states need.
///
/// ```
/// use softanvil_kernel::{Size, preset};
///
/// let size = Size::of(&preset::study())?;
/// // The history of two triangles a cell for every Prony term, and no hoops in plane strain.
/// let terms = preset::study().silicone.n_viscous_term();
/// assert_eq!((size.state_viscous, size.model_hoops), (2 * terms * size.state_cells, 0));
///
/// // Half the edge length makes about four times the cells.
/// let mut finer = preset::study();
/// finer.mesh.element_size *= 0.5;
/// let ratio = Size::of(&finer)?.state_cells as f64 / size.state_cells as f64;
/// assert!(ratio > 3.0 && ratio < 5.0);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Numbers for the nodes of a model.
    pub model_nodes: usize,
    /// Blocks of element constants of a model.
    pub model_cells: usize,
    /// Blocks of hoop constants of a model (none in plane strain).
    pub model_hoops: usize,
    /// Numbers for the nodes of a state.
    pub state_nodes: usize,
    /// Blocks of element history of a state.
    pub state_cells: usize,
    /// Blocks of viscous history of a state.
    pub state_viscous: usize,
}

impl Size {
    /// What `scenario` needs.
    ///
    /// # Errors
    /// A scenario that is refused, or too many cells.
    pub fn of(scenario: &Scenario) -> Result<Self, ModelError> {
        scenario.validate()?;
        Ok(Self::of_grid(scenario, &Grid::new(scenario)?))
    }

    /// What a legal `scenario` needs on its `grid`.
    pub(crate) fn of_grid(scenario: &Scenario, grid: &Grid) -> Self {
        let terms = scenario.layers().iter().fold(0, |most, layer| most.max(layer.material.n_viscous_term()));
        Self {
            model_nodes: MODEL_NODE_FIELDS * grid.n_node(),
            model_cells: grid.n_block(),
            model_hoops: if grid.axisymmetric { grid.n_block() } else { 0 },
            state_nodes: STATE_NODE_FIELDS * grid.n_node() + SURFACE_FIELDS * grid.stride(),
            state_cells: grid.n_block(),
            state_viscous: 2 * terms * grid.n_block(),
        }
    }
}

/// Memory lent to a model while it is built.
///
/// ```
/// use softanvil_kernel::element::{CellConstants, HoopConstants};
/// use softanvil_kernel::scenario::StepBy;
/// use softanvil_kernel::{Model, ModelMemory, Scalars, StateMemory, preset};
///
/// // A size for every scenario to come, as on a microcontroller; it holds one model after the other.
/// let (mut constants, mut nodes) = (None, [0.0; 2000]);
/// let (mut cells, mut hoops) = ([CellConstants::ZERO; 40], [HoopConstants::ZERO; 40]);
/// let mut elements = [0; 2];
/// for (number, element_size) in [5e-3, 4e-3].into_iter().enumerate() {
///     let mut scenario = preset::study();
///     scenario.mesh.element_size = element_size;
///     // A given step needs no trial, so there is no memory of a state for it.
///     (scenario.time.step_by, scenario.time.step) = (StepBy::Given, 1e-6);
///     let scalars = &mut { Scalars::BLANK };
///     let of_state = &mut StateMemory { scalars, nodes: &mut [], cells: &mut [], viscous: &mut [] };
///     let memory = ModelMemory { constants: &mut constants, nodes: &mut nodes, cells: &mut cells, hoops: &mut hoops };
///     elements[number] = Model::new(&scenario, memory, of_state)?.constants.grid.n_elem();
/// }
/// assert!(0 < elements[0] && elements[0] < elements[1]);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct ModelMemory<'a> {
    /// Place for the scalar constants.
    pub constants: &'a mut Option<Constants>,
    /// At least [`Size::model_nodes`] numbers.
    pub nodes: &'a mut [Real],
    /// At least [`Size::model_cells`] blocks.
    pub cells: &'a mut [CellConstants],
    /// At least [`Size::model_hoops`] blocks.
    pub hoops: &'a mut [HoopConstants],
}

/// The arrays among the memory of a model.
pub(crate) struct ModelArrays<'a> {
    pub nodes: &'a mut [Real],
    pub cells: &'a mut [CellConstants],
    pub hoops: &'a mut [HoopConstants],
}

impl ModelArrays<'_> {
    /// The first items of each, as many as `size` says.
    pub fn first(&mut self, size: &Size) -> Result<ModelArrays<'_>, ModelError> {
        Ok(ModelArrays {
            nodes: take(self.nodes, size.model_nodes, "model nodes")?,
            cells: take(self.cells, size.model_cells, "model cells")?,
            hoops: take(self.hoops, size.model_hoops, "model hoops")?,
        })
    }
}

/// Memory lent to a state for its lifetime, or to a model while it is built.
///
/// ```
/// use softanvil_kernel::element::CellHistory;
/// use softanvil_kernel::lanes::Deviator;
/// use softanvil_kernel::{Scalars, Simulation, State, StateMemory, StepInput, preset, steps};
///
/// // A second state of the same model: the drop against a constant force.
/// let mut free = Simulation::new(&preset::study())?;
/// free.run(15e-3, &StepInput::default())?;
/// let held = free.with(|model, _| {
///     let size = &model.constants.size;
///     let (mut scalars, mut nodes) = (Scalars::BLANK, vec![0.0; size.state_nodes]);
///     let mut cells = vec![CellHistory::REST; size.state_cells];
///     let mut viscous = vec![Deviator::ZERO; size.state_viscous];
///     let memory = StateMemory { scalars: &mut scalars, nodes: &mut nodes, cells: &mut cells, viscous: &mut viscous };
///     let mut state = State::new(model, memory)?;
///     let upward = StepInput { external_force: 1000.0, ..StepInput::default() };
///     steps(model, &mut state, model.constants.steps_in(15e-3), &upward)?;
///     Ok::<_, softanvil_kernel::StepError>(state.scalars.metrics.peak_force)
/// })??;
/// assert!(held < free.scalars().metrics.peak_force);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
pub struct StateMemory<'a> {
    /// Place for the numbers that are not arrays: [`Scalars::BLANK`] will do.
    pub scalars: &'a mut Scalars,
    /// At least [`Size::state_nodes`] numbers.
    pub nodes: &'a mut [Real],
    /// At least [`Size::state_cells`] blocks.
    pub cells: &'a mut [CellHistory],
    /// At least [`Size::state_viscous`] blocks.
    pub viscous: &'a mut [Deviator],
}

impl StateMemory<'_> {
    /// The same memory, lent on for a while.
    pub fn lend(&mut self) -> StateMemory<'_> {
        StateMemory { scalars: self.scalars, nodes: self.nodes, cells: self.cells, viscous: self.viscous }
    }
}

/// The first `needed` items of `memory`.
#[inline(always)]
pub(crate) fn take<'a, T>(memory: &'a mut [T], needed: usize, what: &'static str) -> Result<&'a mut [T], MemoryError> {
    let given = memory.len();
    memory.get_mut(..needed).ok_or(MemoryError { what, given, needed })
}

/// Splits `n` numbers off the front of `memory`; none if it is too short, which [`take`] has excluded.
#[inline(always)]
pub(crate) fn split_row<'a>(memory: &mut &'a mut [Real], n: usize) -> Option<&'a mut [Real]> {
    let (row, rest) = core::mem::take(memory).split_at_mut_checked(n)?;
    *memory = rest;
    Some(row)
}
