//! Memory that the caller lends to a model.

use crate::element::{CellConstants, HoopConstants};
use crate::error::{MemoryError, ModelError};
use crate::model::{Constants, Size};
use crate::number::real::Real;

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
