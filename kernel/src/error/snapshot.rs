//! Snapshots that are refused.

use core::fmt;

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SnapshotError {
    /// The buffer is not as long as the snapshot of this model.
    Length {
        /// Bytes given.
        given: usize,
        /// Bytes needed.
        needed: usize,
    },
    /// The bytes are not a snapshot of this format version.
    Format,
    /// The snapshot belongs to a different model.
    Foreign,
    /// The checksum does not match.
    Corrupt,
    /// The state has failed; there is nothing worth saving.
    Failed,
    /// There is too little memory.
    Memory(MemoryError),
}

impl From<MemoryError> for SnapshotError {
    fn from(error: MemoryError) -> Self {
        Self::Memory(error)
    }
}

impl fmt::Display for SnapshotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { given, needed } => {
                write!(f, "the snapshot buffer has {given} bytes: legal is exactly {needed}")
            }
            Self::Format => f.write_str("the bytes are not a snapshot of this version"),
            Self::Foreign => f.write_str("the snapshot belongs to a different model"),
            Self::Corrupt => f.write_str("the snapshot's checksum does not match its content"),
            Self::Failed => f.write_str("the state has failed and cannot be saved: reset or restore it first"),
            Self::Memory(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for SnapshotError {}
