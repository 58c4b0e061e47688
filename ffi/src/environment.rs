//! The floating-point environment of the calling thread: set to the default for the time of a call, and put back.
//!
//! The numbers of the kernel hold for rounding to nearest with denormals kept and no exception trapped, which is what
//! IEEE 754 and C start with. A host may have changed it: audio and game code switches on flush-to-zero, interval
//! arithmetic changes the rounding, debugging traps exceptions. [`neutral`] makes that harmless for one call.
//!
//! | target | register | what is neutralised |
//! |---|---|---|
//! | x86, x86-64 | MXCSR | rounding, flush-to-zero, denormals-are-zero, unmasked exceptions |
//! | aarch64 | FPCR | rounding, flush-to-zero, default NaN, alternate handling, traps |
//! | arm with an FPU in its ABI | FPSCR | rounding, flush-to-zero, default NaN |
//! | riscv with an FPU | frm | rounding (there is no flush-to-zero) |
//! | wasm, soft float | none | nothing: the environment cannot be changed |
//!
//! On every other target the host must keep the default environment.

/// Does `work` in the default environment. In the default environment, which is the usual case, it costs the reading of
/// one register.
///
/// Calls back into the host that `work` makes find the default environment too.
#[inline(always)]
pub fn neutral<R>(work: impl FnOnce() -> R) -> R {
    let found = control::read();
    if control::is_default(found) {
        return apart(work);
    }
    control::write(control::DEFAULT);
    let result = apart(work);
    control::write(found);
    result
}

/// Keeps the arithmetic of `work` behind a call, so that the compiler, which knows nothing of environments, moves none of
/// it past the change of the register.
#[inline(never)]
fn apart<R>(work: impl FnOnce() -> R) -> R {
    work()
}

// Miri interprets no assembly; it runs what remains in the environment that it has.
#[cfg(all(any(target_arch = "x86_64", target_arch = "x86"), not(miri)))]
mod control {
    use core::arch::asm;

    /// All exceptions masked, rounding to nearest, denormals kept, no flag raised.
    pub(super) const DEFAULT: u32 = 0x1f80;
    /// The bits that are flags: they record what happened and change nothing.
    const FLAGS: u32 = 0x3f;

    pub(super) fn is_default(control: u32) -> bool {
        control & !FLAGS == DEFAULT
    }

    pub(super) fn read() -> u32 {
        let mut control = 0_u32;
        // SAFETY: stores the 32 bits of MXCSR at the address of `control`, and does nothing else.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut control, options(nostack, preserves_flags)) };
        control
    }

    pub(super) fn write(control: u32) {
        // SAFETY: loads MXCSR with a value that is the default or was read from it, so no reserved bit is set. The caller
        // puts back what it found before Rust code of anyone else runs.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const control, options(nostack, preserves_flags)) };
    }
}

#[cfg(target_arch = "aarch64")]
mod control {
    use core::arch::asm;

    /// Rounding to nearest, denormals kept, nothing trapped.
    pub(super) const DEFAULT: u64 = 0;

    pub(super) fn is_default(control: u64) -> bool {
        control == DEFAULT
    }

    pub(super) fn read() -> u64 {
        let control;
        // SAFETY: reads FPCR, which any program may.
        unsafe { asm!("mrs {}, fpcr", out(reg) control, options(nostack, preserves_flags)) };
        control
    }

    pub(super) fn write(control: u64) {
        // SAFETY: sets FPCR to the default or to what was read from it; the caller puts back what it found.
        unsafe { asm!("msr fpcr, {}", in(reg) control, options(nostack, preserves_flags)) };
    }
}

#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
mod control {
    use core::arch::asm;

    /// Rounding to nearest, denormals kept, nothing trapped, no flag raised.
    pub(super) const DEFAULT: u32 = 0;
    /// Condition and exception flags, which record what happened and change nothing.
    const FLAGS: u32 = 0xf800_009f;

    pub(super) fn is_default(control: u32) -> bool {
        control & !FLAGS == DEFAULT
    }

    pub(super) fn read() -> u32 {
        let control;
        // SAFETY: reads FPSCR; the ABI has an FPU.
        unsafe { asm!("vmrs {}, fpscr", out(reg) control, options(nostack, preserves_flags)) };
        control
    }

    pub(super) fn write(control: u32) {
        // SAFETY: sets FPSCR to the default or to what was read from it; the caller puts back what it found.
        unsafe { asm!("vmsr fpscr, {}", in(reg) control, options(nostack)) };
    }
}

#[cfg(all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "f"))]
mod control {
    use core::arch::asm;

    /// Rounding to nearest, ties to even.
    pub(super) const DEFAULT: usize = 0;

    pub(super) fn is_default(control: usize) -> bool {
        control == DEFAULT
    }

    pub(super) fn read() -> usize {
        let control;
        // SAFETY: reads the rounding mode; the target has an FPU.
        unsafe { asm!("frrm {}", out(reg) control, options(nostack, preserves_flags)) };
        control
    }

    pub(super) fn write(control: usize) {
        // SAFETY: sets the rounding mode to the default or to what was read; the caller puts back what it found.
        unsafe { asm!("fsrm {}", in(reg) control, options(nostack, preserves_flags)) };
    }
}

#[cfg(not(any(
    all(any(target_arch = "x86_64", target_arch = "x86"), not(miri)),
    target_arch = "aarch64",
    all(target_arch = "arm", target_abi = "eabihf"),
    all(any(target_arch = "riscv32", target_arch = "riscv64"), target_feature = "f")
)))]
mod control {
    pub(super) const DEFAULT: () = ();

    pub(super) fn is_default((): ()) -> bool {
        true
    }

    pub(super) fn read() {}

    pub(super) fn write((): ()) {}
}

#[cfg(all(test, target_arch = "x86_64", not(miri)))]
mod tests;
