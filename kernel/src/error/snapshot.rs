//! Snapshots that are refused.

use thiserror::Error;

use super::memory::MemoryError;

/// Why a saved state was refused.
///
/// ```
/// use softanvil_kernel::{Simulation, SnapshotError, preset};
///
/// let saved = Simulation::new(&preset::study())?.save()?;
/// let mut heavier = preset::study();
/// heavier.impactor.mass = 6.0;
/// let mut other = Simulation::new(&heavier)?;
/// assert_eq!(other.restore(&saved), Err(SnapshotError::Foreign));
/// let (given, needed) = (saved.len() - 1, saved.len());
/// assert_eq!(other.restore(&saved[1..]), Err(SnapshotError::Length { given, needed }));
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SnapshotError {
    /// The buffer is not as long as the snapshot of this model.
    #[error("the snapshot buffer has {given} bytes: expected exactly {needed}")]
    Length {
        /// Bytes given.
        given: usize,
        /// Bytes needed.
        needed: usize,
    },
    /// The bytes are not a snapshot.
    #[error("the bytes are not a snapshot of this simulation")]
    Format,
    /// The snapshot was saved by a version of the library with another format.
    #[error("the snapshot has format version {given}: expected {expected}, the one of this library; save it anew")]
    Version {
        /// The version that the snapshot names.
        given: u64,
        /// The only version that is read.
        expected: u64,
    },
    /// The snapshot belongs to a different model.
    #[error("the snapshot belongs to a different model")]
    Foreign,
    /// The checksum does not match.
    #[error("the snapshot's checksum does not match its content")]
    Corrupt,
    /// The state has failed; there is nothing worth saving.
    #[error("the state has failed and cannot be saved: reset or restore it first")]
    Failed,
    /// There is too little memory.
    #[error(transparent)]
    Memory(#[from] MemoryError),
}
