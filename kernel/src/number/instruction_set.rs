//! The instruction set that steps are made with. It changes the speed and no bit: see [`crate::number::pack`].
//!
//! With the feature `dispatch` the choice is made at run time, by the crate `pulp`; without it, on other processors than
//! x86-64 and in single precision there is only scalar code.

use crate::number::vector::{Scalar, Work};
#[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
use crate::number::x86;

/// Vector instructions.
///
/// ```
/// use softanvil_kernel::{InstructionSet, Simulation, StepInput, preset, step_with};
///
/// let mut anvil = Simulation::new(&preset::study())?;
/// anvil.run(4e-3, &StepInput::default())?;
/// let next = |set| {
///     let mut anvil = anvil.clone();
///     anvil.with(|model, state| step_with(set, model, state, &StepInput::default()))??;
///     Ok::<_, Box<dyn core::error::Error>>(*anvil.scalars())
/// };
/// assert!(InstructionSet::best().available());
/// for set in InstructionSet::ALL.into_iter().filter(|set| set.available()) {
///     assert_eq!(next(set)?, next(InstructionSet::Baseline)?);
/// }
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// SSE2, vectors of two numbers, which every x86-64 has; scalar code elsewhere.
    Baseline,
    /// AVX2: vectors of four numbers.
    Avx2,
    /// AVX-512: vectors of eight numbers.
    Avx512,
}

impl InstructionSet {
    /// Every set, widest last.
    pub const ALL: [Self; 3] = [Self::Baseline, Self::Avx2, Self::Avx512];

    /// The widest set that this processor has.
    #[inline]
    pub fn best() -> Self {
        if Self::Avx512.available() {
            Self::Avx512
        } else if Self::Avx2.available() {
            Self::Avx2
        } else {
            Self::Baseline
        }
    }

    /// Whether this processor has the set, and the kernel uses it.
    #[inline]
    pub fn available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
            Self::Avx2 => x86::V3::is_available(),
            #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
            Self::Avx512 => x86::V4::is_available(),
            #[cfg(not(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single"))))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// Does `work` with this set, or with the baseline where it is not available.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) -> W::Output {
        #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
        {
            if self == Self::Avx512
                && let Some(simd) = x86::V4::try_new()
            {
                return simd.vectorize(x86::Call(simd, work));
            }
            if self == Self::Avx2
                && let Some(simd) = x86::V3::try_new()
            {
                return simd.vectorize(x86::Call(simd, work));
            }
            if let Some(simd) = x86::Sse2::try_new() {
                return apart(simd, work);
            }
        }
        work.run(Scalar)
    }
}

/// Keeps work of the baseline behind a call, as `pulp` does with that of the other sets, which so need no room for its numbers.
#[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri), not(feature = "single")))]
#[inline(never)]
fn apart<W: Work>(simd: x86::Sse2, work: W) -> W::Output {
    work.run(simd)
}
