//! What a rest leaves of the history of the tetrahedra: as [`crate::element::recover`].

use crate::element::solid_history::SolidHistory;
use crate::material::MaterialModel;
use crate::material::relaxation::Overstress;
use crate::number::pack::{LANES, Pack, ZERO};
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::tensor::deviator::Deviatoric;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::symmetric::Symmetric;

/// Lets one tetrahedron of each cell of a block come back to its shape and rest there for the time that is the step of `laws`.
pub(crate) fn recover_solid(laws: &MaterialModel, packs: &mut [Pack]) {
    let Some(history) = SolidHistory::of(laws, packs) else { return };
    let (prony, maxwell) = history.terms.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
    let none = SolidDeviator::uniform(0.0);
    for l in 0..LANES {
        let back = none - SolidDeviator::load(Scalar, history.elastic, l);
        // Its sums are nobody's.
        let mut sums = Overstress::with_equilibrium(Scalar, none);
        laws.prony.update_solid(Scalar, l, &back, prony, &mut sums);
        laws.maxwell.update_solid(Scalar, l, &strain_back(history.stretch, l), maxwell, &mut sums);
        if let Some((mean, terms)) = history.mean.split_first_mut() {
            laws.prony.update_solid_mean(Scalar, l, -mean.get(l).copied().unwrap_or_default(), terms);
        }
    }
    if let Some(mean) = history.mean.first_mut() {
        *mean = ZERO;
    }
    *history.stretch = [ZERO; 6];
    *history.elastic = [ZERO; 5];
    if let Some(slider) = history.slider {
        *slider = [ZERO; 5];
    }
    if let Some([_, stored]) = history.tear {
        *stored = ZERO;
    }
}

/// The strain increment that takes lane `l` back to its shape.
fn strain_back(stretch: &[Pack; 6], l: usize) -> SolidDeviator<Real> {
    let unit = Symmetric::unit(1.0, 0.0);
    let before = Symmetric::load(Scalar, stretch, l).plus(&unit);
    SolidDeviator::of(&SolidKinematics::of_stretch(Scalar, &unit).strain_increment(Scalar, &before))
}
