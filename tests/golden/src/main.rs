//! The commands of [`softanvil_golden::runner`] on targets with a standard library; `--threads N` in front runs the
//! command in N threads at once, which all must succeed.

use std::fmt::Arguments;
use std::process::ExitCode;

#[cfg(feature = "single")]
use softanvil_golden_f32 as softanvil_golden;

use softanvil_golden::runner::{Host, Room, execute};

struct Terminal {
    silent: bool,
}

impl Host for Terminal {
    fn line(&mut self, text: Arguments<'_>) {
        if !self.silent {
            println!("{text}");
        }
    }

    fn read(&mut self, name: &str, room: &mut [u8]) -> Option<usize> {
        let bytes = std::fs::read(name).ok()?;
        room.get_mut(..bytes.len())?.copy_from_slice(&bytes);
        Some(bytes.len())
    }

    fn write(&mut self, name: &str, bytes: &[u8]) -> bool {
        std::fs::write(name, bytes).is_ok()
    }
}

fn carry_out(words: &[String], silent: bool) -> bool {
    execute(words.iter().map(String::as_str), &mut Terminal { silent }, &mut Box::new(Room::new()))
}

fn main() -> ExitCode {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let mut threads = 1;
    if words.first().is_some_and(|word| word == "--threads") {
        threads = words.get(1).and_then(|word| word.parse().ok()).unwrap_or(1);
        words.drain(..2.min(words.len()));
    }
    // Targets without threads still run the first one.
    let same = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(|| carry_out(&words, true))).collect();
        let first = carry_out(&words, false);
        others.into_iter().fold(first, |same, other| same & other.join().unwrap_or(false))
    });
    if same { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
