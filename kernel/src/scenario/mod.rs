//! The description of a test: what a user says, the table of its parameters, ready-made ones.

mod description;
mod impactor;
mod layer;
mod layers;
mod outline;
pub mod parameter;
pub mod prescribed;
pub mod preset;
pub mod presets;
#[cfg(feature = "pads")]
pub mod standards;
mod validation;
mod widths;

pub use description::{
    Body, CoreInterface, Ends, FaceInterface, Formulation, Geometry, Interface, Measurement, Mesh, Scenario, Section,
    Shape, StepBy, Symmetry, Time,
};
pub use impactor::{DropBy, FaceShape, Impactor, Motion};
pub use layer::{Layer, LayerInterface, MAX_LAYER_NAME, MAX_LAYERS};
pub use outline::{EDGE_RADIUS, Outline};
