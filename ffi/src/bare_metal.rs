//! What the static library needs in place of the standard library.

use core::panic::PanicInfo;

/// Where a panic would end. No function of the C ABI reaches it in a release build: the linker drops it.
#[panic_handler]
fn stop(_: &PanicInfo) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
