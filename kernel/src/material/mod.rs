//! The constitutive laws of a layer, each in a file of its own.
//!
//! All deviatoric stresses are Kirchhoff stresses tau = J sigma in the unrotated frame, R^T tau R with F = R U, so that
//! they can be added, carry their history through any rotation unchanged and have no pressure by construction:
//!
//! * [`elastic`]: isochoric hyperelastic stress, by one of the laws that it lists; [`law`] says what makes one;
//! * [`prony`]: quasi-linear viscous overstress on it;
//! * [`maxwell`]: additive viscous overstress, from absolute moduli; both are branches of [`relaxation`];
//! * [`slider`]: frequency-independent damping, a spring and a slider in series;
//! * [`tear`]: irreversible loss of the deviatoric stress beyond a stretch;
//! * [`volumetric`]: pressure from the mean dilatation of a cell.

pub mod arruda_boyce;
pub mod coefficient;
mod coefficients;
mod description;
pub mod elastic;
pub mod gent;
mod invariants;
pub mod law;
pub mod maxwell;
mod model;
mod moduli;
pub mod mooney_rivlin;
pub mod neo_hookean;
pub mod ogden;
pub mod prony;
pub mod relaxation;
pub mod slider;
pub mod tear;
mod union;
pub mod volumetric;
pub mod yeoh;

pub use arruda_boyce::ArrudaBoyce;
pub use coefficient::{Coefficient, Role};
pub use coefficients::Coefficients;
pub use description::{MAX_MAXWELL_TERMS, MAX_PRONY_TERMS, Material, Moduli, VolumetricBy, VolumetricLaw};
pub use elastic::{COEFFICIENTS, Elastic, ElasticLaw, ListedLaw, N_COEFFICIENT};
pub use gent::Gent;
pub use law::{IsochoricLaw, LawDescription, Variant};
pub use maxwell::Maxwell;
pub use model::MaterialModel;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{MAX_OGDEN_TERMS, Ogden};
pub use prony::Prony;
pub use slider::Slider;
pub use tear::Tear;
pub use volumetric::Volumetric;
pub use yeoh::Yeoh;
