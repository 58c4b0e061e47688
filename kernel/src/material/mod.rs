//! The constitutive laws of a layer, each in a file of its own.
//!
//! All deviatoric stresses are Kirchhoff stresses tau = J sigma in the unrotated frame, R^T tau R with F = R U, so that
//! they can be added, carry their history through any rotation unchanged and have no pressure by construction:
//!
//! * [`elastic`]: hyperelastic stress, by one of the laws that it lists; [`law`] says what makes one;
//! * [`prony`]: quasi-linear viscous overstress on it;
//! * [`maxwell`]: additive viscous overstress, from absolute moduli; both are branches of [`relaxation`];
//! * [`slider`]: frequency-independent damping, a spring and a slider in series;
//! * [`softening`]: loss of elastic stress below the largest energy so far;
//! * [`tear`]: irreversible loss of the deviatoric stress beyond a stretch;
//! * [`volumetric`]: pressure from the mean dilatation of a cell, beside an isochoric law.
//!
//! A compressible law ([`hyperfoam`]) gives the mean stress of each triangle as well.

pub mod arruda_boyce;
pub mod coefficient;
mod coefficients;
mod description;
pub mod elastic;
pub mod gent;
#[cfg(feature = "pads")]
pub mod hyperfoam;
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
pub mod softening;
pub mod tear;
mod union;
pub mod volumetric;
pub mod yeoh;

pub use arruda_boyce::ArrudaBoyce;
pub use coefficient::{Coefficient, Role};
pub use coefficients::Coefficients;
pub(crate) use description::n_extra_entry;
pub use description::{MAX_MAXWELL_TERMS, MAX_PRONY_TERMS, Material, Moduli, VolumetricBy, VolumetricLaw};
pub use elastic::{COEFFICIENTS, Elastic, ElasticLaw, ListedLaw, N_COEFFICIENT};
pub use gent::Gent;
#[cfg(feature = "pads")]
pub use hyperfoam::{Hyperfoam, MAX_FOAM_TERMS};
pub use law::{CompressibleLaw, HyperelasticLaw, IsochoricLaw, LawDescription, PrincipalTangent, Variant, WholeStress};
pub use maxwell::Maxwell;
pub use model::MaterialModel;
pub use mooney_rivlin::MooneyRivlin;
pub use neo_hookean::NeoHookean;
pub use ogden::{MAX_OGDEN_TERMS, Ogden};
pub use prony::Prony;
pub use slider::Slider;
pub use softening::{Softened, Softening};
pub use tear::Tear;
pub use volumetric::Volumetric;
pub use yeoh::Yeoh;
