//! The section as it deforms: recorded from a simulation, as a series for ParaView, and as pictures.

pub mod animation;
mod contour;
mod frame;
mod levels;
mod mesh;
pub mod paraview;
pub mod picture;
mod solid_grid;
mod vtk_fields;
mod vtu;

pub use animation::{Animation, Instant, SHADES, Shade};
pub use contour::nodal_means;
pub use frame::Frame;
pub use levels::Levels;
pub use mesh::{Mesh, SLAB};
