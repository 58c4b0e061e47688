//! The description of a test: what a user says, the table of its parameters, ready-made ones.

mod description;
pub mod parameter;
pub mod prescribed;
pub mod preset;
mod validation;

pub use description::{
    CoreInterface, DropBy, FaceInterface, Formulation, Geometry, Impactor, Interface, Layer, Layers, MAX_LAYERS,
    Measurement, Mesh, Motion, Scenario, Section, Shape, StepBy, Time,
};
