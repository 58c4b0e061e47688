//! How the material of a cell responds to its deformation: stresses and energies of its two triangles, whose history they
//! advance.

use crate::element::viscous_history::ViscousHistory;
use crate::element::{Block, CellHistory, ElementEnergy, TriangleHistory};
use crate::material::relaxation::Overstress;
use crate::material::slider::{Slider, SliderStep};
use crate::material::{MaterialModel, Softened};
use crate::number::pack::Pack;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;

/// Deviatoric stress of one triangle, Pa, and its energies.
pub(crate) type Response<V> = (Deviator<V>, EnergyDensity<V>);

/// Energy densities of one triangle, J/m3 of reference volume, as [`ElementEnergy`].
pub(crate) struct EnergyDensity<V> {
    elastic: V,
    viscous_increment: V,
    slider_stored: V,
    slider_increment: V,
    tear_increment: V,
    softening_increment: V,
}

impl<V: Vector> EnergyDensity<V> {
    /// Of elasticity, which may have softened, overstress and springs.
    #[inline(always)]
    pub(super) fn new<S: Simd<Vector = V>>(
        simd: S,
        softened: &Softened<V>,
        overstress: &Overstress<V>,
        elastic: &Deviator<V>,
        strain_increment: &Deviator<V>,
        springs: &SliderStep<V>,
    ) -> Self {
        Self {
            elastic: softened.stored,
            viscous_increment: overstress.twice_mean(elastic).half_contract(strain_increment),
            slider_stored: springs.stored,
            slider_increment: springs.dissipation,
            tear_increment: simd.splat(0.0),
            softening_increment: softened.increment,
        }
    }

    /// Adds the work on an overstress that is no deviator, J/m3.
    #[inline(always)]
    pub(super) fn add_viscous(&mut self, work: V) {
        self.viscous_increment = self.viscous_increment + work;
    }

    /// Adds the energies of triangles of the reference volumes `volume`.
    #[inline(always)]
    pub(crate) fn add_to<S: Simd<Vector = V>>(
        &self,
        simd: S,
        chunk: usize,
        volume: V,
        laws: &MaterialModel,
        sums: &mut ElementEnergy,
    ) {
        simd.add(volume * self.elastic, &mut sums.elastic, chunk);
        if laws.n_term() > 0 {
            simd.add(volume * self.viscous_increment, &mut sums.viscous_increment, chunk);
        }
        if laws.slider.active() {
            simd.add(volume * self.slider_stored, &mut sums.slider_stored, chunk);
            simd.add(volume * self.slider_increment, &mut sums.slider_increment, chunk);
        }
        if laws.tear.active() {
            simd.add(volume * self.tear_increment, &mut sums.tear_increment, chunk);
        }
        if laws.softening.active() {
            simd.add(volume * self.softening_increment, &mut sums.softening_increment, chunk);
        }
    }
}

/// Deviatoric Kirchhoff stress in the unrotated frame, Pa, and energies of the two triangles of each cell; advances their
/// history.
///
/// Both triangles go through each law before the next: one has long chains of operations that wait for each other, two
/// fill the waiting times.
#[inline(always)]
pub(crate) fn deviatoric_stress<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    history: &mut CellHistory,
    viscous: &mut [Deviator],
) -> [Response<S::Vector>; 2] {
    let (laws, axisymmetric) = (block.laws, block.hoop.is_some());
    let [a, b] = &mut history.triangle;
    let strain_increment = [
        strain_increment(simd, chunk, &kinematics[0], &mut a.stretch_prev, axisymmetric),
        strain_increment(simd, chunk, &kinematics[1], &mut b.stretch_prev, axisymmetric),
    ];
    let springs = spring_stress(simd, chunk, &laws.slider, &strain_increment, [&mut *a, &mut *b]);
    let [first, second] = laws.elastic.stress(simd, kinematics, axisymmetric);
    let mut viscous = ViscousHistory::split(laws, viscous);
    let (mut elastic, mut softened) =
        ([first.0, second.0], [Softened::none(simd, first.1), Softened::none(simd, second.1)]);
    if laws.softening.active() {
        let [numbers, numbers_2] = viscous.each_mut().map(|of| &mut *of.numbers);
        softened = [soften(simd, chunk, laws, first.1, numbers), soften(simd, chunk, laws, second.1, numbers_2)];
        elastic = [elastic[0].scaled(softened[0].factor), elastic[1].scaled(softened[1].factor)];
    }
    let overstress = viscous_stress(simd, chunk, laws, &elastic, &strain_increment, [a, b], viscous);
    let mut stress = [overstress[0].total, overstress[1].total];
    if laws.slider.active() {
        stress = [stress[0] + springs[0].stress, stress[1] + springs[1].stress];
    }
    let mut density = [
        EnergyDensity::new(simd, &softened[0], &overstress[0], &elastic[0], &strain_increment[0], &springs[0]),
        EnergyDensity::new(simd, &softened[1], &overstress[1], &elastic[1], &strain_increment[1], &springs[1]),
    ];
    if laws.tear.active() {
        let factor = [
            tear(simd, chunk, laws, &kinematics[0], a, &mut density[0]),
            tear(simd, chunk, laws, &kinematics[1], b, &mut density[1]),
        ];
        stress = [stress[0].scaled(factor[0]), stress[1].scaled(factor[1])];
    }
    let [first, second] = density;
    [(stress[0], first), (stress[1], second)]
}

/// Strain increment of one triangle of each cell since the stretch `before`, which becomes the current one.
#[inline(always)]
fn strain_increment<S: Simd>(
    simd: S,
    chunk: usize,
    kinematics: &Kinematics<S::Vector>,
    before: &mut [Pack; 4],
    axisymmetric: bool,
) -> Deviator<S::Vector> {
    let before = advance_stretch(simd, chunk, kinematics, before, axisymmetric);
    kinematics.strain_increment(simd, &before, axisymmetric)
}

/// The stretch of one triangle of each cell in the last step, in whose place the current one comes.
#[inline(always)]
pub(super) fn advance_stretch<S: Simd>(
    simd: S,
    chunk: usize,
    kinematics: &Kinematics<S::Vector>,
    [mean, difference, shear, hoop]: &mut [Pack; 4],
    axisymmetric: bool,
) -> [S::Vector; 4] {
    let before =
        [simd.load(mean, chunk), simd.load(difference, chunk), simd.load(shear, chunk), simd.load(hoop, chunk)];
    simd.store(kinematics.mean, mean, chunk);
    simd.store(kinematics.difference, difference, chunk);
    simd.store(kinematics.shear, shear, chunk);
    if axisymmetric {
        simd.store(kinematics.hoop, hoop, chunk);
    }
    before
}

/// Takes the energy of the whole law of one triangle of each cell, J/m3, into what softening knows of it.
#[inline(always)]
pub(super) fn soften<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    energy: S::Vector,
    numbers: &mut [Deviator],
) -> Softened<S::Vector> {
    // A law that softens has the entry.
    let Some(Deviator { difference: largest, shear: dissipated, .. }) = numbers.first_mut() else {
        return Softened::none(simd, energy);
    };
    let (mut most, mut lost) = (simd.load(largest, chunk), simd.load(dissipated, chunk));
    let softened = laws.softening.update(simd, energy, &mut most, &mut lost);
    simd.store(most, largest, chunk);
    simd.store(lost, dissipated, chunk);
    softened
}

/// Springs and sliders of the two triangles of each cell, no stress where the material has none; advances their history.
#[inline(always)]
pub(super) fn spring_stress<S: Simd>(
    simd: S,
    chunk: usize,
    slider: &Slider,
    strain_increment: &[Deviator<S::Vector>; 2],
    history: [&mut TriangleHistory; 2],
) -> [SliderStep<S::Vector>; 2] {
    if !slider.active() {
        return [SliderStep::none(simd); 2];
    }
    let [a, b] = history;
    let before = [Deviator::load(simd, &a.slider_stress, chunk), Deviator::load(simd, &b.slider_stress, chunk)];
    let springs =
        [slider.update(simd, &strain_increment[0], &before[0]), slider.update(simd, &strain_increment[1], &before[1])];
    springs[0].stress.store(simd, &mut a.slider_stress, chunk);
    springs[1].stress.store(simd, &mut b.slider_stress, chunk);
    springs
}

/// Long-term stress and viscous overstress of the two triangles of each cell; advances their history.
#[inline(always)]
pub(super) fn viscous_stress<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    elastic: &[Deviator<S::Vector>; 2],
    strain_increment: &[Deviator<S::Vector>; 2],
    [a, b]: [&mut TriangleHistory; 2],
    [first, second]: [ViscousHistory; 2],
) -> [Overstress<S::Vector>; 2] {
    let mut overstress =
        [Overstress::with_equilibrium(simd, elastic[0]), Overstress::with_equilibrium(simd, elastic[1])];
    if laws.prony.n_term() > 0 {
        let increment = [
            elastic[0] - Deviator::load(simd, &a.elastic_prev, chunk),
            elastic[1] - Deviator::load(simd, &b.elastic_prev, chunk),
        ];
        laws.prony.update(simd, chunk, &increment, [first.quasi_linear, second.quasi_linear], &mut overstress);
    }
    laws.maxwell.update(simd, chunk, strain_increment, [first.additive, second.additive], &mut overstress);
    elastic[0].store(simd, &mut a.elastic_prev, chunk);
    elastic[1].store(simd, &mut b.elastic_prev, chunk);
    overstress
}

/// Takes from one triangle of each cell the energies that it has lost by tearing; returns what is left of its stress, over all
/// of it.
#[inline(always)]
pub(super) fn tear<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    kinematics: &Kinematics<S::Vector>,
    history: &mut TriangleHistory,
    density: &mut EnergyDensity<S::Vector>,
) -> S::Vector {
    let [largest, before, after] = laws.tear.update(simd, kinematics, simd.load(&history.largest_stretch, chunk));
    simd.store(largest, &mut history.largest_stretch, chunk);
    let mean = (before + after).mul_scalar(0.5);
    let slides = laws.slider.active();
    let stored = if slides { density.elastic + density.slider_stored } else { density.elastic };
    let lost = (before - after) * (simd.load(&history.stored_prev, chunk) + stored).mul_scalar(0.5);
    simd.store(stored, &mut history.stored_prev, chunk);
    density.tear_increment = lost;
    density.elastic = after * density.elastic;
    density.viscous_increment = mean * density.viscous_increment;
    density.slider_stored = after * density.slider_stored;
    density.slider_increment = mean * density.slider_increment;
    density.softening_increment = mean * density.softening_increment;
    after
}
