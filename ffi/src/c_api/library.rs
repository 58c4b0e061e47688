//! Library

use core::ffi::{CStr, c_char};

use softanvil_kernel::KERNEL_DIGEST;

use crate::c_api::status::SoftanvilStatus;

/// Version of the library that is running, to be compared with `SOFTANVIL_VERSION` of the header: an equal major number
/// (while it is 0: an equal minor number too) promises that the two fit together.
///
/// @return `SOFTANVIL_VERSION` of the library: major * 1000000 + minor * 1000 + patch.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_version() -> u32 {
    VERSION
}

/// Version of the library that is running, as text.
///
/// @return A static string such as "1.2.3".
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_version_text() -> *const c_char {
    const TEXT: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
        Ok(text) => text,
        Err(_) => panic!("the version holds a NUL"),
    };
    TEXT.as_ptr()
}

/// Digest of what the kernel computes: that of the last states of its golden traces, which `softanvil golden check` computes anew
/// on any machine. Libraries with the same digest give the same bits, whatever their version and target.
///
/// @return 64 bits, which packages state as 16 hexadecimal digits.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_kernel_digest() -> u64 {
    KERNEL_DIGEST
}

/// What a status means, in general. `SoftanvilError` says more about one failure.
///
/// @param status A `SoftanvilStatus`, or any other number.
/// @return A static string; "unknown status" for an unknown number.
#[unsafe(no_mangle)]
pub extern "C" fn softanvil_status_text(status: i32) -> *const c_char {
    let known = SoftanvilStatus::ALL.iter().find(|known| **known as i32 == status);
    known.map_or(c"unknown status", |known| known.text()).as_ptr()
}

/// The packed version.
const VERSION: u32 = number(env!("CARGO_PKG_VERSION_MAJOR")) * 1_000_000
    + number(env!("CARGO_PKG_VERSION_MINOR")) * 1_000
    + number(env!("CARGO_PKG_VERSION_PATCH"));

/// A decimal number; anything else stops the compiler.
const fn number(text: &str) -> u32 {
    match u32::from_str_radix(text, 10) {
        Ok(number) => number,
        Err(_) => panic!("the version is not made of numbers"),
    }
}
