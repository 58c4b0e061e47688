//! Arithmetic on registers alone, with one of the instruction sets: what a core can do when it waits for no memory.

use std::hint::black_box;

use pulp::NullaryFnOnce;
use softanvil_kernel::InstructionSet;

/// Independent chains each of additions and of multiplications: more than latency times throughput asks for, and few
/// enough for sixteen registers.
const CHAINS: usize = 6;

/// Sums and products in vectors of `W` numbers, this many per chain.
struct Arithmetic<const W: usize>(usize);

impl<const W: usize> NullaryFnOnce for Arithmetic<W> {
    type Output = usize;

    #[inline(always)]
    fn call(self) -> usize {
        let (factor, summand) = ([black_box(1.000_000_1); W], [black_box(1e-9); W]);
        let (mut products, mut sums) = ([[1.0; W]; CHAINS], [[1.0; W]; CHAINS]);
        for _ in 0..self.0 {
            for chain in 0..CHAINS {
                for l in 0..W {
                    products[chain][l] *= factor[l];
                    sums[chain][l] += summand[l];
                }
            }
        }
        black_box((&products, &sums));
        2 * CHAINS * W * self.0
    }
}

/// Makes `length` sums and products in each of some chains of vectors, apart from each other as in the kernel, which fuses
/// none; returns the number of operations.
pub fn arithmetic(set: InstructionSet, length: usize) -> usize {
    match set {
        InstructionSet::Baseline | InstructionSet::Neon | InstructionSet::Simd128 => run(set, Arithmetic::<2>(length)),
        InstructionSet::Avx2 => run(set, Arithmetic::<4>(length)),
        InstructionSet::Avx512 => run(set, Arithmetic::<8>(length)),
    }
}

/// Does `work` with an instruction set.
///
/// # Panics
/// If the processor does not have it.
pub fn run<W: NullaryFnOnce>(set: InstructionSet, work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    match set {
        InstructionSet::Avx2 => return pulp::x86::V3::try_new().expect("AVX2").vectorize(work),
        InstructionSet::Avx512 => return pulp::x86::V4::try_new().expect("AVX-512").vectorize(work),
        _ => {}
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = set;
    work.call()
}
