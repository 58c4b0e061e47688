//! How work comes to the instruction set that was chosen for it.

use crate::number::instruction_set::InstructionSet;
use crate::number::processor;
use crate::number::vector::Work;

impl InstructionSet {
    /// The widest set that this processor has.
    #[inline]
    pub fn best() -> Self {
        Self::ALL.into_iter().rfind(|set| set.available()).unwrap_or(Self::Baseline)
    }

    /// Whether this processor has the set, and the kernel uses it.
    #[inline]
    pub fn available(self) -> bool {
        self == Self::Baseline || processor::has(self)
    }

    /// Does `work` with this set, or with the baseline where it is not available.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) -> W::Output {
        processor::run(self, work)
    }
}
