//! The description of a test: what a user says, the table of its parameters, ready-made ones.

mod description;
mod layer;
mod layers;
pub mod parameter;
pub mod prescribed;
pub mod preset;
mod validation;

pub use description::{
    CoreInterface, DropBy, FaceInterface, Formulation, Geometry, Impactor, Interface, MAX_INTERFACES, Measurement,
    Mesh, Motion, Scenario, Section, Shape, StepBy, Time,
};
pub use layer::{Layer, LayerInterface, MAX_LAYER_NAME, MAX_LAYERS};
