//! Replays the saved inputs of the fuzzer, and thousands of variations of them that are the same in every run.

mod fuzz;

use std::fs;
use std::path::Path;

/// Variations per saved input.
const VARIATIONS: usize = 500;

/// A linear congruential generator (Knuth's constants): reproducible, and random enough to vary bytes.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % sides
    }

    /// Some bytes changed, a piece doubled or cut out.
    fn vary(&mut self, input: &[u8]) -> Vec<u8> {
        let mut bytes = input.to_vec();
        for _ in 0..=self.roll(4) {
            let (at, length) = (self.roll(bytes.len().max(1)), self.roll(16));
            let end = (at + length).min(bytes.len());
            match self.roll(4) {
                0 => drop(bytes.drain(at.min(end)..end)),
                1 => bytes.extend_from_within(at.min(end)..end),
                2 => bytes.push(self.roll(256) as u8),
                _ => bytes[at.min(end)..end].iter_mut().for_each(|byte| *byte = self.roll(256) as u8),
            }
        }
        bytes
    }
}

#[test]
fn saved_inputs_and_their_variations_keep_the_promises() {
    for (name, target) in fuzz::TARGETS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(name);
        let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        files.sort();
        assert!(files.len() >= 10, "{} holds {} inputs", folder.display(), files.len());
        let mut dice = Dice(1);
        for file in files {
            let input = fs::read(file).unwrap();
            target(&input);
            for _ in 0..VARIATIONS {
                target(&dice.vary(&input));
            }
        }
    }
}
