//! What the tetrahedra of a block of cells of a solid remember, as packs in memory of plain numbers: zeros at rest.

use crate::features::PADS;
use crate::material::{Material, MaterialModel};
use crate::number::pack::Pack;
use crate::tensor::solid_deviator::DEVIATOR_PACKS;
use crate::tensor::symmetric::SYMMETRIC_PACKS;

/// What one tetrahedron of each cell remembers.
pub(crate) struct SolidHistory<'h> {
    /// Right stretch of the last step less the unit tensor.
    pub stretch: &'h mut [Pack; SYMMETRIC_PACKS],
    /// Long-term stress of the last step, Pa, before any tear.
    pub elastic: &'h mut [Pack; DEVIATOR_PACKS],
    /// Stress of the damping spring, Pa, before any tear.
    pub slider: Option<&'h mut [Pack; DEVIATOR_PACKS]>,
    /// Overstress of the Prony terms, then of the Maxwell terms, Pa.
    pub terms: &'h mut [[Pack; DEVIATOR_PACKS]],
    /// Largest principal stretch so far less one, and the energy stored in the last step before any tear, J/m3.
    pub tear: Option<&'h mut [Pack; 2]>,
    /// Largest energy so far, and what softening has dissipated, J/m3.
    pub softening: Option<&'h mut [Pack; 2]>,
    /// Mean stress of a compressible law in the last step, then its overstress in the Prony terms, Pa.
    pub mean: &'h mut [Pack],
}

/// Packs of a tetrahedron's history in a material of which these are there.
fn packs(slides: bool, terms: usize, tears: bool, softens: bool, mean_terms: usize) -> usize {
    SYMMETRIC_PACKS
        + DEVIATOR_PACKS * (1 + usize::from(slides) + terms)
        + 2 * (usize::from(tears) + usize::from(softens))
        + mean_terms
}

/// Packs that a tetrahedron of this material remembers.
pub(crate) fn solid_history_packs(material: &Material) -> usize {
    let terms = material.prony_g.iter().filter(|g| **g > 0.0).count();
    let mean = if material.law.is_compressible() { 1 + terms } else { 0 };
    let (slides, tears) = (material.slider_stiffness > 0.0, material.tear_stretch > 0.0);
    packs(slides, material.n_viscous_term(), tears, PADS && material.softening_r > 0.0, mean)
}

impl<'h> SolidHistory<'h> {
    /// Cuts the packs of a tetrahedron; none if there are too few, which the sizes exclude.
    #[inline(always)]
    pub fn of(laws: &MaterialModel, packs: &'h mut [Pack]) -> Option<Self> {
        let (stretch, packs) = packs.split_first_chunk_mut()?;
        let (elastic, mut packs) = packs.split_first_chunk_mut()?;
        let mut slider = None;
        if laws.slider.active() {
            let (first, rest) = packs.split_first_chunk_mut()?;
            (slider, packs) = (Some(first), rest);
        }
        let (terms, mut packs) = packs.split_at_mut_checked(DEVIATOR_PACKS * laws.n_term())?;
        let (mut tear, mut softening) = (None, None);
        if laws.tear.active() {
            let (first, rest) = packs.split_first_chunk_mut()?;
            (tear, packs) = (Some(first), rest);
        }
        if laws.softening.active() {
            let (first, rest) = packs.split_first_chunk_mut()?;
            (softening, packs) = (Some(first), rest);
        }
        Some(Self { stretch, elastic, slider, terms: terms.as_chunks_mut().0, tear, softening, mean: packs })
    }
}
