//! Some thousands of edited files, the same in every run. `tools/fuzz` tries as many as one likes.

#[path = "../fuzz/mod.rs"]
mod targets;

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Files of each target in a normal run; `SOFTANVIL_CASES` says another number.
const CASES: u64 = 200;

#[test]
fn no_edited_file_makes_a_reader_panic() {
    let cases = std::env::var("SOFTANVIL_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(CASES);
    for (name, target) in targets::TARGETS {
        for case in 0..cases {
            let mut random = Pcg64Mcg::seed_from_u64(case);
            let mut choices = vec![0; 16 + (case % 128) as usize];
            random.fill_bytes(&mut choices);
            assert!(std::panic::catch_unwind(|| target(&choices)).is_ok(), "{name}, case {case}");
        }
    }
}
