//! The only place that touches what C hands over. Every function states what its caller must guarantee; what the
//! library can check itself (null, alignment, length, marker) comes back as a [`Failure`], never as a fault.
//!
//! What no library can check is the contract of the C ABI: a pointer that is neither null nor misaligned points to
//! memory of the stated type or length, alive, and used by no other thread during the call.

use core::ffi::c_char;
use core::marker::PhantomData;
use core::mem::MaybeUninit;
use core::ptr::NonNull;

use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::tensor::deviator::Deviator;

use crate::c_api::failure::Failure;
use crate::c_api::header::{ALIGNMENT, GRANULE, SoftanvilSimulation};
use crate::c_api::text::SOFTANVIL_NAME_SIZE;

/// Where one result goes. Writing is safe, because [`out`] has checked the pointer.
pub(crate) struct Out<'a, T> {
    pointer: NonNull<T>,
    memory: PhantomData<&'a mut T>,
}

impl<T> Out<'_, T> {
    /// Stores the result.
    pub(crate) fn write(self, value: T) {
        // SAFETY: `out`, `zeroed` and `Region` give only pointers that are aligned and valid for writes.
        unsafe { self.pointer.write(value) }
    }

    /// Stores the result and gives out its address.
    pub(crate) fn place(self, value: T) -> *mut T {
        let pointer = self.pointer.as_ptr();
        self.write(value);
        pointer
    }
}

fn checked<T>(pointer: *const T, argument: &'static str) -> Result<NonNull<T>, Failure> {
    let pointer = NonNull::new(pointer.cast_mut()).ok_or(Failure::Null { argument })?;
    if pointer.is_aligned() { Ok(pointer) } else { Err(Failure::Misaligned { argument, alignment: align_of::<T>() }) }
}

/// A place for a result.
///
/// # Safety
/// If `pointer` is neither null nor misaligned, it is valid for writes of a `T` for `'a`.
pub(crate) unsafe fn out<'a, T>(pointer: *mut T, argument: &'static str) -> Result<Out<'a, T>, Failure> {
    Ok(Out { pointer: checked(pointer, argument)?, memory: PhantomData })
}

/// A place for a result that the caller may not want.
///
/// # Safety
/// As [`out`].
pub(crate) unsafe fn optional_out<'a, T>(
    pointer: *mut T,
    argument: &'static str,
) -> Result<Option<Out<'a, T>>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's guarantee is the same.
    unsafe { out(pointer, argument) }.map(Some)
}

/// Something to read.
///
/// # Safety
/// If `pointer` is neither null nor misaligned, it points to a `T` that nobody writes for `'a`.
pub(crate) unsafe fn shared<'a, T>(pointer: *const T, argument: &'static str) -> Result<&'a T, Failure> {
    // SAFETY: not null, aligned, and by the caller's guarantee valid.
    checked(pointer, argument).map(|pointer| unsafe { pointer.as_ref() })
}

/// Something to read that the caller may not give.
///
/// # Safety
/// As [`shared`].
pub(crate) unsafe fn optional_shared<'a, T>(
    pointer: *const T,
    argument: &'static str,
) -> Result<Option<&'a T>, Failure> {
    if pointer.is_null() {
        return Ok(None);
    }
    // SAFETY: the caller's guarantee is the same.
    unsafe { shared(pointer, argument) }.map(Some)
}

/// Something to read and change.
///
/// # Safety
/// If `pointer` is neither null nor misaligned, it points to a `T` that nobody else uses for `'a`.
pub(crate) unsafe fn exclusive<'a, T>(pointer: *mut T, argument: &'static str) -> Result<&'a mut T, Failure> {
    // SAFETY: not null, aligned, and by the caller's guarantee valid and unshared.
    checked(pointer, argument).map(|mut pointer| unsafe { pointer.as_mut() })
}

/// Bytes to read.
///
/// # Safety
/// If `pointer` is not null, it points to `length` bytes that nobody writes for `'a`.
pub(crate) unsafe fn bytes<'a>(pointer: *const u8, length: usize, argument: &'static str) -> Result<&'a [u8], Failure> {
    let pointer = checked(pointer, argument)?;
    check_addressable(length, argument)?;
    // SAFETY: not null, bytes need no alignment, the length is addressable, and the caller guarantees the rest.
    Ok(unsafe { core::slice::from_raw_parts(pointer.as_ptr(), length) })
}

/// Room for bytes or numbers, in which nothing need stand yet.
///
/// # Safety
/// If `pointer` is neither null nor misaligned, it points to room for `count` items that nobody else uses for `'a`.
pub(crate) unsafe fn room<'a, T>(
    pointer: *mut T,
    count: usize,
    argument: &'static str,
) -> Result<&'a mut [MaybeUninit<T>], Failure> {
    let pointer = checked(pointer, argument)?;
    check_addressable(count.saturating_mul(size_of::<T>()), argument)?;
    // SAFETY: not null, aligned, the length is addressable, the caller guarantees the rest, and `MaybeUninit` asks nothing
    // of what stands there.
    Ok(unsafe { core::slice::from_raw_parts_mut(pointer.as_ptr().cast(), count) })
}

/// No object is longer than half the address space, whatever the caller says.
fn check_addressable(length: usize, argument: &'static str) -> Result<(), Failure> {
    if length <= isize::MAX as usize { Ok(()) } else { Err(Failure::Long { argument, given: length }) }
}

/// Longest name that [`name`] reads; no name in any table is longer.
pub(crate) const MAX_NAME: usize = SOFTANVIL_NAME_SIZE - 1;

/// A name handed over as a C string, without its end.
pub(crate) struct Name {
    bytes: [u8; MAX_NAME],
    length: usize,
}

impl Name {
    /// The text; empty, which no name is, if it is none.
    pub(crate) fn text(&self) -> &str {
        let bytes = self.bytes.get(..self.length).unwrap_or_default();
        core::str::from_utf8(bytes).unwrap_or_default()
    }
}

/// Copies a C string; what is longer than any name is no name, and is not read further.
///
/// # Safety
/// If `pointer` is not null, it points to bytes that end with a NUL, or of which there are more than [`MAX_NAME`].
pub(crate) unsafe fn name(pointer: *const c_char, argument: &'static str) -> Result<Name, Failure> {
    let pointer = checked(pointer, argument)?.cast::<u8>();
    let mut name = Name { bytes: [0; MAX_NAME], length: 0 };
    for (i, byte) in name.bytes.iter_mut().enumerate() {
        // SAFETY: every byte before was not the NUL, so by the caller's guarantee this one exists.
        *byte = unsafe { pointer.add(i).read() };
        if *byte == 0 {
            name.length = i;
            return Ok(name);
        }
    }
    Err(Failure::UnknownName { argument })
}

/// Types for which any bytes are a value, so that zeroed memory holds them.
///
/// # Safety
/// The type consists of numbers only.
pub(crate) unsafe trait Plain: Copy {}
// SAFETY: a number.
unsafe impl Plain for f64 {}
// SAFETY: arrays of f64 and nothing else.
unsafe impl Plain for CellConstants {}
// SAFETY: arrays of f64 and nothing else.
unsafe impl Plain for HoopConstants {}
// SAFETY: arrays of f64 and nothing else.
unsafe impl Plain for CellHistory {}
// SAFETY: arrays of f64 and nothing else.
unsafe impl Plain for Deviator {}

/// Initialised memory that begins at a multiple of [`ALIGNMENT`] and is cut into pieces from the front. It holds addresses
/// only while a call lasts, so the memory itself may be moved between calls.
pub(crate) struct Region<'a> {
    start: NonNull<u8>,
    length: usize,
    memory: PhantomData<&'a mut [u8]>,
}

impl<'a> Region<'a> {
    /// Cuts off `count` items and the padding up to a whole [`GRANULE`], so that what is left begins as aligned as the
    /// region. None if the region is too short.
    #[inline(always)]
    fn piece<T>(&mut self, count: usize) -> Option<NonNull<T>> {
        const { assert!(align_of::<T>() <= ALIGNMENT && GRANULE.is_multiple_of(ALIGNMENT)) };
        let bytes = padded::<T>(count)?;
        let rest = self.length.checked_sub(bytes)?;
        let piece = self.start.cast();
        // SAFETY: `bytes` is at most the length of the region, so the sum stays within it or at its end.
        self.start = unsafe { self.start.add(bytes) };
        self.length = rest;
        Some(piece)
    }

    /// Cuts off `count` items, padded.
    #[inline(always)]
    pub(crate) fn take<T: Plain>(&mut self, count: usize) -> Option<&'a mut [T]> {
        let piece = self.piece::<T>(count)?;
        // SAFETY: aligned; `count` items fit into the piece; it is initialised and `T` is plain; it was cut off, so no
        // other piece overlaps it; and it lives as long as the region's memory.
        Some(unsafe { core::slice::from_raw_parts_mut(piece.as_ptr(), count) })
    }

    /// Cuts off the place of one `T`, padded as in [`Region::take`].
    pub(crate) fn slot<T>(&mut self) -> Option<Out<'a, T>> {
        Some(Out { pointer: self.piece(1)?, memory: PhantomData })
    }
}

/// A [`Region`] that is only read.
pub(crate) struct SharedRegion<'a>(Region<'a>);

impl<'a> SharedRegion<'a> {
    /// Cuts off `count` items, padded.
    pub(crate) fn take<T: Plain>(&mut self, count: usize) -> Option<&'a [T]> {
        let piece = self.0.piece::<T>(count)?;
        // SAFETY: as `Region::take`; nobody writes the memory while the region lives.
        Some(unsafe { core::slice::from_raw_parts(piece.as_ptr(), count) })
    }
}

/// Bytes of `count` items, rounded up to whole [`GRANULE`]s.
#[inline(always)]
pub(crate) const fn padded<T>(count: usize) -> Option<usize> {
    match count.checked_mul(size_of::<T>()) {
        Some(bytes) => bytes.checked_next_multiple_of(GRANULE),
        None => None,
    }
}

/// The first `needed` bytes of memory that C lends, set to zero.
///
/// # Safety
/// If `pointer` is not null, it points to `length` bytes that nobody else uses for `'a`.
pub(crate) unsafe fn zeroed<'a>(pointer: *mut u8, length: usize, needed: usize) -> Result<Region<'a>, Failure> {
    const ARGUMENT: &str = "memory";
    let start = checked(pointer, ARGUMENT)?;
    if !start.addr().get().is_multiple_of(ALIGNMENT) {
        return Err(Failure::Misaligned { argument: ARGUMENT, alignment: ALIGNMENT });
    }
    if length < needed {
        return Err(Failure::Short { argument: ARGUMENT, given: length, needed });
    }
    check_addressable(needed, ARGUMENT)?;
    // SAFETY: `needed` is at most `length`, which the caller guarantees.
    unsafe { start.write_bytes(0, needed) };
    Ok(Region { start, length: needed, memory: PhantomData })
}

/// The header of an initialised simulation.
///
/// # Safety
/// If `pointer` is neither null nor misaligned, it points to readable memory of at least a header, which nobody writes
/// for `'a` and whose content, if the marker is right, is what the library wrote.
pub(crate) unsafe fn header<'a>(pointer: *const SoftanvilSimulation) -> Result<&'a SoftanvilSimulation, Failure> {
    const ARGUMENT: &str = "simulation";
    let header = checked(pointer, ARGUMENT)?;
    // SAFETY: the marker is a number inside the memory that the caller guarantees; no reference is made before it is
    // known to be right.
    if unsafe { (&raw const (*header.as_ptr()).marker).read() } != SoftanvilSimulation::MARKER {
        return Err(Failure::Uninitialised { argument: ARGUMENT });
    }
    // SAFETY: not null, aligned, and the marker says that a header was written here.
    Ok(unsafe { header.as_ref() })
}

/// The header of an initialised simulation, and the rest of its block.
///
/// # Safety
/// As [`fn@header`], but for the whole block, and nobody else uses it for `'a`.
#[inline(always)]
pub(crate) unsafe fn block<'a>(
    pointer: *mut SoftanvilSimulation,
) -> Result<(&'a mut SoftanvilSimulation, Region<'a>), Failure> {
    // SAFETY: the caller guarantees more.
    let length = unsafe { header(pointer) }?.bytes;
    let mut start = checked(pointer, "simulation")?;
    let mut region = Region { start: start.cast(), length, memory: PhantomData };
    region.slot::<SoftanvilSimulation>().ok_or(Failure::Uninitialised { argument: "simulation" })?;
    // SAFETY: `header` has accepted it; the region no longer covers it; and nobody else uses it.
    Ok((unsafe { start.as_mut() }, region))
}

/// The header of an initialised simulation, and the rest of its block, to be read.
///
/// # Safety
/// As [`fn@header`], but for the whole block.
pub(crate) unsafe fn shared_block<'a>(
    pointer: *const SoftanvilSimulation,
) -> Result<(&'a SoftanvilSimulation, SharedRegion<'a>), Failure> {
    // SAFETY: the caller guarantees more.
    let header = unsafe { header(pointer) }?;
    let start = checked(pointer, "simulation")?.cast();
    let mut region = Region { start, length: header.bytes, memory: PhantomData };
    region.slot::<SoftanvilSimulation>().ok_or(Failure::Uninitialised { argument: "simulation" })?;
    Ok((header, SharedRegion(region)))
}
