//! The instruction set that steps are made with. It changes the speed and no bit: see [`crate::lanes`].
//!
//! With the feature `dispatch` the choice is made at run time, by the crate `pulp`; without it, and on other processors
//! than x86-64, there is only what the kernel was built for.

/// Vector instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// What the kernel was built for: SSE2 on x86-64 unless told otherwise.
    Baseline,
    /// AVX2: vectors of four numbers.
    Avx2,
    /// AVX-512: vectors of eight numbers.
    Avx512,
}

/// Work that is compiled once per instruction set.
pub(crate) trait Work {
    /// What it gives.
    type Output;
    /// Does it; must be inlined, so that it takes on the instruction set of the caller.
    fn run(self) -> Self::Output;
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
            #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri)))]
            Self::Avx2 => pulp::x86::V3::is_available(),
            #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri)))]
            Self::Avx512 => pulp::x86::V4::is_available(),
            #[cfg(not(all(feature = "dispatch", target_arch = "x86_64", not(miri))))]
            Self::Avx2 | Self::Avx512 => false,
        }
    }

    /// Does `work` with this set, or with the baseline where it is not available.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) -> W::Output {
        #[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri)))]
        match self {
            Self::Avx512 => {
                if let Some(set) = pulp::x86::V4::try_new() {
                    return set.vectorize(Call(work));
                }
            }
            Self::Avx2 => {
                if let Some(set) = pulp::x86::V3::try_new() {
                    return set.vectorize(Call(work));
                }
            }
            Self::Baseline => {}
        }
        work.run()
    }
}

/// [`Work`] in the form that the crate asks for.
#[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri)))]
struct Call<W>(W);

#[cfg(all(feature = "dispatch", target_arch = "x86_64", not(miri)))]
impl<W: Work> pulp::NullaryFnOnce for Call<W> {
    type Output = W::Output;

    #[inline(always)]
    fn call(self) -> W::Output {
        self.0.run()
    }
}
