//! What triangles remember beside what every material does: a deviator for each viscous term, and what few materials have.

use crate::material::MaterialModel;
use crate::tensor::deviator::Deviator;

/// The viscous history of one triangle of each cell of a block, by its parts.
pub(crate) struct ViscousHistory<'h> {
    /// Overstress of the Prony terms, Pa, before any tear.
    pub quasi_linear: &'h mut [Deviator],
    /// Overstress of the Maxwell terms, Pa, before any tear.
    pub additive: &'h mut [Deviator],
    /// None or one: numbers that are no deviator. Its mean is the mean of the elastic stress of a compressible law in the last
    /// step, Pa; its difference is the largest energy of a law that softens, and its shear what softening has dissipated, J/m3.
    pub numbers: &'h mut [Deviator],
    /// Means of the overstress of the Prony terms of a compressible law, Pa, three in an entry.
    pub means: &'h mut [Deviator],
}

impl<'h> ViscousHistory<'h> {
    /// The entries of both triangles of a block.
    #[inline(always)]
    pub fn split(laws: &MaterialModel, entries: &'h mut [Deviator]) -> [Self; 2] {
        let (first, second) = entries.split_at_mut_checked(laws.n_history_entry()).unwrap_or_default();
        [Self::of_triangle(laws, first), Self::of_triangle(laws, second)]
    }

    #[inline(always)]
    fn of_triangle(laws: &MaterialModel, entries: &'h mut [Deviator]) -> Self {
        let (terms, extra) = entries.split_at_mut_checked(laws.n_term()).unwrap_or_default();
        let (quasi_linear, additive) = terms.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
        let (numbers, means) = extra.split_at_mut_checked(1).unwrap_or_default();
        Self { quasi_linear, additive, numbers, means }
    }
}
