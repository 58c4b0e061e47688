//! Contact with the rigid face above the layer and with the rigid core below it.

pub(crate) mod face;
mod friction;
pub(crate) mod interface;
mod node;
mod node_row;
mod pairing;
pub(crate) mod rigid_core;
mod rounded_face;
mod segments;
pub(crate) mod solid_core;
mod solid_edge;
pub(crate) mod solid_face;
pub(crate) mod solid_interface;
mod solid_node;
mod solid_pairing;
mod solid_touch;
pub mod surface;
