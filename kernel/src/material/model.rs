//! All laws of a layer together.

use crate::material::{Elastic, Material, Maxwell, Prony, Slider, Softening, Tear, Volumetric, n_extra_entry};
use crate::number::cube_root::inverse_cbrt;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::Deviatoric;
use crate::tensor::kinematics::Kinematics;
use crate::tensor::solid_kinematics::SolidKinematics;
use crate::tensor::stretch::{IsochoricStretch, PrincipalStretches};
use crate::tensor::symmetric::Symmetric;

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
        self.unrelaxed(elastic)
    }

    /// The shear tangent with overstress and damping, from that of the elastic law, Pa.
    #[inline(always)]
    fn unrelaxed<V: Vector>(&self, elastic: V) -> V {
        elastic
            .mul_scalar(1.0 + self.prony.overstress())
            .add_scalar(self.maxwell.shear_modulus())
            .add_scalar(self.slider.stiffness())
    }

    /// Majorants of the moduli of shear and of volume strain of a tetrahedron with these principal stretches, Pa, but for the pressure
    /// that a cell of an isochoric law shares.
    #[inline(always)]
    pub(crate) fn solid_tangent<S: Simd>(&self, simd: S, stretches: [S::Vector; 3]) -> [S::Vector; 2] {
        if self.elastic.is_compressible() {
            let [mut shear, mut bulk] = self.elastic.whole_solid_tangent(simd, stretches);
            if self.softening.active() {
                let recovery = self.whole_recovery_tangent(simd, stretches);
                (shear, bulk) = (shear + recovery, bulk + recovery);
            }
            return [self.unrelaxed(shear), bulk.mul_scalar(1.0 + self.prony.overstress())];
        }
        let scale = inverse_cbrt(stretches[0] * stretches[1] * stretches[2]);
        let isochoric = [scale * stretches[0], scale * stretches[1], scale * stretches[2]];
        let mut elastic = self.elastic.shear_tangent(simd, &PrincipalStretches(isochoric));
        if self.softening.active() {
            let [u11, u22, u33] = isochoric;
            let diagonal = IsochoricStretch { u11, u22, u12: simd.splat(0.0), u33 };
            elastic = elastic + self.recovery_tangent(simd, &diagonal);
        }
        [self.unrelaxed(elastic), simd.splat(0.0)]
    }

    /// The same as [`Self::recovery_tangent`] of a compressible law, of its whole stress.
    #[inline(always)]
    fn whole_recovery_tangent<S: Simd>(&self, simd: S, [xx, yy, zz]: [S::Vector; 3]) -> S::Vector {
        let stretch = Symmetric { xx, yy, zz, ..Symmetric::unit(xx, simd.splat(0.0)) };
        let stress = self.elastic.whole_solid_stress(simd, &SolidKinematics::of_stretch(simd, &stretch));
        let square = stress.deviator.half_contract(&stress.deviator) + (stress.mean * stress.mean).mul_scalar(1.5);
        self.softening.largest_slope(simd, stress.energy) * square
    }

    /// What the shear tangent is more while an isochoric law recovers from its softening, Pa: half of the square of the stress
    /// times the slope of its factor.
    #[inline(always)]
    fn recovery_tangent<S: Simd>(&self, simd: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let [(stress, energy)] = self.elastic.stress(simd, &[Kinematics::of_isochoric(simd, stretch)], true);
        self.softening.largest_slope(simd, energy) * stress.half_contract(&stress)
    }
}
