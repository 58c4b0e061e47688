//! How the material of a cell responds to its deformation: stresses and energies of its two triangles, whose history they
//! advance.

use crate::element::{Block, CellHistory, ElementEnergy, TriangleHistory};
use crate::material::MaterialModel;
use crate::material::relaxation::Overstress;
use crate::material::slider::{Slider, SliderStep};
use crate::number::pack::Pack;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, Deviatoric};
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
}

impl<V: Vector> EnergyDensity<V> {
    /// Of elasticity, overstress and springs.
    #[inline(always)]
    pub(super) fn new<S: Simd<Vector = V>, D: Deviatoric<V>>(
        simd: S,
        stored: V,
        overstress: &Overstress<D>,
        elastic: &D,
        strain_increment: &D,
        springs: &SliderStep<V, D>,
    ) -> Self {
        Self {
            elastic: stored,
            viscous_increment: overstress.twice_mean(elastic).half_contract(strain_increment),
            slider_stored: springs.stored,
            slider_increment: springs.dissipation,
            tear_increment: simd.splat(0.0),
        }
    }

    /// Takes what is lost where tearing leaves the parts `before` and `after` of the energy in the pack `stored_prev`, J/m3; gives the
    /// mean of both.
    #[inline(always)]
    pub(super) fn lose<S: Simd<Vector = V>>(
        &mut self,
        simd: S,
        chunk: usize,
        laws: &MaterialModel,
        [before, after]: [V; 2],
        stored_prev: &mut Pack,
    ) -> V {
        let mean = (before + after).mul_scalar(0.5);
        let slides = laws.slider.active();
        let stored = if slides { self.elastic + self.slider_stored } else { self.elastic };
        let lost = (before - after) * (simd.load(stored_prev, chunk) + stored).mul_scalar(0.5);
        simd.store(stored, stored_prev, chunk);
        self.tear_increment = lost;
        self.elastic = after * self.elastic;
        self.viscous_increment = mean * self.viscous_increment;
        self.slider_stored = after * self.slider_stored;
        self.slider_increment = mean * self.slider_increment;
        mean
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
    let elastic = [first.0, second.0];
    let overstress = viscous_stress(simd, chunk, laws, &elastic, &strain_increment, [a, b], viscous);
    let mut stress = [overstress[0].total, overstress[1].total];
    if laws.slider.active() {
        stress = [stress[0] + springs[0].stress, stress[1] + springs[1].stress];
    }
    let mut density = [
        EnergyDensity::new(simd, first.1, &overstress[0], &elastic[0], &strain_increment[0], &springs[0]),
        EnergyDensity::new(simd, second.1, &overstress[1], &elastic[1], &strain_increment[1], &springs[1]),
    ];
    if laws.tear.active() {
        stress = [
            tear(simd, chunk, laws, &kinematics[0], a, &stress[0], &mut density[0]),
            tear(simd, chunk, laws, &kinematics[1], b, &stress[1], &mut density[1]),
        ];
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
    viscous: &mut [Deviator],
) -> [Overstress<Deviator<S::Vector>>; 2] {
    let n_quasi_linear = laws.prony.n_term();
    let (first, second) = viscous.split_at_mut_checked(laws.n_term()).unwrap_or_default();
    let (quasi_linear, additive) = first.split_at_mut_checked(n_quasi_linear).unwrap_or_default();
    let (quasi_linear_2, additive_2) = second.split_at_mut_checked(n_quasi_linear).unwrap_or_default();
    let mut overstress =
        [Overstress::with_equilibrium(simd, elastic[0]), Overstress::with_equilibrium(simd, elastic[1])];
    if n_quasi_linear > 0 {
        let increment = [
            elastic[0] - Deviator::load(simd, &a.elastic_prev, chunk),
            elastic[1] - Deviator::load(simd, &b.elastic_prev, chunk),
        ];
        laws.prony.update(simd, chunk, &increment, [quasi_linear, quasi_linear_2], &mut overstress);
    }
    laws.maxwell.update(simd, chunk, strain_increment, [additive, additive_2], &mut overstress);
    elastic[0].store(simd, &mut a.elastic_prev, chunk);
    elastic[1].store(simd, &mut b.elastic_prev, chunk);
    overstress
}

/// Takes from one triangle of each cell the stress and the energies that it has lost by tearing.
#[inline(always)]
fn tear<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    kinematics: &Kinematics<S::Vector>,
    history: &mut TriangleHistory,
    stress: &Deviator<S::Vector>,
    density: &mut EnergyDensity<S::Vector>,
) -> Deviator<S::Vector> {
    let [_, after] = tear_energies(simd, chunk, laws, kinematics, history, density);
    stress.scaled(after)
}

/// Takes from one triangle of each cell the energies that it has lost by tearing; returns the part of all stresses that is left
/// in the mean of the step, and after it.
#[inline(always)]
pub(super) fn tear_energies<S: Simd>(
    simd: S,
    chunk: usize,
    laws: &MaterialModel,
    kinematics: &Kinematics<S::Vector>,
    history: &mut TriangleHistory,
    density: &mut EnergyDensity<S::Vector>,
) -> [S::Vector; 2] {
    let [largest, before, after] = laws.tear.update(simd, kinematics, simd.load(&history.largest_stretch, chunk));
    simd.store(largest, &mut history.largest_stretch, chunk);
    let mean = density.lose(simd, chunk, laws, [before, after], &mut history.stored_prev);
    [mean, after]
}
