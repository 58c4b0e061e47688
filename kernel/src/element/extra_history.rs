//! What triangles remember of softening and of the mean stress of a compressible law, behind the terms of the viscous history.

use crate::material::MaterialModel;
use crate::tensor::deviator::Deviator;

/// The entries of one triangle of each cell of a block.
pub(crate) struct ExtraHistory<'h> {
    /// None or one: numbers that are no deviator. Its mean is the mean of the elastic stress of a compressible law in the last
    /// step, Pa; its difference is the largest energy of a law that softens, and its shear what softening has dissipated, J/m3.
    pub numbers: &'h mut [Deviator],
    /// Means of the overstress of the Prony terms of a compressible law, Pa, three in an entry.
    pub means: &'h mut [Deviator],
}

impl<'h> ExtraHistory<'h> {
    /// The terms of both triangles of a block, and behind them what is more of each.
    #[inline(always)]
    pub fn split(laws: &MaterialModel, entries: &'h mut [Deviator]) -> (&'h mut [Deviator], [Self; 2]) {
        let (terms, extra) = entries.split_at_mut_checked(2 * laws.n_term()).unwrap_or_default();
        let (first, second) = extra.split_at_mut_checked(laws.n_extra_entry()).unwrap_or_default();
        (terms, [Self::of_triangle(first), Self::of_triangle(second)])
    }

    #[inline(always)]
    fn of_triangle(entries: &'h mut [Deviator]) -> Self {
        let (numbers, means) = entries.split_at_mut_checked(1).unwrap_or_default();
        Self { numbers, means }
    }
}
