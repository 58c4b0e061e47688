//! What a rest leaves of the history of the triangles.

use crate::element::extra_history::ExtraHistory;
use crate::element::{CellHistory, TriangleHistory};
use crate::material::MaterialModel;
use crate::material::relaxation::Overstress;
use crate::number::pack::{LANES, ZERO};
use crate::number::real::Real;
use crate::number::vector::Scalar;
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;

/// Lets the triangles of a block of cells come back to their shape and rest there for the time that is the step of `laws`: the
/// elastic stress goes back steadily over the rest, overstresses follow it and decay exactly, springs come back. What damage
/// goes by stays: the largest stretch, and the largest energy with what it has dissipated.
pub(crate) fn recover(laws: &MaterialModel, axisymmetric: bool, history: &mut CellHistory, entries: &mut [Deviator]) {
    let (terms, extra) = ExtraHistory::split(laws, entries);
    let (first, second) = terms.split_at_mut_checked(laws.n_term()).unwrap_or_default();
    let (prony, maxwell) = first.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
    let (prony_2, maxwell_2) = second.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
    for l in 0..LANES {
        let back = history.triangle.each_ref().map(|triangle| stress_back(triangle, l));
        let strain_back = history.triangle.each_ref().map(|triangle| strain_back(triangle, l, axisymmetric));
        // Their sums are nobody's.
        let mut sums = [(); 2].map(|()| Overstress::with_equilibrium(Scalar, NONE));
        laws.prony.update(Scalar, l, &back, [&mut *prony, &mut *prony_2], &mut sums);
        laws.maxwell.update(Scalar, l, &strain_back, [&mut *maxwell, &mut *maxwell_2], &mut sums);
    }
    for ExtraHistory { numbers, means } in extra {
        if let Some(numbers) = numbers.first_mut() {
            for (l, mean) in numbers.mean.iter().enumerate() {
                laws.prony.update_mean(Scalar, l, -mean, means);
            }
            numbers.mean = ZERO;
        }
    }
    for triangle in &mut history.triangle {
        *triangle = TriangleHistory { largest_stretch: triangle.largest_stretch, ..TriangleHistory::REST };
    }
}

/// No stress.
const NONE: Deviator<Real> = Deviator { mean: 0.0, difference: 0.0, shear: 0.0 };

/// What takes the elastic stress of lane `l` back to none, Pa.
fn stress_back(triangle: &TriangleHistory, l: usize) -> Deviator<Real> {
    NONE - Deviator::load(Scalar, &triangle.elastic_prev, l)
}

/// The strain increment that takes lane `l` back to its shape.
fn strain_back(triangle: &TriangleHistory, l: usize, axisymmetric: bool) -> Deviator<Real> {
    let before = triangle.stretch_prev.each_ref().map(|lane| lane.get(l).copied().unwrap_or(1.0));
    Kinematics::REST.strain_increment(Scalar, &before, axisymmetric)
}
