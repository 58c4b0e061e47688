//! Too little memory.

use core::fmt;

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemoryError {
    /// What the memory is for.
    pub what: &'static str,
    /// Items given.
    pub given: usize,
    /// Items needed.
    pub needed: usize,
}

impl fmt::Display for MemoryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, given, needed } = self;
        write!(f, "memory for {what} holds {given} items: legal is at least {needed}")
    }
}

impl core::error::Error for MemoryError {}
