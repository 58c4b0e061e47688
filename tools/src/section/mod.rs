//! The section as it deforms: recorded from a simulation, as a series for ParaView, and as pictures.

pub mod animation;
mod contour;
mod frame;
mod levels;
mod mesh;
#[cfg(feature = "command-line")]
pub mod paraview;
pub mod picture;
#[cfg(feature = "command-line")]
mod solid_grid;
#[cfg(feature = "command-line")]
mod vtk_fields;
#[cfg(feature = "command-line")]
mod vtu;

pub use animation::{Animation, Instant, SHADES, Shade};
pub use contour::nodal_means;
pub use frame::Frame;
pub use levels::Levels;
pub use mesh::{Mesh, SLAB};
