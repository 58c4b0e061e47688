//! The constitutive laws of a layer, each in a file of its own.
//!
//! All deviatoric stresses are Kirchhoff stresses tau = J sigma in the unrotated frame, R^T tau R with F = R U, so that
//! they can be added, carry their history through any rotation unchanged and have no pressure by construction:
//!
//! * [`elastic`]: isochoric hyperelastic stress, by [`neo_hookean`], [`mooney_rivlin`], [`yeoh`] or [`ogden`];
//! * [`prony`]: quasi-linear viscous overstress on it;
//! * [`maxwell`]: additive viscous overstress, from absolute moduli; both are branches of [`relaxation`];
//! * [`slider`]: frequency-independent damping, a spring and a slider in series;
//! * [`tear`]: irreversible loss of the deviatoric stress beyond a stretch;
//! * [`volumetric`]: pressure from the mean dilatation of a cell.

pub mod elastic;
pub mod maxwell;
pub mod mooney_rivlin;
pub mod neo_hookean;
pub mod ogden;
pub mod prony;
pub mod relaxation;
pub mod slider;
pub mod tear;
pub mod volumetric;
pub mod yeoh;

pub use elastic::Elastic;
pub(crate) use elastic::invariant_shear_tangent;
pub use maxwell::{MAX_MAXWELL_TERMS, Maxwell};
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{MAX_OGDEN_TERMS, Ogden};
pub use prony::{MAX_PRONY_TERMS, Prony};
pub use slider::Slider;
pub use tear::Tear;
pub use volumetric::Volumetric;
pub use yeoh::Yeoh;

use crate::real::Real;
use crate::scenario::Material;
use crate::stretch::IsochoricStretch;
use crate::vector::{Instructions, Vector};

/// The laws of one layer with everything precomputed that does not change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laws {
    /// Density, kg/m3.
    pub density: Real,
    /// Long-term isochoric elasticity.
    pub elastic: Elastic,
    /// Pressure.
    pub volumetric: Volumetric,
    /// Quasi-linear viscous overstress.
    pub prony: Prony,
    /// Additive viscous overstress.
    pub maxwell: Maxwell,
    /// Frequency-independent damping.
    pub slider: Slider,
    /// Loss of all these beyond a stretch.
    pub tear: Tear,
    /// Shear modulus at rest before any relaxation, of elasticity, overstress and damping together, Pa.
    pub shear_modulus_0: Real,
}

impl Laws {
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
            tear: Tear::new(material),
            shear_modulus_0: elastic.shear_modulus() * quasi_linear + additive,
        }
    }

    /// Entries of viscous history per block of triangles: the Prony terms, then the Maxwell terms.
    pub fn n_term(&self) -> usize {
        self.prony.n_term() + self.maxwell.n_term()
    }

    /// A majorant of the shear tangent of elasticity, overstress and damping together, Pa.
    ///
    /// All viscous terms count as unrelaxed, and nothing as torn.
    #[inline(always)]
    pub fn shear_tangent<S: Instructions>(&self, set: S, stretch: &IsochoricStretch<S::Vector>) -> S::Vector {
        let elastic = self.elastic.shear_tangent(set, stretch);
        elastic.times(1.0 + self.prony.overstress()).plus(self.maxwell.shear_modulus()).plus(self.slider.stiffness())
    }
}
