//! The pointers of the FMI functions: the only unsafe code of the FMI side.
//!
//! The types stand in the signatures of the exported functions in place of bare pointers. Only C makes their values, and
//! what it promises by the standard is what makes the blocks here sound: a pointer is null (which is checked) or points
//! to as many items as the call says, and nobody else uses an instance during a call on it. Whether a pointer that is
//! not null is stale no library can tell.

use alloc::alloc::{Layout, alloc};
use alloc::boxed::Box;
use core::ffi::{CStr, c_char};
use core::mem::MaybeUninit;
use core::slice;

/// Whether a slice of `n` items may start at `pointer`.
fn is_slice<T>(pointer: *const T, n: usize) -> bool {
    let fits = n.checked_mul(size_of::<T>()).is_some_and(|bytes| bytes <= isize::MAX as usize);
    fits && !pointer.is_null() && pointer.is_aligned()
}

/// Items to read.
#[repr(transparent)]
pub struct Array<T>(*const T);

impl<T: Copy> Array<T> {
    /// The `n` items; none if there should be some and the pointer is null or misaligned.
    pub fn items(&self, n: usize) -> Option<&[T]> {
        if n == 0 {
            return Some(&[]);
        }
        // SAFETY: not null, aligned, of a possible size; the master promises `n` items for the time of the call.
        is_slice(self.0, n).then(|| unsafe { slice::from_raw_parts(self.0, n) })
    }
}

/// Room for results.
#[repr(transparent)]
pub struct Room<T>(*mut T);

impl<T: Copy> Room<T> {
    /// The room for `n` results; none if there should be some and the pointer is null or misaligned.
    pub fn items(&mut self, n: usize) -> Option<&mut [MaybeUninit<T>]> {
        if n == 0 {
            return Some(&mut []);
        }
        // SAFETY: not null, aligned, of a possible size; the master promises room for `n` items for the time of the
        // call, and `MaybeUninit` asks nothing of what stands there.
        is_slice(self.0, n).then(|| unsafe { slice::from_raw_parts_mut(self.0.cast::<MaybeUninit<T>>(), n) })
    }

    /// The room for a single result.
    pub fn item(&mut self) -> Option<&mut MaybeUninit<T>> {
        self.items(1)?.first_mut()
    }
}

/// A text that C ended with a zero.
#[repr(transparent)]
#[derive(Clone, Copy)]
pub struct Text(*const c_char);

impl Text {
    /// The text; none if the pointer is null.
    pub fn get(&self) -> Option<&CStr> {
        // SAFETY: not null; the master promises a text that ends with a zero for the time of the call.
        (!self.0.is_null()).then(|| unsafe { CStr::from_ptr(self.0) })
    }
}

/// An object of ours that the master holds, or null.
#[repr(transparent)]
pub struct Handle<T>(*mut T);

impl<T> Handle<T> {
    /// No object.
    pub const NULL: Self = Self(core::ptr::null_mut());

    /// Hands an object to the master; none if the heap has no room for it.
    pub fn new(object: T) -> Option<Self> {
        const { assert!(size_of::<T>() > 0) };
        // SAFETY: the layout has a size.
        let place = unsafe { alloc(Layout::new::<T>()) }.cast::<T>();
        if place.is_null() {
            return None;
        }
        // SAFETY: fresh memory of the layout of `T`.
        unsafe { place.write(object) };
        Some(Self(place))
    }

    /// The object; none if the handle is null.
    pub fn get(&mut self) -> Option<&mut T> {
        // SAFETY: null, or made by `new` and not yet freed; the master uses an object in one call at a time.
        unsafe { self.0.as_mut() }
    }

    /// Puts `object` into the handle, in place of the one that it holds, if any; none if the heap has no room for it.
    pub fn put(&mut self, object: T) -> Option<()> {
        match self.get() {
            Some(place) => *place = object,
            None => *self = Self::new(object)?,
        }
        Some(())
    }

    /// Takes the object back and frees it; the handle is null then.
    pub fn free(&mut self) {
        if !self.0.is_null() {
            // SAFETY: `new` allocated it as a box does, and it is not yet freed, as the master promises.
            drop(unsafe { Box::from_raw(self.0) });
            *self = Self::NULL;
        }
    }
}

/// A place where the master keeps a handle.
#[repr(transparent)]
pub struct Slot<T>(*mut Handle<T>);

impl<T> Slot<T> {
    /// The handle in its place; none if there is no place.
    pub fn get(&mut self) -> Option<&mut Handle<T>> {
        if self.0.is_null() || !self.0.is_aligned() {
            return None;
        }
        // SAFETY: not null and aligned; the standard asks for a handle there, null at first.
        unsafe { self.0.as_mut() }
    }
}

/// A structure that the master fills.
#[repr(transparent)]
pub struct Given<T>(*const T);

impl<T: Copy> Given<T> {
    /// A copy of the structure; none if the pointer is null or misaligned.
    pub fn get(&self) -> Option<T> {
        // SAFETY: not null and aligned; the master promises the structure for the time of the call.
        is_slice(self.0, 1).then(|| unsafe { *self.0 })
    }
}
