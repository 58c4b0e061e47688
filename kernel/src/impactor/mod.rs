//! The impactor: what moves it from outside, and its one degree of freedom.

mod driven_path;
mod input;
mod motion;

pub use driven_path::DrivenPath;
pub use input::{INPUTS, InputRow, StepInput};
pub use motion::ImpactorState;
pub(crate) use motion::{FaceContact, Prediction};
