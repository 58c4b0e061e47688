//! The cells of the section, two linear triangles each, and of the solid, six linear tetrahedra each.

mod cell;
pub(crate) mod cell_bound;
mod energy;
mod extra_history;
mod history;
pub mod internal_force;
mod recovery;
mod reference_triangle;
mod response;
pub(crate) mod solid_bound;
mod solid_cell;
mod solid_force;
mod solid_history;
mod solid_recovery;
mod solid_response;
pub(crate) mod whole_bound;
mod whole_response;

pub(crate) use cell::Edges;
pub use cell::{Block, CellConstants, Corners, HoopConstants, TriangleConstants};
pub use energy::ElementEnergy;
pub use history::{CellHistory, TriangleHistory};
pub(crate) use internal_force::cell_kinematics;
pub use internal_force::internal_force;
pub(crate) use internal_force::{plain_force, whole_force};
pub(crate) use recovery::recover;
pub(crate) use reference_triangle::Triangle;
pub(crate) use solid_cell::{
    INVERSE_VOLUME, SOLID_BLOCK_PACKS, SolidBlock, SolidConstants, SolidCorners, TETRAHEDRON_PACKS, VOLUME, store_cell,
};
pub(crate) use solid_force::{solid_force, tetrahedron_gradient};
pub(crate) use solid_history::{SolidMemory, solid_history_packs};
pub(crate) use solid_recovery::recover_solid;
