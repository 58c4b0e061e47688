//! How the material of a tetrahedron responds to its deformation: stress and energies, with its history advanced. As
//! [`crate::element::response`] and [`crate::element::whole_response`], of six components.

use crate::element::response::EnergyDensity;
use crate::element::solid_history::SolidHistory;
use crate::material::relaxation::Overstress;
use crate::material::slider::SliderStep;
use crate::material::{MaterialModel, Softened, WholeStress};
use crate::number::pack::Pack;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviatoric;
use crate::tensor::solid_deviator::SolidDeviator;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::symmetric::Symmetric;

/// Stress and energies of one tetrahedron of each cell.
pub(crate) struct SolidResponse<V> {
    /// Deviator of the Kirchhoff stress in the unrotated frame, Pa.
    pub deviator: SolidDeviator<V>,
    /// Mean of the Kirchhoff stress of a compressible law, Pa; 0 of others.
    pub mean: V,
    /// Energies but for the next.
    pub density: EnergyDensity<V>,
    /// Energy dissipated by softening in this step, J/m3.
    pub softening_increment: V,
}

/// Stress and energies of one tetrahedron of each cell.
#[inline(always)]
pub(crate) fn respond<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    kinematics: &SolidKinematics<S::Vector>,
    history: &mut SolidHistory,
) -> SolidResponse<S::Vector> {
    let before = advance_stretch(simd, chunk, kinematics, history.stretch);
    let strain = kinematics.strain_increment(simd, &before);
    let strain_increment = SolidDeviator::of(&strain);
    let springs = spring_stress(simd, chunk, laws, &strain_increment, history.slider.as_deref_mut());
    let elastic = elastic_stress(simd, laws, kinematics);
    let softened = soften(simd, chunk, laws, &elastic, history.softening.as_deref_mut());
    let deviator = if laws.softening.active() { elastic.deviator.scaled(softened.factor) } else { elastic.deviator };
    let overstress = overstress(simd, chunk, laws, &deviator, &strain_increment, history);
    let mut density = EnergyDensity::new(simd, softened.stored, &overstress, &deviator, &strain_increment, &springs);
    let mut response = SolidResponse {
        deviator: overstress.total,
        mean: simd.splat(0.0),
        density,
        softening_increment: softened.increment,
    };
    if laws.slider.active() {
        response.deviator = response.deviator + springs.stress;
    }
    if laws.elastic.is_compressible() {
        let [mean, over] = mean_stress(simd, chunk, laws, softened.factor * elastic.mean, history.mean);
        response.mean = mean;
        density = response.density;
        density.add_viscous(over * strain.trace());
        response.density = density;
    }
    if let Some(tear) = history.tear.as_deref_mut() {
        response.tear(simd, chunk, laws, kinematics, tear);
    }
    response
}

/// The stretch of the last step, in whose place the current one comes.
#[inline(always)]
fn advance_stretch<S: Simd>(
    simd: S,
    chunk: usize,
    kinematics: &SolidKinematics<S::Vector>,
    packs: &mut [Pack; 6],
) -> Symmetric<S::Vector> {
    let unit = Symmetric::unit(simd.splat(1.0), simd.splat(0.0));
    let before = Symmetric::load(simd, packs, chunk).plus(&unit);
    kinematics.stretch.minus(&unit).store(simd, packs, chunk);
    before
}

/// Springs and sliders; no stress where the material has none.
#[inline(always)]
fn spring_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    strain_increment: &SolidDeviator<S::Vector>,
    packs: Option<&mut [Pack; 5]>,
) -> SliderStep<S::Vector, SolidDeviator<S::Vector>> {
    match packs {
        Some(packs) => {
            let before = SolidDeviator::load(simd, packs, chunk);
            let springs = laws.slider.update(simd, strain_increment, &before);
            springs.stress.store(simd, packs, chunk);
            springs
        }
        None => SliderStep::none(simd),
    }
}

/// Long-term stress and energy, before any softening.
#[inline(always)]
fn elastic_stress<S: Simd>(
    simd: S,
    laws: &MaterialModel,
    kinematics: &SolidKinematics<S::Vector>,
) -> WholeStress<S::Vector, SolidDeviator<S::Vector>> {
    if laws.elastic.is_compressible() {
        return laws.elastic.whole_solid_stress(simd, kinematics);
    }
    let (deviator, energy) = laws.elastic.solid_stress(simd, kinematics);
    WholeStress { deviator, mean: simd.splat(0.0), energy }
}

/// What softening leaves.
#[inline(always)]
fn soften<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: &WholeStress<S::Vector, SolidDeviator<S::Vector>>,
    packs: Option<&mut [Pack; 2]>,
) -> Softened<S::Vector> {
    match packs {
        Some([largest, dissipated]) => {
            let (mut most, mut lost) = (simd.load(largest, chunk), simd.load(dissipated, chunk));
            let softened = laws.softening.update(simd, elastic.energy, &mut most, &mut lost);
            simd.store(most, largest, chunk);
            simd.store(lost, dissipated, chunk);
            softened
        }
        None => Softened::none(simd, elastic.energy),
    }
}

/// Long-term stress and viscous overstress.
#[inline(always)]
fn overstress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: &SolidDeviator<S::Vector>,
    strain_increment: &SolidDeviator<S::Vector>,
    history: &mut SolidHistory,
) -> Overstress<SolidDeviator<S::Vector>> {
    let mut overstress = Overstress::with_equilibrium(simd, *elastic);
    let (prony, maxwell) = history.terms.split_at_mut_checked(laws.prony.n_term()).unwrap_or_default();
    if !prony.is_empty() {
        let increment = *elastic - SolidDeviator::load(simd, history.elastic, chunk);
        laws.prony.update_solid(simd, chunk, &increment, prony, &mut overstress);
    }
    laws.maxwell.update_solid(simd, chunk, strain_increment, maxwell, &mut overstress);
    elastic.store(simd, history.elastic, chunk);
    overstress
}

/// Mean stress of a compressible law with its overstress, from that of its elasticity, Pa, and the mean of the overstress over the
/// step.
#[inline(always)]
fn mean_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: S::Vector,
    packs: &mut [Pack],
) -> [S::Vector; 2] {
    match packs.split_first_mut() {
        Some((before, terms)) => {
            let increment = elastic - simd.load(before, chunk);
            simd.store(elastic, before, chunk);
            let [first, last] = laws.prony.update_solid_mean(simd, chunk, increment, terms);
            [elastic + last, (first + last).mul_scalar(0.5)]
        }
        None => [elastic, simd.splat(0.0)],
    }
}

impl<V: Vector> SolidResponse<V> {
    /// Takes what has been lost by tearing.
    #[inline(always)]
    fn tear<S: Simd<Vector = V>>(
        &mut self,
        simd: S,
        chunk: usize,
        laws: &MaterialModel,
        kinematics: &SolidKinematics<V>,
        [largest, stored]: &mut [Pack; 2],
    ) {
        let stretches = kinematics.stretch.principal(simd).values;
        let so_far = simd.load(largest, chunk).add_scalar(1.0);
        let [most, before, after] = laws.tear.update_solid(simd, stretches, so_far);
        simd.store(most.add_scalar(-1.0), largest, chunk);
        let during = self.density.lose(simd, chunk, laws, [before, after], stored);
        (self.deviator, self.mean) = (self.deviator.scaled(after), after * self.mean);
        self.softening_increment = during * self.softening_increment;
    }
}
