//! What is the board's, apart from the simulation: console, end of the program, counter of instructions, use of memory.
//! All of it but the stack paint is for QEMU or a debugger (semihosting): replace it by what your board has.

#![no_std]

pub mod anvil;

use core::panic::PanicInfo;

use cortex_m::peripheral::{SYST, syst::SystClkSource};
use cortex_m_rt::STACK_PAINT_VALUE;
use semihosting::experimental::env;
use semihosting::{println, process};

/// Instructions per tick of the counter under QEMU with `-icount shift=0`, where an instruction takes 1 ns and the
/// processor's clock is 25 MHz. On a board a tick is a cycle of the processor.
pub const INSTRUCTIONS_PER_TICK: u32 = 40;

/// Ends the program and QEMU.
pub fn end(success: bool) -> ! {
    process::exit(i32::from(!success))
}

/// The number that follows the program's name on the command line, which QEMU or a debugger gives.
pub fn argument() -> Option<u64> {
    let arguments = env::args::<256>().ok()?;
    (&arguments).nth(1)?.ok()?.parse().ok()
}

#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    println!("{info}");
    end(false)
}

/// Counts ticks of the processor's clock between readings that are less than 2^24 ticks apart.
pub struct Counter {
    timer: SYST,
    last: u32,
}

impl Counter {
    /// Starts to count.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(SysTick::MASK);
        timer.clear_current();
        timer.enable_counter();
        Self { timer, last: 0 }
    }

    /// Ticks since the last call.
    pub fn ticks(&mut self) -> u32 {
        let _ = &self.timer;
        let now = SYST::get_current();
        let ticks = self.last.wrapping_sub(now) & SysTick::MASK;
        self.last = now;
        ticks
    }
}

/// The timer has 24 bits.
struct SysTick;

impl SysTick {
    const MASK: u32 = 0x00ff_ffff;
}

unsafe extern "C" {
    static __vector_table: u32;
    static __veneer_limit: u32;
    static __sdata: u32;
    static __edata: u32;
    static __sbss: u32;
    static __ebss: u32;
    static _stack_end: u32;
    static _stack_start: u32;
}

/// Distance between two symbols of the linker script, bytes.
fn between(start: *const u32, end: *const u32) -> usize {
    end.addr() - start.addr()
}

/// Bytes of flash: code, constants and initial values.
pub fn flash() -> usize {
    between(&raw const __vector_table, &raw const __veneer_limit) + between(&raw const __sdata, &raw const __edata)
}

/// Bytes of RAM that are taken before the program starts.
pub fn static_ram() -> usize {
    between(&raw const __sdata, &raw const __edata) + between(&raw const __sbss, &raw const __ebss)
}

/// Most bytes of stack that the program has used so far, from the paint that is left.
pub fn stack_high_water() -> usize {
    let (end, start) = (&raw const _stack_end, &raw const _stack_start);
    let words = between(end, start) / size_of::<u32>();
    // SAFETY: the words between the symbols are the stack, which the start-up code has painted; below the current frame
    // nobody writes while they are read.
    let untouched = (0..words).take_while(|i| unsafe { end.add(*i).read_volatile() } == STACK_PAINT_VALUE).count();
    (words - untouched) * size_of::<u32>()
}
