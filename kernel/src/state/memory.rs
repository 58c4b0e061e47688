//! Memory that the caller lends to a state.

use crate::element::CellHistory;
use crate::number::real::Real;
use crate::state::Scalars;
use crate::tensor::deviator::Deviator;

/// Memory lent to a state for its lifetime, or to a model while it is built.
///
/// ```
/// use softanvil_kernel::element::CellHistory;
/// use softanvil_kernel::tensor::deviator::Deviator;
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
    /// At least [`crate::Size::state_nodes`] numbers.
    pub nodes: &'a mut [Real],
    /// At least [`crate::Size::state_cells`] blocks.
    pub cells: &'a mut [CellHistory],
    /// At least [`crate::Size::state_viscous`] blocks.
    pub viscous: &'a mut [Deviator],
}

impl StateMemory<'_> {
    /// The same memory, lent on for a while.
    pub fn lend(&mut self) -> StateMemory<'_> {
        StateMemory { scalars: self.scalars, nodes: self.nodes, cells: self.cells, viscous: self.viscous }
    }
}
