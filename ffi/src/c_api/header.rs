//! What stands at the front of the memory of a simulation.

use softanvil_kernel::{Constants, Scalars};

/// Alignment of a block, bytes: what its numbers need, and what any allocator gives.
pub(crate) const ALIGNMENT: usize = align_of::<SoftanvilSimulation>();

/// Header and arrays begin at multiples of this, bytes, so that lanes of elements do not straddle cache lines in a block
/// that begins on one.
pub(crate) const GRANULE: usize = 64;

/// A simulation. Its content is private to the library; it lives at the front of the memory given to `softanvil_init`.
#[repr(C)]
pub struct SoftanvilSimulation {
    /// Tells that a simulation lives here; the first bytes, so that every version of the library finds it.
    pub(crate) marker: u64,
    /// Length of the block.
    pub(crate) bytes: usize,
    /// Scalar constants of the model.
    pub(crate) constants: Constants,
    /// Scalar numbers of the state.
    pub(crate) scalars: Scalars,
}

impl SoftanvilSimulation {
    /// "SOFTANV" and the version of the block's layout. The types of the kernel behind it are laid out as one build of the
    /// library has it: a block stays in its process.
    pub(crate) const MARKER: u64 = u64::from_le_bytes(*b"SOFTANV\x02");
}

const _: () = assert!(core::mem::offset_of!(SoftanvilSimulation, marker) == 0);
