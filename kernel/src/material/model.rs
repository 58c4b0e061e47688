//! All laws of a layer together.

use crate::material::{Elastic, Material, Maxwell, Prony, Slider, Softening, Tear, Volumetric, n_extra_entry};
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::kinematics::Kinematics;
use crate::tensor::stretch::IsochoricStretch;

/// The laws of one layer with everything precomputed that does not change.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialModel {
    /// Mass density, kg/m3.
    pub density: Real,
    /// Long-term elasticity.
    pub elastic: Elastic,
    /// Pressure, beside an isochoric law.
    pub volumetric: Volumetric,
    /// Quasi-linear viscous overstress.
    pub prony: Prony,
    /// Additive viscous overstress.
    pub maxwell: Maxwell,
    /// Frequency-independent damping.
    pub slider: Slider,
    /// Loss of elastic stress after the first load.
    pub softening: Softening,
    /// Loss of all these beyond a stretch.
    pub tear: Tear,
    /// Shear modulus at rest before any relaxation, of elasticity, overstress and damping together, Pa.
    pub shear_modulus_0: Real,
}

impl MaterialModel {
    /// The laws of `material` for steps of `dt` s.
    pub fn new(material: &Material, dt: Real) -> Self {
        let (elastic, prony, maxwell) = (Elastic::new(material), Prony::new(material, dt), Maxwell::new(material, dt));
        let slider = Slider::new(material.slider_stiffness, material.slider_yield_stress);
        let (quasi_linear, additive) = (1.0 + prony.overstress(), maxwell.shear_modulus() + slider.stiffness());
        Self {
            density: material.density,
            elastic,
            volumetric: Volumetric::new(material),
            prony,
            maxwell,
            slider,
            softening: Softening::new(material),
            tear: Tear::new(material),
            shear_modulus_0: elastic.shear_modulus() * quasi_linear + additive,
        }
    }

    /// Whether the elastic law is isochoric and does not soften.
    #[inline(always)]
    pub fn is_plain(&self) -> bool {
        !self.elastic.is_compressible() && !self.softening.active()
    }

    /// Terms of overstress: the Prony terms, then the Maxwell terms.
    pub fn n_term(&self) -> usize {
        self.prony.n_term() + self.maxwell.n_term()
    }

    /// Entries of viscous history per block of triangles: one for each term, then [`Self::n_extra_entry`].
    pub fn n_history_entry(&self) -> usize {
        self.n_term() + self.n_extra_entry()
    }

    /// Entries of viscous history for what softens and for the mean stress of a compressible law.
    pub fn n_extra_entry(&self) -> usize {
        n_extra_entry(self.elastic.is_compressible(), self.prony.n_term(), self.softening.active())
    }

    /// A majorant of the shear tangent of elasticity, overstress and damping together, Pa.
    ///
    /// All viscous terms count as unrelaxed, and nothing as torn.
    #[inline(always)]
    pub fn shear_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let mut elastic = self.elastic.shear_tangent(simd, stretch);
        if self.softening.active() {
            elastic = elastic + self.recovery_tangent(simd, stretch);
        }
        elastic
            .mul_scalar(1.0 + self.prony.overstress())
            .add_scalar(self.maxwell.shear_modulus())
            .add_scalar(self.slider.stiffness())
    }

    /// What the shear tangent is more while an isochoric law recovers from its softening, Pa: half of the square of the stress
    /// times the slope of its factor.
    #[inline(always)]
    fn recovery_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let [(stress, energy)] = self.elastic.stress(simd, &[Kinematics::of_isochoric(simd, stretch)], true);
        self.softening.largest_slope(simd, energy) * stress.half_contract(&stress)
    }
}
