//! What the tetrahedra of a block of cells of a solid remember, as packs in memory of plain numbers: zeros at rest.

use crate::features::PADS;
use crate::material::{Material, MaterialModel};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::tensor::solid_deviator::{DEVIATOR_PACKS, SolidDeviator};
use crate::tensor::symmetric::{SYMMETRIC_PACKS, Symmetric};

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

/// What one tetrahedron of one cell remembers, to be read.
pub(crate) struct SolidMemory {
    /// Right stretch U of the last step.
    pub stretch: Symmetric<Real>,
    /// Deviator of the Kirchhoff stress of the last step in the unrotated frame, Pa, before any tear.
    pub deviator: SolidDeviator<Real>,
    /// Mean Kirchhoff stress of a compressible law likewise, Pa; 0 of others.
    pub mean: Real,
    /// Largest principal stretch so far, where the material can tear; 1 otherwise.
    pub largest_stretch: Real,
}

impl SolidMemory {
    /// Of lane `l` of the packs of a tetrahedron; none if there are too few.
    pub fn of(laws: &MaterialModel, packs: &[Pack], l: usize) -> Option<Self> {
        let (stretch, packs) = packs.split_first_chunk()?;
        let stresses = 1 + usize::from(laws.slider.active()) + laws.n_term();
        let (stresses, packs) = packs.split_at_checked(DEVIATOR_PACKS * stresses)?;
        let mut deviator = SolidDeviator::none(Scalar);
        for stress in stresses.as_chunks().0 {
            deviator = deviator + SolidDeviator::load(Scalar, stress, l);
        }
        let at = |place: usize| packs.get(place).and_then(|pack| pack.get(l)).copied();
        let before_mean = 2 * (usize::from(laws.tear.active()) + usize::from(laws.softening.active()));
        let largest_stretch = if laws.tear.active() { 1.0 + at(0)? } else { 1.0 };
        let mut mean = 0.0;
        if laws.elastic.is_compressible() {
            (0..=laws.prony.n_term()).for_each(|term| mean += at(before_mean + term).unwrap_or_default());
        }
        let unit = Symmetric::unit(1.0, 0.0);
        Some(Self { stretch: Symmetric::load(Scalar, stretch, l).plus(&unit), deviator, mean, largest_stretch })
    }
}
