//! The commands of `softanvil_golden::runner` on a Cortex-M7; the debugger or QEMU gives the command line and the files.

#![no_std]
#![no_main]

use core::ffi::CStr;
use core::fmt::Arguments;

use cortex_m::singleton;
use cortex_m_rt::entry;
use semihosting::experimental::env;
use semihosting::fs::{self, File};
use semihosting::io::Read;
use semihosting::println;
use softanvil_firmware::end;
use softanvil_golden::runner::{Host, Room, execute};

/// Bytes of the longest command line.
const LINE: usize = 1024;
/// Most words of a command line.
const WORDS: usize = 32;

struct Board;

impl Board {
    /// Does `work` with the name as C has it; none for names that are too long or hold a zero.
    fn named<R>(name: &str, work: impl FnOnce(&CStr) -> Option<R>) -> Option<R> {
        let mut bytes = [0; 256];
        bytes.get_mut(..name.len())?.copy_from_slice(name.as_bytes());
        work(CStr::from_bytes_until_nul(&bytes).ok().filter(|text| text.count_bytes() == name.len())?)
    }
}

impl Host for Board {
    fn line(&mut self, text: Arguments<'_>) {
        println!("{text}");
    }

    fn read(&mut self, name: &str, room: &mut [u8]) -> Option<usize> {
        Self::named(name, |name| {
            let mut file = File::open(name).ok()?;
            let mut length = 0;
            loop {
                match file.read(room.get_mut(length..).filter(|rest| !rest.is_empty())?).ok()? {
                    0 => return Some(length),
                    more => length += more,
                }
            }
        })
    }

    fn write(&mut self, name: &str, bytes: &[u8]) -> bool {
        Self::named(name, |name| fs::write(name, bytes).ok()).is_some()
    }
}

#[entry]
fn main() -> ! {
    let room = singleton!(: Room = Room::new()).unwrap();
    let arguments = env::args::<LINE>().unwrap();
    let mut words = [""; WORDS];
    let mut count = 0;
    // The first word is the name of the program.
    for (place, word) in words.iter_mut().zip((&arguments).skip(1)) {
        *place = word.unwrap();
        count += 1;
    }
    end(execute(words[..count].iter().copied(), &mut Board, room))
}
