//! How the material of a cell responds to its deformation: stresses and energies of its two triangles, whose history they
//! advance.

use crate::element::{Block, CellHistory, ElementEnergy, TriangleHistory};
use crate::material::Laws;
use crate::material::relaxation::Overstress;
use crate::material::slider::{Slider, SliderStep};
use crate::number::pack::Lane;
use crate::number::vector::{Instructions, Vector};
use crate::tensor::deviator::Deviator;
use crate::tensor::kinematics::Kinematics;

/// Deviatoric stress of one triangle, Pa, and its energies.
pub(crate) type Response<V> = (Deviator<V>, Density<V>);

/// Energy densities of one triangle, J/m3 of reference volume, as [`ElementEnergy`].
pub(crate) struct Density<V> {
    elastic: V,
    viscous_increment: V,
    slider_stored: V,
    slider_increment: V,
    tear_increment: V,
}

impl<V: Vector> Density<V> {
    /// Of elasticity, overstress and springs.
    #[inline(always)]
    fn new<S: Instructions<Vector = V>>(
        set: S,
        stored: V,
        overstress: &Overstress<V>,
        elastic: &Deviator<V>,
        strain_increment: &Deviator<V>,
        springs: &SliderStep<V>,
    ) -> Self {
        Self {
            elastic: stored,
            viscous_increment: overstress.double_mean(elastic).half_contract(strain_increment),
            slider_stored: springs.stored,
            slider_increment: springs.dissipation,
            tear_increment: set.splat(0.0),
        }
    }

    /// Adds the energies of triangles of the reference volumes `volume`.
    #[inline(always)]
    pub(crate) fn add_to<S: Instructions<Vector = V>>(
        &self,
        set: S,
        chunk: usize,
        volume: V,
        laws: &Laws,
        sums: &mut ElementEnergy,
    ) {
        set.add(volume * self.elastic, &mut sums.elastic, chunk);
        if laws.n_term() > 0 {
            set.add(volume * self.viscous_increment, &mut sums.viscous_increment, chunk);
        }
        if laws.slider.active() {
            set.add(volume * self.slider_stored, &mut sums.slider_stored, chunk);
            set.add(volume * self.slider_increment, &mut sums.slider_increment, chunk);
        }
        if laws.tear.active() {
            set.add(volume * self.tear_increment, &mut sums.tear_increment, chunk);
        }
    }
}

/// Deviatoric Kirchhoff stress in the unrotated frame, Pa, and energies of the two triangles of each cell; advances their
/// history.
///
/// Both triangles go through each law before the next: one has long chains of operations that wait for each other, two
/// fill the waiting times.
#[inline(always)]
pub(crate) fn deviatoric_stress<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    history: &mut CellHistory,
    viscous: &mut [Deviator],
) -> [Response<S::Vector>; 2] {
    let (laws, rings) = (block.laws, block.hoop.is_some());
    let [a, b] = &mut history.triangle;
    let strain_increment = [
        advance_stretch(set, chunk, &kinematics[0], &mut a.stretch_prev, rings),
        advance_stretch(set, chunk, &kinematics[1], &mut b.stretch_prev, rings),
    ];
    let springs = spring_stress(set, chunk, &laws.slider, &strain_increment, [&mut *a, &mut *b]);
    let [first, second] = laws.elastic.stress(set, kinematics, rings);
    let elastic = [first.0, second.0];
    let overstress = viscous_stress(set, chunk, laws, &elastic, &strain_increment, [a, b], viscous);
    let mut stress = [overstress[0].total, overstress[1].total];
    if laws.slider.active() {
        stress = [stress[0] + springs[0].stress, stress[1] + springs[1].stress];
    }
    let mut density = [
        Density::new(set, first.1, &overstress[0], &elastic[0], &strain_increment[0], &springs[0]),
        Density::new(set, second.1, &overstress[1], &elastic[1], &strain_increment[1], &springs[1]),
    ];
    if laws.tear.active() {
        stress = [
            tear(set, chunk, laws, &kinematics[0], a, &stress[0], &mut density[0]),
            tear(set, chunk, laws, &kinematics[1], b, &stress[1], &mut density[1]),
        ];
    }
    let [first, second] = density;
    [(stress[0], first), (stress[1], second)]
}

/// Strain increment of one triangle of each cell since the stretch `before`, which becomes the current one.
#[inline(always)]
fn advance_stretch<S: Instructions>(
    set: S,
    chunk: usize,
    kinematics: &Kinematics<S::Vector>,
    [mean, difference, shear, hoop]: &mut [Lane; 4],
    rings: bool,
) -> Deviator<S::Vector> {
    let before = [set.load(mean, chunk), set.load(difference, chunk), set.load(shear, chunk), set.load(hoop, chunk)];
    set.store(kinematics.mean, mean, chunk);
    set.store(kinematics.difference, difference, chunk);
    set.store(kinematics.shear, shear, chunk);
    if rings {
        set.store(kinematics.hoop, hoop, chunk);
    }
    kinematics.strain_increment(set, &before, rings)
}

/// Springs and sliders of the two triangles of each cell, no stress where the material has none; advances their history.
#[inline(always)]
fn spring_stress<S: Instructions>(
    set: S,
    chunk: usize,
    slider: &Slider,
    strain_increment: &[Deviator<S::Vector>; 2],
    history: [&mut TriangleHistory; 2],
) -> [SliderStep<S::Vector>; 2] {
    if !slider.active() {
        return [SliderStep::none(set); 2];
    }
    let [a, b] = history;
    let before = [Deviator::load(set, &a.slider_stress, chunk), Deviator::load(set, &b.slider_stress, chunk)];
    let springs =
        [slider.update(set, &strain_increment[0], &before[0]), slider.update(set, &strain_increment[1], &before[1])];
    springs[0].stress.store(set, &mut a.slider_stress, chunk);
    springs[1].stress.store(set, &mut b.slider_stress, chunk);
    springs
}

/// Long-term stress and viscous overstress of the two triangles of each cell; advances their history.
#[inline(always)]
fn viscous_stress<S: Instructions>(
    set: S,
    chunk: usize,
    laws: &Laws,
    elastic: &[Deviator<S::Vector>; 2],
    strain_increment: &[Deviator<S::Vector>; 2],
    [a, b]: [&mut TriangleHistory; 2],
    viscous: &mut [Deviator],
) -> [Overstress<S::Vector>; 2] {
    let n_quasi_linear = laws.prony.n_term();
    let (first, second) = viscous.split_at_mut_checked(laws.n_term()).unwrap_or_default();
    let (quasi_linear, additive) = first.split_at_mut_checked(n_quasi_linear).unwrap_or_default();
    let (quasi_linear_2, additive_2) = second.split_at_mut_checked(n_quasi_linear).unwrap_or_default();
    let mut overstress = [Overstress::beside(set, elastic[0]), Overstress::beside(set, elastic[1])];
    if n_quasi_linear > 0 {
        let increment = [
            elastic[0] - Deviator::load(set, &a.elastic_prev, chunk),
            elastic[1] - Deviator::load(set, &b.elastic_prev, chunk),
        ];
        laws.prony.update(set, chunk, &increment, [quasi_linear, quasi_linear_2], &mut overstress);
    }
    laws.maxwell.update(set, chunk, strain_increment, [additive, additive_2], &mut overstress);
    elastic[0].store(set, &mut a.elastic_prev, chunk);
    elastic[1].store(set, &mut b.elastic_prev, chunk);
    overstress
}

/// Takes from one triangle of each cell the stress and the energies that it has lost by tearing.
#[inline(always)]
fn tear<S: Instructions>(
    set: S,
    chunk: usize,
    laws: &Laws,
    kinematics: &Kinematics<S::Vector>,
    history: &mut TriangleHistory,
    stress: &Deviator<S::Vector>,
    density: &mut Density<S::Vector>,
) -> Deviator<S::Vector> {
    let [largest, before, after] = laws.tear.update(set, kinematics, set.load(&history.largest_stretch, chunk));
    set.store(largest, &mut history.largest_stretch, chunk);
    let mean = (before + after).times(0.5);
    let slides = laws.slider.active();
    let stored = if slides { density.elastic + density.slider_stored } else { density.elastic };
    let lost = (before - after) * (set.load(&history.stored_prev, chunk) + stored).times(0.5);
    set.store(stored, &mut history.stored_prev, chunk);
    density.tear_increment = lost;
    density.elastic = after * density.elastic;
    density.viscous_increment = mean * density.viscous_increment;
    density.slider_stored = after * density.slider_stored;
    density.slider_increment = mean * density.slider_increment;
    stress.scaled(after)
}
