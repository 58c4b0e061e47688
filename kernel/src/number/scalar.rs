//! A processor whose vectors are not used.

use crate::number::instruction_set::InstructionSet;
use crate::number::vector::{Scalar, Work};

/// None of the sets is there.
#[inline]
pub(crate) fn has(_: InstructionSet) -> bool {
    false
}

/// Does `work` one number at a time.
#[inline]
pub(crate) fn run<W: Work>(_: InstructionSet, work: W) -> W::Output {
    work.run(Scalar)
}
