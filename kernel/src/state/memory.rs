//! Memory that the caller lends to a state.

use crate::element::CellHistory;
use crate::number::real::Real;
use crate::state::Scalars;
use crate::tensor::deviator::Deviator;

/// Memory lent to a state for its lifetime, or to a model while it is built.
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
