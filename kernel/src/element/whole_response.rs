//! How a compressible material responds to the deformation of a cell: as [`crate::element::response`], but with the mean
//! stress of each triangle, which the law itself says. Nothing of it is shared in a cell: there is nothing to lock.
//!
//! Prony terms act on the whole stress, Maxwell terms and spring-sliders on its deviator, as ever; softening and tear take
//! from the whole.

use crate::element::response::{EnergyDensity, advance_stretch, soften, spring_stress, tear, viscous_stress};
use crate::element::viscous_history::ViscousHistory;
use crate::element::{Block, CellHistory};
use crate::material::{MaterialModel, Softened, WholeStress};
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;

/// Deviator and mean of the stress of one triangle, Pa, and its energies.
pub(crate) type WholeResponse<V> = (Deviator<V>, V, EnergyDensity<V>);

/// Kirchhoff stress in the unrotated frame, Pa, and energies of the two triangles of each cell; advances their history.
#[inline(always)]
pub(crate) fn whole_stress<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    history: &mut CellHistory,
    viscous: &mut [Deviator],
) -> [WholeResponse<S::Vector>; 2] {
    let (laws, axisymmetric) = (block.laws, block.hoop.is_some());
    let [a, b] = &mut history.triangle;
    let before = [
        advance_stretch(simd, chunk, &kinematics[0], &mut a.stretch_prev, axisymmetric),
        advance_stretch(simd, chunk, &kinematics[1], &mut b.stretch_prev, axisymmetric),
    ];
    let strain_increment = [
        kinematics[0].strain_increment(simd, &before[0], axisymmetric),
        kinematics[1].strain_increment(simd, &before[1], axisymmetric),
    ];
    let springs = spring_stress(simd, chunk, &laws.slider, &strain_increment, [&mut *a, &mut *b]);
    let [mut first, mut second] = ViscousHistory::split(laws, viscous);
    let [(elastic, softened), (elastic_2, softened_2)] = [
        elastic_stress(simd, chunk, laws, &kinematics[0], axisymmetric, &mut first),
        elastic_stress(simd, chunk, laws, &kinematics[1], axisymmetric, &mut second),
    ];
    let means = [
        mean_stress(simd, chunk, laws, elastic.mean, &mut first),
        mean_stress(simd, chunk, laws, elastic_2.mean, &mut second),
    ];
    let deviators = [elastic.deviator, elastic_2.deviator];
    let overstress =
        viscous_stress(simd, chunk, laws, &deviators, &strain_increment, [&mut *a, &mut *b], [first, second]);
    let mut response = [
        (
            overstress[0].total + springs[0].stress,
            means[0][0],
            EnergyDensity::new(simd, &softened, &overstress[0], &deviators[0], &strain_increment[0], &springs[0]),
        ),
        (
            overstress[1].total + springs[1].stress,
            means[1][0],
            EnergyDensity::new(simd, &softened_2, &overstress[1], &deviators[1], &strain_increment[1], &springs[1]),
        ),
    ];
    for t in 0..2 {
        if laws.prony.n_term() > 0 {
            let grown = kinematics[t].volume_increment(simd, &before[t], axisymmetric);
            response[t].2.add_viscous(means[t][1] * grown);
        }
    }
    if laws.tear.active() {
        for (t, history) in [a, b].into_iter().enumerate() {
            let factor = tear(simd, chunk, laws, &kinematics[t], history, &mut response[t].2);
            (response[t].0, response[t].1) = (response[t].0.scaled(factor), factor * response[t].1);
        }
    }
    response
}

/// Long-term stress of one triangle of each cell, which may have softened, and its energies.
#[inline(always)]
fn elastic_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    kinematics: &Kinematics<S::Vector>,
    axisymmetric: bool,
    viscous: &mut ViscousHistory,
) -> (WholeStress<S::Vector>, Softened<S::Vector>) {
    let mut elastic = laws.elastic.whole_stress(simd, kinematics, axisymmetric);
    if !laws.softening.active() {
        return (elastic, Softened::none(simd, elastic.energy));
    }
    let softened = soften(simd, chunk, laws, elastic.energy, viscous.numbers);
    (elastic.deviator, elastic.mean) = (elastic.deviator.scaled(softened.factor), softened.factor * elastic.mean);
    (elastic, softened)
}

/// Mean stress of one triangle of each cell with its overstress, from that of its elasticity, Pa, and the mean of the
/// overstress over the step; advances its history.
#[inline(always)]
fn mean_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: S::Vector,
    viscous: &mut ViscousHistory,
) -> [S::Vector; 2] {
    // A compressible law with Prony terms has the entry.
    match viscous.numbers.first_mut() {
        Some(numbers) if laws.prony.n_term() > 0 => {
            let increment = elastic - simd.load(&numbers.mean, chunk);
            simd.store(elastic, &mut numbers.mean, chunk);
            let [before, after] = laws.prony.update_mean(simd, chunk, increment, viscous.means);
            [elastic + after, (before + after).mul_scalar(0.5)]
        }
        _ => [elastic, simd.splat(0.0)],
    }
}
