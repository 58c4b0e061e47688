//! What the binary of an FMU has in place of the standard library, so that it needs nothing but the C library: the C
//! heap, and an end for panics. Memory that the heap refuses is an error (`tests/fmi/memory.c`); what is left is what `core`
//! and `alloc` check of themselves when they print numbers, sort and fill reserved memory (`tests/fmi/binary.sh`).

use core::alloc::{GlobalAlloc, Layout};
use core::ffi::c_void;
use core::ptr::null_mut;

unsafe extern "C" {
    fn malloc(size: usize) -> *mut c_void;
    fn free(pointer: *mut c_void);
    fn abort() -> !;
}

/// Alignment that `malloc` gives on every supported platform, bytes.
const MALLOC_ALIGNMENT: usize = 16;

/// A cache line, bytes. The arrays of a simulation begin on one: its lanes are as long, and steps are some per cents slower
/// where they lie across two.
const LINE: usize = 64;

/// The alignment with which a block of `layout` is made, bytes.
fn alignment(layout: Layout) -> usize {
    if layout.size() < LINE { layout.align() } else { layout.align().max(LINE) }
}

/// The C heap. Blocks of a larger alignment than `malloc` gives carry the address of their allocation in front.
struct Heap;

// SAFETY: every block comes from `malloc` with room for the layout, begins at a multiple of its alignment, and is handed
// back as the address that `malloc` gave.
unsafe impl GlobalAlloc for Heap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let alignment = alignment(layout);
        if alignment <= MALLOC_ALIGNMENT {
            // SAFETY: any size is legal.
            return unsafe { malloc(layout.size()) }.cast();
        }
        let Some(size) = layout.size().checked_add(alignment + size_of::<*mut c_void>()) else {
            return null_mut();
        };
        // SAFETY: any size is legal.
        let base = unsafe { malloc(size) }.cast::<u8>();
        if base.is_null() {
            return base;
        }
        let first = base.wrapping_add(size_of::<*mut c_void>());
        let block = first.wrapping_add(first.align_offset(alignment));
        // SAFETY: the alignment is at least that of a pointer and the block begins at least a pointer after the base, so
        // the place before it is aligned and inside.
        unsafe { block.cast::<*mut u8>().sub(1).write(base) };
        block
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        let base = match alignment(layout) <= MALLOC_ALIGNMENT {
            true => pointer,
            // SAFETY: `alloc` wrote it there.
            false => unsafe { pointer.cast::<*mut u8>().sub(1).read() },
        };
        // SAFETY: `malloc` gave it, and the caller gives it back once.
        unsafe { free(base.cast()) };
    }
}

#[global_allocator]
static HEAP: Heap = Heap;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: it asks for nothing.
    unsafe { abort() }
}

// The libraries `core` and `alloc` are compiled with tables for unwinding, which name these two. Nothing unwinds, so they
// are traps; hidden, because an FMU exports nothing but the functions of the standard (Windows exports what is listed).
macro_rules! trap {
    ($symbol:literal) => {
        #[cfg(target_os = "linux")]
        core::arch::global_asm!(concat!(".hidden ", $symbol));
        #[cfg(target_arch = "x86_64")]
        core::arch::global_asm!(concat!(".globl ", $symbol), concat!($symbol, ":"), "ud2");
        #[cfg(target_arch = "aarch64")]
        core::arch::global_asm!(concat!(".globl ", $symbol), concat!($symbol, ":"), "brk #1");
    };
}
trap!("rust_eh_personality");
#[cfg(target_os = "linux")]
trap!("_Unwind_Resume");
