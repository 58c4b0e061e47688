//! Memory that the caller lends to a model.

use crate::element::{CellConstants, HoopConstants};
use crate::error::{MemoryError, ModelError};
use crate::model::{Constants, Size};
use crate::number::real::Real;

/// Memory lent to a model while it is built.
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
