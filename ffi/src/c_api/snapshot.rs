//! Snapshot

use softanvil_kernel::state::{restore, snapshot_size, write_words};

use crate::c_api::error::{SoftanvilError, report, status};
use crate::c_api::failure::Failure;
use crate::c_api::header::SoftanvilSimulation;
use crate::c_api::status::SoftanvilStatus;
use crate::c_api::{block, ptr};

/// Tells how long a snapshot of a simulation is.
///
/// @param simulation The simulation.
/// @param size Bytes.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_snapshot_size(
    simulation: *const SoftanvilSimulation,
    size: *mut usize,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (header, size) = unsafe { (ptr::header(simulation), ptr::out(size, "size")) };
    status(|| {
        let (header, size) = (header?, size?);
        size.write(snapshot_size(&header.constants));
        Ok(())
    })
}

/// Saves the state of a simulation. The bytes mean the same on every machine; equal states give equal bytes.
///
/// @param simulation The simulation.
/// @param bytes Where the snapshot goes.
/// @param size Bytes there, at least those of `softanvil_snapshot_size`; the rest stays untouched.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, SNAPSHOT_FAILED.
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_snapshot_save(
    simulation: *const SoftanvilSimulation,
    bytes: *mut u8,
    size: usize,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (block, error) = unsafe { (ptr::shared_block(simulation), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let bytes = unsafe { ptr::room(bytes, size, "bytes") };
    report(error, || {
        let (block, bytes) = (block?, bytes?);
        let (given, needed) = (bytes.len(), snapshot_size(&block.0.constants));
        let bytes = bytes.get_mut(..needed).ok_or(Failure::Short { argument: "bytes", given, needed })?;
        let mut places = bytes.iter_mut();
        let mut put = |word: u64| {
            word.to_le_bytes().iter().zip(&mut places).for_each(|(byte, place)| {
                place.write(*byte);
            })
        };
        block::look(block, |model, state| write_words(model, state, &mut put).map_err(Failure::from))
    })
}

/// Restores the state of a simulation from a snapshot of the same scenario, whichever machine saved it. What follows
/// has the same bits as if nothing had been saved. A snapshot that is refused changes nothing.
///
/// The checksum finds damage, not malice: restore only what comes from a trusted place.
///
/// @param simulation The simulation, which may have failed.
/// @param bytes The snapshot.
/// @param size Bytes of it, at least those of `softanvil_snapshot_size`; the rest is not read.
/// @param error Details of a failure, or NULL.
/// @return NULL_POINTER, MISALIGNED, UNINITIALISED, SHORT_BUFFER, or a status of a snapshot (400 to 499).
///
/// # Safety
/// The conventions of the header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn softanvil_snapshot_restore(
    simulation: *mut SoftanvilSimulation,
    bytes: *const u8,
    size: usize,
    error: *mut SoftanvilError,
) -> SoftanvilStatus {
    // SAFETY: C keeps the conventions of the header.
    let (block, error) = unsafe { (ptr::block(simulation), ptr::optional_out(error, "error")) };
    // SAFETY: as above.
    let bytes = unsafe { ptr::bytes(bytes, size, "bytes") };
    report(error, || {
        let (block, bytes) = (block?, bytes?);
        let (given, needed) = (bytes.len(), snapshot_size(&block.0.constants));
        // Fewer bytes are refused by the kernel, which tells a snapshot of another version from one that is cut.
        let bytes = &bytes[..given.min(needed)];
        block::with(block, |model, state| restore(model, state, bytes).map_err(Failure::from))
    })
}
