//! How a material that softens, or has a compressible law, responds to the deformation of a cell: as
//! [`crate::element::response`], and more.
//!
//! A compressible law says the mean stress of each triangle as well. Nothing of it is shared in a cell: there is nothing to
//! lock. Prony terms act on the whole stress, Maxwell terms and spring-sliders on its deviator, as ever; softening and tear
//! take from the whole.

use crate::element::extra_history::ExtraHistory;
use crate::element::response::{EnergyDensity, advance_stretch, spring_stress, tear_energies, viscous_stress};
use crate::element::{Block, CellHistory};
use crate::material::{MaterialModel, Softened, WholeStress};
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, Deviatoric};
use crate::tensor::kinematics::Kinematics;

/// Stress and energies of one triangle of each cell.
pub(crate) struct WholeResponse<V> {
    /// Deviator of the Kirchhoff stress in the unrotated frame, Pa.
    pub deviator: Deviator<V>,
    /// Mean of the Kirchhoff stress of a compressible law, Pa; 0 of others.
    pub mean: V,
    /// Energies but for the next.
    pub density: EnergyDensity<V>,
    /// Energy dissipated by softening in this step, J/m3.
    pub softening_increment: V,
}

/// Stresses and energies of the two triangles of each cell, of a law that is compressible or not; advances their history.
#[inline(always)]
pub(crate) fn whole_stress<S: Simd, const COMPRESSIBLE: bool>(
    simd: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    history: &mut CellHistory,
    entries: &mut [Deviator],
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
    let (terms, [mut first, mut second]) = ExtraHistory::split(laws, entries);
    let elastic = elastic_stress::<S, COMPRESSIBLE>(simd, laws, kinematics, axisymmetric);
    let softened =
        [soften(simd, chunk, laws, &elastic[0], &mut first), soften(simd, chunk, laws, &elastic[1], &mut second)];
    let deviators = [elastic[0].deviator.scaled(softened[0].factor), elastic[1].deviator.scaled(softened[1].factor)];
    let overstress = viscous_stress(simd, chunk, laws, &deviators, &strain_increment, [&mut *a, &mut *b], terms);
    let mut means = [[simd.splat(0.0); 2]; 2];
    if COMPRESSIBLE {
        means = [
            mean_stress(simd, chunk, laws, softened[0].factor * elastic[0].mean, &mut first),
            mean_stress(simd, chunk, laws, softened[1].factor * elastic[1].mean, &mut second),
        ];
    }
    let mut density = [
        EnergyDensity::new(simd, softened[0].stored, &overstress[0], &deviators[0], &strain_increment[0], &springs[0]),
        EnergyDensity::new(simd, softened[1].stored, &overstress[1], &deviators[1], &strain_increment[1], &springs[1]),
    ];
    if COMPRESSIBLE && laws.prony.n_term() > 0 {
        density[0].add_viscous(means[0][1] * kinematics[0].volume_increment(simd, &before[0], axisymmetric));
        density[1].add_viscous(means[1][1] * kinematics[1].volume_increment(simd, &before[1], axisymmetric));
    }
    let stress = [overstress[0].total + springs[0].stress, overstress[1].total + springs[1].stress];
    let [first, second] = density;
    let mut response = [
        WholeResponse::new(stress[0], means[0][0], first, &softened[0]),
        WholeResponse::new(stress[1], means[1][0], second, &softened[1]),
    ];
    if laws.tear.active() {
        for (t, history) in [a, b].into_iter().enumerate() {
            let [during, after] = tear_energies(simd, chunk, laws, &kinematics[t], history, &mut response[t].density);
            response[t].lose(during, after);
        }
    }
    response
}

impl<V: Vector> WholeResponse<V> {
    #[inline(always)]
    fn new(deviator: Deviator<V>, mean: V, density: EnergyDensity<V>, softened: &Softened<V>) -> Self {
        Self { deviator, mean, density, softening_increment: softened.increment }
    }

    /// Keeps the part `after` of its stresses, and `during` of what was dissipated in the step.
    #[inline(always)]
    fn lose(&mut self, during: V, after: V) {
        (self.deviator, self.mean) = (self.deviator.scaled(after), after * self.mean);
        self.softening_increment = during * self.softening_increment;
    }
}

/// Long-term stress and energy of both triangles of each cell, before any softening.
#[inline(always)]
fn elastic_stress<S: Simd, const COMPRESSIBLE: bool>(
    simd: S,
    laws: &MaterialModel,
    kinematics: &[Kinematics<S::Vector>; 2],
    axisymmetric: bool,
) -> [WholeStress<S::Vector>; 2] {
    if COMPRESSIBLE {
        return laws.elastic.whole_stress(simd, kinematics, axisymmetric);
    }
    let [first, second] = laws.elastic.stress(simd, kinematics, axisymmetric);
    let mean = simd.splat(0.0);
    [
        WholeStress { deviator: first.0, mean, energy: first.1 },
        WholeStress { deviator: second.0, mean, energy: second.1 },
    ]
}

/// What softening leaves of one triangle of each cell.
#[inline(always)]
fn soften<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: &WholeStress<S::Vector>,
    extra: &mut ExtraHistory,
) -> Softened<S::Vector> {
    // A law that softens has the entry.
    match extra.numbers.first_mut() {
        Some(Deviator { difference: largest, shear: dissipated, .. }) if laws.softening.active() => {
            let (mut most, mut lost) = (simd.load(largest, chunk), simd.load(dissipated, chunk));
            let softened = laws.softening.update(simd, elastic.energy, &mut most, &mut lost);
            simd.store(most, largest, chunk);
            simd.store(lost, dissipated, chunk);
            softened
        }
        _ => Softened::none(simd, elastic.energy),
    }
}

/// Mean stress of a compressible law in one triangle of each cell with its overstress, from that of its elasticity, Pa, and the mean of the
/// overstress over the step; advances its history.
#[inline(always)]
fn mean_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: S::Vector,
    extra: &mut ExtraHistory,
) -> [S::Vector; 2] {
    // A compressible law with Prony terms has the entry.
    match extra.numbers.first_mut() {
        Some(numbers) if laws.prony.n_term() > 0 => {
            let increment = elastic - simd.load(&numbers.mean, chunk);
            simd.store(elastic, &mut numbers.mean, chunk);
            let [before, after] = laws.prony.update_mean(simd, chunk, increment, extra.means);
            [elastic + after, (before + after).mul_scalar(0.5)]
        }
        _ => [elastic, simd.splat(0.0)],
    }
}
