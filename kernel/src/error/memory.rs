//! Too little memory.

use thiserror::Error;

/// The memory given is smaller than [`crate::model::Size`] says.
///
/// ```
/// use softanvil_kernel::{MemoryError, Scalars, Simulation, StateContent, StateView, preset};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// let needed = anvil.constants().size.state_nodes;
/// let scalars = *anvil.scalars();
/// let short = StateContent { nodes: &[0.0; 100], cells: &[], viscous: &[] };
/// let refused = anvil.with(|model, _| StateView::new(model, &scalars, short).err())?;
/// assert_eq!(refused, Some(MemoryError { what: "state nodes", given: 100, needed }));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("memory for {what} holds {given} items: expected at least {needed}")]
pub struct MemoryError {
    /// What the memory is for.
    pub what: &'static str,
    /// Items given.
    pub given: usize,
    /// Items needed.
    pub needed: usize,
}
