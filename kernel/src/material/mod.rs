//! The constitutive laws of a layer, each in a file of its own.
//!
//! All deviatoric stresses are Kirchhoff stresses tau = J sigma in the unrotated frame, R^T tau R with F = R U, so that
//! they can be added, carry their history through any rotation unchanged and have no pressure by construction:
//!
//! * [`mooney_rivlin`]: isochoric hyperelastic stress;
//! * [`prony`]: quasi-linear viscous overstress on it;
//! * [`slider`]: frequency-independent damping, a spring and a slider in series;
//! * [`volumetric`]: pressure from the mean dilatation of a cell.

pub mod mooney_rivlin;
pub mod prony;
pub mod slider;
pub mod volumetric;

pub use mooney_rivlin::MooneyRivlin;
pub use prony::{MAX_PRONY_TERMS, Prony};
pub use slider::Slider;
pub use volumetric::Volumetric;

use crate::scenario::Material;

/// The laws of one layer with everything precomputed that does not change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laws {
    /// Long-term isochoric elasticity.
    pub elastic: MooneyRivlin,
    /// Pressure.
    pub volumetric: Volumetric,
    /// Viscous overstress.
    pub prony: Prony,
    /// Frequency-independent damping.
    pub slider: Slider,
}

impl Laws {
    /// The laws of `material` for steps of `dt` s.
    pub fn new(material: &Material, dt: f64) -> Self {
        Self {
            elastic: MooneyRivlin::new(material),
            volumetric: Volumetric { bulk_modulus: material.effective_bulk_modulus() },
            prony: Prony::new(material, dt),
            slider: Slider { stiffness: material.slider_stiffness, yield_stress: material.slider_yield_stress },
        }
    }

    /// An upper bound of the shear tangent of elasticity, overstress and damping together, Pa.
    ///
    /// `i1`, `i2` are the isochoric invariants. All Prony terms count as unrelaxed.
    pub fn shear_tangent(&self, i1: f64, i2: f64) -> f64 {
        self.elastic.shear_tangent(i1, i2) * (1.0 + self.prony.overstress()) + self.slider.stiffness
    }
}
