//! With a look at the register of their own. The environment is that of the test's thread, which gets the default back.

use core::arch::asm;

use super::neutral;

fn environment() -> u32 {
    let mut control = 0_u32;
    // SAFETY: stores the 32 bits of MXCSR at the address of `control`.
    unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut control, options(nostack)) };
    control
}

/// # Safety
/// No arithmetic may raise what `control` does not mask.
unsafe fn set(control: u32) {
    // SAFETY: the callers set bits alone that the processor knows.
    unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const control, options(nostack)) };
}

#[test]
fn whatever_the_host_has_set_work_is_done_in_the_default_environment_and_it_finds_its_own_again() {
    // Rounding down, up and to zero; flush to zero, denormals as zero; nothing masked; with flags raised.
    for host in [0x3f80, 0x5f80, 0x7f80, 0x9f80, 0x1fc0, 0xffe1, 0x0000, 0x1f00] {
        // SAFETY: nothing is computed until the default environment is back.
        let (during, after) = unsafe {
            set(host);
            let during = neutral(environment);
            let after = environment();
            set(0x1f80);
            (during, after)
        };
        assert_eq!((during, after), (0x1f80, host), "{host:x}");
    }
}

#[test]
fn in_the_default_environment_the_register_is_left_alone() {
    for host in [0x1f80, 0x1f81, 0x1fbf] {
        // SAFETY: the default environment, with flags.
        let (during, after) = unsafe {
            set(host);
            (neutral(environment), environment())
        };
        assert_eq!((during, after), (host, host), "{host:x}");
    }
}

#[test]
fn what_work_finds_is_handed_on() {
    assert_eq!(neutral(|| 7), 7);
    // SAFETY: nothing is computed until the default environment is back.
    let found = unsafe {
        set(0x7f80);
        let found = neutral(|| 8);
        set(0x1f80);
        found
    };
    assert_eq!(found, 8);
}
