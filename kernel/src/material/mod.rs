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

mod description;
pub mod elastic;
pub mod maxwell;
mod model;
mod moduli;
pub mod mooney_rivlin;
pub mod neo_hookean;
pub mod ogden;
pub mod prony;
pub mod relaxation;
mod shear_tangent;
pub mod slider;
pub mod tear;
pub mod volumetric;
pub mod yeoh;

pub use description::{
    ElasticLaw, MAX_MAXWELL_TERMS, MAX_OGDEN_TERMS, MAX_PRONY_TERMS, Material, Moduli, VolumetricBy, VolumetricLaw,
};
pub use elastic::Elastic;
pub use maxwell::Maxwell;
pub use model::MaterialModel;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::Ogden;
pub use prony::Prony;
pub use slider::Slider;
pub use tear::Tear;
pub use volumetric::Volumetric;
pub use yeoh::Yeoh;
