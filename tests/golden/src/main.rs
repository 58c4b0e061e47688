//! The commands of [`softanvil_golden::runner`] on targets with a standard library. In front may stand `--threads N`, which
//! runs the command in N threads at once, which all must succeed, and `--instructions NAME`, which makes the steps with
//! `baseline`, `neon`, `simd128`, `avx2` or `avx512` instead of the widest that the processor has.

use std::fmt::Arguments;
use std::process::ExitCode;

#[cfg(feature = "single")]
use softanvil_golden_f32 as softanvil_golden;

use softanvil_golden::runner::{Host, Room, execute};
use softanvil_kernel::InstructionSet;

#[derive(Clone, Copy)]
struct Terminal {
    silent: bool,
    instructions: InstructionSet,
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

    fn instructions(&self) -> InstructionSet {
        self.instructions
    }
}

fn carry_out(words: &[String], mut terminal: Terminal) -> bool {
    execute(words.iter().map(String::as_str), &mut terminal, &mut Box::new(Room::new()))
}

/// Takes `name` and its value from the front of `words`.
fn option(words: &mut Vec<String>, name: &str) -> Option<String> {
    (words.len() > 1 && words[0] == name).then(|| words.drain(..2).nth(1)).flatten()
}

/// The instruction set called `name`, if this program and this processor have it.
fn instruction_set(name: &str) -> Option<InstructionSet> {
    let set = match name {
        "baseline" => InstructionSet::Baseline,
        "neon" => InstructionSet::Neon,
        "simd128" => InstructionSet::Simd128,
        "avx2" => InstructionSet::Avx2,
        "avx512" => InstructionSet::Avx512,
        _ => return None,
    };
    set.available().then_some(set)
}

fn main() -> ExitCode {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let threads = option(&mut words, "--threads").map_or(Some(1), |count| count.parse().ok());
    let name = option(&mut words, "--instructions");
    let instructions = name.as_deref().map_or(Some(InstructionSet::best()), instruction_set);
    let (Some(threads), Some(instructions)) = (threads, instructions) else {
        eprintln!("no number of threads, or no instruction set that this program and this processor have");
        return ExitCode::FAILURE;
    };
    let terminal = Terminal { silent: false, instructions };
    // Targets without threads still run the first one.
    let same = std::thread::scope(|scope| {
        let others: Vec<_> =
            (1..threads).map(|_| scope.spawn(|| carry_out(&words, Terminal { silent: true, ..terminal }))).collect();
        let first = carry_out(&words, terminal);
        others.into_iter().fold(first, |same, other| same & other.join().unwrap_or(false))
    });
    if same { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
