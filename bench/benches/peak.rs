//! What one core can do at best, for the roofline: `cargo bench -p softanvil-bench --bench peak`.
//!
//! Additions and multiplications on numbers in registers, apart from each other as in the kernel, which fuses none; and
//! a triad a = b + s c, 24 bytes a number, on arrays that fit into one level of the caches. The fastest slice counts.

use std::hint::black_box;
use std::time::Instant;

use pulp::NullaryFnOnce;
use softanvil_bench::registers::{self, run};
use softanvil_bench::results;
use softanvil_kernel::InstructionSet;

/// Operations per chain in a slice.
const LENGTH: usize = 20_000;

/// Slices.
const SLICES: usize = 2000;

/// Bytes of the three arrays of the triad together.
const SIZES: [(&str, usize); 3] = [("L1", 24 << 10), ("L2", 768 << 10), ("L3", 24 << 20)];

/// The triad, over and over.
struct Triad<'a> {
    a: &'a mut [f64],
    b: &'a [f64],
    c: &'a [f64],
    times: usize,
}

impl NullaryFnOnce for Triad<'_> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        let scale = black_box(3.0);
        let start = Instant::now();
        for _ in 0..self.times {
            for ((a, b), c) in self.a.iter_mut().zip(self.b).zip(self.c) {
                *a = b + scale * c;
            }
            black_box(&mut *self.a);
        }
        let bytes = 24 * self.a.len() * self.times;
        bytes as f64 / start.elapsed().as_secs_f64()
    }
}

/// Operations per second.
fn arithmetic(set: InstructionSet) -> f64 {
    let start = Instant::now();
    let operations = registers::arithmetic(set, LENGTH);
    operations as f64 / start.elapsed().as_secs_f64()
}

fn main() {
    let mut figures = Vec::new();
    for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
        let peak = (0..SLICES).map(|_| arithmetic(set)).fold(0.0, f64::max);
        figures.push((format!("{set:?} Gflop/s"), 1e-9 * peak));
        for (level, bytes) in SIZES {
            let n = bytes / 24;
            let (mut a, b, c) = (vec![0.0; n], vec![1.0; n], vec![2.0; n]);
            let times = (2_000_000 / n).max(1);
            let slices = if times == 1 { 50 } else { 300 };
            let peak = (0..slices).map(|_| run(set, Triad { a: &mut a, b: &b, c: &c, times })).fold(0.0, f64::max);
            figures.push((format!("{set:?} {level} GB/s"), 1e-9 * peak));
        }
    }
    results::write("peak", &figures);
}
