//! Contact with the rigid face above the layer and with the rigid core below it.

pub(crate) mod face;
mod friction;
mod node;
mod node_row;
pub(crate) mod rigid_core;
mod rounded_face;
pub mod surface;
